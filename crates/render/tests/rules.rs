//! Rules of recursion and energy that hold for every picture.
mod stage;

use raggio_render::{Antialias, AntialiasMethod, Options, Region};
use raggio_scene::*;
use stage::*;

/// Clear panes one behind the other that bend light, before a shining wall.
fn panes(count: usize, ior: f32, level: u16) -> f32 {
    let clear = texture(rgbft([1.0, 1.0, 1.0, 0.0, 1.0]), glowing(0.0));
    let mut objects = vec![plane(v(0.0, 0.0, -1.0), -50.0, texture(Color::WHITE, glowing(1.0)))];
    for i in 0..count {
        let z = i as f64;
        let pane = block(v(-50.0, -50.0, z), v(50.0, 50.0, z + 0.5), clear.clone());
        objects.push(inside(pane, Interior { ior, ..Interior::default() }));
    }
    let mut scene = scene(view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 1.0, 1.0), objects);
    scene.settings.max_trace_level = level;
    pixel(&render(&scene, &options(1, 1)), 0, 0).x
}

#[test]
fn the_trace_level_counts_rays() {
    // Two panes bend four times: the camera's ray and four more.
    assert_eq!(panes(2, 1.5, 4), 0.0);
    assert_eq!(panes(2, 1.5, 5), 1.0);
    // Rays that go straight on use up no level, but are not traced either once all levels are.
    assert_eq!(panes(2, 1.0, 2), 1.0);
    assert_eq!(panes(2, 1.0, 1), 0.0);
}

#[test]
fn hundreds_of_straight_crossings_do_not_end_the_stack() {
    assert_eq!(panes(3000, 1.0, 5), 1.0);
}

#[test]
fn rays_of_too_little_weight_are_black() {
    let mirror = |reflectivity: f32| {
        let finish = Finish {
            reflection: Reflection {
                min: Rgb::splat(reflectivity),
                max: Rgb::splat(reflectivity),
                ..Reflection::default()
            },
            ..glowing(0.0)
        };
        let wall = plane(v(0.0, 0.0, -1.0), 0.0, texture(Color::BLACK, finish));
        let mut scene = scene(view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 1.0, 1.0), vec![wall]);
        scene.settings.adc_bailout = 0.1;
        scene.atmosphere.background = Some(Background { color: Color::WHITE });
        pixel(&render(&scene, &options(1, 1)), 0, 0).x
    };
    assert_eq!(mirror(0.1), 0.1);
    assert_eq!(mirror(0.099), 0.0);
}

#[test]
fn mirrors_in_a_furnace_add_up_to_one() {
    // A closed room that shines with 1 - r and mirrors r looks white, up to what the last level loses.
    let r = 0.5;
    let finish = Finish {
        reflection: Reflection { min: Rgb::splat(r), max: Rgb::splat(r), ..Reflection::default() },
        ..glowing(1.0 - r)
    };
    let room = block(v(-3.0, -2.0, -4.0), v(3.0, 2.0, 4.0), texture(Color::WHITE, finish));
    let mut scene = scene(view(CameraKind::Perspective, v(0.317, 0.131, 0.173), 2.0, 1.5), vec![room]);
    scene.settings.max_trace_level = 12;
    scene.settings.adc_bailout = 0.0;
    let film = render(&scene, &options(8, 6));
    for (i, p) in film.pixels.iter().enumerate() {
        assert!((p[0] - (1.0 - r.powi(12))).abs() < 1e-5, "{i} {p:?}");
    }
}

#[test]
fn transparency_with_and_without_alpha() {
    let half = texture(rgbft([1.0, 0.0, 0.0, 0.0, 0.5]), glowing(1.0));
    let pane = block(v(-5.0, -5.0, 0.0), v(5.0, 5.0, 1.0), half);
    let scene = scene(view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 1.0, 1.0), vec![pane]);
    let film = render(&scene, &Options { alpha: true, ..options(1, 1) });
    // Both faces of the box count.
    assert_eq!(film.pixels[0], [0.75, 0.0, 0.0, 0.25]);
    let film = render(&scene, &options(1, 1));
    assert_eq!(film.pixels[0], [0.75, 0.0, 0.0, 0.0]);
}

/// A scene that uses random numbers in every way.
fn noisy() -> Scene {
    let mut light = Light::new(v(3.0, 6.0, -4.0), Rgb::ONE);
    light.area = Some(AreaLight {
        axis1: v(2.0, 0.0, 0.0),
        axis2: v(0.0, 0.0, 2.0),
        size1: 3,
        size2: 3,
        adaptive: Some(1),
        jitter: true,
        circular: false,
        orient: false,
        area_illumination: false,
        photons_area: false,
    });
    let rough = Finish { crand: 0.3, ..Finish::default() };
    let mut camera = view(CameraKind::Perspective, v(0.0, 1.5, -5.0), 1.4, 1.0);
    camera.focal_blur = Some(FocalBlur {
        aperture: 0.3,
        min_samples: 2,
        max_samples: 5,
        confidence: 0.9,
        variance: 1e-3,
        focal_distance: 5.0,
        bokeh: None,
    });
    scene(
        camera,
        vec![
            shine(light),
            plane(v(0.0, 1.0, 0.0), 0.0, texture(Color::WHITE, rough)),
            sphere(v(0.0, 1.0, 0.0), 1.0, texture(rgbft([0.9, 0.4, 0.2, 0.0, 0.0]), Finish::default())),
        ],
    )
}

#[test]
fn the_picture_does_not_depend_on_threads() {
    let antialias = Some(Antialias {
        method: AntialiasMethod::Recursive,
        threshold: 0.1,
        depth: 2,
        jitter: 1.0,
        gamma: 2.5,
    });
    let with = |threads, seed| render(&noisy(), &Options { threads, seed, antialias, ..options(40, 36) });
    let one = with(1, 0);
    assert!(one.pixels == with(2, 0).pixels && one.pixels == with(7, 0).pixels);
    assert!(one.pixels != with(1, 1).pixels, "the seed must change random choices");
}

#[test]
fn a_region_is_a_part_of_the_whole_picture() {
    let whole = render(&noisy(), &options(50, 40));
    let region = Region { left: 10, top: 5, right: 45, bottom: 39 };
    let part = render(&noisy(), &Options { region: Some(region), ..options(50, 40) });
    assert_eq!((part.width, part.height), (35, 34));
    for (row, y) in part.pixels.chunks(35).zip(5..39) {
        assert_eq!(row, &whole.pixels[y * 50 + 10..y * 50 + 45]);
    }
}

#[test]
fn cancelled_pictures_say_so_and_progress_ends_at_all_pixels() {
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
    let world = raggio_render::World::build(&noisy()).expect("the scene can be built");
    let most = AtomicUsize::new(0);
    let film = world.render(&options(40, 33), &AtomicBool::new(false), &|done, all| {
        assert_eq!(all, 40 * 33);
        most.fetch_max(done, Ordering::Relaxed);
    });
    assert!(!film.cancelled && most.into_inner() == 40 * 33);
    assert!(world.render(&options(40, 33), &AtomicBool::new(true), &|_, _| {}).cancelled);
}
