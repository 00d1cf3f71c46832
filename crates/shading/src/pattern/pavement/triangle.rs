//! Pavements of unit triangles, and of hexagons made of six.
use raggio_math::Vec2;

use super::{Shape, Style};

const SQRT_3: f64 = 1.732_050_807_568_877_2;
/// The height of a triangle.
const H: f64 = SQRT_3 / 2.0;

/// Corners of the standard triangle.
const LEFT: Vec2 = Vec2::new(0.0, 0.0);
const RIGHT: Vec2 = Vec2::new(1.0, 0.0);
const TOP: Vec2 = Vec2::new(0.5, H);

/// A point in the standard triangle, and the code of the cell that the triangle stands for.
struct Place {
    p: Vec2,
    code: u32,
    hexagons: bool,
    /// `sqrt(3) z + x` and `sqrt(3) z - x`, which tell the thirds of the triangle apart.
    u: f64,
    w: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Third {
    Top,
    Left,
    Right,
}

/// The value in a pavement of triangles or hexagons.
pub(super) fn value(shape: Shape, style: Style, x: f64, z: f64) -> f64 {
    let place = Place::of(shape, x, z);
    let v = place.inner_corners(style.interior, place.sides());
    let v = if place.hexagons { v } else { place.outer_corners(style.exterior, v) };
    place.bends(style.form).unwrap_or(v)
}

impl Place {
    fn of(shape: Shape, x: f64, z: f64) -> Place {
        let (column, row) = (x.floor(), (z / SQRT_3).floor());
        let (mut x, mut z) = (x - column, z - SQRT_3 * row);
        // Saturating: far out the answer is meaningless, but must not overflow.
        let (mut i, mut j) = ((column as i64).saturating_mul(2), (row as i64).saturating_mul(2));
        if z > H {
            z -= H;
            j = j.saturating_add(1);
            if x > 0.5 {
                x -= 0.5;
                i = i.saturating_add(1);
            } else {
                x += 0.5;
                i = i.saturating_sub(1);
            }
        }
        if x == 0.0 || z > SQRT_3 * x {
            (x, z) = (0.5 - x, H - z);
            i = i.saturating_sub(1);
        }
        if x == 1.0 || z > SQRT_3 * (1.0 - x) {
            (x, z) = (1.5 - x, H - z);
            i = i.saturating_add(1);
        }
        Place {
            p: Vec2::new(x, z),
            code: shape.code(i, j),
            hexagons: shape.sides() == 6,
            u: SQRT_3 * z + x,
            w: SQRT_3 * z - x,
        }
    }

    fn has(&self, bits: u32) -> bool {
        self.code & bits == bits
    }

    /// Is the point in this third? Borders count where `closed`.
    fn in_third(&self, third: Third, closed: bool) -> bool {
        let (x, u, w) = (self.p.x, self.u, self.w);
        let over = |a: f64, b: f64| a > b || (closed && a == b);
        match third {
            Third::Top => over(u, 1.0) && over(w, 0.0),
            Third::Left => over(1.0, u) && over(0.5, x),
            Third::Right => over(x, 0.5) && over(0.0, w),
        }
    }

    /// Nearness to each side, by the side's bit.
    fn side(&self, bit: u32) -> f64 {
        let Vec2 { x, y: z } = self.p;
        match bit {
            1 => 1.0 - SQRT_3 * (SQRT_3 * x - z).abs(),
            2 => 1.0 - SQRT_3 * (SQRT_3 * (1.0 - x) - z).abs(),
            _ => 1.0 - 2.0 * SQRT_3 * z,
        }
    }

    fn sides(&self) -> f64 {
        [1, 2, 4].into_iter().filter(|&bit| self.has(bit)).fold(0.0, |v: f64, bit| v.max(self.side(bit)))
    }

    /// Corners where the outline only touches the cell.
    fn inner_corners(&self, interior: u8, mut v: f64) -> f64 {
        let corners = [(Third::Top, 0x83, 0x4000), (Third::Left, 0x85, 0x2000), (Third::Right, 0x86, 0x1000)];
        for (third, absent, hexagon_bit) in corners {
            if self.code & absent == 0 || (self.hexagons && self.has(hexagon_bit)) {
                v = v.max(self.inner_corner(third, interior));
            }
        }
        v
    }

    fn inner_corner(&self, third: Third, interior: u8) -> f64 {
        let Vec2 { x, y: z } = self.p;
        let (u, w) = (1.5 * self.u, 1.5 * (self.w + 1.0));
        match (interior, third) {
            (0, Third::Top) => 1.0 - 2.0 * SQRT_3 * (H - z),
            (0, Third::Left) => 1.0 - SQRT_3 * (SQRT_3 * x + z),
            (0, Third::Right) => 1.0 - SQRT_3 * (SQRT_3 * (x - 1.0) - z).abs(),
            (1, _) if !self.in_third(third, false) => 0.0,
            (1, Third::Top) => u.min(w) - 2.0,
            (1, Third::Left) => (1.0 - u).min(1.0 - 3.0 * x),
            (1, Third::Right) => (1.0 - w).min(3.0 * x - 2.0),
            (_, _) => 1.0 - 3.0 * self.p.distance(third.corner()),
        }
    }

    /// Corners where two sides of the outline meet.
    fn outer_corners(&self, exterior: u8, mut v: f64) -> f64 {
        let (g, k) = (self.p.x - 0.5, self.p.y - SQRT_3 / 6.0);
        match exterior {
            1 => {
                let lines = [
                    (3, 2.0 * SQRT_3 * k.abs()),
                    (6, SQRT_3 * (SQRT_3 * g - k).abs()),
                    (5, SQRT_3 * (SQRT_3 * g + k).abs()),
                ];
                for (pair, line) in lines {
                    let both_near = [1, 2, 4].iter().all(|&bit| pair & bit == 0 || self.side(bit) >= 0.0);
                    if self.has(pair) && both_near {
                        v = line.min(1.0);
                    }
                }
            }
            2 => {
                let pairs = [(3, Third::Top), (6, Third::Right), (5, Third::Left)];
                if pairs.iter().any(|&(pair, third)| self.has(pair) && self.in_third(third, true)) {
                    v = (2.0 * SQRT_3 * g.hypot(k)).min(1.0);
                }
            }
            _ => {}
        }
        v
    }

    /// Outlines that bend round a corner.
    fn bends(&self, form: u8) -> Option<f64> {
        if form == 0 {
            return None;
        }
        let (x, u, w) = (self.p.x, self.u, self.w);
        let bends = [
            (0x120, Third::Top, LEFT, 2.0 * (u - 1.0)),
            (0x140, Third::Left, TOP, 2.0 * (1.0 - u)),
            (0x210, Third::Top, RIGHT, 2.0 * w),
            (0x240, Third::Right, TOP, -2.0 * w),
            (0x410, Third::Left, RIGHT, 2.0 - 4.0 * x),
            (0x420, Third::Right, LEFT, 4.0 * x - 2.0),
        ];
        let (_, _, centre, f) =
            bends.into_iter().find(|&(mask, third, ..)| self.has(mask) && self.in_third(third, false))?;
        Some(if form == 1 {
            f.min(1.0)
        } else {
            (2.0 * SQRT_3 * (self.p.distance(centre) - SQRT_3 / 3.0)).clamp(0.0, 1.0)
        })
    }
}

impl Third {
    fn corner(self) -> Vec2 {
        match self {
            Third::Top => TOP,
            Third::Left => LEFT,
            Third::Right => RIGHT,
        }
    }
}
