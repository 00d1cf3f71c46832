//! Bounds of crackle over a box.
//!
//! The k-th least distance lies between the k-th least of the distances' least values in the box and the k-th least of
//! their greatest ones. It is everywhere the distance of a point that comes into question there, so a difference
//! quotient of it is a mean of the slopes of such distances.
use raggio_function::{Bounds, Range};
use raggio_math::{EPS, Vec3};
use smallvec::SmallVec;

use super::crackle::{Crackle, Metric};
use super::scatter::point_in;

/// Boxes longer than this hold many points and tell little.
const LONGEST: f64 = 1.0;
/// Farther out there is no telling cells apart.
const FARTHEST: f64 = 1e9;

/// Evaluation looks at cells so far away from its own, but not along two axes at once.
const REACH: u32 = 2;

/// Cells at one place along an axis.
struct Slab {
    cell: f64,
    /// The metric's power of the gap between them and the box.
    gap: f64,
    /// 0 where they touch all cells of the box, 1 where they lie at most one farther, 2 beyond.
    far: u32,
}

/// A feature point seen from a box.
struct Seen {
    /// From the point to the box, along each axis.
    way: [Range; 3],
    /// The metric's power of the distance.
    power: Range,
    /// Is it among those that count, wherever in the box one stands?
    counts: bool,
}

impl Crackle {
    /// Where the values lie over bounds of a point, and their slopes.
    pub(super) fn enclose(&self, p: &[Bounds; 3]) -> Bounds {
        let long = |p: &Bounds| p.is_vague() || p.value.width() > LONGEST || p.value.size() > FARTHEST;
        if self.solid || self.metric.exponent() < 1.0 || p.iter().any(long) {
            return Bounds::UNKNOWN;
        }
        let Some(last) = (0..3).rev().find(|&k| self.form[k] != 0.0) else { return Bounds::constant(0.0) };
        let seen = self.seen(p.map(|p| p.value), last);
        let mut sum = Bounds::constant(0.0);
        for k in (0..=last).filter(|&k| self.form[k] != 0.0) {
            let Some((value, gradient)) = self.ranked(&seen, k) else { return Bounds::UNKNOWN };
            sum += Bounds::of_point(value, gradient, p) * self.form[k];
        }
        sum.clamp(0.0, 1.0)
    }

    /// The feature points that may be the `last` nearest or nearer, and maybe others.
    fn seen(&self, place: [Range; 3], last: usize) -> Vec<Seen> {
        let [xs, ys, zs] = place.map(|r| self.slabs(r));
        let mut seen = Vec::with_capacity(32);
        // No point beyond the greatest of the least powers counts.
        let mut least = [f64::INFINITY; 3];
        for x in &xs {
            for y in &ys {
                let gap = self.start() + x.gap + y.gap;
                for z in &zs {
                    if gap + z.gap > least[last] {
                        break;
                    }
                    let far = x.far + y.far + z.far;
                    let point = point_in(Vec3::new(x.cell, y.cell, z.cell));
                    let point = self.see(point, place, far <= 1);
                    offer(&mut least, point.power.hi);
                    seen.push(point);
                }
            }
        }
        seen.retain(|s| s.power.lo <= least[last]);
        seen
    }

    /// The cells along an axis, the nearest first.
    fn slabs(&self, place: Range) -> SmallVec<[Slab; 6]> {
        let (first, last) = ((place.lo - EPS).floor(), (place.hi - EPS).floor());
        let count = (last - first) as u32 + 2 * REACH + 1;
        let mut slabs: SmallVec<[Slab; 6]> = (0..count)
            .map(|i| {
                let cell = first - f64::from(REACH) + f64::from(i);
                let gap = (cell - place.hi).max(place.lo - cell - 1.0).max(0.0);
                let away = (last - cell).max(cell - first);
                let far = if away > 2.0 { 2 } else { u32::from(away == 2.0) };
                Slab { cell, gap: self.metric.term(gap), far }
            })
            .collect();
        slabs.sort_by(|a, b| a.gap.total_cmp(&b.gap));
        slabs
    }

    fn see(&self, point: Vec3, place: [Range; 3], counts: bool) -> Seen {
        let way = |k: usize| Range { lo: place[k].lo - point[k], hi: place[k].hi - point[k] };
        let way = [way(0), way(1), way(2)];
        let [x, y, z] = [self.term(way[0]), self.term(way[1]), self.term(way[2])];
        let start = self.start();
        let power = Range { lo: start + x.lo + y.lo + z.lo, hi: start + x.hi + y.hi + z.hi };
        Seen { way, power, counts }
    }

    /// What the offset adds to each power.
    fn start(&self) -> f64 {
        if self.offset == 0.0 { 0.0 } else { self.metric.term(self.offset) }
    }

    /// What a way along an axis adds to the power.
    fn term(&self, way: Range) -> Range {
        let nearest = way.lo.max(-way.hi).max(0.0);
        Range { lo: self.metric.term(nearest), hi: self.metric.term(way.size()) }
    }

