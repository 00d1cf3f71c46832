//! Julia fractals of quaternions and hypercomplex numbers (shapes spec, section 4).
//!
//! A point of space is lifted to four numbers by the slice; it is inside if its orbit stays bounded for a number of
//! steps. Rays march by an estimate of the distance to the set and halve the step where they cross its border.
use raggio_math::{Aabb, Ray, Vec3, Vec4, poly};
use raggio_scene::{JuliaAlgebra, JuliaFunction};

use super::beyond;
use super::collect::{Collect, Enough, Nearest, searched_from};
use super::hypercomplex::{self, Hypercomplex};
use super::quaternion;
use crate::{LocalHit, Surface};
use proved::{Proof, Proved};

pub(super) mod proved;

const LEAST: f64 = 1e-7;
/// Borders are found to this.
const FINE: f64 = 1e-7;

/// A Julia fractal, ready to be hit.
#[derive(Clone, Debug)]
pub(crate) struct Julia {
    map: Map,
    parameter: Vec4,
    steps: u32,
    /// The shortest step of the march.
    least_step: f64,
    /// The slice: `w = at_origin - along . p`.
    along: Vec3,
    at_origin: f64,
    /// Radius of the ball that holds the set, and the square of the radius at which an orbit escapes.
    radius: f64,
    escape: f64,
    /// Where no march is needed; `None` for maps of which nothing is proved.
    proved: Option<Proved>,
}

/// What an orbit repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Map {
    Quaternion(quaternion::Power),
    Hypercomplex(hypercomplex::Map),
}

impl Map {
    /// Is anything known of what it does to balls?
    fn can_prove(self) -> bool {
        !matches!(self, Map::Hypercomplex(hypercomplex::Map::Function(_)))
    }

    /// Does the march take the very steps of POV-Ray, on which it depends what thin parts are met? Those of quaternions
    /// are too short for that to matter.
    fn strides(self) -> bool {
        matches!(self, Map::Hypercomplex(_))
    }
}

/// What is known where the march stands.
struct Look {
    inside: bool,
    /// The same is known up to here.
    until: f64,
    /// How far the march may go from there.
    step: f64,
    /// The step at which the orbit escapes and its squared size there, where they were looked at.
    end: Option<(u32, f64)>,
}

/// A place on a ray near the border.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    inside: bool,
    /// See [`Julia::level`]; not a number where it is unknown.
    level: f64,
}

/// The radius of the ball around the origin that is known to hold a fractal.
pub(crate) fn radius(julia: &raggio_scene::Julia) -> f64 {
    match julia.algebra {
        JuliaAlgebra::Quaternion => (1.0 + Vec4::from_array(julia.parameter).length() + 1e-7).min(2.0),
        JuliaAlgebra::Hypercomplex => 4.0,
    }
}

impl Julia {
    /// Makes a fractal ready.
    pub(crate) fn new(julia: &raggio_scene::Julia) -> Self {
        let parameter = Vec4::from_array(julia.parameter);
        let map = match (julia.algebra, julia.function) {
            (JuliaAlgebra::Quaternion, JuliaFunction::Cube) => Map::Quaternion(quaternion::Power::Cube),
            (JuliaAlgebra::Quaternion, _) => Map::Quaternion(quaternion::Power::Square),
            (JuliaAlgebra::Hypercomplex, function) => Map::Hypercomplex(hypercomplex::Map::of(function)),
        };
        let radius = radius(julia);
        let escape = match map {
            Map::Quaternion(_) => radius * radius + 1e-7,
            Map::Hypercomplex(_) => 16.0,
        };
        let [x, y, z, t] = julia.slice;
        let mut julia = Julia {
            map,
            parameter,
            steps: julia.max_iteration.max(1),
            least_step: 1.0 / julia.precision.max(1.0),
            along: Vec3::new(x, y, z) / t,
            at_origin: julia.slice_distance / t,
            radius,
            escape,
            proved: None,
        };
        if map.can_prove() {
            julia.proved = Some(Proved::new(radius, |middle, radius| julia.proof(middle, radius)));
        }
        julia
    }

    /// What can be proved of a ball of space.
    fn proof(&self, middle: Vec3, radius: f64) -> Proof {
        // The slice leans against space.
        let radius = radius * (1.0 + self.along.length_squared()).sqrt();
        let (q, limits) = (self.lifted(middle), (self.steps, self.escape));
        match self.map {
            Map::Quaternion(power) => quaternion::proof(power, (q, radius), self.parameter, limits),
            Map::Hypercomplex(map) => {
                // Neither complex number changes by more than its share of the four numbers.
                let ball = (Hypercomplex::from_vec(q), [radius * 2f64.sqrt(); 2]);
                map.proof(ball, self.hyper_parameter(), limits)
            }
        }
    }

    fn lifted(&self, p: Vec3) -> Vec4 {
        p.extend(self.at_origin - self.along.dot(p))
    }

