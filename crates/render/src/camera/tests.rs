//! Every projection against rays worked out by hand from the light spec, section 1.2.
use std::f64::consts::PI;

use super::*;

const FRAME: Frame = Frame { width: 4.0, height: 2.0 };

/// A plain camera at <1,2,3> that looks along z.
pub fn camera(kind: CameraKind) -> scene::Camera {
    scene::Camera {
        kind,
        location: Vec3::new(1.0, 2.0, 3.0),
        direction: Vec3::Z * 1.3,
        up: Vec3::Y * 1.1,
        right: Vec3::X * 1.6,
        angle: 90.0,
        focal_blur: None,
        normal: None,
    }
}

fn shot(kind: CameraKind, x: f64, y: f64) -> Option<Ray> {
    let camera = camera(kind);
    let built = Camera {
        kind: camera.kind.clone(),
        axes: Axes::new(&camera),
        angle: camera.angle.to_radians(),
        normal: None,
        lens: None,
        mesh: None,
        interiors: Some(SmallVec::new()),
    };
    built.ray(x, y, FRAME, None)
}

fn check(kind: CameraKind, origin: Vec3, dir: Vec3) {
    // Pixel (0, 0) of 4 x 2: px = -0.375, py = 0.25.
    let ray = shot(kind.clone(), 0.0, 0.0).expect("a ray");
    assert!((ray.origin - origin).length() < 1e-12, "{kind:?} {}", ray.origin);
    assert!((ray.dir - dir.normalize()).length() < 1e-12, "{kind:?} {} {}", ray.dir, dir.normalize());
}

const EYE: Vec3 = Vec3::new(1.0, 2.0, 3.0);

#[test]
fn planar_projections() {
    check(CameraKind::Perspective, EYE, Vec3::new(-0.375 * 1.6, 0.25 * 1.1, 1.3));
    check(CameraKind::Orthographic, EYE + Vec3::new(-0.375 * 1.6, 0.25 * 1.1, 0.0), Vec3::Z);
}

#[test]
fn fisheye_takes_the_distance_from_the_middle_as_angle() {
    // Two columns of one row: a = -0.5 * 1.6, b = 0.
    let camera = camera(CameraKind::Fisheye);
    let axes = Axes::new(&camera);
    let ray = round::fisheye(&axes, Place { px: -0.25, py: 0.0 }, PI / 2.0).unwrap();
    let theta: f64 = 0.8 * PI / 4.0;
    assert!((ray.dir - Vec3::new(-theta.sin(), 0.0, theta.cos())).length() < 1e-12);
    assert!(round::fisheye(&axes, Place { px: -0.375, py: 0.0 }, PI / 2.0).is_none());
    assert!(shot(CameraKind::Fisheye, 0.0, 0.0).is_none());
}

#[test]
fn omnimax_cuts_below_the_horizon() {
    let axes = Axes::new(&camera(CameraKind::Omnimax));
    // lr / lu = 1.4545 > 1.283458.
    let ray = round::omnimax(&axes, Place { px: 0.0, py: 0.5 }).unwrap();
    // b = 1: rho = 1, phi = 90 degrees.
    let theta: f64 = 1.411269 - 0.09439 + 0.25674;
    assert!((ray.dir - Vec3::new(0.0, theta.sin(), theta.cos())).length() < 1e-12);
    assert!(round::omnimax(&axes, Place { px: 0.0, py: -0.5 }).is_some());
    assert!(round::omnimax(&axes, Place { px: 0.45, py: -0.4 }).is_none());
}

#[test]
fn angular_projections() {
    let (alpha, beta) = (-0.375 * PI / 2.0, 0.25 * PI / 2.0 * 1.1 / 1.6);
    check(CameraKind::UltraWideAngle, EYE, Vec3::new(alpha.sin(), beta.sin(), alpha.cos() * beta.cos()));
    let (lambda, rise) = ((1.0 - 0.125) * PI, (0.5 * PI / 2.0).tan());
    check(CameraKind::Panoramic, EYE, Vec3::new(1.6 * lambda.cos(), 1.1 * rise, 1.3 * lambda.sin()));
}

#[test]
fn cylinders() {
    let (alpha, v) = (-0.375 * PI / 2.0, 0.25 * 1.1);
    let (beta, h) = (0.25 * PI / 2.0, -0.375 * 1.6);
    check(CameraKind::Cylinder(1), EYE, Vec3::new(alpha.sin(), v, alpha.cos()));
    check(CameraKind::Cylinder(2), EYE, Vec3::new(h, beta.sin(), beta.cos()));
    check(CameraKind::Cylinder(3), EYE + Vec3::Y * v, Vec3::new(alpha.sin(), 0.0, alpha.cos()));
    check(CameraKind::Cylinder(4), EYE + Vec3::X * h, Vec3::new(0.0, beta.sin(), beta.cos()));
}

#[test]
fn spherical_follows_latitude_and_longitude() {
    let (lambda, phi) = (-0.375 * PI / 2.0, 0.25 * PI / 4.0);
    let dir = Vec3::new(phi.cos() * lambda.sin(), phi.sin(), phi.cos() * lambda.cos());
    check(CameraKind::Spherical { v_angle: 45.0 }, EYE, dir);
}

#[test]
fn mesh_cameras_start_on_faces() {
    let mesh = scene::Mesh {
        vertices: vec![[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        faces: scene::Faces::from_iter([scene::MeshFace {
            vertices: [0, 1, 2],
            normals: None,
            uvs: Some([0, 1, 2]),
            texture: scene::FaceTexture::Object,
        }]),
        ..Default::default()
    };
    let mesh_camera = |method| scene::MeshCamera {
        rays_per_pixel: 1,
        method,
        max_distance: 0.0,
        meshes: vec![scene::Placed::new(std::sync::Arc::new(mesh.clone()))],
        smooth: false,
    };
    let mut frame = camera(CameraKind::Perspective);
    frame.location = Vec3::new(0.0, 0.0, 0.5);
    let rays = MeshRays::new(&std::sync::Arc::new(mesh_camera(0)), &frame);
    let one = Frame { width: 1.0, height: 1.0 };
    let ray = rays.ray(0.0, 0.0, 0, one).unwrap();
    assert!((ray.origin - Vec3::new(1.0, 1.0, -0.5)).length() < 1e-12);
    assert!((ray.dir + Vec3::Z).length() < 1e-12);
    assert!(rays.ray(0.0, 0.0, 1, one).is_none());
    let by_uv = MeshRays::new(&std::sync::Arc::new(mesh_camera(3)), &frame);
    // x' = 0.5, y' = 6.5 of a 10 x 10 picture: u = 0, v = 0.3.
    let ray = by_uv.ray(0.0, 7.0, 0, Frame { width: 10.0, height: 10.0 });
    let ray = ray.expect("the uv triangle holds the point");
    assert!((ray.origin - Vec3::new(0.0, 0.9, -0.5)).length() < 1e-12, "{}", ray.origin);
    assert!(by_uv.ray(9.0, 0.0, 0, Frame { width: 10.0, height: 10.0 }).is_none());
}
