//! Every pattern, wave form and warp against values recorded from the language's reference renderer.
use raggio_math::Vec3;
use raggio_shading::{Context, Noise, Pattern};

use crate::statement;

/// Points of a statement and the recorded values.
struct Sample {
    statement: &'static str,
    points: Vec<(Vec3, f64)>,
}

/// Rows `pattern,statement,x,y,z,value`; a statement with commas or quotes stands in quotes.
fn samples() -> Vec<Sample> {
    let mut samples: Vec<Sample> = Vec::new();
    for line in include_str!("../data/pattern_samples.csv").lines().skip(1) {
        let (rest, numbers) = split_numbers(line);
        let statement = rest.split_once(',').map_or(rest, |(_, statement)| statement);
        if samples.last().is_none_or(|last| last.statement != statement) {
            samples.push(Sample { statement, points: Vec::new() });
        }
        let [x, y, z, value] = numbers;
        if let Some(last) = samples.last_mut() {
            last.points.push((Vec3::new(x, y, z), value));
        }
    }
    samples
}

fn split_numbers(line: &'static str) -> (&'static str, [f64; 4]) {
    let mut fields = line.rsplitn(5, ',');
    let mut number = || fields.next().and_then(|f| f.parse().ok()).expect("a number");
    let (value, z, y, x) = (number(), number(), number(), number());
    (fields.next().expect("a statement"), [x, y, z, value])
}

fn tolerance(statement: &str) -> f64 {
    match statement.split(' ').next() {
        Some("tiling") => 1e-5,
        _ => 2e-6,
    }
}

/// The largest error of a statement, relative where values are large.
fn worst(sample: &Sample) -> (f64, Vec3, f64, f64) {
    let text = sample.statement.trim_matches('"').replace("\"\"", "\"");
    let pattern = Pattern::compile(&statement::pattern(&text), Noise::default());
    let mut worst = (0.0, Vec3::ZERO, 0.0, 0.0);
    for &(p, expected) in &sample.points {
        let actual = pattern.eval(p, &Context::NONE);
        let error = (actual - expected).abs() / expected.abs().max(1.0);
        if error > worst.0 {
            worst = (error, p, expected, actual);
        }
    }
    worst
}

#[test]
fn every_recorded_value_is_met() {
    let samples = samples();
    assert_eq!(samples.len(), 199);
    let mut failures = Vec::new();
    for sample in &samples {
        assert!(sample.points.len() >= 44, "{}", sample.statement);
        let (error, p, expected, actual) = worst(sample);
        if error > tolerance(sample.statement) {
            failures.push(format!("{}: at {p} {expected} became {actual}", sample.statement));
        }
    }
    assert!(failures.is_empty(), "{} of 199 differ:\n{}", failures.len(), failures.join("\n"));
}
