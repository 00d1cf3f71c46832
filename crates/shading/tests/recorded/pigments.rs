//! Pigments against colours that the language's reference renderer gives for the same statements.
use std::sync::Arc;

use crate::statement::{self, pictures::image_map};
use raggio_function::External;
use raggio_image::Curve;
use raggio_math::Vec3;
use raggio_scene::{Color, ImageMap, Interpolation, MapType, Pigment as ScenePigment, PigmentKind, Warp};
use raggio_shading::{Context, Noise, Pigment, PigmentFunction};

fn pigment(kind: PigmentKind) -> ScenePigment {
    ScenePigment { kind, quick_color: None }
}

fn color(c: [f64; 5]) -> Color {
    Color::from_array(c)
}

fn solid(c: [f64; 5]) -> Arc<ScenePigment> {
    Arc::new(ScenePigment::solid(color(c)))
}

fn color_map(settings: &str, map: Vec<(f32, Color)>) -> ScenePigment {
    pigment(PigmentKind::ColorMap { pattern: Arc::new(statement::pattern(settings)), map: Arc::new(map) })
}

fn stripes(settings: &str) -> Arc<ScenePigment> {
    let ends = vec![(0.0, Color::opaque(1.0, 0.0, 0.0)), (1.0, Color::opaque(0.0, 1.0, 1.0))];
    Arc::new(color_map(settings, ends))
}

fn pigment_map(settings: &str, map: Vec<(f32, Arc<ScenePigment>)>) -> ScenePigment {
    pigment(PigmentKind::PigmentMap { pattern: Arc::new(statement::pattern(settings)), map })
}

fn average() -> ScenePigment {
    let mut pattern = statement::pattern("bozo scale <0.5,1,1>");
    pattern.kind = raggio_scene::PatternKind::Average;
    let map = vec![(1.0, stripes("gradient x scale 0.3")), (3.0, solid([0.2, 0.9, 0.1, 0.0, 0.5]))];
    pigment(PigmentKind::PigmentMap { pattern: Arc::new(pattern), map })
}

fn converted(name: &str, from: Curve) -> ImageMap {
    ImageMap { conversion: Some((from, Curve::Linear)), ..image_map(name) }
}

fn image(settings: &str, image: ImageMap) -> ScenePigment {
    let warps: Vec<Warp> = statement::pattern(settings).warps;
    pigment(PigmentKind::Image { warps, image: Arc::new(image) })
}

fn image_by_name(name: &str) -> ScenePigment {
    let rgb = || converted("tex_rgb.png", Curve::Srgb);
    let rgba = || converted("tex_rgba.png", Curve::Srgb);
    let bilinear = |map: ImageMap| ImageMap { interpolation: Interpolation::Bilinear, ..map };
    match name {
        "image" => image("bozo", rgb()),
        "image bilinear" => image("bozo scale 1.3 rotate 20*z", bilinear(rgb())),
        "image alpha" => image("bozo", ImageMap { filter_all: 0.2, transmit_all: 0.1, ..bilinear(rgba()) }),
        "image premultiplied" => image("bozo", ImageMap { premultiplied: true, ..bilinear(rgba()) }),
        "image once" => {
            image("bozo", ImageMap { once: true, interpolation: Interpolation::Bicubic, ..rgba() })
        }
        "image palette" => image(
            "bozo",
            ImageMap {
                interpolation: Interpolation::NormalizedDistance,
                filter_all: 0.3,
                transmit_index: vec![(2, 0.5)],
                filter_index: vec![(3, 0.7)],
                ..converted("tex_pal.png", Curve::Srgb)
            },
        ),
        "image turbulent" => image("bozo turbulence 0.3", bilinear(rgb())),
        "image raw" => image("bozo", bilinear(image_map("tex_rgb.png"))),
        "image 1.8" => image(
            "bozo",
            ImageMap { map_type: MapType::Spherical, ..converted("tex_rgb.png", Curve::Power(1.8)) },
        ),
        other => panic!("no pigment {other}"),
    }
}

