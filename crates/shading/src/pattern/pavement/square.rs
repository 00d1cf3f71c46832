//! Pavements of unit squares.
use raggio_math::turns::fraction;

use super::{Shape, Style};

/// A corner of a cell.
struct Corner {
    /// Set in the code of a cell whose outline touches only here.
    bit: u32,
    /// The corner's own axes in terms of the cell's.
    signs: (f64, f64),
    /// Codes with all these bits bend round this corner.
    bend: u32,
    /// The two sides that meet here.
    sides: u32,
}

const CORNERS: [Corner; 4] = [
    Corner { bit: 0x10, signs: (-1.0, 1.0), bend: 0x16, sides: 0x09 },
    Corner { bit: 0x20, signs: (1.0, 1.0), bend: 0x2c, sides: 0x03 },
    Corner { bit: 0x40, signs: (1.0, -1.0), bend: 0x49, sides: 0x06 },
    Corner { bit: 0x80, signs: (-1.0, -1.0), bend: 0x83, sides: 0x0c },
];

/// The value in a pavement of squares.
pub(super) fn value(shape: Shape, style: Style, x: f64, z: f64) -> f64 {
    let code = shape.code(x.floor() as i64, z.floor() as i64);
    let (a, b) = (2.0 * fraction(x) - 1.0, 2.0 * fraction(z) - 1.0);
    let has = |bits: u32| code & bits == bits;
    let at = |corner: &Corner| (corner.signs.0 * a, corner.signs.1 * b);
    if style.form < 3
        && let Some(corner) = CORNERS.iter().find(|corner| has(corner.bend))
    {
        return bend(style.form, at(corner));
    }
    let sides = [(1, b), (2, a), (4, -b), (8, -a)];
    let mut v = sides.iter().filter(|side| has(side.0)).fold(0.0, |v: f64, side| v.max(side.1));
    for corner in &CORNERS {
        if has(corner.bit) {
            v = v.max(inner_corner(style.interior, at(corner)));
        }
        if has(corner.sides) {
            v = v.max(outer_corner(style.exterior, at(corner)));
        }
    }
    v
}

fn bend(form: u8, (p, q): (f64, f64)) -> f64 {
    match form {
        0 => (-p).max(-q).max(p.min(q)),
        1 => (1.0 - p - q).abs().min(1.0),
        _ => ((1.0 - p).hypot(1.0 - q) - 1.0).abs().min(1.0),
    }
}

fn inner_corner(interior: u8, (p, q): (f64, f64)) -> f64 {
    match interior {
        0 => p.min(q),
        1 => p + q - 1.0,
        _ => 1.0 - (1.0 - p).hypot(1.0 - q),
    }
}

fn outer_corner(exterior: u8, (p, q): (f64, f64)) -> f64 {
    match exterior {
        1 => (p + q).min(1.0),
        2 if p >= 0.0 && q >= 0.0 => p.hypot(q).min(1.0),
        _ => 0.0,
    }
}
