//! Subsurface light against means recorded from POV-Ray 3.7 over pictures of 64 pixels.
mod stage;

use raggio_scene::*;
use stage::*;

/// The mean colour of a half space seen and lit from above.
fn half_space(diffuse_samples: u32, single_samples: u32) -> Rgb {
    let mut sun = Light::new(v(0.0, 100.0, 0.0), Rgb::splat(0.3));
    sun.parallel = true;
    sun.point_at = v(0.0, 0.0, 0.0);
    let finish = Finish {
        diffuse: 0.8,
        diffuse_raw: 0.8,
        subsurface: Some(Subsurface { translucency: rgb(1.0, 2.0, 0.5), anisotropy: Rgb::ZERO }),
        ..glowing(0.0)
    };
    let ground = plane(v(0.0, 1.0, 0.0), 0.0, texture(rgbft([1.0, 0.8, 0.5, 0.0, 0.0]), finish));
    let ground = inside(ground, Interior { ior: 1.3, ..Interior::default() });
    let mut camera = view(CameraKind::Orthographic, v(0.0, 10.0, 0.0), 1.0, 1.0);
    (camera.direction, camera.up) = (v(0.0, -1.0, 0.0), v(0.0, 0.0, 1.0));
    let mut scene = scene(camera, vec![shine(sun), ground]);
    scene.settings.subsurface =
        Some(SubsurfaceSettings { diffuse_samples, single_samples, radiosity: false });
    let film = render(&scene, &options(8, 8));
    film.pixels.iter().map(|p| rgb(p[0], p[1], p[2])).sum::<Rgb>() / 64.0
}

fn check(got: Rgb, recorded: [f32; 3], tolerance: f32) {
    let apart = (got / Rgb::from_array(recorded) - Rgb::ONE).abs().max_element();
    assert!(apart < tolerance, "{got}, recorded {recorded:?}");
}

#[test]
fn light_that_is_scattered_often() {
    check(half_space(400, 0), [0.463798, 0.370970, 0.231937], 0.005);
}

#[test]
fn light_that_is_scattered_once() {
    check(half_space(0, 200), [0.0119795, 0.0117616, 0.0109481], 0.02);
}
