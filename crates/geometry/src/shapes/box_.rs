//! The box.
use raggio_math::{Aabb, Ray, Vec2, Vec3};

use super::{Few, Stretch, apart, beyond, clearly_beyond};
use crate::{LocalHit, Surface};

/// The least distance a box reports.
const LEAST: f64 = 1e-6;

/// Slab distances closer than this count as equal: the ray meets an edge.
const EDGE: f64 = 1e-6;

/// The number of no face.
const NO_FACE: u32 = u32::MAX;

/// An axis-aligned box; flat ones are welcome. Parts of hits are faces: 0 to 5 for -x, +x, -y, +y, -z, +z.
#[derive(Clone, Copy)]
pub(crate) struct Cuboid {
    min: Vec3,
    max: Vec3,
}

/// A ray, whose direction may be of any length, made ready for many boxes.
#[derive(Default)]
pub(crate) struct AxisRay {
    origin: Vec3,
    /// Without negative zeros.
    dir: Vec3,
}

impl AxisRay {
    #[inline(always)]
    pub(crate) fn new(ray: &Ray) -> Self {
        AxisRay { origin: ray.origin, dir: ray.dir + Vec3::ZERO }
    }
}

/// Where a ray enters and leaves the slab of each axis, and the box.
struct Way {
    near: [f64; 3],
    far: [f64; 3],
    entry: f64,
    exit: f64,
}

impl Way {
    /// The axis whose slab makes the end at `t`; at edges the one along which the ray runs faster.
    #[inline]
    fn axis(ends: &[f64; 3], t: f64, ray: &Ray) -> usize {
        let mut axis = 3;
        for (k, end) in ends.iter().enumerate() {
            let here = (end - t).abs() <= EDGE;
            if here && (axis == 3 || ray.dir[k].abs() > ray.dir[axis].abs()) {
                axis = k;
            }
        }
        axis.min(2)
    }

    /// The ray enters by the lower face where it runs upwards.
    #[inline]
    fn entry_face(&self, ray: &Ray) -> u32 {
        let axis = Way::axis(&self.near, self.entry, ray);
        face(axis, ray.dir[axis] < 0.0)
    }

    #[inline]
    fn exit_face(&self, ray: &Ray) -> u32 {
        let axis = Way::axis(&self.far, self.exit, ray);
        face(axis, ray.dir[axis] >= 0.0)
    }
}

#[inline]
fn face(axis: usize, upper: bool) -> u32 {
    (2 * axis + usize::from(upper)) as u32
}

#[inline]
fn least(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

#[inline]
fn most(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

impl Cuboid {
    pub(crate) fn new(min: Vec3, max: Vec3) -> Self {
        Cuboid { min, max }
    }

    /// The box.
    pub(crate) fn extent(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    /// The same box stretched along the axes, then moved.
    pub(crate) fn moved(&self, scale: Vec3, offset: Vec3) -> Self {
        Cuboid { min: self.min * scale + offset, max: self.max * scale + offset }
    }

    /// Are all points beyond one side, or inside?
    pub(crate) fn misses(&self, hull: &[Vec3; 8]) -> bool {
        let around = Aabb::around(*hull);
        let within = |k: usize| {
            clearly_beyond(around.min[k], self.min[k]) && clearly_beyond(self.max[k], around.max[k])
        };
        apart(&self.bounds(), hull) || (0..3).all(within)
    }

    /// The ray's way through the box.
    #[inline(always)]
    fn way(&self, ray: &Ray) -> Option<Way> {
        let (mut near, mut far) = ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]);
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.dir[axis]);
            if d == 0.0 {
                if o < self.min[axis] || o > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (a, b) = ((self.min[axis] - o) / d, (self.max[axis] - o) / d);
            (near[axis], far[axis]) = (least(a, b), most(a, b));
        }
        let entry = most(most(near[0], near[1]), near[2]);
        let exit = least(least(far[0], far[1]), far[2]);
        (entry <= exit).then_some(Way { near, far, entry, exit })
    }

    /// Where the ray is inside.
    #[inline(always)]
    pub(crate) fn stretch(&self, ray: &AxisRay) -> Stretch {
        // Divided, not multiplied by one over the direction: faces that coincide with other surfaces then mostly do to the
        // last bit.
        let (low, high) = ((self.min - ray.origin) / ray.dir, (self.max - ray.origin) / ray.dir);
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            // A ray that runs in a side has an end that is no number; it counts as inside, and no comparison holds.
            let (a, b) = (low[axis], high[axis]);
            let (near, far) = if ray.dir[axis] < 0.0 { (b, a) } else { (a, b) };
            enter = most(enter, near);
            leave = least(leave, far);
        }
        match enter <= leave {
            true => Stretch { enter, leave, beyond: false },
            false => Stretch::NOWHERE,
        }
    }

    /// Where the ray first meets a face, and which; [`NO_FACE`] where it meets none. Two numbers come back in registers,
    /// a hit would have to be waited for.
    #[inline(never)]
    fn first(&self, ray: &Ray, range: (f64, f64)) -> (f64, u32) {
        let (lo, hi) = beyond(range, LEAST);
        match self.way(ray) {
            // A flat box shows its far face.
            Some(way) if way.entry > lo && way.entry < way.exit => match way.entry < hi {
                true => (way.entry, way.entry_face(ray)),
                false => (way.entry, NO_FACE),
            },
            Some(way) if way.exit > lo && way.exit < hi => (way.exit, way.exit_face(ray)),
            _ => (f64::INFINITY, NO_FACE),
        }
    }

    /// Entry and exit, as far as they are in the range.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        if let Some(way) = self.way(ray) {
            if way.entry > range.0 && way.entry < range.1 {
                out.push(way.entry, way.entry_face(ray), range);
            }
            if way.exit > range.0 && way.exit < range.1 {
                out.push(way.exit, way.exit_face(ray), range);
            }
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
        few.into_hits(out);
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let (t, part) = self.first(ray, range);
        (part != NO_FACE).then(|| LocalHit { part, ..LocalHit::at(t) })
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