    /// The step at which the orbit escapes, or the number of steps, and the squared size last looked at.
    fn last_size(&self, p: Vec3) -> (u32, f64) {
        let q = self.lifted(p);
        match self.map {
            Map::Quaternion(power) => {
                quaternion::last_size(power, q, self.parameter, self.steps, self.escape)
            }
            Map::Hypercomplex(map) => {
                let start = Hypercomplex::from_vec(map.defective_start(q));
                map.last_size(start, self.hyper_parameter(), self.steps, self.escape)
            }
        }
    }

    /// Does the orbit stay bounded?
    fn stays(&self, p: Vec3) -> bool {
        self.last_size(p).0 == self.steps
    }

    fn hyper_parameter(&self) -> Hypercomplex {
        Hypercomplex::from_vec(self.parameter)
    }

    /// Is the ray inside at a distance, and how far can the march go?
    #[inline]
    fn look(&self, ray: &Ray, inverse: Vec3, t: f64) -> Look {
        let step = self.least_step;
        let Some(proved) = &self.proved else { return self.look_closely(ray, t) };
        let (proof, until) = proved.at(ray, inverse, t);
        match (proof, self.map.strides()) {
            (Proof::Inside, true) => {
                let steps = ((until - t) / step).floor();
                Look { inside: true, until: t + steps * step, step, end: None }
            }
            (Proof::Inside | Proof::Outside, false) => {
                Look { inside: proof == Proof::Inside, until, step, end: None }
            }
            _ => self.look_closely(ray, t),
        }
    }

    #[inline]
    fn look_closely(&self, ray: &Ray, t: f64) -> Look {
        let (p, dir) = (ray.at(t), ray.dir);
        let q = self.lifted(p);
        let mut end = None;
        let (inside, estimate) = match self.map {
            Map::Quaternion(power) => {
                let (last, distance) = quaternion::orbit(power, q, self.parameter, self.steps, self.escape);
                end = Some(last);
                (distance.is_none(), distance.unwrap_or(self.least_step))
            }
            Map::Hypercomplex(map) => {
                let start = Hypercomplex::from_vec(q);
                match map.escape(start, self.hyper_parameter(), self.steps, self.escape) {
                    None => (true, self.least_step),
                    Some(orbit) => {
                        let size = orbit.escaped.unwrap_or(self.escape);
                        let newton = size / (-map.growth_scale() * orbit.growth(dir));
                        let sane = self.least_step < newton && newton < 30.0 * self.least_step;
                        (false, if sane { newton } else { self.least_step })
                    }
                }
            }
        };
        // A step that is not a number becomes the least one.
        Look {
            inside,
            until: t,
            step: if estimate > self.least_step { estimate } else { self.least_step },
            end,
        }
    }

    /// The part of a ray in the ball and the box that hold the set, not before its start.
    fn span(&self, ray: &Ray) -> Option<(f64, f64)> {
        let middle = -ray.origin.dot(ray.dir);
        let closest = ray.at(middle).length_squared();
        let chord = poly::quadratic([closest - self.radius * self.radius, 0.0, 1.0]);
        let [enter, leave] = chord[..] else { return None };
        let (enter, leave) = ((middle + enter).max(FINE), middle + leave);
        let Some(proved) = &self.proved else { return Some((enter, leave)) };
        let (from, to) = proved.hull.hit(ray)?;
        Some((if self.map.strides() { enter } else { enter.max(from) }, leave.min(to)))
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let Some((mut t, leave)) = self.span(ray) else { return };
        if t >= leave {
            return;
        }
        let inverse = ray.dir.recip();
        let clear = |t: f64| match &self.proved {
            Some(proved) if self.map.strides() => proved.outside_until(ray, inverse, t, leave),
            _ => Some(t),
        };
        let Some(mut outside_until) = clear(t) else { return };
        let mut now = self.look(ray, inverse, t);
        if now.inside {
            t += 2.0 * FINE;
            now = self.look(ray, inverse, t);
        }
        while now.until < leave && now.until < to.range().1 {
            if now.until > outside_until {
                match clear(now.until) {
                    Some(until) => outside_until = until,
                    None => return,
                }
            }
            let next = now.until + now.step;
            // So far away that a step changes nothing.
            if next <= now.until {
                return;
            }
            let seen = self.look(ray, inverse, next);
            if seen.inside != now.inside && !to.settles(now.until, next) {
                to.push(LocalHit::at(self.border(ray, self.place(&now, now.until), self.place(&seen, next))));
            }
            now = seen;
        }
    }

    /// The nearest hit, or one at about the place of any that `stops` says yes to.
    pub(super) fn closest_or(
        &self,
        ray: &Ray,
        range: (f64, f64),
        stops: impl FnMut(&LocalHit) -> bool,
    ) -> Option<LocalHit> {
        let mut enough = Enough { nearest: Nearest::new(beyond(range, LEAST)), stops };
        self.search(ray, &mut enough);
        enough.nearest.best()
    }

    fn place(&self, look: &Look, t: f64) -> Place {
        Place { t, inside: look.inside, level: look.end.map_or(f64::NAN, |end| self.level(end)) }
    }

