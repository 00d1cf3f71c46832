//! Radiosity: closed furnaces, and a picture recorded from POV-Ray 3.7 (radiosity spec, appendix).
mod stage;

use std::sync::Arc;

use raggio_math::Vec3;
use raggio_scene::*;
use stage::*;

fn settings() -> RadiositySettings {
    RadiositySettings { count: 50, recursion_limit: 1, ..RadiositySettings::default() }
}

fn matt(diffuse: f32) -> Finish {
    Finish { diffuse, diffuse_raw: diffuse, ..glowing(0.0) }
}

fn down() -> Camera {
    let mut camera = view(CameraKind::Orthographic, v(0.0, 10.0, 0.0), 16.0, 16.0);
    camera.direction = v(0.0, -1.0, 0.0);
    camera.up = v(0.0, 0.0, 16.0);
    camera
}

fn gradient(along: Vec3, wave: Wave) -> Pattern {
    Pattern {
        kind: PatternKind::Gradient(along),
        warps: Vec::new(),
        wave,
        frequency: 1.0,
        phase: 0.0,
        noise_generator: 0,
    }
}

/// A floor under a sky that goes from black at the horizon to orange at the zenith.
fn open_floor() -> Scene {
    let floor = texture(rgbft([0.9, 0.8, 0.7, 0.0, 0.0]), matt(0.8));
    let mut scene = scene(down(), vec![plane(v(0.0, 1.0, 0.0), 0.0, floor)]);
    let map = Arc::new(vec![(0.0, Color::BLACK), (1.0, rgbft([1.0, 0.5, 0.25, 0.0, 0.0]))]);
    let pigment = Pigment {
        kind: PigmentKind::ColorMap { pattern: Arc::new(gradient(v(0.0, 1.0, 0.0), Wave::Ramp)), map },
        quick_color: None,
    };
    scene.atmosphere.sky_sphere =
        Some(SkySphere { pigments: vec![Placed::new(Arc::new(pigment))], emission: Rgb::ONE });
    scene.settings.radiosity = Some(settings());
    scene
}

#[test]
fn an_open_floor_under_a_sky() {
    let film = render(&open_floor(), &options(40, 40));
    // Which samples there are depends on the order of tiles, so that single pixels differ a little.
    expect(&film, 5, 5, [0.48128, 0.48128 * 4.0 / 9.0, 0.48128 * 7.0 / 36.0], 0.01);
    expect(&film, 34, 27, [0.47955, 0.47955 * 4.0 / 9.0, 0.47955 * 7.0 / 36.0], 0.01);
    // The mean of y over the hemisphere by cosine is 2/3.
    let mean = film.pixels.iter().map(|p| p[0]).sum::<f32>() / 1600.0;
    assert!((mean - 0.9 * 0.8 * 2.0 / 3.0).abs() < 0.01, "{mean}");
}

/// Bumps so steep that they look down into the floor do not turn it over.
#[test]
fn steep_bumps_gather_as_a_flat_floor_does() {
    let mut scene = open_floor();
    scene.camera = view(CameraKind::Perspective, v(0.0, 1.0, 0.0), 1.0, 1.0);
    scene.camera.direction = v(0.0, -0.6, 0.8);
    let flat = render(&scene, &options(20, 20));
    let floor = Arc::make_mut(&mut scene.objects[0]);
    let texture = Arc::make_mut(&mut floor.texture.as_mut().expect("a texture").item);
    let TextureKind::Layers(layers) = &mut texture.kind else { panic!("layers") };
    let kind = NormalKind::Slope { pattern: Arc::new(gradient(v(0.0, 1.0, 1.0), Wave::Sine)), map: None };
    layers[0].normal = Some(Arc::new(Normal { kind, amount: 5.0, accuracy: 0.02, no_bump_scale: false }));
    assert_eq!(render(&scene, &options(20, 20)).pixels, flat.pixels);
}

#[test]
fn a_furnace_settles_at_its_known_light() {
    // Inside a sphere that shines with e and reflects r the light is e (1 + r + r^2 + ...), cut off at the limit.
    let (e, r, depth) = (0.2, 0.5, 3u32);
    let finish = Finish { emission: Rgb::splat(e), ..matt(r) };
    let wall = sphere(v(0.0, 0.0, 0.0), 10.0, texture(Color::WHITE, finish));
    let mut scene = scene(view(CameraKind::Perspective, v(1.0, 2.0, 3.0), 1.0, 1.0), vec![wall]);
    scene.settings.radiosity = Some(RadiositySettings { recursion_limit: depth, ..settings() });
    scene.settings.max_trace_level = 20;
    let film = render(&scene, &options(8, 8));
    let expected = e * (0..=depth as i32).map(|k| r.powi(k)).sum::<f32>();
    for y in 0..8 {
        expect(&film, 4, y, [expected; 3], 2e-4);
    }
}

#[test]
fn the_picture_does_not_depend_on_threads() {
    for recursion_limit in 1..=2 {
        let mut scene = open_floor();
        scene.settings.radiosity = Some(RadiositySettings { recursion_limit, ..settings() });
        let with = |threads| render(&scene, &raggio_render::Options { threads, ..options(70, 40) });
        let one = with(1);
        assert!(one.pixels == with(2).pixels && one.pixels == with(7).pixels, "{recursion_limit}");
    }
}
