//! Crackle: distances to the nearest of scattered points, one in each unit cell.
use raggio_math::noise::noise;
use raggio_math::turns::floors;
use raggio_math::{EPS, Vec3};
use raggio_scene as scene;

use super::each;
use super::few::{Few, of_two_nearest};
use super::scatter::{Around, Each, least, point_in};

/// A compiled `crackle`.
#[derive(Debug)]
pub(super) struct Crackle {
    pub(super) form: Vec3,
    pub(super) metric: Metric,
    pub(super) offset: f64,
    pub(super) solid: bool,
    noise: u8,
}

/// How far apart two points are. `power` is the distance to the power of the metric's number.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Metric {
    Euclid,
    /// Sum of absolute differences.
    Manhattan,
    /// Sum of the feature point's lead over the place, with signs: what `facets` makes of metric 1.
    Signed,
    /// Sum of third powers.
    Cubic,
    /// Sum of powers that are so many halves: roots and products make them.
    Halves(i32),
    /// Sum of powers.
    Power(f64),
}

impl Metric {
    /// The metric of crackle by its number.
    fn new(metric: f64) -> Self {
        match metric {
            2.0 => Metric::Euclid,
            1.0 => Metric::Manhattan,
            3.0 => Metric::Cubic,
            m if m > 0.0 && m <= 16.0 && (2.0 * m).fract() == 0.0 => Metric::Halves((2.0 * m) as i32),
            m => Metric::Power(m),
        }
    }

    /// The metric's number.
    pub(super) fn exponent(self) -> f64 {
        match self {
            Metric::Euclid => 2.0,
            Metric::Manhattan | Metric::Signed => 1.0,
            Metric::Cubic => 3.0,
            Metric::Halves(halves) => f64::from(halves) / 2.0,
            Metric::Power(m) => m,
        }
    }

    /// The metric of facets by its number.
    pub fn signed(metric: f64) -> Self {
        if metric == 1.0 { Metric::Signed } else { Metric::new(metric) }
    }

    /// What a difference along one axis adds to the power.
    #[inline]
    pub(super) fn term(self, d: f64) -> f64 {
        match self {
            Metric::Euclid => d * d,
            Metric::Manhattan => d.abs(),
            Metric::Signed => -d,
            Metric::Cubic => d.abs() * d * d,
            Metric::Halves(halves) => {
                let whole = d.abs().powi(halves / 2);
                if halves % 2 == 0 { whole } else { whole * d.abs().sqrt() }
            }
            Metric::Power(m) => d.abs().powf(m),
        }
    }

    #[inline]
    pub(super) fn power(self, d: Vec3) -> f64 {
        self.term(d.x) + self.term(d.y) + self.term(d.z)
    }

    pub(super) fn root(self, power: f64) -> f64 {
        match self {
            Metric::Euclid => power.sqrt(),
            Metric::Manhattan | Metric::Signed => power,
            Metric::Cubic => power.cbrt(),
            Metric::Halves(_) | Metric::Power(_) => power.powf(1.0 / self.exponent()),
        }
    }

    /// Is a point never nearer than its cell?
    fn grows(self) -> bool {
        match self {
            Metric::Euclid | Metric::Manhattan | Metric::Cubic | Metric::Halves(_) => true,
            Metric::Signed => false,
            Metric::Power(m) => m > 0.0,
        }
    }
}

/// The `N` nearest feature points: powers of their distances, ascending, and the nearest itself.
struct Nearest<const N: usize> {
    powers: [f64; N],
    point: Vec3,
    /// Where the nearest stands in the order that settles ties.
    order: usize,
}

/// Four points within so far of the first share a search.
const NEAR: f64 = 0.2;

/// Offsets of the 81 cells that count, the near ones first, each with its place in the order x, y, z ascending.
pub(super) static CELLS: [([i8; 3], u8); 81] = cells();

/// As many of them touch the middle one or are it.
pub(super) const NEAR_CELLS: usize = 27;

const fn cells() -> [([i8; 3], u8); 81] {
    let mut out = [([0; 3], 0); 81];
    let (mut ring, mut n) = (0, 0);
    while ring < 5 {
        let mut i = 0;
        let mut order = 0;
        while i < 125 {
            let d = [(i / 25) as i8 - 2, (i / 5 % 5) as i8 - 2, (i % 5) as i8 - 2];
            let squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            let far = (d[0].abs() == 2) as u8 + (d[1].abs() == 2) as u8 + (d[2].abs() == 2) as u8;
            if far <= 1 {
                if ring_of(squared) == ring {
                    out[n] = (d, order);
                    n += 1;
                }
                order += 1;
            }
            i += 1;
        }
        ring += 1;
    }
    out
}

/// Cells in shells about the middle one.
const fn ring_of(squared: i8) -> u8 {
    match squared {
        0 => 0,
        1 => 1,
        2 => 2,
        3 => 3,
        _ => 4,
    }
}

