//! Pixels of small scenes against what POV-Ray 3.7 gives for them (linear values before gamma).
mod stage;

use raggio_render::Film;
use raggio_scene::*;
use stage::*;

/// Four decimals were recorded.
const NEAR: f32 = 2e-4;

fn check(film: &Film, recorded: &[((usize, usize), [f32; 3])]) {
    for &((x, y), color) in recorded {
        expect(film, x, y, color, NEAR);
    }
}

fn reflection(min: f32, max: f32) -> Reflection {
    Reflection { min: Rgb::splat(min), max: Rgb::splat(max), ..Reflection::default() }
}

#[test]
fn metal_glass_and_a_glossy_floor_under_two_lights() {
    let floor = Finish { reflection: reflection(0.3, 0.3), ..Finish::default() };
    let metal = Finish {
        phong: 0.7,
        phong_size: 30.0,
        specular: 0.4,
        roughness: 0.02,
        metallic: 1.0,
        reflection: Reflection { falloff: 2.0, metallic: 1.0, ..reflection(0.1, 0.6) },
        ..Finish::default()
    };
    let glass = Finish {
        ambient: Rgb::ZERO,
        diffuse: 0.1,
        diffuse_raw: 0.1,
        reflection: Reflection { fresnel: true, ..reflection(0.0, 1.0) },
        conserve_energy: true,
        ..Finish::default()
    };
    let inside_glass = Interior {
        ior: 1.4,
        fade_distance: 1.0,
        fade_power: 2.0,
        fade_color: rgb(0.1, 0.5, 0.2),
        ..Interior::default()
    };
    let glass = sphere(v(1.6, 0.5, -1.0), 0.5, texture(rgbft([0.9, 1.0, 0.9, 0.9, 0.0]), glass));
    let mut scene = scene(
        view(CameraKind::Perspective, v(0.0, 1.0, -5.0), 1.333333333, 1.0),
        vec![
            shine(Light::new(v(-3.0, 5.0, -4.0), rgb(1.0, 1.0, 1.0))),
            shine(Light::new(v(4.0, 3.0, -2.0), rgb(0.4, 0.3, 0.2))),
            plane(v(0.0, 1.0, 0.0), 0.0, texture(rgbft([0.8, 0.6, 0.4, 0.0, 0.0]), floor)),
            sphere(v(0.0, 1.0, 0.0), 1.0, texture(rgbft([1.0, 0.2, 0.1, 0.0, 0.0]), metal)),
            inside(glass, inside_glass),
        ],
    );
    scene.atmosphere.background = Some(Background { color: rgbft([0.2, 0.3, 0.4, 0.0, 0.0]) });
    let film = render(&scene, &options(40, 30));
    check(
        &film,
        &[
            ((3, 3), [0.2, 0.3, 0.4]),
            ((20, 15), [0.4708, 0.089, 0.042]),
            ((33, 22), [0.3596, 0.3679, 0.2526]),
            ((10, 25), [0.659, 0.5204, 0.3944]),
            ((30, 20), [0.1032, 0.2081, 0.1821]),
            ((5, 20), [0.4979, 0.4184, 0.3389]),
            ((32, 15), [0.2475, 0.3011, 0.1801]),
        ],
    );
}

#[test]
fn soft_shadows_of_a_fading_area_light_through_a_filter() {
    let mut light = Light::new(v(0.0, 4.0, 0.0), Rgb::ONE);
    (light.fade_distance, light.fade_power) = (4.0, 2.0);
    light.area = Some(AreaLight {
        axis1: v(2.0, 0.0, 0.0),
        axis2: v(0.0, 0.0, 1.0),
        size1: 5,
        size2: 3,
        adaptive: None,
        jitter: false,
        circular: false,
        orient: false,
        area_illumination: false,
        photons_area: false,
    });
    let matt = |diffuse: f32| Finish { diffuse, diffuse_raw: diffuse, ..glowing(0.0) };
    let mut camera = view(CameraKind::Orthographic, v(0.0, 5.0, -0.001), 4.0, 3.0);
    // look_at <0, 0, 0> from there.
    camera.direction = v(0.0, -5.0, 0.001).normalize();
    camera.up = v(0.0, 0.001, 5.0).normalize() * 3.0;
    let scene = scene(
        camera,
        vec![
            shine(light),
            plane(v(0.0, 1.0, 0.0), 0.0, texture(Color::WHITE, matt(1.0))),
            block(v(-0.5, 1.5, -0.5), v(0.5, 1.6, 0.5), texture(rgbft([1.0, 0.5, 0.2, 0.5, 0.0]), matt(0.2))),
        ],
    );
    let film = render(&scene, &options(40, 30));
    check(
        &film,
        &[
            ((3, 3), [0.7932, 0.7932, 0.7932]),
            ((20, 15), [0.2454, 0.0819, 0.0298]),
            ((13, 12), [0.5156, 0.4018, 0.37]),
            ((20, 8), [0.4261, 0.2892, 0.2508]),
            ((33, 22), [0.8071, 0.7919, 0.7876]),
            ((10, 25), [0.8247, 0.8091, 0.8048]),
            ((30, 20), [0.7247, 0.6763, 0.6627]),
        ],
    );
}

#[test]
fn layers_with_energy_kept_in_fog() {
    let mut light = Light::new(v(0.0, 0.0, -100.0), Rgb::ONE);
    light.parallel = true;
    light.point_at = v(0.0, 0.0, 0.0);
    let diffuse = |ambient: f32, diffuse: f32| Finish {
        ambient: Rgb::splat(ambient),
        diffuse,
        diffuse_raw: diffuse,
        ..Finish::default()
    };
    let wall = Finish { phong: 0.5, ..diffuse(0.2, 0.5) };
    let bottom = Finish { specular: 0.3, ..diffuse(0.3, 0.4) };
    let top =
        Finish { phong: 0.2, reflection: reflection(0.25, 0.25), conserve_energy: true, ..diffuse(0.1, 0.6) };
    let mut pane = plane(
        v(0.0, 0.0, -1.0),
        1.0,
        layers(vec![(rgbft([0.9, 0.1, 0.1, 0.0, 0.0]), bottom), (rgbft([0.2, 0.8, 0.4, 0.3, 0.4]), top)]),
    );
    let half = Shape::Plane { normal: v(1.0, 0.0, 0.0), distance: 0.0 };
    pane.clips = vec![std::sync::Arc::new(Object::new(ObjectKind::Shape(std::sync::Arc::new(half))))];
    let mut scene = scene(
        view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 4.0, 3.0),
        vec![
            shine(light),
            plane(v(0.0, 0.0, -1.0), 0.0, texture(rgbft([0.2, 0.4, 0.9, 0.0, 0.0]), wall)),
            pane,
        ],
    );
    scene.atmosphere.background = Some(Background { color: rgbft([0.1, 0.2, 0.3, 0.0, 0.0]) });
    scene.atmosphere.fogs = vec![Fog {
        kind: FogKind::Constant,
        color: rgbft([0.6, 0.5, 0.4, 0.0, 0.0]),
        distance: 10.0,
        turbulence: None,
        turb_depth: 0.5,
    }];
    let film = render(&scene, &options(40, 30));
    check(&film, &[((3, 3), [0.6756, 0.6144, 0.486]), ((20, 15), [0.6243, 0.6698, 0.8428])]);
}
