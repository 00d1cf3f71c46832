//! The sphere sweep: the union of all spheres whose centre and radius run along a spline (shapes spec, section 5).
//!
//! At parameter s the ray is within the sphere between `-b(s) - sqrt(D(s))` and `-b(s) + sqrt(D(s))`. Where `D` is not
//! negative over a whole stretch of s these intervals change steadily, so their union is a single interval, from the
//! least near end to the greatest far end. Those lie at the ends of the stretch or where `D'^2 = 4 b'^2 D`.
use raggio_math::{Aabb, Ray, Vec3, poly};
use raggio_scene::{SplineKind, SweepSphere};
use smallvec::SmallVec;

use super::collect::{Collect, searched_from};
use super::parts::Parts;
use crate::{LocalHit, Surface};

const LEAST: f64 = 0.0;

/// A sphere sweep, ready to be hit.
pub(crate) struct SphereSweep {
    segments: Vec<Segment>,
    parts: Parts,
    /// Hits nearer than this are dropped.
    tolerance: f64,
}

/// A piece of the spline: coefficients of rising powers of s in 0..=1.
#[derive(Clone, Copy, Debug)]
struct Segment {
    centre: [Vec3; 4],
    radius: [f64; 4],
    linear: bool,
}

/// An end of a stretch of the ray within the sweep.
#[derive(Clone, Copy, Debug)]
struct End {
    t: f64,
    segment: u32,
    s: f64,
}

type Stretches = SmallVec<[(End, End); 8]>;

impl Segment {
    fn new(kind: SplineKind, p: &[SweepSphere]) -> Segment {
        // Rows: power of s; columns: control sphere.
        let rows: [[f64; 4]; 4] = match kind {
            SplineKind::Linear => [[1., 0., 0., 0.], [-1., 1., 0., 0.], [0.; 4], [0.; 4]],
            SplineKind::BSpline => {
                [[1., 4., 1., 0.], [-3., 0., 3., 0.], [3., -6., 3., 0.], [-1., 3., -3., 1.]]
                    .map(|r| r.map(|x| x / 6.0))
            }
            _ => [[0., 2., 0., 0.], [-1., 0., 1., 0.], [2., -5., 4., -1.], [-1., 3., -3., 1.]]
                .map(|r| r.map(|x| x / 2.0)),
        };
        let centre = rows.map(|row| p.iter().zip(row).map(|(q, k)| q.center * k).sum());
        let radius = rows.map(|row| p.iter().zip(row).map(|(q, k)| q.radius * k).sum());
        Segment { centre, radius, linear: kind == SplineKind::Linear }
    }

    fn centre_at(&self, s: f64) -> Vec3 {
        self.centre.iter().rev().fold(Vec3::ZERO, |sum, &c| sum * s + c)
    }

    /// The spheres at the Bezier control points, whose hull holds all spheres.
    fn hull(&self) -> [(Vec3, f64); 4] {
        let control = |c: [f64; 4]| {
            [c[0], c[0] + c[1] / 3.0, c[0] + (2.0 * c[1] + c[2]) / 3.0, c[0] + c[1] + c[2] + c[3]]
        };
        let axes = [0, 1, 2].map(|axis| control(self.centre.map(|c| c[axis])));
        let radii = control(self.radius);
        std::array::from_fn(|k| (Vec3::new(axes[0][k], axes[1][k], axes[2][k]), radii[k].abs()))
    }

    fn bounds(&self) -> Aabb {
        let around = |(at, radius): (Vec3, f64)| Aabb { min: at, max: at }.grown(radius);
        self.hull().into_iter().fold(Aabb::EMPTY, |sum, ball| sum.union(&around(ball)))
    }

    fn stretches(&self, ray: &Ray, index: u32, out: &mut Stretches) {
        if self.linear {
            self.stretches_sized::<2, 3, 3>(ray, index, out);
        } else {
            self.stretches_sized::<4, 7, 11>(ray, index, out);
        }
    }

    /// `N` coefficients of the spline, `D` of the discriminant, `G` of the condition for an extremum.
    fn stretches_sized<const N: usize, const D: usize, const G: usize>(
        &self,
        ray: &Ray,
        index: u32,
        out: &mut Stretches,
    ) {
        let mut b = [0.0; N];
        let mut disc = [0.0; D];
        let mut off = [Vec3::ZERO; N];
        for k in 0..N {
            let from = if k == 0 { ray.origin - self.centre[0] } else { -self.centre[k] };
            b[k] = from.dot(ray.dir);
            off[k] = from - ray.dir * b[k];
        }
        for i in 0..N {
            for j in 0..N {
                disc[i + j] += self.radius[i] * self.radius[j] - off[i].dot(off[j]);
            }
        }
        let cuts = roots_between(&disc, 0.0, 1.0);
        let extremum = extremum_condition::<N, D, G>(&b, &disc);
        let end = |s: f64, side: f64| {
            let half = poly::eval(&disc, s).max(0.0).sqrt();
            End { t: -poly::eval(&b, s) + side * half, segment: index, s }
        };
        let mut from = 0.0;
        for &to in cuts.iter().chain(&[1.0]) {
            if poly::eval(&disc, 0.5 * (from + to)) >= 0.0 {
                let (mut near, mut far) = (end(from, -1.0), end(from, 1.0));
                for &s in roots_between(&extremum, from, to).iter().chain(&[to]) {
                    let (n, f) = (end(s, -1.0), end(s, 1.0));
                    if n.t < near.t {
                        near = n;
                    }
                    if f.t > far.t {
                        far = f;
                    }
                }
                out.push((near, far));
            }
            from = to;
        }
    }