    /// The distance of the point number `k`, counted from the nearest, and its gradient.
    fn ranked(&self, seen: &[Seen], k: usize) -> Option<(Range, [Range; 3])> {
        let power = Range {
            lo: least(seen.iter().map(|s| s.power.lo))[k],
            hi: least(seen.iter().map(|s| s.power.hi))[k],
        };
        let mut gradient: Option<[Range; 3]> = None;
        for s in seen.iter().filter(|s| s.power.lo <= power.hi) {
            if !s.counts {
                return None;
            }
            if s.power.hi >= power.lo {
                let slopes = self.slopes(s);
                gradient = Some(gradient.map_or(slopes, |g| std::array::from_fn(|k| g[k].hull(slopes[k]))));
            }
        }
        let value = Range::new(self.metric.root(power.lo), self.metric.root(power.hi));
        Some((value, gradient?))
    }

    /// The slopes of a point's distance along the axes. They rise with the way along the axis, and are the flatter the
    /// farther the point is along the other two.
    fn slopes(&self, seen: &Seen) -> [Range; 3] {
        std::array::from_fn(|k| {
            let own = self.term(seen.way[k]);
            let rest = Range { lo: seen.power.lo - own.lo, hi: seen.power.hi - own.hi };
            let Range { lo, hi } = seen.way[k];
            Range {
                lo: self.slope(lo, if lo > 0.0 { rest.hi } else { rest.lo }),
                hi: self.slope(hi, if hi > 0.0 { rest.lo } else { rest.hi }),
            }
        })
    }

    /// The slope of the distance along an axis, for the way there and what the others add to the power.
    fn slope(&self, way: f64, rest: f64) -> f64 {
        let own = self.metric.term(way.abs());
        match self.metric {
            Metric::Manhattan => 1_f64.copysign(way),
            _ if own == 0.0 => 0.0,
            Metric::Euclid => way / (own + rest.max(0.0)).sqrt(),
            _ => {
                let exponent = self.metric.exponent();
                (own / (own + rest.max(0.0))).powf((exponent - 1.0) / exponent).copysign(way)
            }
        }
    }
}

/// The three least numbers, ascending.
fn least(numbers: impl Iterator<Item = f64>) -> [f64; 3] {
    let mut least = [f64::INFINITY; 3];
    numbers.for_each(|number| offer(&mut least, number));
    least
}

/// Takes a number that may be among the least.
#[inline]
fn offer(least: &mut [f64; 3], mut number: f64) {
    for kept in least {
        if number < *kept {
            std::mem::swap(kept, &mut number);
        }
    }
}

#[cfg(test)]
mod tests {
    use raggio_scene::CrackleSettings;

    use super::*;

    /// Numbers spread over 0..1.
    fn share(i: u32, by: f64) -> f64 {
        (f64::from(i) * by).fract()
    }

    #[test]
    fn values_and_slopes_lie_within_their_bounds() {
        let mut known = 0;
        for (form, metric, offset) in [
            ([1.0, 0.0, 0.0], 2.0, 0.0),
            ([-1.0, 1.0, 0.0], 2.0, 0.3),
            ([0.5, 0.5, -0.6], 2.5, 0.5),
            ([-0.2, 0.0, 0.9], 1.0, 0.0),
            ([1.1, 0.0, 0.0], 4.0, 1.0),
            ([-0.5, 1.0, -0.5], 2.2, 0.0),
        ] {
            let settings = CrackleSettings { form: form.into(), metric, offset, solid: false };
            let crackle = Crackle::new(&settings, 2);
            for i in 0..300 {
                let size = 0.02 + 0.3 * share(i, 0.37);
                let corner = Vec3::new(share(i, 0.713), share(i, 0.519), share(i, 0.831)) * 20.0 - 10.0;
                let place: [Range; 3] =
                    std::array::from_fn(|k| Range { lo: corner[k], hi: corner[k] + size });
                let bounds = crackle.enclose(&std::array::from_fn(|k| Bounds::variable(k, place[k])));
                if bounds.is_vague() {
                    continue;
                }
                known += 1;
                let holds = |r: Range, v: f64| r.lo - 1e-9 <= v && v <= r.hi + 1e-9;
                for j in 0..20 {
                    let inside = Vec3::new(share(j, 0.317), share(j, 0.619), share(j, 0.223));
                    let p = corner + inside * size;
                    let here = crackle.value(p);
                    assert!(holds(bounds.value, here), "{here} at {p} is outside {bounds:?}");
                    for k in 0..3 {
                        let mut q = p;
                        q[k] = corner[k] + share(j + i, 0.447) * size;
                        let slope = (crackle.value(q) - here) / (q[k] - p[k]);
                        let steady = (q[k] - p[k]).abs() > 1e-3 * size;
                        assert!(!steady || holds(bounds.slopes[k], slope), "{slope} along {k}: {bounds:?}");
                    }
                }
            }
        }
        assert!(known > 1500, "{known}");
    }
}
