//! How far a blob's surface reaches: well within the balls in which its components act.
//!
//! Cells of space are cut in halves, that which reaches farthest first, and dropped where the field cannot come up to
//! the threshold.
use std::cmp::Ordering;
use std::collections::BinaryHeap;

use raggio_math::{Aabb, Vec3};
use smallvec::SmallVec;

use super::{Blob, Element, Form};

/// So many cells are looked at for one answer.
const LOOKS: usize = 48;
/// Cells are cut no smaller than this share of all.
const FINEST: f64 = 1.0 / 256.0;
/// They are cut shorter by so much along the vector that is asked for than across it.
const FLATNESS: f64 = 4.0;
/// Blobs of a lower threshold reach as far as their components act.
const LEAST_THRESHOLD: f64 = 1e-3;

/// A part of space in which the field may come up to the threshold.
struct Cell {
    middle: Vec3,
    half: Vec3,
    /// Components that act in it.
    elements: Elements,
}

type Elements = SmallVec<[u32; 8]>;

/// A cell by number, and how far it reaches.
struct Waiting {
    reach: f64,
    cell: usize,
}

/// A search for the cell that reaches farthest along a vector.
struct Search<'a> {
    blob: &'a Blob,
    along: Vec3,
    cells: Vec<Cell>,
    waiting: BinaryHeap<Waiting>,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.reach.total_cmp(&other.reach)
    }
}

impl Element {
    /// What it adds at most to the field in a cell; `None` if it does not act there.
    fn most(&self, middle: Vec3, half: Vec3) -> Option<f64> {
        let (away, half, length, per_radius2) = match &self.form {
            Form::Ball { centre, per_radius2 } => (middle - *centre, half, 0.0, *per_radius2),
            Form::Placed { unit_from_blob, length } => {
                let m = &unit_from_blob.matrix3;
                let half = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
                (unit_from_blob.transform_point3(middle), half, *length, 1.0)
            }
        };
        let beside = |w: Vec3| w.x * w.x + w.y * w.y;
        let near = (away.abs() - half).max(Vec3::ZERO);
        let far = away.abs() + half;
        let near_z = (away.z - half.z - length).max(-(away.z + half.z)).max(0.0);
        let far_z = (away.z + half.z - length).max(half.z - away.z).max(0.0);
        let u = 1.0 - per_radius2 * (beside(near) + near_z * near_z);
        let least = (1.0 - per_radius2 * (beside(far) + far_z * far_z)).max(0.0);
        (u > 0.0).then_some(self.strength * if self.strength > 0.0 { u * u } else { least * least })
    }
}

impl Blob {
    /// A box around the surface; `acting` is that around what its components act in.
    pub(super) fn hull(&self, acting: Aabb) -> Aabb {
        if acting.is_empty() {
            return acting;
        }
        let reach = |sign: f64| Vec3::AXES.map(|axis| sign * self.reach_within(&acting, axis * sign));
        acting.intersection(&Aabb { min: reach(-1.0).into(), max: reach(1.0).into() })
    }

    /// How far the surface, which lies in a box, reaches at most along a vector.
    pub(super) fn reach_within(&self, b: &Aabb, along: Vec3) -> f64 {
        if self.threshold.is_nan() || self.threshold < LEAST_THRESHOLD || !b.is_finite() {
            return f64::INFINITY;
        }
        let whole = (b.size() * 0.5).max(Vec3::splat(f64::MIN_POSITIVE));
        // What to multiply sides of cells by, before the longest is cut.
        let length = along.length().max(f64::MIN_POSITIVE);
        let shares = (Vec3::ONE + along.abs() / length * (FLATNESS - 1.0)) / whole;
        let mut search = Search { blob: self, along, cells: Vec::new(), waiting: BinaryHeap::new() };
        search.look(b.centre(), b.size() * 0.5, &(0..self.elements.len() as u32).collect());
        let mut looks = 0;
        while let Some(Waiting { reach, cell }) = search.waiting.pop() {
            let Cell { middle, mut half, .. } = search.cells[cell];
            let share = half * shares;
            let axis = (0..3).fold(0, |most, k| if share[k] > share[most] { k } else { most });
            if looks >= LOOKS || share[axis] < FINEST {
                return reach;
            }
            looks += 2;
            half[axis] *= 0.5;
            let step = Vec3::AXES[axis] * half[axis];
            let elements = std::mem::take(&mut search.cells[cell].elements);
            search.look(middle - step, half, &elements);
            search.look(middle + step, half, &elements);
        }
        f64::NEG_INFINITY
    }
}