fn by_name(name: &str) -> ScenePigment {
    match name {
        "map" => color_map(
            "bozo turbulence 0.3 scale 0.4",
            vec![
                (0.2, color([1.0, 0.2, 0.0, 0.0, 0.0])),
                (0.5, color([0.0, 1.0, 0.3, 0.4, 0.2])),
                (0.5, color([0.0, 0.0, 1.0, 0.0, 0.0])),
                (0.8, color([0.3, 0.1, 0.9, 0.0, 0.5])),
            ],
        ),
        "pigments" => pigment_map(
            "bozo turbulence 0.4 scale 0.5 rotate 30*z",
            vec![(0.3, stripes("gradient x scale 0.3")), (0.7, solid([0.2, 0.9, 0.1, 0.5, 0.0]))],
        ),
        "average" => average(),
        "checker" => pigment_map(
            "checker scale 0.3",
            vec![(0.0, stripes("gradient x")), (1.0, solid([0.1, 0.2, 0.3, 0.0, 0.0]))],
        ),
        other => image_by_name(other),
    }
}

#[test]
fn colours_are_the_recorded_ones() {
    let (mut failures, mut points) = (Vec::new(), 0);
    for line in include_str!("../data/pigments.csv").lines().skip(1) {
        let mut fields = line.split(',');
        let name = fields.next().expect("a name");
        let n: Vec<f64> = fields.map(|f| f.parse().expect("a number")).collect();
        let actual = PigmentFunction::new(Arc::new(by_name(name)), Noise::default()).eval(&n[..3]);
        points += 1;
        if actual.iter().zip(&n[3..]).any(|(a, b)| (a - b).abs() > 2e-6) {
            failures.push(format!("{line} became {actual:?}"));
        }
    }
    assert_eq!(points, 260);
    assert!(failures.is_empty(), "{} of {points} differ:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn beside_a_picture_used_once_there_is_no_colour() {
    let once = Arc::new(by_name("image once"));
    let alone = Pigment::compile(&once, Noise::default());
    assert_eq!(alone.eval(Vec3::new(1.5, 0.5, 0.0), &Context::NONE), None);
    assert!(alone.eval(Vec3::new(0.5, 0.5, 0.0), &Context::NONE).is_some());
    let mixed = pigment_map("gradient y", vec![(0.0, once.clone()), (1.0, solid([0.0; 5]))]);
    let mixed = Pigment::compile(&mixed, Noise::default());
    let found = mixed.eval(Vec3::new(1.5, 0.25, 0.0), &Context::NONE);
    assert_eq!(found, Some(color([0.75, 0.75, 0.75, 0.0, 0.75])), "found where either part is");
}

#[test]
fn opacity_is_known_before_the_first_ray() {
    let opaque = |pigment: &ScenePigment| Pigment::compile(pigment, Noise::default()).is_opaque();
    assert!(opaque(&by_name("checker")) && opaque(&by_name("image")));
    for clear in ["map", "pigments", "average", "image alpha", "image once", "image palette"] {
        assert!(!opaque(&by_name(clear)), "{clear}");
    }
}

#[test]
fn quick_colour_and_uv_pass_through() {
    let mut quick = ScenePigment::solid(Color::WHITE);
    quick.quick_color = Some(Color::BLACK);
    assert_eq!(Pigment::compile(&quick, Noise::default()).quick_color(), Some(Color::BLACK));
    let uv = pigment(PigmentKind::Uv(stripes("gradient x")));
    let context = Context { uv: raggio_math::Vec2::new(0.25, 0.0), ..Context::NONE };
    let found = Pigment::compile(&uv, Noise::default()).eval(Vec3::splat(9.0), &context);
    assert_eq!(found, Some(Color::opaque(0.75, 0.25, 0.25)));
}
