//! Crackle: distances to the nearest of scattered points, one in each unit cell.
use raggio_math::noise::{hash3, noise, random3};
use raggio_math::{EPS, Vec3};
use raggio_scene as scene;

/// A compiled `crackle`.
#[derive(Debug)]
pub(super) struct Crackle {
    form: Vec3,
    metric: Metric,
    offset: f64,
    solid: bool,
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
            m => Metric::Power(m),
        }
    }

    /// The metric of facets by its number.
    pub fn signed(metric: f64) -> Self {
        if metric == 1.0 { Metric::Signed } else { Metric::new(metric) }
    }

    /// What a difference along one axis adds to the power.
    #[inline]
    fn term(self, d: f64) -> f64 {
        match self {
            Metric::Euclid => d * d,
            Metric::Manhattan => d.abs(),
            Metric::Signed => -d,
            Metric::Cubic => d.abs() * d * d,
            Metric::Power(m) => d.abs().powf(m),
        }
    }

    #[inline]
    fn power(self, d: Vec3) -> f64 {
        self.term(d.x) + self.term(d.y) + self.term(d.z)
    }

    fn root(self, power: f64) -> f64 {
        match self {
            Metric::Euclid => power.sqrt(),
            Metric::Manhattan | Metric::Signed => power,
            Metric::Cubic => power.cbrt(),
            Metric::Power(m) => power.powf(1.0 / m),
        }
    }

    /// Is a point never nearer than its cell?
    fn grows(self) -> bool {
        match self {
            Metric::Euclid | Metric::Manhattan | Metric::Cubic => true,
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

/// Offsets of the 81 cells that count, the near ones first, each with its place in the order x, y, z ascending.
static CELLS: [([i8; 3], u8); 81] = cells();

/// As many of them touch the middle one or are it.
const NEAR_CELLS: usize = 27;

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
    fn search(q: Vec3, metric: Metric) -> Self {
        let base = (q - Vec3::splat(EPS)).floor();
        let f = q - base;
        // What the way to the slab of cells two below .. two above adds at least, per axis.
        let term = |d: f64| metric.term(d);
        let gap = |f: f64| [term(f + 1.0), term(f), term(0.0), term(1.0 - f), term(2.0 - f)];
        let gaps = [gap(f.x), gap(f.y), gap(f.z)];
        let rim = |gap: &[f64; 5]| gap[0].min(gap[4]);
        let far = rim(&gaps[0]).min(rim(&gaps[1])).min(rim(&gaps[2]));
        let prune = metric.grows();
        let mut nearest = Nearest { powers: [f64::INFINITY; N], point: base, order: usize::MAX };
        for (i, (d, order)) in CELLS.iter().enumerate() {
            let gap = |k: usize| gaps[k][(d[k] + 2) as usize];
            if prune && i == NEAR_CELLS && far > nearest.powers[N - 1] {
                break;
            }
            if prune && gap(0) + gap(1) + gap(2) > nearest.powers[N - 1] {
                continue;
            }
            let cell = base + Vec3::new(f64::from(d[0]), f64::from(d[1]), f64::from(d[2]));
            let point = cell + Vec3::from(random3(hash3(cell.x as i64, cell.y as i64, cell.z as i64)));
            nearest.offer(metric.power(q - point), point, usize::from(*order));
        }
        nearest
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
        let mut powers = Nearest::<3>::search(p, self.metric).powers;
        if self.offset != 0.0 {
            powers = powers.map(|power| power + self.metric.term(self.offset));
        }
        let distance = |k: usize| if self.form[k] == 0.0 { 0.0 } else { self.metric.root(powers[k]) };
        self.form.dot(Vec3::new(distance(0), distance(1), distance(2))).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All 81 cells, none skipped.
    fn exhaustive(q: Vec3, metric: Metric) -> [f64; 3] {
        let base = (q - Vec3::splat(EPS)).floor();
        let mut all: Vec<f64> = CELLS
            .iter()
            .map(|(d, _)| {
                let cell = base + Vec3::new(f64::from(d[0]), f64::from(d[1]), f64::from(d[2]));
                let s = hash3(cell.x as i64, cell.y as i64, cell.z as i64);
                metric.power(q - (cell + Vec3::from(random3(s))))
            })
            .collect();
        all.sort_by(f64::total_cmp);
        [all[0], all[1], all[2]]
    }

    #[test]
    fn skipping_far_cells_changes_nothing() {
        for i in 0..300 {
            let t = f64::from(i);
            let q = Vec3::new(t * 0.37 - 20.0, 13.0 - t * 0.11, t * 0.053);
            for metric in [Metric::Euclid, Metric::Manhattan, Metric::Power(3.0), Metric::Power(0.5)] {
                assert_eq!(Nearest::<3>::search(q, metric).powers, exhaustive(q, metric), "{q} {metric:?}");
            }
        }
    }

    #[test]
    fn the_cells_are_81_and_start_in_the_middle() {
        assert_eq!(CELLS[0], ([0, 0, 0], 40));
        let mut orders: Vec<u8> = CELLS.iter().map(|c| c.1).collect();
        orders.sort_unstable();
        assert_eq!(orders, (0..81).collect::<Vec<u8>>());
    }
}
