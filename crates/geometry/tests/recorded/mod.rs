//! POV-Ray's own answers, and the objects that they were asked about.
//!
//! `data/shape_hits.csv` holds rays and what `trace` said, `data/inside.csv` points and what `inside` said,
//! `data/uv.csv` camera rays and texture coordinates read from 16-bit pictures.
use std::sync::Arc;

use raggio_geometry::{Geometry, Hit, RayClass};
use raggio_math::{Ray, Vec2, Vec3};
use raggio_scene::{Csg, Object, ObjectKind, Shape};

mod objects;

pub use objects::object;

const HITS: &str = include_str!("../data/shape_hits.csv");
const INSIDE: &str = include_str!("../data/inside.csv");
const UV: &str = include_str!("../data/uv.csv");

/// The numbers of a line from a column on; empty ones are not numbers.
fn numbers(line: &str, from: usize) -> Vec<f64> {
    line.split(',').skip(from).map(|n| n.parse().unwrap_or(f64::NAN)).collect()
}

fn lines<'a>(data: &'a str, name: &'a str) -> impl Iterator<Item = &'a str> {
    data.lines().filter(move |line| line.split(',').next() == Some(name))
}

fn vec(n: &[f64]) -> Vec3 {
    Vec3::new(n[0], n[1], n[2])
}

/// Compiles an object on its own.
pub fn compile(object: Object) -> Geometry {
    Geometry::of_object(&Arc::new(object)).expect("every shape here is supported")
}

/// What `trace` does.
pub fn trace(geometry: &Geometry, ray: &Ray) -> Option<Hit> {
    geometry.closest(ray, (0.0, f64::INFINITY), RayClass::Any)
}

/// Compares all recorded rays of a shape; `tolerance` is for points, ten times that for normals.
pub fn check_hits(name: &str, tolerance: f64) {
    let geometry = compile(object(name));
    let mut count = 0;
    for line in lines(HITS, name) {
        let n = numbers(line, 1);
        let ray = Ray::new(vec(&n), vec(&n[3..]).normalize());
        let hit = trace(&geometry, &ray);
        assert_eq!(hit.is_some(), n[6] == 1.0, "{name}: {line}: {hit:?}");
        if let Some(hit) = hit {
            let at = geometry.interaction(&ray, &hit);
            assert!((at.p - vec(&n[7..])).length() < tolerance, "{name}: {line}: {}", at.p);
            assert!((at.n - vec(&n[10..])).length() < 10.0 * tolerance, "{name}: {line}: normal {}", at.n);
        }
        count += 1;
    }
    assert_eq!(count, 30, "{name}");
}

/// Compares all recorded points of a shape.
pub fn check_inside(name: &str) {
    let geometry = compile(object(name));
    let mut count = 0;
    for line in lines(INSIDE, name) {
        let n = numbers(line, 1);
        assert_eq!(geometry.inside(vec(&n)), n[3] == 1.0, "{name}: {line}");
        count += 1;
    }
    assert!(count > 0, "{name}");
}

/// Compares all recorded texture coordinates of a shape.
pub fn check_uv(name: &str) {
    let geometry = compile(object(name));
    let mut count = 0;
    for line in lines(UV, name) {
        let n = numbers(line, 2);
        let ray = Ray::new(vec(&n), vec(&n[3..]).normalize());
        let hit = trace(&geometry, &ray).unwrap_or_else(|| panic!("{name}: {line}: missed"));
        let (uv, expected) = (geometry.interaction(&ray, &hit).uv, Vec2::new(n[6], n[7]));
        // The pictures show parts of whole numbers only, in steps of a ten-thousandth.
        let off = uv - expected - (uv - expected).round();
        assert!(off.abs().max_element() < 3e-4, "{name}: {line}: {uv}");
        count += 1;
    }
    assert!(count > 0, "{name}");
}

/// An object of one shape.
pub fn solid(shape: Shape) -> Object {
    Object::new(ObjectKind::Shape(Arc::new(shape)))
}

/// A combination of objects.
pub fn csg(op: Csg, children: impl IntoIterator<Item = Object>) -> Object {
    Object::new(ObjectKind::Csg { op, children: Arc::new(children.into_iter().map(Arc::new).collect()) })
}
