//! Rounding from double to single precision in a chosen direction.

/// The greatest single not above `x`.
#[inline]
pub(crate) fn down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

/// The least single not below `x`.
#[inline]
pub(crate) fn up(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) < x { y.next_up() } else { y }
}

/// More than the share by which rounding to single precision changes a number.
const SHARE: f64 = 1.0 / (1 << 23) as f64;

/// A single that is no less than a distance and next to no greater. Quicker than [`up`], which has to decide something that
/// no processor foresees.
#[inline]
pub(crate) fn not_before(t: f64) -> f32 {
    (t * (1.0 + SHARE)) as f32 + f32::MIN_POSITIVE
}

/// A single, 0 or more, that is no greater than a distance of 0 or more and next to no less.
#[inline]
pub(crate) fn not_behind(t: f64) -> f32 {
    ((t * (1.0 - SHARE)) as f32 - f32::MIN_POSITIVE).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_encloses() {
        for x in [0.1, -0.1, 1e-50, -1e-50, 1e300, -1e300, 0.0, 0.5, f64::INFINITY] {
            assert!(f64::from(down(x)) <= x && x <= f64::from(up(x)), "{x}");
        }
        assert_eq!((down(0.5), up(0.5)), (0.5, 0.5));
    }

    #[test]
    fn distances_are_enclosed_without_a_decision() {
        let mut t = 1e-50;
        while t < 1e38 {
            let (near, far) = (f64::from(not_behind(t)), f64::from(not_before(t)));
            assert!(near <= t && t <= far, "{near} {t} {far}");
            assert!(far - near <= t * 5e-7 + 5e-38, "{near} {t} {far}");
            t *= 1.0123456789;
        }
        assert_eq!(not_before(f64::INFINITY), f32::INFINITY);
        assert_eq!(not_behind(-1.0).to_bits(), 0);
        assert_eq!(not_behind(0.0).to_bits(), 0);
    }
}
