//! Julia fractals of quaternions and hypercomplex numbers (shapes spec, section 4).
//!
//! A point of space is lifted to four numbers by the slice; it is inside if its orbit stays bounded for a number of
//! steps. Rays march by an estimate of the distance to the set and halve the step where they cross its border.
use raggio_math::{Aabb, Ray, Vec3, Vec4, poly, wide};
use raggio_scene::{JuliaAlgebra, JuliaFunction};

use super::beyond;
use super::collect::{Collect, Enough, Nearest, searched_from};
use super::hypercomplex::{self, Hypercomplex};
use super::quaternion;
use crate::{LocalHit, Surface};
use proved::{Course, Proof, Proved};
use together::{Ends, From, LANES, Lanes, Law, Orbits};

mod border;
pub(super) mod proved;
pub(super) mod together;

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

    /// What its orbits repeat if they are followed together; or the map whose orbits are not.
    #[inline(always)]
    fn law(self) -> Result<Law, hypercomplex::Map> {
        match self {
            Map::Quaternion(power) => Ok(Law::Quaternions(power)),
            Map::Hypercomplex(hypercomplex::Map::Square) => Ok(Law::Squares),
            Map::Hypercomplex(map) => Err(map),
        }
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
    /// The step at which the orbit escapes and its squared size there.
    end: (u32, f64),
}

/// The end of an orbit that was not looked at.
const UNSEEN: (u32, f64) = (0, f64::NAN);

/// A ray under way.
struct Way<'a> {
    ray: &'a Ray,
    course: Option<(&'a Proved, Course)>,
    /// What starts on the ray, for maps whose orbits are followed together.
    orbits: Option<Orbits>,
    /// How far the next look is thought to be from one that is made.
    gap: f64,
    /// What has been seen where the march may come next: the first of the distances that it has not reached.
    next: usize,
    ahead: Lanes,
    ends: Ends,
}

/// The radius of the ball around the origin that is known to hold a fractal.
pub(crate) fn radius(julia: &raggio_scene::Julia) -> f64 {
    match julia.algebra {
        JuliaAlgebra::Quaternion => (1.0 + Vec4::from_array(julia.parameter).length() + 1e-7).min(2.0),
        JuliaAlgebra::Hypercomplex => 4.0,
    }
}