    /// How far an orbit that ended in this way is from escaping just at the last step: the logarithm of its size against
    /// the one at which it would. Sizes after it has escaped are told from its growth, for some steps.
    fn level(&self, (step, size2): (u32, f64)) -> f64 {
        let beyond = self.steps.saturating_sub(step + 1);
        let growth = match self.map {
            _ if beyond == 0 => 1.0,
            Map::Quaternion(power) if beyond <= 2 => power.degree().powi(beyond as i32),
            Map::Hypercomplex(hypercomplex::Map::Square) if beyond <= 2 => 2f64.powi(beyond as i32),
            _ => return f64::NAN,
        };
        growth * size2.ln() - self.escape.ln()
    }

    /// The border between two distances, just on its inner side. Near the border orbits escape at the last step or not
    /// at all, and the size there tells where between two points it is.
    fn border(&self, ray: &Ray, near: Place, far: Place) -> f64 {
        let (mut a, mut b) = (near, far);
        let mut share = 0.5;
        while (b.t - a.t).abs() > FINE {
            let t = a.t + share * (b.t - a.t);
            if t == a.t || t == b.t {
                break;
            }
            let (end, left) = (self.last_size(ray.at(t)), a);
            a = Place { t, inside: end.0 == self.steps, level: self.level(end) };
            let left = if a.inside == left.inside { left } else { std::mem::replace(&mut b, left) };
            share = Place::share(a, b, left);
        }
        if a.inside { a.t } else { b.t }
    }
}

impl Place {
    /// At which part of the way from `a` to `b`, with the border between, it had best be looked for; `c` was given up
    /// before. Half way, unless the parabola through all three is to be trusted (Chandrupatla 1997); then far enough from
    /// either end that the border is soon enclosed.
    fn share(a: Place, b: Place, c: Place) -> f64 {
        let (xi, phi) = ((a.t - b.t) / (c.t - b.t), (a.level - b.level) / (c.level - b.level));
        if !(phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
            return 0.5;
        }
        let (ab, ac, bc) = (b.level - a.level, c.level - a.level, c.level - b.level);
        let share =
            (c.t - a.t) / (b.t - a.t) * (a.level / ac) * (b.level / bc) - (a.level / ab) * (c.level / bc);
        let nudge = 0.4 * FINE / (b.t - a.t).abs();
        (share + nudge.copysign(0.5 - share)).max(nudge).min(1.0 - nudge)
    }
}

impl Surface for Julia {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        let ball = Aabb::new(Vec3::splat(-self.radius), Vec3::splat(self.radius));
        self.proved.as_ref().map_or(ball, |proved| ball.intersection(&proved.hull))
    }

    fn inside(&self, p: Vec3) -> bool {
        self.stays(p)
    }

    fn normal(&self, p: Vec3, _hit: &LocalHit) -> Vec3 {
        let q = self.lifted(p);
        let n = match self.map {
            Map::Quaternion(power) => quaternion::gradient(power, q, self.parameter, self.steps),
            Map::Hypercomplex(map) => {
                let start = Hypercomplex::from_vec(map.defective_start(q));
                map.orbit(start, self.hyper_parameter(), self.steps, self.escape).gradient()
            }
        };
        n.try_normalize().unwrap_or(Vec3::X)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a fine lattice that fits the grid nowhere: what is proved is so.
    fn proofs_hold(algebra: JuliaAlgebra, function: JuliaFunction, slice: [f64; 4]) {
        let parameter = [-0.083, 0.1, -0.83, -0.025];
        let julia = Julia::new(&raggio_scene::Julia {
            algebra,
            function,
            parameter,
            max_iteration: 6,
            precision: 20.0,
            slice,
            slice_distance: 0.05,
        });
        let proved = julia.proved.as_ref().expect("a map that is proved of");
        let (mut insides, mut outsides) = (0, 0);
        for k in 0..64_000 {
            let p = Vec3::new(f64::from(k % 40), f64::from(k / 40 % 40), f64::from(k / 1600));
            let p = (p / 19.5 - Vec3::ONE) * julia.radius;
            let (proof, _) = proved.at(&Ray::new(p, Vec3::X), Vec3::INFINITY, 0.0);
            match proof {
                Proof::Open => {}
                _ => assert_eq!(proof == Proof::Inside, julia.stays(p), "{p} {proof:?}"),
            }
            insides += u32::from(proof == Proof::Inside);
            outsides += u32::from(proof == Proof::Outside);
            assert!(!julia.stays(p) || proved.hull.contains(p), "{p} is not in the hull");
        }
        assert!(outsides > 30_000 && insides > 50, "only {outsides} and {insides} are proved");
    }

    #[test]
    fn what_is_proved_of_blocks_is_so() {
        use JuliaAlgebra::{Hypercomplex, Quaternion};
        use JuliaFunction::{Cube, Reciprocal, Sqr};
        let (straight, slanted) = ([0.0, 0.0, 0.0, 1.0], [0.1, 0.3, -0.2, 0.9]);
        proofs_hold(Quaternion, Sqr, straight);
        proofs_hold(Quaternion, Cube, slanted);
        proofs_hold(Hypercomplex, Sqr, slanted);
        proofs_hold(Hypercomplex, Reciprocal, straight);
    }
}
