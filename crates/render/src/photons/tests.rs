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
            shine(Light::new(v(0.0, 10.0, 0.0), Rgb::ONE)),
            target,
            plane(v(0.0, 1.0, 0.0), 0.0, texture(Color::WHITE, Finish::default())),
        ],
    );
    let radius = [0.0, 1.0, 0.0, 1.0];
    scene.settings.photons = Some(Photons { spacing, count, radius, ..Photons::default() });
    scene
}

fn map(scene: &Scene) -> PhotonMap {
    let world = World::build(scene).expect("the scene can be built");
    shoot(&world, &options(10, 10), 100 << 10, &AtomicBool::new(false))
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
