//! Bent normals against those recovered from pictures of the language's reference renderer: a tilted plane under
//! three coloured lights, 16 bits a channel (`data/facets.pov` is one of the scenes).
use std::sync::Arc;

use crate::statement::{self, pictures::image_map};
use raggio_math::{Vec2, Vec3};
use raggio_scene::{
    ImageMap, Interpolation, Normal as SceneNormal, NormalKind, NormalPattern, PatternKind, Warp,
};
use raggio_shading::{Context, Noise, Normal};

fn normal(kind: NormalKind, amount: f32) -> SceneNormal {
    SceneNormal { kind, amount, accuracy: 0.02, no_bump_scale: false }
}

/// A normal with a rule of its own; `settings` names any pattern with the modifiers that are wanted.
fn special(pattern: NormalPattern, settings: &str, amount: f32) -> SceneNormal {
    normal(NormalKind::Special { pattern, settings: Arc::new(statement::pattern(settings)) }, amount)
}

fn slope(settings: &str, amount: f32) -> SceneNormal {
    normal(NormalKind::Slope { pattern: Arc::new(statement::pattern(settings)), map: None }, amount)
}

fn map(settings: &str, entries: Vec<(f32, SceneNormal)>) -> SceneNormal {
    let map = entries.into_iter().map(|(at, entry)| (at, Arc::new(entry))).collect();
    normal(NormalKind::Map { pattern: Arc::new(statement::pattern(settings)), map }, 0.5)
}

fn kept(normal: SceneNormal) -> SceneNormal {
    SceneNormal { no_bump_scale: true, ..normal }
}

fn facets(size: f64, coords: f64, metric: f64) -> SceneNormal {
    special(NormalPattern::Facets { size, coords, metric }, "bozo", 0.5)
}

fn bump_map(image: ImageMap, settings: &str, size: f32) -> SceneNormal {
    let warps: Vec<Warp> = statement::pattern(settings).warps;
    normal(NormalKind::Bump { warps, image: Arc::new(image) }, size)
}

fn slope_map() -> SceneNormal {
    let knots = vec![(0.1, 0.0, 1.0), (0.4, 1.0, 0.5), (0.4, 0.3, 0.0), (1.0, 0.2, -1.0)];
    let pattern = Arc::new(statement::pattern("gradient x scale 0.7"));
    normal(NormalKind::Slope { pattern, map: Some(knots) }, 0.2)
}

fn average() -> SceneNormal {
    let mut pattern = statement::pattern("bozo scale <0.5,1,1>");
    pattern.kind = PatternKind::Average;
    let entries = [
        (1.0, special(NormalPattern::Bumps, "bumps", 0.3)),
        (2.0, special(NormalPattern::Wrinkles, "wrinkles scale 0.5", 0.2)),
    ];
    let map = entries.into_iter().map(|(weight, entry)| (weight, Arc::new(entry))).collect();
    normal(NormalKind::Map { pattern: Arc::new(pattern), map }, 0.5)
}

