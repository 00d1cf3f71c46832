//! Bounds of noise.
//!
//! The value in the middle of a box and how far it may change from there to its faces, by the slopes: those of lattice
//! noise are bounded cell by cell; those of gradient noise lie about the ones in the middle, for its second derivatives
//! have a bound that holds everywhere.
use raggio_math::Vec3;

use super::elementary::each;
use super::{Bounds, Range, VARIABLES, lattice};

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
    if at.iter().any(Bounds::is_vague) {
        return Bounds::UNKNOWN;
    }
    if generator != 1 {
        return smooth(generator, at);
    }
    (smooth(2, at) * STRETCH + SHIFT).max(0.0).min(1.0)
}

/// The noise of the second or the third generator.
fn smooth(generator: u8, at: [Bounds; 3]) -> Bounds {
    let [x, y, z] = [at[0].value, at[1].value, at[2].value];
    let half = 0.5 * Vec3::new(x.width(), y.width(), z.width());
    let middle = Vec3::new(x.middle(), y.middle(), z.middle());
    let steepest = Range::within(STEEPEST);
    let gradient = match generator {
        3 => bent(generator, middle, half),
        _ => lattice::slopes([x, y, z]).map(|raw| each(|k| raw[k] * (1.0 / STRETCH))),
    };
    let gradient = gradient.map_or([steepest; VARIABLES], |found| each(|k| steepest.meet(found[k])));
    let away = gradient[0].size() * half.x + gradient[1].size() * half.y + gradient[2].size() * half.z;
    let noise = raggio_math::noise::noise(generator, middle);
    let value = (Range::one(noise) + Range::within(away)).meet(Range { lo: 0.0, hi: 1.0 });
    Bounds::of_point(value, gradient, &at)
}

/// The gradient in the middle of a box, and how far it may bend from there.
fn bent(generator: u8, middle: Vec3, half: Vec3) -> Option<[Range; VARIABLES]> {
    let noise = |p: Vec3| raggio_math::noise::noise(generator, p);
    let change = half * (BEND - TWIST) + Vec3::splat(half.element_sum() * TWIST);
    // Where the box is too large for the slope in the middle to tell anything.
    if change.min_element() > 2.0 * STEEPEST {
        return None;
    }
    Some(std::array::from_fn(|k| {
        let step = Vec3::AXES[k] * STEP;
        let slope = (noise(middle + step) - noise(middle - step)) / (2.0 * STEP);
        Range::one(slope) + Range::within(change[k] + BEND * STEP)
    }))
}
