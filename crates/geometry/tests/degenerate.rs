//! What cannot be hit is not hit, and no ray or point does harm.
use std::sync::Arc;

use raggio_geometry::{Geometry, RayClass};
use raggio_math::transform::{rotate, scale};
use raggio_math::{Aabb, Ray, Vec3};
use raggio_scene::{Csg, Object, ObjectKind, Shape};

fn solid(shape: Shape) -> Object {
    Object::new(ObjectKind::Shape(Arc::new(shape)))
}

fn compile(object: Object) -> Geometry {
    Geometry::of_object(&Arc::new(object)).expect("these shapes are supported")
}

fn ever_hit(object: Object) -> bool {
    let geometry = compile(object);
    (0..200).any(|i| {
        let a = f64::from(i) * 0.7;
        let from = Vec3::new(4.0 * a.cos(), 3.0 * (a * 1.3).sin(), 4.0 * a.sin());
        let aim = Vec3::new((a * 3.1).sin(), (a * 1.7).cos(), (a * 0.3).sin()) * 0.3;
        let ray = Ray::new(from, (aim - from).normalize());
        geometry.closest(&ray, (0.0, f64::INFINITY), RayClass::Any).is_some()
    })
}

#[test]
fn shapes_without_extent_are_never_hit() {
    let (o, x, y, z) = (Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z);
    let nothing = [
        Shape::Sphere { center: o, radius: 0.0 },
        Shape::Cylinder { base: o, cap: y, radius: 0.0, open: false },
        Shape::Disc { center: o, normal: y, radius: 1.0, hole: 1.5 },
        Shape::Disc { center: o, normal: o, radius: 1.0, hole: 0.0 },
        Shape::Triangle { points: [o, x, x * 2.0] },
        // Normals that do not all point to one side.
        Shape::SmoothTriangle { points: [o, x, y], normals: Box::new([z, z, -z]) },
        // Not in a plane.
        Shape::Polygon { loops: vec![vec![o, x, x + y + z, y, o]] },
        Shape::Polygon { loops: vec![vec![o, x, x * 2.0, o]] },
        Shape::Quadric([1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
    ];
    for shape in nothing {
        let name = format!("{shape:?}");
        assert!(!ever_hit(solid(shape)), "{name}");
    }
}

#[test]
fn odd_but_legal_shapes() {
    let down = |geometry: &Geometry, x: f64| {
        let ray = Ray::new(Vec3::new(x, 5.0, 0.0), Vec3::NEG_Y);
        geometry.closest(&ray, (0.0, 100.0), RayClass::Any).map(|h| {
            let at = geometry.interaction(&ray, &h);
            (at.p.y, at.n)
        })
    };
    // A negative radius turns the normal inwards.
    let ball = compile(solid(Shape::Sphere { center: Vec3::ZERO, radius: -1.0 }));
    assert_eq!(down(&ball, 0.0), Some((1.0, Vec3::NEG_Y)));
    // A flat box shows its far face.
    let flat = compile(solid(Shape::Box { min: Vec3::new(-1., 0., -1.), max: Vec3::new(1., 0., 1.) }));
    assert_eq!(down(&flat, 0.0), Some((0.0, Vec3::NEG_Y)));
    // Radii of opposite sign make a double cone, empty between.
    let (base, cap) = (Vec3::new(0.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
    let double = compile(solid(Shape::Cone { base, base_radius: 1.0, cap, cap_radius: -1.0, open: true }));
    let (y, n) = down(&double, 0.5).expect("the lower side of the upper cone");
    assert!((y - 0.5).abs() < 1e-12 && n.y < 0.0);
    assert!(double.inside(Vec3::new(0.4, 0.5, 0.0)) && !double.inside(Vec3::new(0.4, 0.3, 0.0)));
}

#[test]
fn a_combination_of_nothing_shows_nothing() {
    for op in [Csg::Union, Csg::Merge, Csg::Intersection, Csg::Difference { cutaway_textures: false }] {
        let empty = Object::new(ObjectKind::Csg { op, children: Arc::new(Vec::new()) });
        assert!(!ever_hit(empty.clone()));
        assert_eq!(compile(empty).bounds(), Aabb::EMPTY);
    }
}

#[test]
fn no_number_does_harm() {
    let shapes = || {
        let (o, x, y, z) = (Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z);
        [
            Shape::Sphere { center: o, radius: 1.0 },
            Shape::Box { min: -Vec3::ONE, max: Vec3::ONE },
            Shape::Plane { normal: y, distance: 0.0 },
            Shape::Cone { base: o, base_radius: 1.0, cap: y, cap_radius: 0.0, open: false },
            Shape::Disc { center: o, normal: y, radius: 1.0, hole: 0.0 },
            Shape::Triangle { points: [x, y, z] },
            Shape::Polygon { loops: vec![vec![o, x, y, o]] },
            Shape::Quadric([1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]),
        ]
        .map(|shape| {
            let mut object = solid(shape);
            object.transform(&scale(Vec3::new(1.0, 2.0, 3.0)));
            object.transform(&rotate(Vec3::new(10.0, 20.0, 30.0)));
            object
        })
    };
    let odd = [0.0, -0.0, 1.0, 1e-300, -1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    for op in [Csg::Union, Csg::Merge, Csg::Difference { cutaway_textures: false }] {
        let children = Arc::new(shapes().into_iter().map(Arc::new).collect());
        let geometry = compile(Object::new(ObjectKind::Csg { op, children }));
        for a in odd {
            for b in odd {
                let v = Vec3::new(a, b, 1.0);
                for ray in [Ray::new(v, Vec3::Z), Ray::new(Vec3::ONE, v), Ray::new(v, Vec3::new(b, a, 0.0))] {
                    if let Some(hit) = geometry.closest(&ray, (0.0, f64::INFINITY), RayClass::Camera) {
                        assert!(hit.t > 0.0 && hit.t <= raggio_math::MAX_DISTANCE);
                        let _ = geometry.interaction(&ray, &hit);
                    }
                }
                assert!(geometry.interiors_at(v).len() <= 1);
            }
        }
    }
}