fn by_name(name: &str) -> SceneNormal {
    use NormalPattern::{Bumps, Dents, Quilted, Ripples, Waves, Wrinkles};
    let turned = "bumps scale <0.3,0.6,0.9> rotate <20,40,60>";
    match name {
        "bumps" => special(Bumps, "bumps", 0.3),
        "bumps scaled" => special(Bumps, turned, 0.4),
        "bumps kept" => kept(special(Bumps, turned, 0.3)),
        "dents" => special(Dents, "dents scale 0.5 turbulence 0.3", 0.8),
        "dents 3" => special(Dents, "dents noise_generator 3", 0.8),
        "wrinkles" => special(Wrinkles, "wrinkles", 0.2),
        "quilted" => special(Quilted { control0: 0.2, control1: 1.3 }, "quilted scale 0.6", 0.4),
        "ripples" => special(Ripples, "ripples frequency 2 phase 0.3", 0.3),
        "waves" => special(Waves, "waves frequency 2 phase 0.1", 0.2),
        "facets snap" => facets(0.3, 0.0, 2.0),
        "facets" => facets(0.4, 0.5, 2.0),
        "facets 1" => facets(0.4, 0.3, 1.0),
        "facets 3" => facets(0.4, 0.3, 3.0),
        "granite" => SceneNormal { accuracy: 0.05, ..slope("granite", 0.1) },
        "slope map" => slope_map(),
        "marble" => slope("marble turbulence 0.5", 0.15),
        "wood" => slope("wood sine_wave frequency 2 rotate 30*x scale 0.8", 0.2),
        "crackle" => slope("crackle scale 0.5", 0.2),
        "checker" => map(
            "checker scale 0.7",
            vec![(0.0, special(Bumps, "bumps", 0.3)), (1.0, special(Dents, "dents scale 0.3", 0.7))],
        ),
        "map" => map(
            "bozo turbulence 0.4 scale 0.4 rotate 30*z",
            vec![(0.3, special(Bumps, "bumps", 0.3)), (0.7, special(Dents, "dents scale 0.2", 0.9))],
        ),
        "map kept" => kept(map(
            "bozo scale 0.4",
            vec![(0.3, special(Bumps, "bumps scale 0.5", 0.2)), (0.7, special(Dents, "dents", 0.9))],
        )),
        "average" => average(),
        "bump map" => bump_map(
            ImageMap { interpolation: Interpolation::Bilinear, ..image_map("tex_rgb.png") },
            "bozo",
            0.5,
        ),
        "bump map index" => {
            bump_map(ImageMap { use_index: true, ..image_map("tex_pal.png") }, "bozo scale 2", 0.1)
        }
        "bump map once" => {
            let image =
                ImageMap { once: true, interpolation: Interpolation::Bicubic, ..image_map("tex_rgb.png") };
            bump_map(image, "bozo rotate 20*y", 0.8)
        }
        other => panic!("no normal {other}"),
    }
}

/// The facing normal of the recorded plane.
fn facing() -> Vec3 {
    Vec3::new(0.2, 0.3, -1.0).normalize()
}

#[test]
fn bent_normals_are_the_recorded_ones() {
    let mut failures = Vec::new();
    let (mut name, mut compiled, mut points) = ("", None, 0);
    for line in include_str!("../data/normals.csv").lines().skip(1) {
        let mut fields = line.split(',');
        let this = fields.next().expect("a name");
        let numbers: Vec<f64> = fields.map(|f| f.parse().expect("a number")).collect();
        if this != name {
            (name, compiled) = (this, Some(Normal::compile(&by_name(this), Noise::default())));
        }
        let (p, expected) = (Vec3::from_slice(&numbers[..3]), Vec3::from_slice(&numbers[3..]));
        let bent = compiled.as_ref().expect("a normal").perturb(facing(), p, &Context::NONE).normalize();
        points += 1;
        if (bent - expected).length() > 1e-4 {
            failures.push(format!("{name} at {p}: {expected} became {bent}"));
        }
    }
    assert_eq!(points, 3007);
    assert!(failures.is_empty(), "{} of {points} differ:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn uv_mapping_asks_at_the_texture_coordinates() {
    let bumps = special(NormalPattern::Bumps, "bumps scale 0.3", 0.3);
    let uv = normal(NormalKind::Uv(Arc::new(bumps.clone())), 0.5);
    let context = Context { uv: Vec2::new(0.3, 0.8), ..Context::NONE };
    let bent = Normal::compile(&uv, Noise::default()).perturb(facing(), Vec3::splat(7.0), &context);
    let direct = Normal::compile(&bumps, Noise::default());
    assert_eq!(bent, direct.perturb(facing(), Vec3::new(0.3, 0.8, 0.0), &context));
}

#[test]
fn hopeless_bumps_leave_the_normal_alone() {
    let bumps = Normal::compile(&special(NormalPattern::Bumps, "bumps", f32::INFINITY), Noise::default());
    assert_eq!(bumps.perturb(Vec3::Z, Vec3::splat(0.3), &Context::NONE), Vec3::Z);
}
