//! Patterns of whole numbers: each cell of a grid has its entry in a list.
use raggio_math::noise::{hash3, random};
use raggio_math::turns::{floor, floors, fraction};
use raggio_math::{EPS, Vec3};

const SQRT_3: f64 = 1.732_050_807_568_877_2;

fn is_odd(v: f64) -> bool {
    v as i64 & 1 != 0
}

fn shifted_floor(p: Vec3) -> Vec3 {
    floors(p + Vec3::splat(EPS))
}

pub(super) fn cells(p: Vec3) -> f64 {
    let c = shifted_floor(p);
    random(hash3(c.x as i64, c.y as i64, c.z as i64))
}

pub(super) fn checker(p: Vec3) -> f64 {
    f64::from(u8::from(is_odd(shifted_floor(p).element_sum())))
}

/// 0 is mortar. `mortar` is the gap's share of the brick per axis.
pub(super) fn brick(p: Vec3, size: Vec3, mortar: Vec3, gap: f64) -> f64 {
    let q = (p + Vec3::splat(EPS + gap)) / size;
    if fraction(q.y) <= mortar.y {
        return 0.0;
    }
    let lower = fraction(q.y * 0.5) <= 0.5;
    let (a, c) = if lower { (q.x, q.z + 0.5) } else { (q.x + 0.5, q.z) };
    if fraction(a) <= mortar.x || fraction(c) <= mortar.z { 0.0 } else { 1.0 }
}

pub(super) fn square(p: Vec3) -> f64 {
    match (is_odd(floor(p.x)), is_odd(floor(p.z))) {
        (false, false) => 0.0,
        (false, true) => 1.0,
        (true, true) => 2.0,
        (true, false) => 3.0,
    }
}

/// The sides of a cube, in the order of the `cubic` list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub(crate) enum CubeFace {
    PosX,
    PosY,
    PosZ,
    NegX,
    NegY,
    NegZ,
}

/// The side of a cube about the origin that a point is seen through.
pub(crate) fn cube_face(p: Vec3) -> CubeFace {
    let a = p.abs();
    if p.x >= 0.0 && p.x >= a.y && p.x >= a.z {
        CubeFace::PosX
    } else if p.y >= 0.0 && p.y >= a.x && p.y >= a.z {
        CubeFace::PosY
    } else if p.z >= 0.0 && p.z >= a.x && p.z >= a.y {
        CubeFace::PosZ
    } else if p.x < 0.0 && a.x >= a.y && a.x >= a.z {
        CubeFace::NegX
    } else if p.y < 0.0 && a.y >= a.x && a.y >= a.z {
        CubeFace::NegY
    } else {
        CubeFace::NegZ
    }
}

/// Hexagons about the y axis in three colours.
pub(super) fn hexagon(p: Vec3) -> f64 {
    // 3 sqrt(3) and sqrt(3) / 2, as the language rounds them.
    const PERIOD: f64 = 5.196152424;
    const HALF: f64 = 0.866025404;
    let in_six = |v: f64| v - 6.0 * floor(v / 6.0);
    let z = if p.z < 0.0 { PERIOD - p.z.abs() } else { p.z };
    let (x, z) = (in_six(2.0 * p.x.abs()), in_six(z / HALF));
    let (m, n) = (floor(x) as u8 % 6, floor(z) as usize % 6);
    let row: [u8; 6] = match m {
        0 | 5 => [0, 1, 1, 2, 2, 0],
        2 | 3 => [2, 2, 0, 0, 1, 1],
        _ if below_diagonal(fraction(x), fraction(z), usize::from(m) + n) => [0, 2, 1, 0, 2, 1],
        _ => [2, 1, 0, 2, 1, 0],
    };
    f64::from(row[n])
}

/// Columns 1 and 4 of the hexagon grid are crossed by slanted sides.
fn below_diagonal(fx: f64, fz: f64, parity: usize) -> bool {
    let fx = if parity % 2 == 1 { 1.0 - fx } else { fx };
    let fx = if fx == 0.0 { 1e-4 } else { fx };
    fz / fx < 1.0
}

/// Triangles about the y axis in six colours.
pub(super) fn triangular(p: Vec3) -> f64 {
    let x = p.x - 3.0 * floor(p.x / 3.0);
    let z = p.z - SQRT_3 * floor(p.z / SQRT_3);
    let column = floor(x);
    let u = x - column;
    let upper = z >= SQRT_3 / 2.0;
    let z = if upper { SQRT_3 - z } else { z };
    let (right_of_left_side, left_of_right_side) = (u != 0.0 && z / u < SQRT_3, z / (1.0 - u) < SQRT_3);
    let k = match (right_of_left_side, left_of_right_side) {
        (true, true) => 0,
        (true, false) => 3,
        (false, _) => 1,
    };
    let turn = 2 * column as i64;
    let k = if k % 2 == 1 { k + turn } else { 6 + k - turn }.rem_euclid(6);
    (if upper { 5 - k } else { k }) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ties_between_cube_faces_go_to_the_first() {
        assert_eq!(cube_face(Vec3::ONE), CubeFace::PosX);
        assert_eq!(cube_face(Vec3::new(-1.0, 1.0, 1.0)), CubeFace::PosY);
        assert_eq!(cube_face(-Vec3::ONE), CubeFace::NegX);
        assert_eq!(cube_face(Vec3::NEG_Z), CubeFace::NegZ);
    }

    #[test]
    fn a_checker_changes_just_under_whole_numbers() {
        assert_eq!(checker(Vec3::new(1.0 - 1e-11, 0.0, 0.0)), 1.0);
        assert_eq!(checker(Vec3::new(1.0 - 1e-9, 0.0, 0.0)), 0.0);
        assert_eq!(checker(Vec3::new(-0.5, 0.5, 0.5)), 1.0);
    }
}
