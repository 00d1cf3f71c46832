//! The transforms of the scene language.
//!
//! The language writes row vectors (`p' = p M`) and composes statements left to right; [`Affine`] works on column
//! vectors, so "first `a`, then `b`" is `b * a`. Space is left-handed (manual 3.7, section 3.4.1.2).
use crate::{Affine, Mat3, Vec3};

/// Moves by `by`.
pub fn translate(by: Vec3) -> Affine {
    Affine::from_translation(by)
}

/// Stretches along the axes.
pub fn scale(by: Vec3) -> Affine {
    Affine::from_scale(by)
}

/// Turns about x, then y, then z, by angles in degrees.
pub fn rotate(degrees: Vec3) -> Affine {
    let r = degrees * std::f64::consts::PI / 180.0;
    Affine::from_rotation_z(r.z) * Affine::from_rotation_y(r.y) * Affine::from_rotation_x(r.x)
}

/// Turns about an axis through the origin, by an angle in degrees. A zero axis turns nothing.
pub fn rotate_about(axis: Vec3, degrees: f64) -> Affine {
    match axis.try_normalize() {
        Some(axis) => Affine::from_axis_angle(axis, degrees.to_radians()),
        None => Affine::IDENTITY,
    }
}

/// The twelve numbers of a `matrix` statement: three rows of the linear part, then the translation.
pub fn matrix(m: &[f64; 12]) -> Affine {
    let row = |i: usize| Vec3::new(m[3 * i], m[3 * i + 1], m[3 * i + 2]);
    Affine::from_mat3_translation(Mat3::from_cols(row(0), row(1), row(2)), row(3))
}

/// A normal carried by `to_from_here`, given that transform's inverse: the inverse transpose, not renormalised.
#[inline]
pub fn normal_by_inverse(here_from_to: &Affine, normal: Vec3) -> Vec3 {
    let m = &here_from_to.matrix3;
    Vec3::new(m.x_axis.dot(normal), m.y_axis.dot(normal), m.z_axis.dot(normal))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_follow_the_left_hand() {
        let near = |a: Vec3, b: Vec3| assert!((a - b).length() < 1e-12, "{a} {b}");
        near(rotate(Vec3::X * 90.0).transform_vector3(Vec3::Y), Vec3::Z);
        near(rotate(Vec3::Y * 90.0).transform_vector3(Vec3::Z), Vec3::X);
        near(rotate(Vec3::Z * 90.0).transform_vector3(Vec3::X), Vec3::Y);
    }

    #[test]
    fn matrix_lists_rows() {
        let m = matrix(&[1., 2., 3., 4., 5., 6., 7., 8., 10., 11., 12., 13.]);
        assert_eq!(m.transform_point3(Vec3::new(1., 2., 3.)), Vec3::new(41., 48., 58.));
    }

    #[test]
    fn normals_stay_perpendicular() {
        let m = scale(Vec3::new(1., 2., 3.)) * rotate(Vec3::new(10., 20., 30.));
        let (t, n) = (Vec3::new(1., 1., 0.), Vec3::new(1., -1., 0.));
        let moved = normal_by_inverse(&m.inverse(), n);
        assert!(moved.dot(m.transform_vector3(t)).abs() < 1e-12);
    }
}