    /// `|p - C(s)|^2 - r(s)^2`
    fn off_sphere(&self, p: Vec3) -> [f64; 7] {
        let mut c = [0.0; 7];
        let from = |k: usize| if k == 0 { self.centre[0] - p } else { self.centre[k] };
        for i in 0..4 {
            for j in 0..4 {
                c[i + j] += from(i).dot(from(j)) - self.radius[i] * self.radius[j];
            }
        }
        c
    }
}

/// The roots in `lo..=hi`, sorted; those of quadratics in closed form.
#[inline]
fn roots_between<const N: usize>(c: &[f64; N], lo: f64, hi: f64) -> SmallVec<[f64; 10]> {
    if N == 3 {
        return poly::quadratic([c[0], c[1], c[2]])
            .iter()
            .copied()
            .filter(|s| (lo..=hi).contains(s))
            .collect();
    }
    SmallVec::from_slice(&poly::roots_in(c, lo, hi))
}

/// `D'^2 - 4 b'^2 D`
fn extremum_condition<const N: usize, const D: usize, const G: usize>(
    b: &[f64; N],
    disc: &[f64; D],
) -> [f64; G] {
    let mut out = [0.0; G];
    for i in 1..D {
        for j in 1..D {
            out[i + j - 2] += (i * j) as f64 * disc[i] * disc[j];
        }
    }
    for i in 1..N {
        for j in 1..N {
            let slopes = 4.0 * (i * j) as f64 * b[i] * b[j];
            for (k, d) in disc.iter().enumerate() {
                out[i + j - 2 + k] -= slopes * d;
            }
        }
    }
    out
}

impl SphereSweep {
    /// A sweep along the spline of the given kind.
    pub(crate) fn new(kind: SplineKind, spheres: &[SweepSphere], tolerance: f64) -> Self {
        let window = if kind == SplineKind::Linear { 2 } else { 4 };
        let segments: Vec<_> = spheres.windows(window).map(|p| Segment::new(kind, p)).collect();
        let boxes: Vec<_> = segments.iter().map(Segment::bounds).collect();
        SphereSweep { segments, parts: Parts::new(&boxes), tolerance }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        // Distances from the point nearest to the middle of the sweep.
        let bounds = self.parts.bounds();
        let shift = (bounds.centre() - ray.origin).dot(ray.dir);
        let near = Ray::new(ray.at(shift), ray.dir);
        let mut stretches = Stretches::new();
        // Stretches that hold the origin count as well, so the search starts in front of everything.
        let before = Ray::new(ray.at(shift - bounds.size().length()), ray.dir);
        self.parts.visit_ray(&before, (0.0, f64::INFINITY), |i| {
            self.segments[i].stretches(&near, i as u32, &mut stretches);
            f64::INFINITY
        });
        stretches.sort_unstable_by(|a, b| a.0.t.total_cmp(&b.0.t));
        let mut emit = |end: End| {
            let t = shift + end.t;
            if t > self.tolerance {
                to.push(LocalHit { t, part: end.segment, u: end.s, v: 0.0 });
            }
        };
        let mut stretches = stretches.into_iter();
        let Some(mut current) = stretches.next() else { return };
        for next in stretches {
            if next.0.t > current.1.t {
                emit(current.0);
                emit(current.1);
                current = next;
            } else if next.1.t > current.1.t {
                current.1 = next.1;
            }
        }
        emit(current.0);
        emit(current.1);
    }
}

impl Surface for SphereSweep {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        self.parts.bounds()
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let balls = self.segments.iter().flat_map(Segment::hull);
        let reaches = balls.map(|(at, radius)| at.dot(along) + radius * along.length());
        Some(reaches.fold(f64::NEG_INFINITY, f64::max))
    }

    /// As the language has it: inside is where the point lies on a sphere of some segment. A point within all spheres of
    /// every segment that it touches is outside.
    fn inside(&self, p: Vec3) -> bool {
        let mut inside = false;
        self.parts.visit_point(p, |i| {
            inside = inside || !poly::roots_in(&self.segments[i].off_sphere(p), 0.0, 1.0).is_empty();
        });
        inside
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        (p - self.segments[hit.part as usize].centre_at(hit.u)).try_normalize().unwrap_or(Vec3::X)
    }
}
