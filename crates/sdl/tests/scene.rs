//! Cameras, atmosphere and global settings.
mod common;

use common::run;
use raggio_math::Vec3;
use raggio_scene::{Camera, CameraKind, Curve, FogKind, GammaMode, Rgb, Scene};

#[track_caller]
fn scene(text: &str) -> Scene {
    let run = run(text);
    match run.scene {
        Some(parsed) => parsed.scene,
        None => panic!("{text}\n{:#?}", run.diagnostics),
    }
}

fn camera(items: &str) -> Camera {
    scene(&format!("camera {{ {items} }}")).camera
}

#[track_caller]
fn near(a: Vec3, b: Vec3) {
    assert!((a - b).length() < 1e-9, "{a} is not {b}");
}

#[test]
fn a_plain_camera_looks_along_z() {
    let c = camera("");
    assert_eq!((c.location, c.direction, c.up, c.right), (Vec3::ZERO, Vec3::Z, Vec3::Y, Vec3::X * 1.33));
}

#[test]
fn angle_then_look_at_make_the_frame() {
    let c = camera("look_at <0, 0, 0> location <0, 0, -5> angle 60 right x*2 up y*3");
    near(c.direction, Vec3::Z * (2.0 / (2.0 * 30f64.to_radians().tan())));
    near(c.right, Vec3::X * 2.0);
    near(c.up, Vec3::Y * 3.0);
    let c = camera("location <5, 0, 0> look_at 0 right -x");
    near(c.direction, -Vec3::X);
    near(c.right, -Vec3::Z);
    let c = camera("location y look_at 0 translate x rotate 90*y");
    near(c.location, Vec3::new(0.0, 1.0, -1.0));
    assert!(run("camera { location y look_at 0 }").warned("parallel-look-at"));
    assert_eq!(run("camera { look_at 0 }").error(), "bad-look-at");
    assert_eq!(run("camera { angle 180 }").error(), "bad-angle");
}

#[test]
fn orthographic_views_scale_unless_they_say_their_size() {
    let c = camera("orthographic location -10*z look_at 0");
    near(c.right, Vec3::X * 13.3);
    near(c.up, Vec3::Y * 10.0);
    near(camera("orthographic location -10*z look_at 0 right 4*x up 3*y").right, Vec3::X * 4.0);
    let angled = camera("orthographic location -10*z look_at 0 right 4*x up 3*y angle 90");
    near(angled.right, Vec3::X * 20.0);
}

#[test]
fn copies_take_transforms_only_and_kinds_keep_their_angles() {
    let c = scene("#declare C = camera { location z look_at 2*z angle 40 } camera { C translate x }").camera;
    near(c.location, Vec3::new(1.0, 0.0, 1.0));
    near(c.direction, Vec3::Z * (1.33 / (2.0 * 20f64.to_radians().tan())));
    assert_eq!(camera("fisheye").angle, 90.0);
    let c = camera("spherical angle 200");
    assert!(matches!(c.kind, CameraKind::Spherical { v_angle: 100.0 }) && c.angle == 200.0);
    assert!(matches!(camera("cylinder 3").kind, CameraKind::Cylinder(3)));
}

#[test]
fn words_act_in_their_order_below_version_3_5() {
    let old = scene("#version 3.1; camera { right 2*x location -4*z look_at 0 right 3*x }").camera;
    near(old.right, Vec3::X * 3.0);
    let old = scene("#version 3.1; camera { location x } camera { translate y }").camera;
    near(old.location, Vec3::X + Vec3::Y);
    let new = scene("camera { location x } camera { translate y }").camera;
    near(new.location, Vec3::Y);
}

#[test]
fn blur_needs_an_aperture_and_samples() {
    assert!(camera("aperture 0.4").focal_blur.is_none());
    let blur = camera("aperture 0.4 blur_samples 4, 30 focal_point 3*z").focal_blur.expect("a blur");
    assert_eq!((blur.min_samples, blur.max_samples, blur.focal_distance), (4, 30, 3.0));
}

#[test]
fn space_is_filled() {
    let text =
        "background { rgb 0.5 } fog { fog_type 2 distance 5 rgb 1 fog_alt 2 up 2*x rotate 90*z turbulence 1 }
        fog { color rgb 1 200 } sky_sphere { pigment { gradient y } emission 2 rotate 90*x }
        rainbow { direction z angle 42 width 5 color_map { [0 rgb 0] [1 rgb 1] } } media { absorption 1 }";
    let a = scene(text).atmosphere;
    assert_eq!(a.background.expect("a background").color.rgb, Rgb::splat(0.5));
    let FogKind::Ground { alt: 2.0, up, .. } = a.fogs[0].kind else { panic!("{:?}", a.fogs) };
    near(up, Vec3::Y);
    assert_eq!((a.fogs[1].kind, a.fogs[1].distance), (FogKind::Constant, 200.0));
    assert_eq!(a.sky_sphere.expect("a sky").emission, Rgb::splat(2.0));
    assert_eq!((a.rainbows[0].arc_angle, a.media.len()), (None, 1));
    assert_eq!(run("rainbow { angle 42 width 5 }").error(), "bad-rainbow");
}

#[test]
fn global_settings_are_read_as_one() {
    let text = "global_settings { assumed_gamma 2.2 max_trace_level 900 ambient_light 2 noise_generator 3
        radiosity { count 50, 90 minimum_reuse 0.2 } photons { spacing 0.1 media 100, 2 radius 1, 2 }
        subsurface { samples 3, 4 } mm_per_unit 5 charset utf8 }";
    let s = scene(text).settings;
    assert_eq!(
        (s.gamma, s.max_trace_level, s.noise_generator),
        (GammaMode::Working(Curve::Power(2.2)), 256, 3)
    );
    let r = s.radiosity.expect("radiosity");
    assert_eq!((r.count, r.count_pool, r.maximum_reuse, r.nearest_count), (50, 90, 0.4, 5));
    let f = s.photons.expect("photons");
    assert_eq!((f.spacing, f.media_max_steps, f.radius), (0.1, 100, [1.0, 2.0, -1.0, 1.0]));
    assert_eq!(s.subsurface.map(|s| (s.diffuse_samples, s.single_samples)), Some((3, 4)));
    assert!(scene("global_settings { photons { gather 0, 0 } }").settings.photons.is_none());
    assert!(run("global_settings { assumed_gamma 1 assumed_gamma 2 }").warned("second-gamma"));
    assert!(run("max_trace_level 9").warned("loose-setting"));
    assert_eq!(
        run("global_settings { radiosity { pretrace_start 0.01 pretrace_end 0.1 } }").error(),
        "bad-radiosity"
    );
}

#[test]
fn defaults_change_from_there_on() {
    assert_eq!(run("#default { texture { pigment { rgb 1 } } } sphere { 0, 1 }").error(), "");
    assert_eq!(run("#default { texture { checker texture {} texture {} } }").error(), "bad-default");
    let c = scene("#default { camera { location 7*x } } camera { up 2*y }").camera;
    near(c.location, Vec3::X * 7.0);
}
