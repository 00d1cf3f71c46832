//! Choosing between textures: weights, points and normals on their way in and out.
use std::sync::Arc;

use raggio_image::{Bitmap, FileCurve, Pixels};
use raggio_math::{Vec3, transform};
use raggio_scene as scene;
use raggio_scene::{Color, Finish, Pattern, PatternKind, Pigment, TextureKind, Warp, Wave};
use raggio_shading::{Context, Noise, Texture, TextureMap};

fn plain(color: Color) -> Arc<scene::Texture> {
    let layer =
        scene::Layer { pigment: Arc::new(Pigment::solid(color)), normal: None, finish: Finish::default() };
    Arc::new(scene::Texture { kind: TextureKind::Layers(vec![layer]) })
}

fn glass() -> Color {
    Color { transmit: 0.5, ..Color::WHITE }
}

fn pattern(kind: PatternKind, warps: Vec<Warp>) -> Arc<Pattern> {
    Arc::new(Pattern { kind, warps, wave: Wave::Ramp, frequency: 1.0, phase: 0.0, noise_generator: 0 })
}

fn patterned(pattern: Arc<Pattern>, entries: Vec<(f32, Arc<scene::Texture>)>) -> Texture {
    compile(TextureKind::Patterned { pattern, map: entries })
}

fn compile(kind: TextureKind) -> Texture {
    Texture::compile(&scene::Texture { kind }, Noise::default())
}

fn choice(texture: &Texture) -> &TextureMap {
    match texture {
        Texture::Map(map) => map,
        other => panic!("{other:?} chooses nothing"),
    }
}

/// What is chosen at a point: red of the first layer's pigment, weight, and where to ask.
fn chosen(texture: &Texture, p: Vec3) -> Vec<(f32, f32, Vec3)> {
    let mut all = Vec::new();
    choice(texture).select(p, &Context::NONE, &mut |texture, weight, at| {
        if let Texture::Layers(layers) = texture {
            let red = layers[0].pigment.eval(at, &Context::NONE).map_or(f32::NAN, |c| c.rgb.x);
            all.push((red, weight, at));
        }
    });
    all
}

fn doubled() -> Vec<Warp> {
    let forward = transform::scale(Vec3::new(2.0, 1.0, 1.0));
    vec![Warp::Transform { forward, inverse: forward.inverse() }]
}

#[test]
fn a_map_mixes_its_neighbours_at_the_warped_point() {
    let entries = vec![(0.0, plain(Color::BLACK)), (1.0, plain(Color::WHITE))];
    let texture = patterned(pattern(PatternKind::Gradient(Vec3::X), doubled()), entries);
    let at = Vec3::new(0.25, 0.5, 0.0);
    assert_eq!(chosen(&texture, Vec3::new(0.5, 0.5, 0.0)), [(0.0, 0.75, at), (1.0, 0.25, at)]);
    assert_eq!(chosen(&texture, Vec3::ZERO), [(0.0, 1.0, Vec3::ZERO)]);
}

#[test]
fn an_average_uses_all_by_weight() {
    let entries = vec![(1.0, plain(Color::BLACK)), (3.0, plain(Color::WHITE))];
    let texture = patterned(pattern(PatternKind::Average, Vec::new()), entries);
    assert_eq!(chosen(&texture, Vec3::ONE), [(0.0, 0.25, Vec3::ONE), (1.0, 0.75, Vec3::ONE)]);
}

#[test]
fn a_material_map_takes_the_palettes_index() {
    let pixels = Pixels::Palette { indices: vec![1, 0, 3, 2], colors: vec![[0, 0, 0, 255]; 4] };
    let bitmap = Bitmap { width: 2, height: 2, pixels, curve: FileCurve::None, premultiplied: false };
    let image = scene::ImageMap::new(bitmap.into());
    let textures = vec![plain(Color::BLACK), plain(Color::WHITE)];
    let texture = compile(TextureKind::MaterialMap { warps: Vec::new(), image: Arc::new(image), textures });
    let red = |x: f64, y: f64| chosen(&texture, Vec3::new(x, y, 0.0))[0].0;
    // Rows run from the top: index 1 then 0; below 3, which is 1 again, then 2, which takes the last.
    assert_eq!([red(0.2, 0.7), red(0.7, 0.7), red(0.2, 0.2), red(0.7, 0.2)], [1.0, 0.0, 1.0, 1.0]);
}

#[test]
fn normals_go_in_and_come_back() {
    let texture = patterned(pattern(PatternKind::Bozo, doubled()), vec![(0.0, plain(Color::BLACK))]);
    let n = Vec3::new(1.0, 1.0, 0.0).normalize();
    let inside = choice(&texture).normal_in(n);
    assert!((inside - Vec3::new(2.0, 1.0, 0.0).normalize()).length() < 1e-12);
    assert!((choice(&texture).normal_out(inside) - n).length() < 1e-12);
}

#[test]
fn one_opaque_layer_stops_all_light() {
    let glassy = |colors: &[Color]| {
        let layers = colors.iter().map(|&color| scene::Layer {
            pigment: Arc::new(Pigment::solid(color)),
            normal: None,
            finish: Finish::default(),
        });
        compile(TextureKind::Layers(layers.collect())).is_opaque()
    };
    assert!(glassy(&[Color::WHITE, glass()]) && !glassy(&[glass(), glass()]));
    let mixed = vec![(0.0, plain(Color::WHITE)), (1.0, plain(glass()))];
    assert!(!patterned(pattern(PatternKind::Bozo, Vec::new()), mixed).is_opaque());
}

#[test]
fn parts_shared_in_deep_nesting_are_compiled_once() {
    let mut pigment = Arc::new(Pigment::solid(Color::WHITE));
    for _ in 0..60 {
        let map = vec![(0.0, pigment.clone()), (1.0, pigment)];
        let kind = scene::PigmentKind::PigmentMap { pattern: pattern(PatternKind::Bozo, Vec::new()), map };
        pigment = Arc::new(Pigment { kind, quick_color: None });
    }
    assert!(raggio_shading::Pigment::compile(&pigment, Noise::default()).is_opaque());
}

/// Wrinkles where a crackle of the same wrinkles says so; in the same place in memory, or in places of their own.
fn wrinkled(alike: bool) -> raggio_shading::Pigment {
    let wrinkles = || {
        let map = vec![(0.0, Color::BLACK), (1.0, Color::WHITE)];
        let pattern = pattern(PatternKind::Wrinkles, doubled());
        let kind = scene::PigmentKind::ColorMap { pattern, map: map.into() };
        Arc::new(Pigment { kind, quick_color: None })
    };
    let first = wrinkles();
    let again = || if alike { first.clone() } else { wrinkles() };
    let map = vec![(0.1, again()), (0.5, Arc::new(Pigment::solid(glass()))), (0.9, again())];
    let pattern = pattern(PatternKind::Pigment(again()), Vec::new());
    let kind = scene::PigmentKind::PigmentMap { pattern, map };
    raggio_shading::Pigment::compile(&Pigment { kind, quick_color: None }, Noise::default())
}

#[test]
fn a_pigment_used_twice_gives_what_two_pigments_give() {
    let (one, two) = (wrinkled(true), wrinkled(false));
    for i in 0..100 {
        let p = Vec3::new(0.1 * f64::from(i / 2), 3.0, 0.7);
        assert_eq!(one.eval(p, &Context::NONE), two.eval(p, &Context::NONE), "{p}");
    }
}
