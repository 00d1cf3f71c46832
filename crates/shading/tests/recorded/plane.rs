//! All pavements in several styles, and all tilings far from the origin.
use raggio_math::Vec3;
use raggio_scene::PatternKind;
use raggio_shading::{Context, Noise, Pattern};

use crate::statement::bare;

/// Columns: sides (0 for a tiling), tiles, pattern or number, exterior, interior, form, x, z, value.
#[test]
fn pavements_and_tilings_are_the_recorded_ones() {
    let (mut failures, mut points) = (Vec::new(), 0);
    for line in include_str!("../data/plane.csv").lines() {
        let n: Vec<f64> = line.split(',').map(|f| f.parse().expect("a number")).collect();
        let byte = |k: usize| n[k] as u8;
        let kind = match byte(0) {
            0 => PatternKind::Tiling(byte(2)),
            sides => PatternKind::Pavement {
                sides,
                tiles: byte(1),
                pattern: byte(2),
                exterior: byte(3),
                interior: byte(4),
                form: byte(5),
            },
        };
        let pattern = Pattern::compile(&bare(kind), Noise::default());
        let value = pattern.eval(Vec3::new(n[6], 0.0, n[7]), &Context::NONE);
        points += 1;
        if (value - n[8]).abs() > 2e-5 {
            failures.push(format!("{line} became {value}"));
        }
    }
    assert_eq!(points, 5204);
    assert!(failures.is_empty(), "{} of {points} differ:\n{}", failures.len(), failures.join("\n"));
}
