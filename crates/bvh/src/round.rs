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
}