impl<const N: usize> Nearest<N> {
    /// Looks at the 27 cells around the point, and at the others only where they may count.
    #[inline]
    fn search(q: Vec3, metric: Metric) -> Self {
        if !metric.grows() {
            return Self::search_all(q, metric);
        }
        let base = floors(q - Vec3::splat(EPS));
        let f = q - base;
        let rim = (f + 1.0).min_element().min((2.0 - f).min_element());
        let mut near = Around::ask(base, |around| Self::among(around, q, metric));
        if metric.term(rim) > near.powers[N - 1] {
            return near;
        }
        if N == 1 {
            // Of equally near points it matters which comes first.
            return Self::search_all(q, metric);
        }
        near.look(q, metric, &CELLS[NEAR_CELLS..]);
        near
    }

    fn among(around: &Around, q: Vec3, metric: Metric) -> Self {
        let all = match metric {
            Metric::Euclid => around.each(q, |d| Metric::Euclid.power(d)),
            Metric::Manhattan => around.each(q, |d| Metric::Manhattan.power(d)),
            Metric::Cubic => around.each(q, |d| Metric::Cubic.power(d)),
            _ => Self::costly(around, q, metric),
        };
        let powers = least(&all);
        let point = if N == 1 { around.point_of(powers[0], &all) } else { Vec3::ZERO };
        Nearest { powers, point, order: 0 }
    }

    /// Powers of those points only that may be among the nearest by their greatest difference along an axis: a power is
    /// at least that difference's and at most three times that.
    fn costly(around: &Around, q: Vec3, metric: Metric) -> Each {
        let mut all = around.each(q, |d| d.abs().max_element());
        let limit = least::<N>(&all)[N - 1] * 3f64.powf(1.0 / metric.exponent()) * (1.0 + EPS);
        for (value, d) in all.iter_mut().zip(around.ways(q)) {
            *value = if *value <= limit { metric.power(d) } else { f64::INFINITY };
        }
        all
    }

    fn search_all(q: Vec3, metric: Metric) -> Self {
        let mut nearest = Nearest { powers: [f64::INFINITY; N], point: q, order: usize::MAX };
        nearest.look(q, metric, &CELLS);
        nearest
    }

    /// Looks at cells around that of the point.
    fn look(&mut self, q: Vec3, metric: Metric, cells: &[([i8; 3], u8)]) {
        let base = floors(q - Vec3::splat(EPS));
        let f = q - base;
        // What the way to the slab of cells two below .. two above adds at least, per axis.
        let term = |d: f64| metric.term(d);
        let gap = |f: f64| [term(f + 1.0), term(f), term(0.0), term(1.0 - f), term(2.0 - f)];
        let gaps = [gap(f.x), gap(f.y), gap(f.z)];
        let prune = metric.grows();
        for (d, order) in cells {
            let gap = |k: usize| gaps[k][(d[k] + 2) as usize];
            if prune && gap(0) + gap(1) + gap(2) > self.powers[N - 1] {
                continue;
            }
            let cell = base + Vec3::new(f64::from(d[0]), f64::from(d[1]), f64::from(d[2]));
            let point = point_in(cell);
            self.offer(metric.power(q - point), point, usize::from(*order));
        }
    }

    #[inline]
    fn offer(&mut self, power: f64, point: Vec3, order: usize) {
        if power < self.powers[0] || (power == self.powers[0] && order < self.order) {
            (self.point, self.order) = (point, order);
        }
        let mut power = power;
        for kept in &mut self.powers {
            if power < *kept {
                std::mem::swap(kept, &mut power);
            }
        }
    }
}

/// The feature point nearest to `q`.
pub(crate) fn nearest_feature(q: Vec3, metric: Metric) -> Vec3 {
    Nearest::<1>::search(q, metric).point
}

impl Crackle {
    pub fn new(settings: &scene::CrackleSettings, noise: u8) -> Self {
        let scene::CrackleSettings { form, metric, offset, solid } = *settings;
        Crackle { form, metric: Metric::new(metric), offset, solid, noise }
    }

    pub fn value(&self, p: Vec3) -> f64 {
        if self.solid {
            return noise(self.noise, nearest_feature(p, self.metric));
        }
        if self.form.z != 0.0 {
            return self.formed(Nearest::<3>::search(p, self.metric).powers);
        }
        if matches!(self.metric, Metric::Euclid) {
            let value = of_two_nearest(p, f64::INFINITY, |first, second| self.formed([first, second, 0.0]));
            if !value.is_nan() {
                return value;
            }
        }
        let [first, second] = Nearest::<2>::search(p, self.metric).powers;
        self.formed([first, second, 0.0])
    }

    /// The values at four points.
    pub fn value4(&self, points: &[Vec3; 4]) -> [f64; 4] {
        let middle = points[0];
        let radius = points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
        let asked = !self.solid && self.form.z == 0.0 && matches!(self.metric, Metric::Euclid);
        let few = if asked && radius < NEAR { Few::around(middle, radius) } else { None };
        each(points, |&p| match &few {
            Some(few) => {
                let [first, second] = few.two_nearest(p);
                self.formed([first, second, 0.0])
            }
            None => self.value(p),
        })
    }

