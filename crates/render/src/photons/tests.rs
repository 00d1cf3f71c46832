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

fn maps(scene: &Scene) -> Maps {
    let world = World::build(scene).expect("the scene can be built");
    shoot(&world, &options(10, 10), 100 << 10, &AtomicBool::new(false))
}

fn map(scene: &Scene) -> PhotonMap {
    maps(scene).surface
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

/// The pane filled with a mist that scatters, and takes some of the light away or none.
fn misty(extinction: f32) -> Scene {
    let scattering = Scattering { kind: 1, color: Rgb::ONE, eccentricity: 0.0, extinction };
    let mist = Media { samples: (4, 4), scattering: Some(scattering), ..Media::default() };
    let mut scene = pane(0.05, 0, false);
    let target = Arc::make_mut(&mut scene.objects[1]);
    let media = vec![Placed::new(Arc::new(mist))];
    target.interior = Some(Placed::new(Arc::new(Interior { media, ..Interior::default() })));
    target.hollow = Some(true);
    let photons = scene.settings.photons.as_mut().expect("a scene with photons");
    (photons.media_max_steps, photons.radius) = (100, [0.0, 1.0, 0.25, 1.0]);
    scene
}

#[test]
fn photons_fill_the_media_that_they_cross() {
    // A photon stands for the room around it, and the lit room is the pane, 2 x 2 x 0.5.
    let sum = |maps: &Maps| (0..maps.media.len()).map(|i| maps.media.photon(i as u32).power.x).sum::<f32>();
    let clear = maps(&misty(0.0));
    assert_eq!(clear.surface.len(), 1685);
    assert_eq!(clear.media.radius, 0.25);
    assert!((sum(&clear) - 2.0).abs() < 0.15, "{}", sum(&clear));
    let dim = maps(&misty(1.0));
    // What is stored in an interval has not been dimmed yet; what leaves it has, by a way of half a unit. Of 7 x 7
    // photons 7 x 7 - 6.5 x 6.5 leave by the sides before.
    assert!((sum(&dim) - sum(&clear)).abs() < 1e-3);
    let on_floor = |maps: &Maps| (0..1685).map(|i| maps.surface.photon(i).power.x).sum::<f32>();
    let left = on_floor(&dim) / on_floor(&clear);
    let below = (6.5f32 / 7.0).powi(2);
    let expected = below * (-0.505f32).exp() + (1.0 - below) * 2.0 * (1.0 - (-0.5f32).exp());
    assert!((left - expected).abs() < 0.01, "{left} {expected}");
}

#[test]
fn coarse_steps_in_media_count_for_more() {
    let mut scene = misty(0.0);
    let many = maps(&scene).media.len();
    scene.settings.photons.as_mut().expect("a scene with photons").media_max_steps = 2;
    let few = maps(&scene).media;
    let sum: f32 = (0..few.len()).map(|i| few.photon(i as u32).power.x).sum();
    assert!(few.len() * 4 < many, "{} {many}", few.len());
    assert!((sum - 2.0).abs() < 0.15, "{sum}");
}
