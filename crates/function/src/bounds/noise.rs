//! Bounds of noise.
//!
//! The value and the gradient in the middle of a box, and how far they may change from there to its faces: the second
//! derivatives of a noise have a bound that holds everywhere.
use raggio_math::Vec3;

use super::{Bounds, Range, VARIABLES};

/// Step of the central differences.
const STEP: f64 = 1e-5;

/// The greatest slope along an axis, the greatest change of a slope along its own axis, and along another, of the second
/// and third generators. Found by search over 400000 points, rounded up by a tenth.
const STEEPEST: f64 = 1.4;
const BEND: f64 = 7.2;
const TWIST: f64 = 3.6;
/// The first generator is the second, stretched and moved.
const STRETCH: f64 = 1.0 / 0.48985582;
const SHIFT: f64 = 0.5 - 1.05242;

/// The noise of a generator over bounds of a point.
pub(crate) fn enclose(generator: u8, at: [Bounds; 3]) -> Bounds {
    if generator != 1 {
        return smooth(generator, at);
    }
    (smooth(2, at) * STRETCH + SHIFT).max(0.0).min(1.0)
}

/// The noise of the second or the third generator.
fn smooth(generator: u8, at: [Bounds; 3]) -> Bounds {
    if at.iter().any(Bounds::is_vague) {
        return Bounds::UNKNOWN;
    }
    let noise = |p: Vec3| raggio_math::noise::noise(generator, p);
    let half = Vec3::from(at.map(|b| 0.5 * b.value.width()));
    let middle = Vec3::from(at.map(|b| b.value.middle()));
    let change = half * (BEND - TWIST) + Vec3::splat(half.element_sum() * TWIST);
    let steepest = Range::within(STEEPEST);
    let gradient = |k: usize| {
        // Where the cell is too large for the slope in the middle to tell anything.
        if change[k] > 2.0 * STEEPEST {
            return steepest;
        }
        let step = Vec3::AXES[k] * STEP;
        let slope = (noise(middle + step) - noise(middle - step)) / (2.0 * STEP);
        (Range::one(slope) + Range::within(change[k] + BEND * STEP)).meet(steepest)
    };
    let gradient: [Range; 3] = std::array::from_fn(gradient);
    let away: f64 = (0..3).map(|k| gradient[k].size() * half[k]).sum();
    let value = (Range::one(noise(middle)) + Range::within(away)).meet(Range { lo: 0.0, hi: 1.0 });
    let slope = |v: usize| (0..3).fold(Range::ZERO, |sum, k| sum + gradient[k] * at[k].slopes[v]);
    let slopes: [Range; VARIABLES] = std::array::from_fn(slope);
    Bounds::new(value, slopes)
}
