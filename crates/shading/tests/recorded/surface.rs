//! Patterns that look at the surface, against pictures of a sphere by the language's reference renderer (16 bits).
use crate::statement::{bare, transformed};
use raggio_math::{Vec2, Vec3, transform};
use raggio_scene::{FractalKind, FractalSettings, Pattern as ScenePattern, PatternKind, SlopeSettings};
use raggio_shading::{Context, Noise, Pattern};

const PLAIN: SlopeSettings = SlopeSettings {
    direction: Vec3::Y,
    point_at: false,
    slope_range: (0.0, 0.0),
    altitude: None,
    altitude_range: (0.0, 0.0),
};

fn moved(kind: PatternKind) -> ScenePattern {
    let mut pattern = bare(kind);
    transformed(&mut pattern, transform::scale(Vec3::splat(0.5)));
    transformed(&mut pattern, transform::translate(Vec3::new(0.2, 0.3, 0.0)));
    pattern
}

fn by_name(name: &str) -> ScenePattern {
    let slope = |settings| PatternKind::Slope(settings);
    let to = SlopeSettings { direction: Vec3::new(3.0, 2.0, -1.0), point_at: true, ..PLAIN };
    let up = SlopeSettings { direction: Vec3::new(0.0, 2.0, -1.0), ..PLAIN };
    match name {
        "slope" => bare(slope(SlopeSettings {
            direction: Vec3::new(1.0, 2.0, -0.5),
            slope_range: (0.2, 0.9),
            ..PLAIN
        })),
        "slope altitude" => bare(slope(SlopeSettings {
            slope_range: (0.1, 0.8),
            altitude: Some(3.0 * Vec3::Y),
            altitude_range: (-1.0, 2.0),
            ..up
        })),
        "point at" => bare(slope(to)),
        "point at range" => moved(slope(SlopeSettings { slope_range: (0.3, 0.8), ..to })),
        "altitude scaled" => moved(slope(SlopeSettings {
            altitude: Some(Vec3::new(0.0, 2.0, 1.0)),
            altitude_range: (-1.0, 2.0),
            ..up
        })),
        "aoi" => bare(PatternKind::Aoi),
        other => panic!("no pattern {other}"),
    }
}

/// The front of the recorded sphere seen along z.
fn hit(x: f64, y: f64) -> Context {
    let (center, radius) = (Vec3::new(0.1, 0.2, 0.3), 1.4);
    let aside = Vec2::new(x, y) - center.truncate();
    let point = Vec3::new(x, y, center.z - (radius * radius - aside.length_squared()).sqrt());
    Context { normal: Some((point - center) / radius), point, ray_dir: Vec3::Z, uv: Vec2::ZERO }
}

/// The recorded pictures' size, and the width and height of what they show.
const COLUMNS: usize = 25;
const ROWS: usize = 20;
const EXTENT: f64 = 1.9;

/// Pictures of 16 bits are right to half a step.
const HALF_STEP: f64 = 0.5 / 65_535.0 + 1e-6;

#[test]
fn slopes_and_angles_are_the_recorded_ones() {
    let mut names = 0;
    for line in include_str!("../data/slope.csv").lines() {
        let (name, values) = line.split_once('|').expect("values");
        let pattern = Pattern::compile(&by_name(name), Noise::default());
        let values: Vec<f64> = values.split('|').map(|v| v.parse().expect("a number")).collect();
        assert_eq!(values.len(), COLUMNS * ROWS, "{name}");
        for (i, expected) in values.into_iter().enumerate() {
            let across = ((i % COLUMNS) as f64 + 0.5) / COLUMNS as f64 - 0.5;
            let down = ((i / COLUMNS) as f64 + 0.5) / ROWS as f64 - 0.5;
            let context = hit(0.1 + EXTENT * across, 0.2 - EXTENT * down);
            let value = pattern.eval(context.point, &context);
            assert!(
                (value - expected).abs() <= HALF_STEP,
                "{name} {}: {expected} became {value}",
                context.point
            );
        }
        names += 1;
    }
    assert_eq!(names, 6);
}

#[test]
fn without_a_surface_they_are_zero() {
    for name in ["slope", "slope altitude", "aoi"] {
        let pattern = Pattern::compile(&by_name(name), Noise::default());
        assert_eq!(pattern.eval(Vec3::ONE, &Context::NONE), 0.0);
    }
}

/// Columns: x, y, magnet 1 julia, magnet 1 mandel, magnet 2 julia.
#[test]
fn magnets_inside_measure_their_orbits() {
    let magnet = |kind, julia: Option<Vec2>, iterations| {
        let settings = FractalSettings {
            kind,
            julia,
            iterations,
            exterior_type: 0,
            exterior_factor: 0.25,
            interior_type: 1,
            interior_factor: 1.0,
        };
        Pattern::compile(&bare(PatternKind::Fractal(settings)), Noise::default())
    };
    let patterns = [
        magnet(FractalKind::Magnet1, Some(Vec2::new(0.5, 0.3)), 30),
        magnet(FractalKind::Magnet1, None, 30),
        magnet(FractalKind::Magnet2, Some(Vec2::new(1.5, 0.3)), 10),
    ];
    for line in include_str!("../data/magnet.csv").lines() {
        let n: Vec<f64> = line.split(',').map(|f| f.parse().expect("a number")).collect();
        for (pattern, expected) in patterns.iter().zip(&n[2..]) {
            let value = pattern.eval(Vec3::new(n[0], n[1], 0.0), &Context::NONE);
            assert!((value - expected).abs() < 1e-8, "{line}: {value}");
        }
    }
}
