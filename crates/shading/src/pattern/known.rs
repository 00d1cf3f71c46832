//! What is known of crackle from values near by: the difference of two distances changes by no more than twice the way.
use std::cell::RefCell;

use raggio_math::Vec3;
use raggio_math::turns::floors;

/// How fast the difference of the distances to the two nearest points may grow or fall.
const STEEPNESS: f64 = 2.0;
/// Space is cut into so many places along a unit; each remembers its last value.
const FINENESS: f64 = 8.0;
/// How many places a thread remembers.
const KEPT: usize = 2048;
/// Feature points nearer than this are among those that the search looks at: the nearest that it leaves out lie two
/// cells away along two axes.
const SIGHT: f64 = std::f64::consts::SQRT_2;
/// For rounding.
const MARGIN: f64 = 1e-9;

thread_local! {
    static KNOWN: RefCell<[Known; KEPT]> = const { RefCell::new([Known::NOTHING; KEPT]) };
}

/// The distances to the two nearest feature points at a place.
#[derive(Clone, Copy)]
struct Known {
    place: Vec3,
    value: f64,
    second: f64,
}

impl Known {
    /// Of no place: what is compared with NaN is not less.
    const NOTHING: Known = Known { place: Vec3::NAN, value: 0.0, second: 0.0 };

    /// Is the value at `q` above the bound?
    #[inline]
    fn surely_above(&self, q: Vec3, bound: f64) -> bool {
        let reach = ((self.value - bound) / STEEPNESS).min(SIGHT - self.second) - MARGIN;
        reach > 0.0 && (q - self.place).length_squared() < reach * reach
    }
}

/// The difference of the distances that `measure` finds to the second and the first of the feature points around `q`;
/// `None` where it is sure to be above `bound` without that.
#[inline]
pub(super) fn difference_unless_above(
    q: Vec3,
    bound: f64,
    measure: impl FnOnce() -> [f64; 2],
) -> Option<f64> {
    let cell = floors(q * FINENESS);
    let (x, y, z) = (cell.x as i64, cell.y as i64, cell.z as i64);
    let mixed = x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791);
    KNOWN.with_borrow_mut(|all| {
        let known = &mut all[mixed as usize % KEPT];
        if known.surely_above(q, bound) {
            return None;
        }
        let [first, second] = measure();
        *known = Known { place: q, value: second - first, second };
        Some(second - first)
    })
}
