//! Which of many rays from a point surely meet nothing: asked of a few boxes around everything, eight rays at once.
use raggio_math::{Aabb, MIN_HIT, Vec3, Wide, wide};

use crate::Geometry;
use crate::borders::Borders;
use crate::index::Index;

/// At most so many boxes stand for everything.
const MOST: usize = 16;

/// Rays that are asked together.
const WIDTH: usize = 8;

/// A number for each of them.
type Lanes = [f32; WIDTH];

/// What rises less over a surface, as a share of the distance from the origin, is taken to lie in it: boxes are so much
/// larger than what is in them.
const LOW: f64 = 3e-7;

/// But not if that is more than this share of its own size.
const MOST_RISE: f64 = 1e-3;

/// Nothing lies farther away along an axis, and no way along an axis is a smaller part of a ray than one over this.
const FAR: f32 = 1e16;

/// By how much, as a share, a place on a ray may be off.
const ROUNDING: f32 = 2e-6;

/// Slopes to a plane that are less may have the other sign.
const LEAST_SLOPE: f32 = 1e-6;

/// Boxes around all that is not a plane.
pub(crate) struct Outlook(Vec<Aabb>);

/// What lies around a point on a surface.
struct Around {
    /// Boxes by their corners from the point.
    boxes: Vec<([f32; 3], [f32; 3])>,
    /// The normals of planes, and how far the point lies before them.
    planes: Vec<([f32; 3], f32)>,
}

/// Some rays there.
struct Among<'a> {
    around: &'a Around,
    /// By axis.
    directions: [Lanes; 3],
}

impl Outlook {
    /// `None` where something has no end.
    pub(crate) fn of(others: &Index) -> Option<Outlook> {
        others.cover(MOST).map(Outlook)
    }

    /// What rays from a point may meet that all lead to the side of a surface to which `up` points.
    fn around(&self, from: Vec3, up: Vec3, borders: &Borders) -> Around {
        let low = LOW * (1.0 + from.abs().max_element());
        let seen = self.0.iter().map(|b| (b.min - from, b.max - from));
        let lies_in = |lo: Vec3, hi: Vec3| {
            (lo * up).max(hi * up).element_sum() <= low && low <= MOST_RISE * (hi - lo).max_element()
        };
        let above = seen.filter(|&(lo, hi)| !lies_in(lo, hi));
        let single = |v: Vec3| v.as_vec3().to_array().map(|x| x.clamp(-FAR, FAR));
        Around {
            boxes: above.map(|(lo, hi)| (single(lo), single(hi))).collect(),
            planes: borders
                .sides()
                .map(|(normal, distance)| (single(normal), (distance - normal.dot(from)) as f32))
                .collect(),
        }
    }
}

impl Wide for Among<'_> {
    /// Which of the rays may meet something: a bit each.
    type Output = u8;

    #[inline(always)]
    fn run(self) -> u8 {
        let d = &self.directions;
        // Below zero where something is met.
        let mut gap = [f32::INFINITY; WIDTH];
        let inverse = d.map(|row| row.map(|x| most(least(1.0 / x, FAR), -FAR)));
        for (lo, hi) in &self.around.boxes {
            let (mut near, mut far) = ([0.0; WIDTH], [f32::INFINITY; WIDTH]);
            for k in 0..3 {
                for i in 0..WIDTH {
                    let (a, b) = (lo[k] * inverse[k][i], hi[k] * inverse[k][i]);
                    near[i] = most(near[i], least(a, b));
                    far[i] = least(far[i], most(a, b));
                }
            }
            for i in 0..WIDTH {
                gap[i] = least(gap[i], near[i] * (1.0 - ROUNDING) - far[i]);
            }
        }
        for &(n, depth) in &self.around.planes {
            for i in 0..WIDTH {
                let slope = n[0] * d[0][i] + n[1] * d[1][i] + n[2] * d[2][i];
                let size = slope.abs();
                // It leads away from the plane, or out of it.
                let leaves = (slope * depth < 0.0) | (depth.abs() < 0.5 * MIN_HIT as f32 * size);
                gap[i] = if leaves & (size > LEAST_SLOPE) { gap[i] } else { -1.0 };
            }
        }
        gap.iter().enumerate().fold(0, |met, (i, &gap)| met | u8::from(gap <= 0.0) << i)
    }
}

#[inline(always)]
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

