//! Tiling 25: Penrose's pentagons of three kinds, with stars, boats and diamonds, by deflation.
use raggio_math::Vec2;

use super::EPS6;
use super::penrose::{CENTRE, PHI, fold5, levels, mirror, rot, sin_cos};

/// The tiles of the deflation; a letter may stand for several ways in which a tile is cut.
#[derive(Clone, Copy)]
enum Tile {
    A,
    B0,
    B1,
    C0,
    C1,
    S,
    T0,
    T1,
    D0,
    D1,
}

/// Lengths and angles of a pentagon with edges of 1.
struct Pentagon {
    /// From the middle to a corner.
    s: f64,
    /// From the middle to an edge.
    h: f64,
}

fn tan(degrees: f64) -> f64 {
    degrees.to_radians().tan()
}

fn cos(degrees: f64) -> f64 {
    sin_cos(degrees).1
}

pub(super) fn value(x: f64, z: f64) -> f64 {
    let p = Vec2::new(x, z);
    if p.length() <= CENTRE {
        return 1.0;
    }
    let pentagon = Pentagon { s: 0.5 / sin_cos(36.0).0, h: 0.5 / tan(36.0) };
    let mut p = fold5(p);
    let m = levels(2.0 * p.x * tan(36.0), PHI.powi(4));
    p *= PHI.powi(-4 * m);
    let mut tile = Tile::A;
    for _ in 0..4 * m {
        let (next, q) = pentagon.step(tile, mirror(p));
        (tile, p) = (next, q * PHI);
    }
    pentagon.tile_value(tile, mirror(p))
}

impl Pentagon {
    /// The next smaller tile at a point of this one, and the point in the new tile's coordinates before scaling.
    fn step(&self, tile: Tile, p: Vec2) -> (Tile, Vec2) {
        let Pentagon { s, h } = *self;
        match tile {
            Tile::A => {
                let p = fold5(p);
                if p.y < (p.x - h) * tan(54.0) + 0.5 {
                    (Tile::B0, p - Vec2::X * (h + s * cos(72.0) / PHI))
                } else {
                    (Tile::S, rot(p, -36.0))
                }
            }
            Tile::B0 | Tile::B1 => self.step_b(tile, p),
            Tile::C0 | Tile::C1 => self.step_c(tile, p),
            Tile::S if p.x < h / PHI => (Tile::A, p),
            Tile::S => (Tile::C1, Vec2::new(2.0 * h / PHI - p.x, p.y)),
            Tile::T1 if p.x > PHI * s * cos(108.0) => (Tile::A, Vec2::new(-p.x, p.y)),
            Tile::T1 => (Tile::C1, p + Vec2::X * s),
            Tile::T0 => (Tile::C1, rot(p, 72.0) + Vec2::X * s),
            Tile::D1 => (Tile::A, p),
            Tile::D0 => (Tile::C1, p),
        }
    }

    fn step_b(&self, tile: Tile, p: Vec2) -> (Tile, Vec2) {
        let s = self.s;
        if let Tile::B0 = tile {
            return if p.y < (p.x + s) * tan(18.0) {
                (Tile::D0, p + Vec2::X * (s - s / (PHI * PHI)))
            } else {
                (Tile::C0, self.turned_over(rot(p, -36.0)))
            };
        }
        let w = p.x - s / (PHI * PHI);
        if p.y < w * tan(54.0) {
            (Tile::A, p - Vec2::X * s)
        } else if p.y < w * tan(162.0) {
            (Tile::D1, Vec2::new(-p.x, p.y))
        } else {
            (Tile::B1, rot(p, 108.0) + Vec2::X * (s / PHI))
        }
    }

    fn step_c(&self, tile: Tile, p: Vec2) -> (Tile, Vec2) {
        let Pentagon { s, h } = *self;
        if let Tile::C1 = tile {
            return if p.x > s * cos(72.0) / (PHI * PHI) {
                (Tile::B1, Vec2::new(s * cos(72.0) / (PHI * PHI) + h / PHI - p.x, p.y))
            } else {
                (Tile::T1, p)
            };
        }
        if p.x < s * cos(108.0) {
            (Tile::B0, rot(p, -144.0) - Vec2::X * s)
        } else if p.y > (p.x - s / (PHI * PHI)) * tan(126.0) {
            (Tile::C0, self.turned_over(rot(p, 36.0)))
        } else {
            (Tile::T0, p)
        }
    }

    fn turned_over(&self, q: Vec2) -> Vec2 {
        let (sin72, cos72) = sin_cos(72.0);
        Vec2::new(-q.x - self.s * cos72, q.y - self.s * sin72)
    }

    fn tile_value(&self, tile: Tile, p: Vec2) -> f64 {
        const STEEPNESS: f64 = 5.55 / PHI;
        let Pentagon { s, h } = *self;
        let star_edge = |p: Vec2| {
            let (sin, cos) = sin_cos(162.0);
            (sin * (p.x - PHI * s) - cos * p.y).abs()
        };
        let pentagon_edge = |p: Vec2| (fold5(p).x - h).abs();
        let (class, distance) = match tile {
            Tile::A => (0.0, pentagon_edge(p)),
            Tile::B0 | Tile::B1 => (1.0, pentagon_edge(p)),
            Tile::C0 | Tile::C1 => (2.0, pentagon_edge(p)),
            Tile::S => (3.0, star_edge(p)),
            Tile::T0 | Tile::T1 => {
                let front = (p.x - s * cos(72.0) / PHI).abs();
                (4.0, front.min(star_edge(fold5(Vec2::new(-p.x, p.y)))))
            }
            Tile::D0 | Tile::D1 => {
                let (sin, cos) = sin_cos(18.0);
                (5.0, (sin * (p.x + s / PHI) - cos * p.y).abs())
            }
        };
        let least = if class == 0.0 { 0.0 } else { class / 6.0 + EPS6 };
        ((class + 1.0 - STEEPNESS * distance) / 6.0).clamp(least, (class + 1.0) / 6.0 - EPS6)
    }
}
