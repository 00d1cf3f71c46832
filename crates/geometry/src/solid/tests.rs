//! Sweeps find what asking every member finds.
use std::sync::Arc;

use raggio_math::transform::{rotate, scale, translate};
use raggio_math::{Ray, Vec3};
use raggio_scene::{Csg, Object, ObjectKind, Shape};

use crate::{Geometry, RayClass};

/// Numbers between 0 and 1 without pattern, the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self, reach: f64) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|_| (2.0 * self.next() - 1.0) * reach))
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() * count as f64) as usize
    }
}

fn shape(n: &mut Numbers) -> Shape {
    match n.below(6) {
        0 => Shape::Sphere { center: n.vector(0.5), radius: 0.4 + 0.6 * n.next() },
        1 => Shape::Box { min: Vec3::splat(-0.5 - 0.3 * n.next()), max: Vec3::splat(0.5) },
        2 => Shape::Cylinder { base: n.vector(0.5), cap: Vec3::Y, radius: 0.5, open: false },
        3 => {
            Shape::Cone { base: n.vector(0.5), base_radius: 0.6, cap: Vec3::X, cap_radius: 0.2, open: false }
        }
        4 => Shape::Quadric([1.0, 2.0 * n.next() - 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.3]),
        _ => Shape::Plane { normal: n.vector(1.0).normalize_or(Vec3::Y), distance: 0.3 * n.next() },
    }
}

fn object(n: &mut Numbers, depth: u32) -> Object {
    let mut object = if depth == 0 || n.below(5) == 0 {
        Object::new(ObjectKind::Shape(Arc::new(shape(n))))
    } else {
        let op = [Csg::Union, Csg::Merge, Csg::Intersection, Csg::Difference { cutaway_textures: false }]
            [n.below(4)];
        let count = 2 + n.below(3);
        let children = Arc::new((0..count).map(|_| Arc::new(object(n, depth - 1))).collect());
        Object::new(ObjectKind::Csg { op, children })
    };
    object.inverse = n.below(6) == 0;
    if n.below(6) == 0 {
        let clip = Shape::Sphere { center: n.vector(0.3), radius: 1.0 };
        object.clips = vec![Arc::new(Object::new(ObjectKind::Shape(Arc::new(clip))))];
    }
    // A third keeps its place: there, faces of boxes coincide.
    if n.below(3) > 0 {
        object.transform(&rotate(n.vector(90.0)));
        object.transform(&scale(Vec3::ONE + n.vector(0.3)));
        object.transform(&translate(n.vector(0.4)));
    }
    object
}

#[test]
fn sweeps_find_what_asking_every_member_finds() {
    let mut n = Numbers(5);
    let (mut met, mut solids) = (0, 0);
    for _ in 0..150 {
        let object = Arc::new(object(&mut n, 3));
        let mut geometry = Geometry::of_object(&object).expect("it is supported");
        let rays: Vec<Ray> = (0..300)
            .map(|_| {
                let reach = if n.below(2) == 0 { 4.0 } else { 0.8 };
                let origin = n.vector(reach);
                Ray::new(origin, (n.vector(0.8) - origin).normalize())
            })
            .collect();
        let ask = |geometry: &Geometry| -> Vec<_> {
            let closest = |ray| geometry.closest(ray, (0.0, f64::INFINITY), RayClass::Any);
            rays.iter().map(|ray| closest(ray).map(|hit| (hit.leaf, hit.t))).collect()
        };
        let swept = ask(&geometry);
        solids += geometry.tree.groups.iter().filter(|group| group.solid.is_some()).count();
        geometry.tree.groups.iter_mut().for_each(|group| group.solid = None);
        let asked = ask(&geometry);
        for (ray, (a, b)) in rays.iter().zip(swept.iter().zip(&asked)) {
            let same = match (a, b) {
                (Some(a), Some(b)) => a.0 == b.0 && (a.1 - b.1).abs() < 1e-9,
                _ => a.is_none() == b.is_none(),
            };
            assert!(same, "{a:?} and {b:?} for {ray:?} in {object:?}");
        }
        met += swept.iter().flatten().count();
    }
    assert!(met > 5000 && solids > 100, "{met} hits, {solids} sweeps");
}
