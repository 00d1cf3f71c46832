//! Laws of combined objects, on random trees.
use std::sync::Arc;

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raggio_geometry::{Geometry, RayClass};
use raggio_math::transform::{rotate, translate};
use raggio_math::{Ray, Vec3};
use raggio_scene::{Csg, Object, ObjectKind, Shape};

fn config() -> ProptestConfig {
    ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(3),
        cases: 300,
        ..ProptestConfig::default()
    }
}

fn vector(reach: f64) -> impl Strategy<Value = Vec3> {
    (-reach..reach, -reach..reach, -reach..reach).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn solid(shape: Shape) -> Object {
    Object::new(ObjectKind::Shape(Arc::new(shape)))
}

fn shape() -> impl Strategy<Value = Object> {
    prop_oneof![
        (vector(1.0), 0.3..1.2f64).prop_map(|(center, radius)| solid(Shape::Sphere { center, radius })),
        (vector(1.0), vector(1.0)).prop_map(|(a, b)| {
            solid(Shape::Box { min: a.min(b) - Vec3::splat(0.2), max: a.max(b) + Vec3::splat(0.2) })
        }),
        (vector(1.0), vector(1.0), 0.2..0.8f64).prop_map(|(base, offset, radius)| {
            let cap = base + offset + Vec3::new(0.0, 0.3, 0.0);
            solid(Shape::Cylinder { base, cap, radius, open: false })
        }),
        (vector(1.0), -0.5..0.8f64)
            .prop_map(|(n, distance)| { solid(Shape::Plane { normal: n.normalize_or(Vec3::Y), distance }) }),
    ]
}

/// How the members are combined; unions only where asked for, since they show inner surfaces.
fn operation(unions: bool) -> impl Strategy<Value = Csg> {
    let solid = [Csg::Merge, Csg::Intersection, Csg::Difference { cutaway_textures: false }];
    (0..if unions { 4usize } else { 3 }).prop_map(move |i| *solid.get(i).unwrap_or(&Csg::Union))
}

fn tree(unions: bool) -> impl Strategy<Value = Object> {
    let any = shape().prop_recursive(3, 14, 4, move |inner| {
        (operation(unions), prop::collection::vec(inner, 2..5)).prop_map(|(op, children)| {
            Object::new(ObjectKind::Csg {
                op,
                children: Arc::new(children.into_iter().map(Arc::new).collect()),
            })
        })
    });
    (any, vector(180.0), vector(0.5), any_inverse()).prop_map(|(mut object, turn, shift, inverse)| {
        object.inverse = inverse;
        object.transform(&rotate(turn));
        object.transform(&translate(shift));
        object
    })
}

fn any_inverse() -> impl Strategy<Value = bool> {
    prop::bool::weighted(0.2)
}

/// Inside by the definition of the operations, without any search structure.
fn contains(object: &Object, p: Vec3) -> bool {
    let q = object.parent_from_object.inverse().transform_point3(p);
    let own = match &object.kind {
        ObjectKind::Shape(shape) => match **shape {
            Shape::Sphere { center, radius } => (q - center).length() < radius,
            Shape::Box { min, max } => q.cmpge(min).all() && q.cmple(max).all(),
            Shape::Plane { normal, distance } => normal.dot(q) < distance,
            Shape::Cylinder { base, cap, radius, .. } => {
                let axis = (cap - base).normalize();
                let h = (q - base).dot(axis);
                h >= 0.0 && h <= (cap - base).length() && (q - base - axis * h).length() <= radius
            }
            _ => unreachable!("no other shape is made here"),
        },
        ObjectKind::Csg { op, children } => match op {
            Csg::Union | Csg::Merge => children.iter().any(|c| contains(c, q)),
            Csg::Intersection | Csg::CutawayIntersection => children.iter().all(|c| contains(c, q)),
            Csg::Difference { .. } => {
                contains(&children[0], q) && !children[1..].iter().any(|c| contains(c, q))
            }
        },
        _ => unreachable!("no lights here"),
    };
    own != object.inverse
}

/// All hits along the ray, by starting again behind each.
fn march(geometry: &Geometry, ray: &Ray) -> Vec<f64> {
    let mut all = Vec::new();
    let mut from = 0.0;
    while let Some(hit) = geometry.closest(ray, (from, 20.0), RayClass::Any) {
        all.push(hit.t);
        from = hit.t;
        assert!(all.len() < 200, "hits come one after the other");
    }
    all
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn inside_follows_the_operations(object in tree(true), points in prop::collection::vec(vector(2.5), 20)) {
        let geometry = Geometry::of_object(&Arc::new(object.clone())).unwrap();
        for p in points {
            prop_assert_eq!(geometry.inside(p), contains(&object, p), "at {}", p);
        }
    }

    #[test]
    fn inside_changes_only_at_hits(object in tree(true), o in vector(4.0), aim in vector(1.0)) {
        let ray = Ray::new(o, (aim - o).normalize_or(Vec3::X));
        let geometry = Geometry::of_object(&Arc::new(object.clone())).unwrap();
        let hits = march(&geometry, &ray);
        prop_assert!(hits.windows(2).all(|w| w[0] < w[1]));
        let mut ends = vec![raggio_math::MIN_HIT];
        ends.extend(&hits);
        ends.push(20.0);
        for w in ends.windows(2) {
            // Between two hits nothing changes.
            let at = |f: f64| contains(&object, ray.at(w[0] + f * (w[1] - w[0])));
            let middle = at(0.5);
            prop_assert!(w[1] - w[0] < 1e-6 || [0.01, 0.2, 0.37, 0.8, 0.99].iter().all(|&f| at(f) == middle));
        }
    }

    #[test]
    fn every_hit_of_a_solid_leads_in_or_out(object in tree(false), o in vector(4.0), aim in vector(1.0)) {
        let ray = Ray::new(o, (aim - o).normalize_or(Vec3::X));
        let geometry = Geometry::of_object(&Arc::new(object.clone())).unwrap();
        let hits = march(&geometry, &ray);
        for (i, &t) in hits.iter().enumerate() {
            let near = |other: Option<&f64>| other.is_some_and(|&s| (s - t).abs() < 1e-4);
            if near(hits.get(i + 1)) || (i > 0 && near(hits.get(i - 1))) {
                continue;
            }
            let (before, after) = (contains(&object, ray.at(t - 1e-5)), contains(&object, ray.at(t + 1e-5)));
            prop_assert_ne!(before, after, "at {}", t);
            let hit = geometry.closest(&ray, (t - 1e-6, t + 1e-6), RayClass::Any).unwrap();
            let outwards = geometry.interaction(&ray, &hit).n.dot(ray.dir);
            // The reported normal points out of what remains.
            prop_assert!(outwards.abs() < 1e-3 || (outwards > 0.0) == before);
        }
    }
}

#[test]
fn a_difference_of_ten_thousand_holes_is_one_solid() {
    let mut children = vec![solid(Shape::Box { min: Vec3::new(0., 0., 0.), max: Vec3::new(100., 100., 1.) })];
    for i in 0..10_000 {
        let at = Vec3::new(f64::from(i % 100) + 0.5, f64::from(i / 100) + 0.5, 0.0);
        children.push(solid(Shape::Cylinder {
            base: at - Vec3::Z,
            cap: at + Vec3::Z * 0.75,
            radius: 0.25,
            open: false,
        }));
    }
    let object = Object::new(ObjectKind::Csg {
        op: Csg::Difference { cutaway_textures: false },
        children: Arc::new(children.into_iter().map(Arc::new).collect()),
    });
    let geometry = Geometry::of_object(&Arc::new(object)).unwrap();
    let depth = |x: f64, y: f64| {
        let ray = Ray::new(Vec3::new(x, y, -2.0), Vec3::Z);
        geometry.closest(&ray, (0.0, 10.0), RayClass::Any).map(|h| h.t)
    };
    for i in 0..100 {
        let at = f64::from(i);
        assert_eq!(depth(at + 0.5, 99.5 - at), Some(2.75), "the bottom of a hole");
        assert_eq!(depth(at + 0.01, 99.9 - at), Some(2.0), "the plate between holes");
    }
    assert!(!geometry.inside(Vec3::new(0.5, 0.5, 0.5)) && geometry.inside(Vec3::new(0.5, 0.5, 0.9)));
}

/// A quartic without bounds, held by a pipe between two planes, turned and moved as a whole.
#[test]
fn turned_clips_still_have_a_box() {
    let coefficients = (0..35).map(|i| if i == 16 || i == 33 { 1.0 } else { 0.0 }).collect::<Vec<_>>();
    let pipe = Shape::Quadric([1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
    let mut quartic = solid(Shape::Poly { degree: 4, coefficients: coefficients.into() });
    let clips = vec![
        pipe,
        Shape::Plane { normal: Vec3::Z, distance: 1.5 },
        Shape::Plane { normal: -Vec3::Z, distance: 0.0 },
    ];
    quartic.clips = clips.into_iter().map(|shape| Arc::new(solid(shape))).collect();
    for turn in [Vec3::Z * 160.0, -Vec3::X * 90.0, Vec3::new(-30.0, 0.0, 30.0)] {
        quartic.transform(&rotate(turn));
    }
    let bounds = Geometry::of_object(&Arc::new(quartic)).unwrap().bounds();
    assert!(bounds.is_finite() && bounds.size().max_element() < 4.0, "{bounds:?}");
}
