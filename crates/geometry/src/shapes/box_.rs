//! The box.
use raggio_math::{Aabb, Affine, Ray, Vec2, Vec3, Wide, wide};

use super::{Few, Stretch, apart, beyond, clearly_beyond};
use crate::leaf::moved_normal;
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

/// Three numbers, and one more to make up a wide vector.
type Four = [f64; 4];

#[inline(always)]
fn four(v: Vec3) -> Four {
    [v.x, v.y, v.z, 0.0]
}

/// Where a ray enters and leaves the slab of each axis, and the box.
struct Way {
    near: Four,
    far: Four,
    entry: f64,
    exit: f64,
}

impl Way {
    /// The way of a ray through a box.
    #[inline(always)]
    fn new((min, max): (&Four, &Four), o: &Four, d: &Four) -> Way {
        let (mut near, mut far) = ([0.0; 4], [0.0; 4]);
        for k in 0..4 {
            let (a, b) = ((min[k] - o[k]) / d[k], (max[k] - o[k]) / d[k]);
            (near[k], far[k]) = (least(a, b), most(a, b));
        }
        if (d[0] == 0.0) | (d[1] == 0.0) | (d[2] == 0.0) {
            along_slabs(&mut near, &mut far, (min, max), o, d);
        }
        let entry = most(most(near[0], near[1]), near[2]);
        let exit = least(least(far[0], far[1]), far[2]);
        Way { near, far, entry, exit }
    }

    /// Where the ray first meets a face within a range, and which; [`NO_FACE`] where it meets none. Two numbers come
    /// back in registers, a hit would have to be waited for.
    #[inline(always)]
    fn first(&self, d: &Four, range: (f64, f64)) -> (f64, u32) {
        if self.is_beside() {
            return (f64::INFINITY, NO_FACE);
        }
        let (lo, hi) = beyond(range, LEAST);
        // A flat box shows its far face.
        if self.entry > lo && self.entry < self.exit {
            let face = if self.entry < hi { self.entry_face(d) } else { NO_FACE };
            return (self.entry, face);
        }
        let face = if self.exit > lo && self.exit < hi { self.exit_face(d) } else { NO_FACE };
        (self.exit, face)
    }

    /// Does it lead past the box?
    #[inline(always)]
    fn is_beside(&self) -> bool {
        self.entry > self.exit
    }

    /// The axis whose slab makes the end at `t`; at edges the one along which the ray runs faster.
    #[inline]
    fn axis(ends: &Four, t: f64, d: &Four) -> usize {
        let mut axis = 3;
        for (k, end) in ends.iter().enumerate().take(3) {
            let here = (end - t).abs() <= EDGE;
            if here && (axis == 3 || d[k].abs() > d[axis].abs()) {
                axis = k;
            }
        }
        axis.min(2)
    }

    /// The ray enters by the lower face where it runs upwards.
    #[inline]
    fn entry_face(&self, d: &Four) -> u32 {
        let axis = Way::axis(&self.near, self.entry, d);
        face(axis, d[axis] < 0.0)
    }

    #[inline]
    fn exit_face(&self, d: &Four) -> u32 {
        let axis = Way::axis(&self.far, self.exit, d);
        face(axis, d[axis] >= 0.0)
    }
}

/// Mends the ends of a way along some slabs: it is in them everywhere or nowhere.
#[cold]
#[inline(never)]
fn along_slabs(near: &mut Four, far: &mut Four, (min, max): (&Four, &Four), o: &Four, d: &Four) {
    for k in (0..3).filter(|&k| d[k] == 0.0) {
        let outside = o[k] < min[k] || o[k] > max[k];
        near[k] = if outside { f64::INFINITY } else { f64::NEG_INFINITY };
        far[k] = -near[k];
    }
}

/// A box at a place, its numbers in fours.
#[derive(Clone, Copy)]
pub(crate) struct PlacedCuboid {
    /// The columns of `object_from_world`.
    columns: [Four; 4],
    min: Four,
    max: Four,
    /// The normals of its faces in the world.
    normals: [Vec3; 6],
}

/// A box at a place and a ray in the world.
struct Asked<'a> {
    placed: &'a PlacedCuboid,
    ray: &'a Ray,
    range: (f64, f64),
}

