//! Media against values recorded from POV-Ray 3.7 (media spec, appendix) and against closed formulas.
mod stage;

use std::sync::Arc;

use raggio_math::transform;
use raggio_scene::*;
use stage::*;

/// `density { gradient z scale ... translate ... }`
fn ramp(scale: f64, shift: f64) -> Placed<Density> {
    let forward = transform::translate(v(0.0, 0.0, shift)) * transform::scale(v(scale, scale, scale));
    let pattern = Pattern {
        kind: PatternKind::Gradient(v(0.0, 0.0, 1.0)),
        warps: vec![Warp::Transform { forward, inverse: forward.inverse() }],
        wave: Wave::Ramp,
        frequency: 1.0,
        phase: 0.0,
        noise_generator: 0,
    };
    let map = Arc::new(vec![(0.0, Color::BLACK), (1.0, Color::WHITE)]);
    let kind = PigmentKind::ColorMap { pattern: Arc::new(pattern), map };
    Placed::new(Arc::new(Density(Arc::new(Pigment { kind, quick_color: None }))))
}

/// A clear box, 2 thick, filled with a medium.
fn filled(media: Media) -> Object {
    let clear = texture(rgbft([1.0, 1.0, 1.0, 0.0, 1.0]), glowing(0.0));
    let interior = Interior { media: vec![Placed::new(Arc::new(media))], ..Interior::default() };
    let mut object = inside(block(v(-5.0, -5.0, 0.0), v(5.0, 5.0, 2.0), clear), interior);
    object.hollow = Some(true);
    object
}

fn ahead() -> Camera {
    view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 4.0, 3.0)
}

fn seen(objects: Vec<Object>) -> f32 {
    pixel(&render(&scene(ahead(), objects), &options(1, 1)), 0, 0).x
}

fn scattered(kind: u8, eccentricity: f32, extinction: f32) -> f32 {
    let mut sun = Light::new(v(0.0, 0.0, -100.0), Rgb::ONE);
    sun.parallel = true;
    sun.point_at = v(0.0, 0.0, 0.0);
    let scattering = Some(Scattering { kind, color: Rgb::splat(0.1), eccentricity, extinction });
    seen(vec![shine(sun), filled(Media { scattering, ..Media::default() })])
}

#[test]
fn all_kinds_of_scattering() {
    for (kind, eccentricity, extinction, recorded) in [
        (1, 0.0, 1.0, 0.16985),
        (2, 0.0, 1.0, 0.09795),
        (3, 0.0, 1.0, 0.08420),
        (4, 0.0, 1.0, 0.27155),
        (5, 0.4, 0.5, 0.05634),
    ] {
        let got = scattered(kind, eccentricity, extinction);
        assert!((got - recorded).abs() < 2e-5, "kind {kind}: {got}, recorded {recorded}");
    }
}

#[test]
fn method_3_with_a_density() {
    for (samples, recorded) in [(1, 0.13333), (4, 0.15), (10, 0.17143)] {
        let media = Media {
            emission: Rgb::splat(0.4),
            samples: (samples, samples),
            aa_threshold: 0.01,
            densities: vec![ramp(4.0, 0.0)],
            ..Media::default()
        };
        let got = seen(vec![filled(media)]);
        assert!((got - recorded).abs() < 2e-5, "{samples} samples: {got}, recorded {recorded}");
    }
}

#[test]
fn absorption_and_emission_over_a_background() {
    for (samples, recorded) in [(10, 0.32119), (1, 0.34459)] {
        let media = Media {
            emission: Rgb::splat(0.1),
            absorption: Rgb::splat(0.5),
            samples: (samples, samples),
            ..Media::default()
        };
        let mut scene = scene(ahead(), vec![filled(media)]);
        scene.atmosphere.background = Some(Background { color: rgbft([0.5, 0.5, 0.5, 0.0, 0.0]) });
        let got = pixel(&render(&scene, &options(1, 1)), 0, 0).x;
        assert!((got - recorded).abs() < 2e-5, "{samples} samples: {got}, recorded {recorded}");
    }
}

/// The mean of many pixels, each with random samples of its own.
fn mean(media: Media) -> f32 {
    let film = render(&scene(ahead(), vec![filled(media)]), &options(64, 64));
    film.pixels.iter().map(|p| p[0]).sum::<f32>() / film.pixels.len() as f32
}

#[test]
fn random_methods_are_right_on_average() {
    // The integral of 0.4 z / 4 over 0..2.
    let glow = |method, intervals, samples| Media {
        method,
        intervals,
        samples,
        jitter: 0.8,
        emission: Rgb::splat(0.4),
        densities: vec![ramp(4.0, 0.0)],
        ..Media::default()
    };
    assert!((mean(glow(1, 2, (3, 3))) - 0.2).abs() < 2e-3);
    // Jitter of method 2 moves samples forward, by 0.4 of a third of an interval on average.
    assert!((mean(glow(2, 2, (3, 3))) - (0.2 + 0.2 * 0.4 / 3.0)).abs() < 2e-3);
    let more = Media { variance: 0.001, ..glow(1, 1, (2, 20)) };
    assert!((mean(more) - 0.2).abs() < 5e-3);
}

#[test]
fn absorption_dims_light_on_its_way_to_a_surface() {
    let media = Media { absorption: Rgb::splat(0.5), ..Media::default() };
    let floor = plane(v(0.0, 0.0, -1.0), -3.0, {
        let matt = Finish { diffuse: 1.0, diffuse_raw: 1.0, ..glowing(0.0) };
        texture(Color::WHITE, matt)
    });
    let mut sun = Light::new(v(0.0, 0.0, -100.0), Rgb::ONE);
    sun.parallel = true;
    sun.point_at = v(0.0, 0.0, 0.0);
    let got = seen(vec![shine(sun), filled(media), floor]);
    // Through the box once as light and once as the camera's ray.
    assert!((got - (-2f32).exp()).abs() < 1e-5, "{got}");
}

#[test]
fn a_solid_that_is_not_hollow_shows_no_media() {
    let media = Media { emission: Rgb::splat(0.4), ..Media::default() };
    let mut solid = filled(media);
    solid.hollow = Some(false);
    assert_eq!(seen(vec![solid]), 0.0);
}
