//! Maps: what a pattern's value looks up (textures spec, section 9.1).
use raggio_function::{Bounds, Range};
use raggio_image::Color;

/// Entries by position.
#[derive(Debug)]
pub(crate) struct Map<T> {
    positions: Box<[f32]>,
    items: Box<[T]>,
    /// Do positions never fall? The language neither sorts nor checks them.
    sorted: bool,
}

/// Maps shorter than this are walked, longer ones halved.
const WALK: usize = 12;

/// What lies at a value.
#[derive(Debug, PartialEq)]
pub(crate) enum Blend<'a, T> {
    /// One entry alone; `None` in an empty map.
    One(Option<&'a T>),
    /// Between two entries, at this fraction of the way.
    Two(&'a T, &'a T, f64),
}

impl<T> Map<T> {
    pub fn new(entries: impl IntoIterator<Item = (f32, T)>) -> Self {
        let (positions, items): (Vec<f32>, Vec<T>) = entries.into_iter().unzip();
        let sorted = positions.is_sorted();
        Map { positions: positions.into(), items: items.into(), sorted }
    }

    /// The entry at a value, or the two around it.
    #[inline(always)]
    pub fn at(&self, value: f64) -> Blend<'_, T> {
        match self.positions.last() {
            Some(&last) if value < f64::from(last) => {}
            _ => return Blend::One(self.items.last()),
        }
        let above = self.first_not_below(value);
        let Some(previous) = above.checked_sub(1) else { return Blend::One(self.items.first()) };
        let (low, high) = (f64::from(self.positions[previous]), f64::from(self.positions[above]));
        if value == high {
            return Blend::One(self.items.get(above));
        }
        Blend::Two(&self.items[previous], &self.items[above], (value - low) / (high - low))
    }

    /// The index of the first entry whose position is at least `value`; there is one.
    #[inline]
    fn first_not_below(&self, value: f64) -> usize {
        let below = |&position: &f32| value > f64::from(position);
        if self.sorted && self.positions.len() > WALK {
            self.positions.partition_point(below)
        } else {
            self.positions.iter().take_while(|p| below(p)).count()
        }
    }

    /// All entries, with what an average takes for their weights.
    pub fn weighted(&self) -> impl Iterator<Item = (f32, &T)> {
        self.positions.iter().copied().zip(&self.items)
    }

    /// The sum of those weights; 1 in place of 0, which would divide.
    pub fn total_weight(&self) -> f64 {
        let total: f64 = self.positions.iter().map(|&w| f64::from(w)).sum();
        if total == 0.0 { 1.0 } else { total }
    }

    /// The last entry, and the position from which on there is nothing else.
    pub fn tail(&self) -> Option<(f64, &T)>
    where
        T: PartialEq,
    {
        let last = self.items.last().filter(|_| self.sorted)?;
        let others = self.items.iter().rposition(|item| item != last).map_or(0, |i| i + 1);
        Some((f64::from(self.positions[others]), last))
    }

    pub fn items(&self) -> impl ExactSizeIterator<Item = &T> {
        self.items.iter()
    }
}

/// Components of colours are found in single precision.
const COARSE: f64 = 1e-7;

