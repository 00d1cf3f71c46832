//! The few scattered points of crackle that count in a small part of space. How far the second nearest is changes by no
//! more than the way, so that what is too far from the middle of a ball is too far anywhere in it.
use std::cell::RefCell;

use raggio_math::turns::floors;
use raggio_math::{EPS, Vec3};

use super::crackle::{CELLS, Metric, NEAR_CELLS};
use super::scatter::{Around, in_order, least, point_in};

/// Space is cut into so many blocks along a unit.
const FINENESS: f64 = 8.0;
/// From the middle of a block to its corners.
const HALF_DIAGONAL: f64 = 0.866_025_403_784_438_6 / FINENESS;
/// How many blocks a thread remembers.
const KEPT: usize = 1024;
/// Farther out there is no telling blocks apart.
const FARTHEST: f64 = 1e6;
/// No more points than this count as few.
const MOST: usize = 8;
/// Points nearer than this are among those that evaluation looks at: the nearest that it leaves out lie two cells away
/// along two axes.
const SIGHT: f64 = std::f64::consts::SQRT_2;
/// Added to a number below 2^51 it leaves the nearest whole number in the low bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// For rounding.
const MARGIN: f64 = 1e-9;

thread_local! {
    static BLOCKS: RefCell<[Block; KEPT]> = const { RefCell::new([Block::NOWHERE; KEPT]) };
}

/// All points that may be the nearest or the second nearest to a place in a ball.
pub(super) struct Few {
    /// How many; 0 where they are too many.
    count: usize,
    /// By coordinate; infinite at places that are left.
    points: [[f64; MOST]; 3],
}

impl Few {
    /// No points, and no place for any.
    const NOTHING: Few = Few { count: 0, points: [[0.0; MOST]; 3] };
    /// No points yet.
    const NONE: Few = Few { count: 0, points: [[f64::INFINITY; MOST]; 3] };

    /// Those of a ball, unless they are many.
    pub fn around(middle: Vec3, radius: f64) -> Option<Few> {
        let mut few = Few::NONE;
        few.gather(middle, radius);
        (few.count > 0).then_some(few)
    }

    /// Finds those of a ball; gives the squared distances from its middle to the two nearest.
    fn gather(&mut self, middle: Vec3, radius: f64) -> [f64; 2] {
        *self = Few::NONE;
        let cell = floors(middle - Vec3::splat(EPS));
        Around::ask(cell, |around| {
            let powers = around.each(middle, |d| Metric::Euclid.power(d));
            let [first, second] = least(&powers);
            let limit = second.sqrt() + 2.0 * radius + MARGIN;
            if limit >= SIGHT {
                return [first, second];
            }
            let limit = limit * limit;
            for (i, &power) in powers.iter().enumerate() {
                if power <= limit {
                    self.add(around.point(i));
                }
            }
            self.gather_beyond(middle, cell, limit);
            self.count *= usize::from(self.count <= MOST);
            [first, second]
        })
    }

    /// Finds those in cells two away from that of the ball's middle.
    #[inline]
    fn gather_beyond(&mut self, middle: Vec3, cell: Vec3, limit: f64) {
        let f = middle - cell;
        let (low, high) = (f + 1.0, 2.0 - f);
        let rim = low.min(high).min_element();
        if rim * rim > limit {
            return;
        }
        let gaps = [low, f, Vec3::ZERO, 1.0 - f, high].map(|gap| gap * gap);
        for (d, _) in &CELLS[NEAR_CELLS..] {
            let gap = |k: usize| gaps[(d[k] + 2) as usize][k];
            if gap(0) + gap(1) + gap(2) <= limit {
                let point = point_in(cell + Vec3::from(d.map(f64::from)));
                if Metric::Euclid.power(middle - point) <= limit {
                    self.add(point);
                }
            }
        }
    }

    #[inline]
    fn add(&mut self, point: Vec3) {
        if self.count < MOST {
            for (row, c) in self.points.iter_mut().zip(point.to_array()) {
                row[self.count] = c;
            }
        }
        self.count += 1;
    }

    /// The squared distances to the two nearest.
    #[inline]
    pub fn two_nearest(&self, q: Vec3) -> [f64; 2] {
        let [x, y, z] = &self.points;
        let power = |i: usize| Metric::Euclid.power(q - Vec3::new(x[i], y[i], z[i]));
        let four = |i: usize| [power(i), power(i + 1), power(i + 2), power(i + 3)];
        let [a, b, c, d] = four(0);
        let ((a, b), (c, d)) = (in_order(a, b), in_order(c, d));
        let ((first, c), second) = (in_order(a, c), b.min(d));
        if self.count <= 4 {
            return [first, c.min(second)];
        }
        let second = c.min(second);
        let [a, b, c, d] = four(4);
        let ((a, b), (c, d)) = (in_order(a, b), in_order(c, d));
        let (a, c) = in_order(a, c);
        let (first, a) = in_order(first, a);
        [first, second.min(a).min(b.min(d)).min(c)]
    }
}

/// A part of space with what counts in it.
struct Block {
    /// Its lower corner, in parts of a unit, with `ROUND` added.
    mark: Vec3,
    /// Everywhere in it the second nearest point is so much farther than the nearest.
    least: f64,
    few: Few,
}

impl Block {
    /// No place. All is zero, so that memory costs nothing where nobody asks.
    const NOWHERE: Block = Block { mark: Vec3::ZERO, least: 0.0, few: Few::NOTHING };

    #[cold]
    fn fill(&mut self, mark: Vec3) {
        self.mark = mark;
        let middle = (mark - ROUND + 0.5) / FINENESS;
        let [first, second] = self.few.gather(middle, HALF_DIAGONAL);
        self.least = second.sqrt() - first.sqrt() - 2.0 * HALF_DIAGONAL - MARGIN;
        // Of points that evaluation does not look at nothing is known.
        if self.few.count == 0 {
            self.least = f64::NEG_INFINITY;
        }
    }
}

/// What is made of the squared distances to the two nearest points: infinity where the distances are sure to differ by
/// more than a bound, NaN where a search has to find them. (Numbers come back in registers.)
#[inline]
pub(super) fn of_two_nearest(q: Vec3, bound: f64, answer: impl FnOnce(f64, f64) -> f64) -> f64 {
    if !q.abs().cmplt(Vec3::splat(FARTHEST)).all() {
        return f64::NAN;
    }
    let mark = (q * FINENESS - 0.5) + ROUND;
    let mixed = mark.x.to_bits().wrapping_mul(73_856_093)
        ^ mark.y.to_bits().wrapping_mul(19_349_663)
        ^ mark.z.to_bits().wrapping_mul(83_492_791);
    BLOCKS.with_borrow_mut(|blocks| {
        let block = &mut blocks[mixed as usize % KEPT];
        if block.mark != mark {
            block.fill(mark);
        }
        if block.least > bound {
            return f64::INFINITY;
        }
        if block.few.count == 0 {
            return f64::NAN;
        }
        let [first, second] = block.few.two_nearest(q);
        answer(first, second)
    })
}