impl Search<'_> {
    /// Puts a cell, in which of some components only these act, among the others, unless the field is too weak there.
    fn look(&mut self, middle: Vec3, half: Vec3, elements: &Elements) {
        let mut sum = 0.0;
        let acts = |&i: &u32| {
            let most = self.blob.elements[i as usize].most(middle, half);
            sum += most.unwrap_or_default();
            most.is_some()
        };
        let elements: Elements = elements.iter().copied().filter(acts).collect();
        if sum > self.blob.surely_less() {
            let reach = middle.dot(self.along) + half.dot(self.along.abs());
            self.waiting.push(Waiting { reach, cell: self.cells.len() });
            self.cells.push(Cell { middle, half, elements });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Spans, Surface};
    use super::*;
    use crate::shapes::collect::All;
    use raggio_math::{Affine, Ray, transform};
    use raggio_scene::{BlobComponent, BlobShape};

    /// Balls and rods about the origin, some turned, stretched or of negative strength.
    fn blob(seed: usize) -> Blob {
        let wave = |i: usize| ((seed * 31 + i * 17) as f64 * 0.73).sin();
        let vector = |i: usize| Vec3::new(wave(i), wave(i + 1), wave(i + 2));
        let component = |i: usize| {
            let (at, radius) = (vector(i) * 0.8, 0.9 + 0.4 * wave(i + 3));
            let shape = match i % 3 {
                0 => BlobShape::Cylinder { base: at, cap: -at * 0.5, radius },
                _ => BlobShape::Sphere { center: at, radius },
            };
            let turn = transform::rotate(vector(i + 4) * 90.0);
            let blob_from_component = turn * transform::scale(Vec3::ONE + 0.5 * vector(i + 5));
            let strength = if i % 4 == 3 { -0.7 } else { 1.0 + 0.3 * wave(i + 6) };
            BlobComponent { shape, strength, blob_from_component, texture: None }
        };
        let components = (0..1 + seed % 5).map(component).collect();
        Blob::new(&raggio_scene::Blob { threshold: 0.5, components }, &Affine::IDENTITY)
    }

    #[test]
    fn a_ball_reaches_as_far_as_its_surface() {
        let shape = BlobShape::Sphere { center: Vec3::X, radius: 2.0 };
        let component =
            BlobComponent { shape, strength: 1.0, blob_from_component: Affine::IDENTITY, texture: None };
        let ball =
            Blob::new(&raggio_scene::Blob { threshold: 0.6, components: vec![component] }, &Affine::IDENTITY);
        // Where (1 - (r / 2)^2)^2 is the threshold.
        let radius = 2.0 * (1.0 - 0.6_f64.sqrt()).sqrt();
        let b = ball.bounds();
        for (reach, exact) in [(b.max.x, 1.0 + radius), (-b.min.x, radius - 1.0), (b.max.z, radius)] {
            assert!(reach >= exact && reach < exact + 0.1, "{reach} for {exact}");
        }
    }

    #[test]
    fn no_surface_lies_beyond_and_no_hit_where_rays_plainly_miss() {
        let (mut hits, mut missed) = (0, 0);
        for seed in 0..40 {
            let blob = blob(seed);
            let b = blob.bounds();
            for i in 0..100 {
                let turn = f64::from(i) * 2.4;
                let origin = Vec3::new(turn.cos(), (turn * 0.7).sin(), turn.sin()) * 4.0;
                let aim = Vec3::new((turn * 1.3).sin(), (turn * 1.9).cos(), (turn * 0.3).sin());
                let ray = Ray::new(origin, (aim - origin).normalize());
                // The sweep without its short cut.
                let mut spans = Spans::new();
                blob.gather(&ray, (0.0, 9.0), f64::INFINITY, &mut spans);
                spans.sort_unstable_by(|a, b| a.from.total_cmp(&b.from));
                let mut all = Vec::new();
                blob.sweep(&spans, (0.0, f64::INFINITY), &mut All { range: (0.0, 9.0), out: &mut all });
                for hit in &all {
                    let p = ray.at(hit.t);
                    assert!(b.grown(1e-9).contains(p), "{p} in {b:?}, {seed}");
                    let along = Vec3::new(0.6, -0.8, turn.sin());
                    assert!(p.dot(along) <= blob.reach(along).expect("a reach") + 1e-9, "{p}, {seed}");
                }
                let misses = blob.plainly_misses(&ray, (0.0, 9.0));
                assert!(!misses || all.is_empty(), "{seed} {i}");
                (hits, missed) = (hits + all.len(), missed + usize::from(misses));
            }
        }
        assert!(hits > 1000 && missed > 500, "{hits} {missed}");
    }
}
