//! Every pattern, wave form and warp against values recorded from the language's reference renderer by `patterns.pov`.
use raggio_math::Vec3;
use raggio_shading::{Context, Noise, Pattern};

use crate::statement;

/// The points of the recording scene: three quarters near the origin, the others up to 30 away.
fn points() -> Vec<Vec3> {
    let mut seed = 1_u32;
    let mut unit = || {
        seed = (seed * 3877 + 29573) % 139_968;
        f64::from(seed) / 139_968.0 - 0.5
    };
    let sizes = (1..=500).map(|i| if i % 4 == 0 { 60.0 } else { 6.0 });
    sizes.map(|size| size * Vec3::new(unit(), unit(), unit())).collect()
}

/// Lines `statement|value|value ...`.
fn samples() -> impl Iterator<Item = (&'static str, Vec<f64>)> {
    include_str!("../data/patterns.csv").lines().map(|line| {
        let (statement, values) = line.split_once('|').expect("values");
        (statement, values.split('|').map(|v| v.parse().expect("a number")).collect())
    })
}

/// Relative where values are large; the colours that tilings are recorded as have single precision.
fn tolerance(statement: &str) -> f64 {
    if statement.starts_with("tiling") { 1e-5 } else { 1e-6 }
}

#[test]
fn every_recorded_value_is_met() {
    let points = points();
    let (mut statements, mut failures) = (0, Vec::new());
    for (statement, values) in samples() {
        assert_eq!(values.len(), points.len(), "{statement}");
        statements += 1;
        let pattern = Pattern::compile(&statement::pattern(statement), Noise::default());
        let errors = points.iter().zip(values).map(|(&p, expected)| {
            let actual = pattern.eval(p, &Context::NONE);
            ((actual - expected).abs() / expected.abs().max(1.0), p, expected, actual)
        });
        let far: Vec<_> = errors.filter(|e| e.0.is_nan() || e.0 > tolerance(statement)).collect();
        if let Some((_, p, expected, actual)) = far.first() {
            failures.push(format!("{statement}: {} points, at {p} {expected} became {actual}", far.len()));
        }
    }
    assert_eq!(statements, 254);
    assert!(failures.is_empty(), "{} of 254 differ:\n{}", failures.len(), failures.join("\n"));
}
