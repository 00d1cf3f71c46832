//! The box.
use raggio_math::{Aabb, Ray, Vec2, Vec3};

use super::{Few, beyond};
use crate::{LocalHit, Surface};

/// The least distance a box reports.
const LEAST: f64 = 1e-6;

/// Slab distances closer than this count as equal: the ray meets an edge.
const EDGE: f64 = 1e-6;

/// An axis-aligned box; flat ones are welcome. Parts of hits are faces: 0 to 5 for -x, +x, -y, +y, -z, +z.
#[derive(Clone, Copy)]
pub(crate) struct Cuboid {
    min: Vec3,
    max: Vec3,
}

/// One end of the ray's way through the box.
struct End {
    t: f64,
    axis: usize,
}

impl End {
    /// Takes the slab's distance where it is later than what is known; at edges the axis along which the ray runs
    /// faster wins.
    #[inline]
    fn take(&mut self, later: f64, t: f64, axis: usize, ray: &Ray) {
        let ahead = (t - self.t) * later;
        let faster = || ray.dir[axis].abs() > ray.dir[self.axis].abs();
        if ahead > EDGE || (ahead > -EDGE && faster()) || self.t.is_infinite() {
            self.axis = axis;
        }
        if ahead > 0.0 {
            self.t = t;
        }
    }
}

impl Cuboid {
    pub(crate) fn new(min: Vec3, max: Vec3) -> Self {
        Cuboid { min, max }
    }

    /// Entry and exit.
    #[inline]
    fn ends(&self, ray: &Ray) -> Option<[LocalHit; 2]> {
        let mut entry = End { t: f64::NEG_INFINITY, axis: 0 };
        let mut exit = End { t: f64::INFINITY, axis: 0 };
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.dir[axis]);
            if d == 0.0 {
                if o < self.min[axis] || o > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (a, b) = ((self.min[axis] - o) / d, (self.max[axis] - o) / d);
            entry.take(1.0, a.min(b), axis, ray);
            exit.take(-1.0, a.max(b), axis, ray);
        }
        if entry.t > exit.t {
            return None;
        }
        // The ray enters by the lower face where it runs upwards.
        let face = |axis: usize, upper: bool| (2 * axis + usize::from(upper)) as u32;
        let entry_face = face(entry.axis, ray.dir[entry.axis] < 0.0);
        let exit_face = face(exit.axis, ray.dir[exit.axis] >= 0.0);
        Some([
            LocalHit { part: entry_face, ..LocalHit::at(entry.t) },
            LocalHit { part: exit_face, ..LocalHit::at(exit.t) },
        ])
    }

    /// Entry and exit, as far as they are in the range.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        if let Some([entry, exit]) = self.ends(ray) {
            out.push(entry, range);
            out.push(exit, range);
        }
    }
}

impl Surface for Cuboid {
    fn bounds(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        let mut few = Few::default();
        self.few(ray, range, &mut few);
        out.extend_from_slice(few.as_slice());
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (lo, hi) = beyond(range, LEAST);
        let [entry, exit] = self.ends(ray)?;
        // A flat box shows its far face.
        let hit = if entry.t > lo && entry.t < exit.t { entry } else { exit };
        (hit.t > lo && hit.t < hi).then_some(hit)
    }

    fn inside(&self, p: Vec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    fn normal(&self, _: Vec3, hit: &LocalHit) -> Vec3 {
        let axis = Vec3::AXES[(hit.part / 2) as usize % 3];
        if hit.part & 1 == 0 { -axis } else { axis }
    }

    /// The faces as a cross of four by three squares.
    fn uv(&self, p: Vec3, hit: &LocalHit) -> Option<Vec2> {
        const THIRD: f64 = 1.0 / 3.0;
        let size = self.max - self.min;
        let q = (p - self.min) / size.map(|s| if s == 0.0 { 1.0 } else { s });
        let (x, y, z) = (q.x, q.y, q.z);
        Some(match hit.part {
            0 => Vec2::new(z / 4.0, THIRD + y / 3.0),
            1 => Vec2::new(0.75 - z / 4.0, THIRD + y / 3.0),
            2 => Vec2::new(0.25 + x / 4.0, z / 3.0),
            3 => Vec2::new(0.25 + x / 4.0, 1.0 - z / 3.0),
            4 => Vec2::new(1.0 - x / 4.0, THIRD + y / 3.0),
            _ => Vec2::new(0.25 + x / 4.0, THIRD + y / 3.0),
        })
    }
}