impl Map<Color> {
    /// Bounds of the colour's components over bounds of the value; nothing is known where the colour jumps.
    pub fn enclose(&self, v: Bounds) -> [Bounds; 5] {
        let Range { lo, hi } = v.value;
        let (Some(&first), Some(&last)) = (self.positions.first(), self.positions.last()) else {
            return [Bounds::constant(0.0); 5];
        };
        let jumps = self.positions.windows(2).any(|w| w[0] == w[1] && v.value.contains(f64::from(w[0])));
        if v.is_vague() || !self.sorted || jumps {
            return [Bounds::UNKNOWN; 5];
        }
        let at = |v: f64| match self.at(v) {
            Blend::One(color) => color.copied().unwrap_or_default(),
            Blend::Two(low, high, t) => low.lerp(*high, t),
        };
        let entries = || self.positions.iter().map(|&p| f64::from(p)).zip(self.items.iter());
        std::array::from_fn(|k| {
            let mut value = Range::one(at(lo).to_array()[k]).hull(Range::one(at(hi).to_array()[k]));
            // Beyond the ends nothing changes.
            let flat = lo < f64::from(first) || hi > f64::from(last) || first == last;
            let mut slope = flat.then_some(Range::ZERO);
            for ((p, a), (q, b)) in entries().zip(entries().skip(1)) {
                let (a, b) = (a.to_array()[k], b.to_array()[k]);
                if p <= hi && lo <= q && p < q {
                    let here = Range::one((b - a) / (q - p));
                    slope = Some(slope.map_or(here, |s| s.hull(here)));
                }
                for (place, v) in [(p, a), (q, b)] {
                    if lo < place && place < hi {
                        value = value.hull(Range::one(v));
                    }
                }
            }
            v.through(value + Range::within(COARSE * value.size()), slope.unwrap_or(Range::ZERO))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(positions: &[f32]) -> Map<usize> {
        Map::new(positions.iter().copied().zip(0..))
    }

    #[test]
    fn values_outside_take_the_nearest_end() {
        let m = map(&[0.25, 0.5]);
        assert_eq!(m.at(0.1), Blend::One(Some(&0)));
        assert_eq!(m.at(0.5), Blend::One(Some(&1)));
        assert_eq!(m.at(7.0), Blend::One(Some(&1)));
        assert_eq!(m.at(f64::NAN), Blend::One(Some(&1)));
    }

    #[test]
    fn between_two_entries_both_count() {
        assert_eq!(map(&[0.0, 0.5, 1.0]).at(0.625), Blend::Two(&1, &2, 0.25));
        assert_eq!(map(&[0.0, 0.5, 1.0]).at(0.5), Blend::One(Some(&1)));
    }

    #[test]
    fn of_two_entries_at_one_place_the_first_wins_at_it() {
        let m = map(&[0.0, 0.5, 0.5, 1.0]);
        assert_eq!(m.at(0.5), Blend::One(Some(&1)));
        assert!(matches!(m.at(0.5 + 1e-9), Blend::Two(&2, &3, _)));
    }

    #[test]
    fn unsorted_maps_are_walked_from_the_start() {
        let m = map(&[0.6, 0.2, 0.9]);
        assert_eq!(m.at(0.3), Blend::One(Some(&0)));
        assert!(matches!(m.at(0.7), Blend::Two(&1, &2, _)));
    }

    #[test]
    fn halving_finds_what_walking_finds() {
        let positions: Vec<f32> = (0..40).map(|i| (i / 2) as f32 / 20.0).collect();
        let halved = map(&positions);
        let walked = Map { sorted: false, ..map(&positions) };
        for i in 0..200 {
            let v = f64::from(i) / 190.0;
            assert_eq!(halved.at(v), walked.at(v), "{v}");
        }
    }

    #[test]
    fn the_tail_is_what_stays_the_same_to_the_end() {
        let colors = |all: &[(f32, char)]| Map::new(all.iter().copied());
        assert_eq!(
            colors(&[(0.0, 'a'), (0.1, 'b'), (0.5, 'b'), (1.0, 'b')]).tail(),
            Some((f64::from(0.1f32), &'b'))
        );
        assert_eq!(colors(&[(0.2, 'a')]).tail(), Some((f64::from(0.2f32), &'a')));
        assert_eq!(colors(&[(0.6, 'a'), (0.2, 'b')]).tail(), None);
    }

    #[test]
    fn bounds_of_colours_hold_what_lies_between() {
        let grey = |v: f32| Color { rgb: raggio_image::Rgb::splat(v), ..Color::default() };
        let map = Map::new([(0.0, grey(0.0)), (0.5, grey(1.0)), (1.0, grey(0.5))]);
        let over = |lo: f64, hi: f64| map.enclose(Bounds::variable(0, Range::new(lo, hi)))[0];
        let close = |r: Range, lo: f64, hi: f64| (r.lo - lo).abs() < 1e-6 && (r.hi - hi).abs() < 1e-6;
        let rising = over(0.1, 0.4);
        assert!(close(rising.value, 0.2, 0.8) && close(rising.slopes[0], 2.0, 2.0), "{rising:?}");
        let bent = over(0.4, 0.75);
        assert!(close(bent.value, 0.75, 1.0) && close(bent.slopes[0], -1.0, 2.0), "{bent:?}");
        let beyond = over(0.75, 1.5);
        assert!(close(beyond.value, 0.5, 0.75) && close(beyond.slopes[0], -1.0, 0.0), "{beyond:?}");
        let jumping = Map::new([(0.0, grey(0.0)), (0.5, grey(0.2)), (0.5, grey(1.0))]);
        assert!(jumping.enclose(Bounds::variable(0, Range::new(0.4, 0.6)))[0].is_vague());
    }

    #[test]
    fn an_empty_map_has_nothing() {
        assert_eq!(map(&[]).at(0.5), Blend::One(None));
    }
}
