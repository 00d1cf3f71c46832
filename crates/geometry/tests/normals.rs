//! Normals as POV-Ray's `trace` reports them in cases that the recorded objects do not cover.
use std::sync::Arc;

use raggio_geometry::{Geometry, RayClass};
use raggio_math::transform::scale;
use raggio_math::{Ray, Vec3};
use raggio_scene::{Csg, Object, ObjectKind, Shape};

fn solid(shape: Shape) -> Object {
    Object::new(ObjectKind::Shape(Arc::new(shape)))
}

fn normal(object: Object, origin: Vec3) -> Vec3 {
    let geometry = Geometry::of_object(&Arc::new(object)).expect("these shapes are supported");
    let ray = Ray::new(origin, Vec3::Z);
    let hit = geometry.closest(&ray, (0.0, 100.0), RayClass::Any).expect("the ray meets the object");
    geometry.interaction(&ray, &hit).n
}

fn near(a: Vec3, b: Vec3) {
    assert!((a - b).length() < 2e-6, "{a} {b}");
}

#[test]
fn smooth_triangles_blend_normals_carried_one_by_one() {
    let (o, x, y) = (Vec3::ZERO, Vec3::X, Vec3::Y);
    let normals = [Vec3::new(0.1, 0.0, 1.0), Vec3::new(0.2, 0.1, 1.0), Vec3::new(0.0, 0.3, 1.0)];
    let triangle = || {
        solid(Shape::SmoothTriangle { points: [o, x, y], normals: Box::new(normals.map(Vec3::normalize)) })
    };
    let from = Vec3::new(0.3, 0.2, -3.0);
    near(normal(triangle(), from), Vec3::new(0.109222, 0.087480, 0.990160));
    let mut scaled = triangle();
    scaled.transform(&scale(Vec3::new(1.0, 2.0, 3.0)));
    near(normal(scaled, from), Vec3::new(0.332115, 0.080921, 0.939761));
}

#[test]
fn cutters_turn_their_normals_except_quadrics() {
    let cut_by = |cutter: Shape, from: f64| {
        let cube = solid(Shape::Box { min: Vec3::splat(-2.0), max: Vec3::splat(2.0) });
        let children = Arc::new(vec![Arc::new(cube), Arc::new(solid(cutter))]);
        let op = Csg::Difference { cutaway_textures: false };
        normal(Object::new(ObjectKind::Csg { op, children }), Vec3::Z * from)
    };
    near(cut_by(Shape::Sphere { center: Vec3::ZERO, radius: 1.0 }, 0.0), Vec3::NEG_Z);
    near(cut_by(Shape::Plane { normal: Vec3::Z, distance: 0.0 }, -3.0), Vec3::NEG_Z);
    let ball = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
    near(cut_by(Shape::Quadric(ball), 0.0), Vec3::Z);
}