    /// What the form makes of the powers of the three least distances.
    #[inline]
    fn formed(&self, powers: [f64; 3]) -> f64 {
        let moved = if self.offset == 0.0 { 0.0 } else { self.metric.term(self.offset) };
        let distance = |k: usize| if self.form[k] == 0.0 { 0.0 } else { self.metric.root(powers[k] + moved) };
        self.form.dot(Vec3::new(distance(0), distance(1), distance(2))).clamp(0.0, 1.0)
    }

    /// Is it the difference of the distances to the two nearest points, as it is where a scene says nothing?
    pub fn is_usual(&self) -> bool {
        let plain = matches!(self.metric, Metric::Euclid) && self.offset == 0.0;
        plain && !self.solid && self.form == Vec3::new(-1.0, 1.0, 0.0)
    }

    /// The value of the usual crackle; `None` where it is above `bound`.
    pub fn value_unless_above(&self, p: Vec3, bound: f64) -> Option<f64> {
        let mut difference = of_two_nearest(p, bound, |first, second| second.sqrt() - first.sqrt());
        if difference.is_nan() {
            let [first, second] = Nearest::<2>::search(p, Metric::Euclid).powers;
            difference = second.sqrt() - first.sqrt();
        }
        let value = difference.clamp(0.0, 1.0);
        (value <= bound).then_some(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All 81 cells, none skipped.
    fn exhaustive(q: Vec3, metric: Metric) -> [f64; 3] {
        let base = floors(q - Vec3::splat(EPS));
        let mut all: Vec<f64> = CELLS
            .iter()
            .map(|(d, _)| {
                let cell = base + Vec3::new(f64::from(d[0]), f64::from(d[1]), f64::from(d[2]));
                metric.power(q - point_in(cell))
            })
            .collect();
        all.sort_by(f64::total_cmp);
        [all[0], all[1], all[2]]
    }

    #[test]
    fn skipping_far_cells_changes_nothing() {
        for i in 0..1000 {
            let t = f64::from(i);
            let q = Vec3::new(t * 0.37 - 20.0, 13.0 - t * 0.11, t * 0.053);
            for metric in [2.0, 1.0, 3.0, 4.0, 2.5, 0.5, 2.2, 0.3].map(Metric::new) {
                let all = exhaustive(q, metric);
                assert_eq!(Nearest::<3>::search(q, metric).powers, all, "{q} {metric:?}");
                assert_eq!(Nearest::<3>::search_all(q, metric).powers, all, "{q} {metric:?}");
                let (one, same) = (Nearest::<1>::search(q, metric), Nearest::<1>::search_all(q, metric));
                assert_eq!((one.powers[0], one.point), (all[0], same.point), "{q} {metric:?}");
            }
        }
    }

    const USUAL: Crackle = Crackle {
        form: Vec3::new(-1.0, 1.0, 0.0),
        metric: Metric::Euclid,
        offset: 0.0,
        solid: false,
        noise: 2,
    };

    #[test]
    fn few_points_give_what_all_give() {
        for i in 0..20_000 {
            let t = f64::from(i);
            let q = Vec3::new(t * 0.37 - 20.0, 13.0 - t * 0.11, t * 0.053);
            for q in [q, q + 0.003] {
                let all = exhaustive(q, Metric::Euclid);
                let value = (all[1].sqrt() - all[0].sqrt()).min(1.0);
                assert_eq!(USUAL.value(q), value, "{q}");
            }
            let points = [q, q + 0.02, q - Vec3::X * 0.1, q + Vec3::Y * 0.2 * (i % 2) as f64];
            assert_eq!(USUAL.value4(&points), points.map(|p| USUAL.value(p)), "{q}");
        }
    }

    #[test]
    fn what_is_known_near_by_holds() {
        let usual = &USUAL;
        let mut known = 0;
        for i in 0..40_000 {
            let t = f64::from(i) * 1e-3;
            let p = Vec3::new(t, 0.3 * t - 7.0, 5.0 * (0.01 * t).sin());
            let value = usual.value(p);
            match usual.value_unless_above(p, 0.1) {
                Some(found) => assert_eq!(found, value, "{p}"),
                None => {
                    known += 1;
                    assert!(value > 0.1, "{p}");
                }
            }
        }
        assert!(known > 20_000, "{known}");
    }

    #[test]
    fn the_cells_are_81_and_start_in_the_middle() {
        assert_eq!(CELLS[0], ([0, 0, 0], 40));
        let mut orders: Vec<u8> = CELLS.iter().map(|c| c.1).collect();
        orders.sort_unstable();
        assert_eq!(orders, (0..81).collect::<Vec<u8>>());
    }
}