impl Wide for Asked<'_> {
    type Output = (f64, u32);

    #[inline(always)]
    fn run(self) -> (f64, u32) {
        let PlacedCuboid { columns: [x, y, z, at], min, max, .. } = self.placed;
        let Ray { origin, dir } = *self.ray;
        let (mut o, mut d) = ([0.0; 4], [0.0; 4]);
        for k in 0..4 {
            o[k] = x[k] * origin.x + y[k] * origin.y + z[k] * origin.z + at[k];
            d[k] = x[k] * dir.x + y[k] * dir.y + z[k] * dir.z;
        }
        Way::new((min, max), &o, &d).first(&d, self.range)
    }
}

impl PlacedCuboid {
    pub(crate) fn new(cuboid: &Cuboid, object_from_world: &Affine) -> Self {
        let m = &object_from_world.matrix3;
        PlacedCuboid {
            columns: [m.x_axis, m.y_axis, m.z_axis, object_from_world.translation].map(four),
            min: four(cuboid.min),
            max: four(cuboid.max),
            normals: std::array::from_fn(|part| moved_normal(object_from_world, face_normal(part))),
        }
    }

    /// The unit normal in the world at a hit.
    #[inline]
    pub(crate) fn normal(&self, hit: &LocalHit) -> Vec3 {
        self.normals[(hit.part as usize).min(5)]
    }

    /// The nearest hit of a ray in the world.
    #[inline]
    pub(crate) fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        hit_of(wide(Asked { placed: self, ray, range }))
    }
}

#[inline]
fn face_normal(part: usize) -> Vec3 {
    let axis = Vec3::AXES[(part / 2).min(2)];
    if part.is_multiple_of(2) { -axis } else { axis }
}

#[inline]
fn hit_of((t, part): (f64, u32)) -> Option<LocalHit> {
    (part != NO_FACE).then(|| LocalHit { part, ..LocalHit::at(t) })
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

    /// Where the ray first meets a face, and which. Not inlined: see [`crate::leaf::Leaves::closest_apart`].
    #[inline(never)]
    fn first(&self, ray: &Ray, range: (f64, f64)) -> (f64, u32) {
        let d = four(ray.dir);
        Way::new((&four(self.min), &four(self.max)), &four(ray.origin), &d).first(&d, range)
    }

    /// The ray's way through the box.
    #[inline(always)]
    fn way(&self, ray: &Ray) -> Option<Way> {
        let way = Way::new((&four(self.min), &four(self.max)), &four(ray.origin), &four(ray.dir));
        (!way.is_beside()).then_some(way)
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

    /// Entry and exit, as far as they are in the range.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        if let Some(way) = self.way(ray) {
            if way.entry > range.0 && way.entry < range.1 {
                out.push(way.entry, way.entry_face(&four(ray.dir)), range);
            }
            if way.exit > range.0 && way.exit < range.1 {
                out.push(way.exit, way.exit_face(&four(ray.dir)), range);
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
        hit_of(self.first(ray, range))
    }

    fn inside(&self, p: Vec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    fn normal(&self, _: Vec3, hit: &LocalHit) -> Vec3 {
        face_normal(hit.part as usize)
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

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::transform::{rotate, translate};

    #[test]
    fn a_box_at_a_place_is_hit_as_in_its_own_coordinates() {
        let cuboid = Cuboid::new(Vec3::new(-1.0, -0.5, 0.0), Vec3::new(1.0, 2.0, 0.7));
        let spread = |i: usize| (Vec3::new(3.0, 11.0, 17.0) * (i as f64 * 0.37)).map(|x| x.cos() * 3.0);
        let mut hits = 0;
        for turn in [Vec3::ZERO, Vec3::new(90.0, 0.0, 0.0), Vec3::new(20.0, 30.0, 40.0)] {
            let place = (rotate(turn) * translate(Vec3::X)).inverse();
            let placed = PlacedCuboid::new(&cuboid, &place);
            for i in 0..300 {
                let along = Vec3::AXES[i % 3] * if i % 2 == 0 { 1.0 } else { -1.0 };
                let dir = if i % 4 == 0 { along } else { (-spread(i + 5)).normalize() };
                let ray = Ray::new(spread(i), dir);
                let found = placed.closest(&ray, (0.0, 100.0));
                assert_eq!(found, cuboid.closest(&ray.transformed(&place), (0.0, 100.0)), "{i}");
                let mut few = Few::default();
                cuboid.few(&ray.transformed(&place), (0.0, 100.0), &mut few);
                assert_eq!(found.map(|hit| hit.t), few.pop_nearest().map(|hit| hit.t), "{i}");
                hits += usize::from(found.is_some());
            }
        }
        assert!(hits > 100, "{hits}");
    }
}
