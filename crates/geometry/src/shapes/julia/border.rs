//! Where on a ray the border of a Julia fractal is, between two places that were seen to lie on either side.
use raggio_math::wide;

use super::together::{From, LANES, Lanes};
use super::{FINE, Julia, Map, Way};
use crate::shapes::quaternion;

/// A place on a ray near the border.
#[derive(Clone, Copy)]
pub(super) struct Place {
    t: f64,
    inside: bool,
    /// See [`Julia::level`]; not a number where it is unknown.
    level: f64,
}

impl Julia {
    pub(super) fn place(&self, t: f64, end: (u32, f64), inside: bool) -> Place {
        Place { t, inside, level: self.level(end) }
    }

    /// About how far an orbit that ended in this way is from escaping just at the last step: the logarithm of its size
    /// against the one at which it would, as a series. Sizes after it has escaped are told from its growth, for some
    /// steps.
    fn level(&self, (step, mut size2): (u32, f64)) -> f64 {
        for _ in (step + 1..self.steps).take(4) {
            size2 = match self.map {
                Map::Quaternion(quaternion::Power::Cube) => size2 * size2 * size2,
                _ => size2 * size2,
            };
        }
        let u = (size2 - self.escape) / (size2 + self.escape);
        u * (1.0 + u * u * (1.0 / 3.0 + u * u / 5.0))
    }

    /// How the orbits of some points of a ray end.
    #[inline(always)]
    pub(super) fn ends(&self, way: &Way, t: Lanes) -> [(u32, f64); LANES] {
        match &way.orbits {
            Some(orbits) => {
                let ends = wide(From(orbits, t));
                [ends.last(0), ends.last(1), ends.last(2), ends.last(3)]
            }
            None => t.map(|t| self.last_size(way.ray.at(t))),
        }
    }

    /// The border between two distances, just on its inner side. Near the border orbits escape at the last step or not
    /// at all, and the size there tells where between two points it is.
    #[inline(never)]
    pub(super) fn border(&self, way: &Way, near: Place, far: Place) -> f64 {
        // The border is between the first two; the others lie close to it.
        let (mut a, mut b, mut c, mut d) = (near, far, near, far);
        let mut t = Place::evenly(a, b);
        while b.t - a.t > FINE {
            let (before, ends) = (b.t - a.t, self.ends(way, t));
            for k in 0..LANES {
                let seen = self.place(t[k], ends[k], ends[k].0 == self.steps);
                if a.t < seen.t && seen.t < b.t {
                    d = c;
                    c = std::mem::replace(if seen.inside == a.inside { &mut a } else { &mut b }, seen);
                }
            }
            // There is nothing between them.
            if b.t - a.t >= before {
                break;
            }
            let quick = b.t - a.t < 0.3 * before;
            let around = if quick { Place::around_root([a, b, c, d]) } else { None };
            t = around.unwrap_or_else(|| Place::evenly(a, b));
        }
        if a.inside { a.t } else { b.t }
    }
}

impl Place {
    /// The middle between two places, and others that halve the halves.
    fn evenly(a: Place, b: Place) -> Lanes {
        let nearer = if a.level.abs() < b.level.abs() { 0.125 } else { 0.875 };
        [0.5, 0.25, 0.75, nearer].map(|share| a.t + share * (b.t - a.t))
    }

    /// Four distances about where the level is zero, by the curve through four places, the first two on either side; the
    /// closer the less the fourth changes. `None` where the curve is not to be trusted.
    fn around_root([a, b, c, d]: [Place; 4]) -> Option<Lanes> {
        // Neville's scheme.
        let meet =
            |(p, t): (Place, f64), (q, s): (Place, f64)| (t * q.level - s * p.level) / (q.level - p.level);
        let (ab, bc, cd) = (meet((a, a.t), (b, b.t)), meet((b, b.t), (c, c.t)), meet((c, c.t), (d, d.t)));
        let (abc, bcd) = (meet((a, ab), (c, bc)), meet((b, bc), (d, cd)));
        let root = meet((a, abc), (d, bcd));
        let doubt = (root - abc).abs();
        let trusted = a.t < root && root < b.t && doubt < 0.1 * (b.t - a.t);
        let near = (0.05 * doubt).max(0.4 * FINE);
        let far = doubt.max(4.0 * FINE);
        let within = |t: f64| {
            if t < a.t {
                a.t
            } else if t > b.t {
                b.t
            } else {
                t
            }
        };
        trusted.then(|| [within(root - near), within(root + near), within(root - far), within(root + far)])
    }
}