#[inline(always)]
fn most(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

impl Geometry {
    /// Which rays from a point on a surface surely meet nothing, eight to a byte, the first in the lowest bit. All of them
    /// lead to the side to which `up` points. `None` where nothing can be said.
    pub fn open_rays(&self, from: Vec3, up: Vec3, directions: &[Vec3]) -> Option<Vec<u8>> {
        let outlook = self.outlook.get_or_init(|| Outlook::of(&self.borders.others)).as_ref()?;
        let around = &outlook.around(from, up, &self.borders);
        let ask = |directions: &[Vec3]| {
            let mut rows = [[1.0; WIDTH]; 3];
            for (i, d) in directions.iter().enumerate() {
                for k in 0..3 {
                    rows[k][i] = d[k] as f32;
                }
            }
            !wide(Among { around, directions: rows })
        };
        Some(directions.chunks(WIDTH).map(ask).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RayClass;
    use raggio_math::Ray;
    use raggio_scene::{Csg, Object, ObjectKind, Shape};
    use std::sync::Arc;

    /// So many balls over a floor, some of them behind a wall.
    fn world(balls: usize) -> Geometry {
        let place = |i: usize| (Vec3::new(7.0, 5.0, 3.0) * (i as f64 * 0.61)).map(|x| x.sin() * 4.0);
        let object = |shape| Arc::new(Object::new(ObjectKind::Shape(Arc::new(shape))));
        let ball = |i| object(Shape::Sphere { center: place(i) + Vec3::Y * 4.3, radius: 0.3 });
        let mut children: Vec<_> = (0..balls).map(ball).collect();
        children.push(object(Shape::Plane { normal: Vec3::Y, distance: 0.0 }));
        children.push(object(Shape::Plane { normal: Vec3::new(0.6, 0.0, 0.8), distance: -2.0 }));
        let all = Object::new(ObjectKind::Csg { op: Csg::Union, children: Arc::new(children) });
        Geometry::of_object(&Arc::new(all)).unwrap()
    }

    #[test]
    fn what_rises_little_over_a_far_floor_is_met() {
        // In the metres of a land survey: 4000 km from the origin, where single precision knows no half metre.
        let centre = Vec3::new(5e5, 0.0, 4e6);
        let step =
            Shape::Box { min: centre - Vec3::new(5.0, 0.0, 5.0), max: centre + Vec3::new(5.0, 1.0, 5.0) };
        let geometry =
            Geometry::of_object(&Arc::new(Object::new(ObjectKind::Shape(Arc::new(step))))).unwrap();
        let (from, dir) = (centre - Vec3::X * 6.0, Vec3::new(1.0, 0.3, 0.0).normalize());
        assert!(geometry.closest(&Ray::new(from, dir), (MIN_HIT, 1e9), RayClass::Radiosity).is_some());
        assert_eq!(geometry.open_rays(from, Vec3::Y, &[dir]).unwrap()[0] & 1, 0);
    }

    #[test]
    fn open_rays_meet_nothing() {
        for balls in [0, 3, 90] {
            let geometry = world(balls);
            let (mut open, mut all) = (0, 0);
            for i in 0..200 {
                let spread = |k: f64| (Vec3::new(3.0, 11.0, 17.0) * (k * 0.37 + 0.1)).map(f64::cos);
                // Every other point lies on the floor.
                let raised = f64::from(i % 2) * 3.0;
                let from = spread(f64::from(i)) * Vec3::new(6.0, 0.0, 6.0) + Vec3::Y * raised;
                let up = |d: Vec3| if raised == 0.0 { Vec3::new(d.x, d.y.abs(), d.z) } else { d };
                let normal = if raised == 0.0 { Vec3::Y } else { Vec3::X };
                let directions: Vec<_> = (0..43)
                    .map(|k| up(spread(f64::from(i * 43 + k))).normalize())
                    .map(|d| if d.dot(normal) < 0.0 { -d } else { d })
                    .collect();
                let found = geometry.open_rays(from, normal, &directions).unwrap();
                for (k, &dir) in directions.iter().enumerate() {
                    let met = geometry.closest(&Ray::new(from, dir), (MIN_HIT, 1e9), RayClass::Radiosity);
                    let is_open = found[k / WIDTH] >> (k % WIDTH) & 1 == 1;
                    assert!(!is_open || met.is_none(), "{from} {dir}");
                    open += usize::from(is_open);
                    all += usize::from(met.is_none());
                }
            }
            assert!(open <= all && (balls > 3 || 10 * open > 9 * all) && 4 * open > all, "{open} of {all}");
        }
    }
}
