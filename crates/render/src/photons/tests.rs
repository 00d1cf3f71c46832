//! Photons against counts and powers recorded from POV-Ray 3.7 (photon spec, appendix).
use std::sync::atomic::AtomicBool;

use raggio_scene::*;

use super::*;
use crate::World;
use crate::stage::*;

/// Clear glass under a lamp, over a floor.
fn pane(spacing: f32, count: u32, collect: bool) -> Scene {
    let clear = texture(rgbft([1.0, 1.0, 1.0, 0.0, 1.0]), Finish::default());
    let mut target = block(v(-1.0, 3.0, -1.0), v(1.0, 3.5, 1.0), clear);
    target.photons = PhotonFlags {
        target: Some(1.0),
        reflection: Some(false),
        refraction: Some(true),
        pass_through: false,
        collect: Some(collect),
    };
    let mut scene = scene(
        view(CameraKind::Perspective, v(0.0, 5.0, -10.0), 1.0, 1.0),
        vec![
            shine(point_light(v(0.0, 10.0, 0.0), Rgb::ONE)),
            target,
            plane(v(0.0, 1.0, 0.0), 0.0, texture(Color::WHITE, Finish::default())),
        ],
    );
    scene.settings.photons = Some(Photons {
        spacing,
        count,
        gather_min: 20,
        gather_max: 100,
        jitter: 0.4,
        max_trace_level: None,
        adc_bailout: None,
        autostop: 0.5,
        expand_increase: 0.2,
        expand_min: 35,
        radius: [0.0, 1.0, 0.0, 1.0],
        media_max_steps: 0,
        media_factor: 1.0,
        save_file: None,
        load_file: None,
    });
    scene
}

fn map(scene: &Scene) -> PhotonMap {
    let world = World::build(scene).expect("the scene can be built");
    shoot(&world, &options(10, 10), 100 << 10, &AtomicBool::new(false)).surface
}

#[test]
fn as_many_photons_as_recorded() {
    assert_eq!(map(&pane(0.2, 0, false)).len(), 107);
    assert_eq!(map(&pane(0.05, 0, false)).len(), 1685);
    assert_eq!(map(&pane(0.05, 1000, false)).len(), 1306);
    assert_eq!(map(&pane(0.05, 1000, true)).len(), 1296);
}

#[test]
fn photons_bring_the_light_that_clear_glass_would_let_through() {
    let lit = |scene: &Scene| {
        let mut scene = scene.clone();
        scene.camera = view(CameraKind::Orthographic, v(0.0, 2.0, 0.0), 1.0, 1.0);
        scene.camera.direction = v(0.0, -1.0, 0.0);
        scene.camera.up = v(0.0, 0.0, 1.0);
        let film = render(&scene, &options(4, 4));
        film.pixels.iter().map(|p| p[0]).sum::<f32>() / 16.0
    };
    let scene = pane(0.02, 0, false);
    let mut plain = scene.clone();
    plain.settings.photons = None;
    let (with, without) = (lit(&scene), lit(&plain));
    assert!((with / without - 1.0).abs() < 0.05, "{with} {without}");
}