impl Julia {
    /// Makes a fractal ready, after so many others.
    pub(crate) fn new(julia: &raggio_scene::Julia, before: usize) -> Self {
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
            julia.proved = Some(Proved::new(radius, before, |middle, radius| julia.proof(middle, radius)));
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
    #[inline(always)]
    fn look(&self, way: &mut Way, t: f64) -> Look {
        let step = self.least_step;
        let Some((proved, course)) = &way.course else { return self.look_closely(way, t) };
        let (proof, until) = proved.at(course, t);
        match (proof, self.map.strides()) {
            (Proof::Inside, true) => {
                let steps = ((until - t) / step).floor();
                Look { inside: true, until: t + steps * step, step, end: UNSEEN }
            }
            (Proof::Inside | Proof::Outside, false) => {
                Look { inside: proof == Proof::Inside, until, step, end: UNSEEN }
            }
            _ => self.look_closely(way, t),
        }
    }

    #[inline(always)]
    fn look_closely(&self, way: &mut Way, t: f64) -> Look {
        let law = match self.map.law() {
            Ok(law) => law,
            Err(map) => return self.look_at(map, way.ray, t),
        };
        if way.ahead.get(way.next) != Some(&t) {
            self.look_ahead(way, t);
        }
        let (lane, least) = (way.next, self.least_step);
        way.next += 1;
        let (end, slope) = (way.ends.last(lane), way.ends.slope[lane]);
        let inside = end.0 == self.steps;
        let step = match law {
            _ if inside => least,
            Law::Quaternions(_) => quaternion::distance(end.1, slope, least),
            Law::Squares => self.newton(hypercomplex::Map::Square, end.1, slope),
        };
        Look { inside, until: t, step, end }
    }

    /// Works out what is known at a distance, together with what is known one and more least steps from there.
    #[inline(never)]
    fn look_ahead(&self, way: &mut Way, t: f64) {
        let Some(orbits) = &way.orbits else { return };
        let (second, least) = (t + way.gap, self.least_step);
        way.ahead = [t, second, second + least, second + least + least];
        way.next = 0;
        way.ends = wide(From(orbits, way.ahead));
    }

    /// POV-Ray's step from where an orbit escapes.
    #[inline(always)]
    fn newton(&self, map: hypercomplex::Map, size2: f64, growth: f64) -> f64 {
        let (step, least) = (size2 / (-map.growth_scale() * growth), self.least_step);
        if least < step && step < 30.0 * least { step } else { least }
    }

    #[inline(never)]
    fn look_at(&self, map: hypercomplex::Map, ray: &Ray, t: f64) -> Look {
        let start = Hypercomplex::from_vec(self.lifted(ray.at(t)));
        let (inside, step) = match map.escape(start, self.hyper_parameter(), self.steps, self.escape) {
            None => (true, self.least_step),
            Some(orbit) => {
                (false, self.newton(map, orbit.escaped.unwrap_or(self.escape), orbit.growth(ray.dir)))
            }
        };
        Look { inside, until: t, step, end: UNSEEN }
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

    fn way<'a>(&'a self, ray: &'a Ray) -> Way<'a> {
        let line = [self.lifted(ray.origin), ray.dir.extend(-self.along.dot(ray.dir))];
        let (parameter, steps, escape) = (self.parameter, self.steps, self.escape);
        Way {
            ray,
            course: self.proved.as_ref().map(|proved| (proved, proved.course(ray))),
            orbits: self.map.law().ok().map(|law| Orbits { law, line, parameter, steps, escape }),
            gap: self.least_step,
            next: LANES,
            ahead: [0.0; LANES],
            ends: Ends::NONE,
        }
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let Some((mut t, leave)) = self.span(ray) else { return };
        if t >= leave {
            return;
        }
        let way = &mut self.way(ray);
        let clear = |way: &Way, t: f64| match &way.course {
            Some((proved, course)) if self.map.strides() => proved.outside_until(course, t, leave),
            _ => Some(t),
        };
        let Some(mut outside_until) = clear(way, t) else { return };
        // Only from within the ball can it start inside.
        if t <= FINE {
            way.gap = 2.0 * FINE;
        }
        let mut now = self.look(way, t);
        if now.inside {
            t += 2.0 * FINE;
            now = self.look(way, t);
        }
        way.gap = self.least_step;
        while now.until < leave && now.until < to.range().1 {
            if now.until > outside_until {
                match clear(way, now.until) {
                    Some(until) => outside_until = until,
                    None => return,
                }
            }
            let next = now.until + now.step;
            // So far away that a step changes nothing.
            if next <= now.until {
                return;
            }
            let seen = self.look(way, next);
            if seen.inside != now.inside && !to.settles(now.until, next) {
                let (near, far) = (now.until, next);
                let (near, far) =
                    (self.place(near, now.end, now.inside), self.place(far, seen.end, seen.inside));
                to.push(LocalHit::at(self.border(way, near, far)));
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

    /// What is proved is so, in the grid of the first fractal and in the coarser ones of later ones.
    fn proofs_hold(algebra: JuliaAlgebra, function: JuliaFunction, slice: [f64; 4]) {
        let [first, second, third] =
            [0, 8, 1024].map(|before| proved_points(algebra, function, slice, 6, before));
        assert!(first.1 > 30_000 && first.0 > 50, "only {first:?} are proved");
        assert!(first.0 >= second.0 && second.0 >= third.0 && second.1 >= third.1, "{third:?}");
        // Orbits that go on for long leave the numbers behind.
        for steps in [8, 9, 10, 11, 12, 20, 40] {
            let proved = proved_points(algebra, function, slice, steps, 8);
            assert!(proved.1 > 20_000, "{steps}: {proved:?}");
        }
    }

    /// How many points of a fine lattice that fits the grid nowhere are proved to be inside and outside.
    fn proved_points(
        algebra: JuliaAlgebra,
        function: JuliaFunction,
        slice: [f64; 4],
        max_iteration: u32,
        before: usize,
    ) -> (u32, u32) {
        let parameter = [-0.083, 0.1, -0.83, -0.025];
        let julia = Julia::new(
            &raggio_scene::Julia {
                algebra,
                function,
                parameter,
                max_iteration,
                precision: 20.0,
                slice,
                slice_distance: 0.05,
            },
            before,
        );
        let proved = julia.proved.as_ref().expect("a map that is proved of");
        let (mut insides, mut outsides) = (0, 0);
        for k in 0..64_000 {
            let p = Vec3::new(f64::from(k % 40), f64::from(k / 40 % 40), f64::from(k / 1600));
            let p = (p / 19.5 - Vec3::ONE) * julia.radius;
            let ray = Ray::new(p, Vec3::new(0.48, -0.6, 0.64));
            let (proof, until) = proved.at(&proved.course(&ray), 0.0);
            for t in [0.0, 0.3, 0.7, 1.0].map(|share| share * until) {
                let (p, same) = (ray.at(t), |stays| (proof == Proof::Inside) == stays);
                assert!(proof == Proof::Open || same(julia.stays(p)), "{p} {proof:?}");
            }
            insides += u32::from(proof == Proof::Inside);
            outsides += u32::from(proof == Proof::Outside);
            assert!(!julia.stays(p) || proved.hull.contains(p), "{p} is not in the hull");
        }
        (insides, outsides)
    }

    /// Orbits followed together end as they do one by one.
    #[test]
    fn orbits_together_end_as_alone() {
        use JuliaAlgebra::{Hypercomplex, Quaternion};
        use JuliaFunction::{Cube, Sqr};
        for (algebra, function) in [(Quaternion, Sqr), (Quaternion, Cube), (Hypercomplex, Sqr)] {
            let julia = Julia::new(
                &raggio_scene::Julia {
                    algebra,
                    function,
                    parameter: [-0.083, 0.1, -0.83, -0.025],
                    max_iteration: 8,
                    precision: 20.0,
                    slice: [0.1, 0.3, -0.2, 0.9],
                    slice_distance: 0.05,
                },
                0,
            );
            let mut seen = [0; 9];
            for k in 0..400 {
                let ray = Ray::new(Vec3::new(f64::from(k) / 200.0 - 1.0, 0.3, -2.0), Vec3::Z);
                let t = [0, 1, 2, 3].map(|lane| 0.7 + f64::from(k % 20) / 50.0 + 0.37 * f64::from(lane));
                for (t, end) in t.into_iter().zip(julia.ends(&julia.way(&ray), t)) {
                    let alone = julia.last_size(ray.at(t));
                    assert_eq!(end.0, alone.0, "{t}");
                    assert!((end.1 - alone.1).abs() < 1e-9 * alone.1, "{t} {end:?} {alone:?}");
                    seen[end.0 as usize] += 1;
                    if algebra == Hypercomplex {
                        let together = julia.look_closely(&mut julia.way(&ray), t);
                        let alone = julia.look_at(hypercomplex::Map::Square, &ray, t);
                        assert_eq!(together.inside, alone.inside);
                        assert!((together.step - alone.step).abs() < 1e-9, "{t} {}", together.step);
                    }
                }
            }
            assert!(seen[8] > 20 && seen.iter().filter(|&&n| n > 20).count() > 3, "{seen:?}");
        }
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
