//! The advanced shapes against rays, points and texture coordinates recorded from POV-Ray 3.7, and laws that every one
//! of them must keep.
use std::sync::Arc;

use raggio_function::Function;
use raggio_math::{Affine, MIN_HIT, Ray, Vec2, Vec3, transform};
use raggio_scene::{
    BlobComponent, BlobShape, Container, Curve2, CurveKind, Prism, Shape, SplineKind, SweepSphere,
};

use super::{ShapeKind, build};

use crate::Surface;

mod fields;
mod functions;
mod laws;
mod properties;
mod swept;

const HITS: &str = include_str!("../../../tests/data/shape_hits.csv");
const INSIDE: &str = include_str!("../../../tests/data/inside.csv");
const UV: &str = include_str!("../../../tests/data/uv.csv");

/// A shape at its place, asked in the world.
struct Subject {
    name: &'static str,
    surface: ShapeKind,
    world_from_object: Affine,
    object_from_world: Affine,
}

struct WorldHit {
    p: Vec3,
    n: Vec3,
    uv: Vec2,
}

impl Subject {
    fn new(name: &'static str, shape: &Shape, world_from_object: Affine) -> Self {
        let surface = build(shape, 0).expect("the shape is there");
        Subject { name, surface, world_from_object, object_from_world: world_from_object.inverse() }
    }

    /// The ray in the object's space, and how many of its units one world unit is.
    fn local(&self, origin: Vec3, dir: Vec3) -> (Ray, f64) {
        let ray = Ray::new(origin, dir.normalize()).transformed(&self.object_from_world);
        let length = ray.dir.length();
        (Ray::new(ray.origin, ray.dir / length), length)
    }

    fn trace(&self, origin: Vec3, dir: Vec3) -> Option<WorldHit> {
        let (ray, length) = self.local(origin, dir);
        let hit = self.surface.closest(&ray, (MIN_HIT * length, f64::INFINITY))?;
        let local = ray.at(hit.t);
        let p = self.world_from_object.transform_point3(local);
        let n = self.surface.normal(local, &hit);
        assert!((n.length() - 1.0).abs() < 1e-9, "{}: normal {n} is not of unit length", self.name);
        let n = transform::normal_by_inverse(&self.object_from_world, n).normalize();
        let uv = self.surface.uv(local, &hit).unwrap_or(Vec2::new(p.x, p.y));
        Some(WorldHit { p, n, uv })
    }

    fn inside(&self, p: Vec3) -> bool {
        self.surface.inside(self.object_from_world.transform_point3(p))
    }

    /// Every recorded row: how many differ by more than the tolerances, and which.
    fn differing_hits(&self, point: f64, normal: f64) -> Vec<String> {
        let mut wrong = Vec::new();
        for row in rows(HITS, self.name) {
            let v = numbers(&row[1..]);
            let found = self.trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5]));
            let expected =
                (v[6] == 1.0).then(|| (Vec3::new(v[7], v[8], v[9]), Vec3::new(v[10], v[11], v[12])));
            let same = match (&found, &expected) {
                (None, None) => true,
                (Some(f), Some((p, n))) => (f.p - *p).length() <= point && (f.n - *n).length() <= normal,
                _ => false,
            };
            if !same {
                let found = found.map(|f| (f.p, f.n));
                wrong.push(format!("{row:?}\n  found {found:?}"));
            }
        }
        wrong
    }

    fn differing_insides(&self) -> Vec<String> {
        let differs = |row: &Vec<&str>| {
            let v = numbers(&row[1..]);
            self.inside(Vec3::new(v[0], v[1], v[2])) != (v[3] == 1.0)
        };
        rows(INSIDE, self.name).filter(differs).map(|row| format!("{row:?}")).collect()
    }

    fn agrees_with_the_record(&self, point: f64, normal: f64) {
        let wrong = self.differing_hits(point, normal);
        assert!(wrong.is_empty(), "{} hits of {} differ:\n{}", wrong.len(), self.name, wrong.join("\n"));
        let wrong = self.differing_insides();
        assert!(wrong.is_empty(), "{} points of {} differ:\n{}", wrong.len(), self.name, wrong.join("\n"));
    }

    fn uv_agrees_with_the_record(&self, tolerance: f64) {
        for row in rows(UV, self.name).filter(|row| row[1].is_empty()) {
            let v = numbers(&row[2..]);
            let hit = self.trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5])).expect("a hit");
            let wrapped = |a: f64| (a - a.round()).abs();
            let off = Vec2::new(hit.uv.x - v[6], hit.uv.y - v[7]);
            assert!(wrapped(off.x).max(wrapped(off.y)) < tolerance, "{row:?}: {}", hit.uv);
        }
    }

    /// Hits alternate between entry and exit, `inside` says so between them, and `closest` is the first of them.
    fn is_a_consistent_solid(&self) {
        let mut tested = 0;
        for k in 0..400 {
            let h = |m: u32| f64::from((k * m + 977) % 1009) / 1009.0 * 2.0 - 1.0;
            let origin = Vec3::new(h(37), h(101), h(59)).normalize() * 4.0;
            let target = Vec3::new(h(211), h(17), h(83));
            let (ray, _) = self.local(origin, target - origin);
            let mut hits = Vec::new();
            self.surface.hits(&ray, (0.0, f64::INFINITY), &mut hits);
            hits.sort_by(|a, b| a.t.total_cmp(&b.t));
            let first = self.surface.closest(&ray, (0.0, f64::INFINITY)).map(|h| h.t);
            assert_eq!(first, hits.first().map(|h| h.t), "{}: ray {k}", self.name);
            assert!(hits.len() % 2 == 0, "{}: ray {k} has {} hits", self.name, hits.len());
            for (i, pair) in hits.windows(2).enumerate() {
                if pair[1].t - pair[0].t < 1e-3 {
                    continue;
                }
                tested += 1;
                let middle = ray.at(0.5 * (pair[0].t + pair[1].t));
                assert_eq!(self.surface.inside(middle), i % 2 == 0, "{}: ray {k} after hit {i}", self.name);
            }
        }
        assert!(tested > 20, "{}: only {tested} intervals", self.name);
    }
}

fn rows(table: &'static str, name: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().map(|l| l.split(',').collect::<Vec<_>>()).filter(move |row| row[0] == name)
}

/// Empty fields are zero.
fn numbers(fields: &[&str]) -> Vec<f64> {
    fields.iter().map(|f| f.trim().parse().unwrap_or(0.0)).collect()
}

fn plain(name: &'static str, shape: Shape) -> Subject {
    Subject::new(name, &shape, Affine::IDENTITY)
}

fn rotate(x: f64, y: f64, z: f64) -> Affine {
    transform::rotate(Vec3::new(x, y, z))
}
