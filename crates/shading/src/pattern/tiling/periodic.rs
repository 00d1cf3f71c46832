//! Tilings that repeat on a lattice, out of convex tiles.
use raggio_math::Vec2;

use super::EPS6;
use super::table::TilingData;

/// A tiling ready for look-up: every tile that reaches into the lattice's first cell.
#[derive(Debug)]
pub(in crate::pattern) struct Periodic {
    classes: f64,
    rho: f64,
    lattice: Lattice,
    tiles: Box<[Tile]>,
}

/// Two vectors, and the way back to multiples of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    a: Vec2,
    b: Vec2,
    area: f64,
}

impl Lattice {
    pub fn new(a: Vec2, b: Vec2) -> Self {
        Lattice { a, b, area: a.perp_dot(b) }
    }

    /// A point as multiples of the two vectors.
    pub fn coordinates(&self, p: Vec2) -> Vec2 {
        Vec2::new(p.perp_dot(self.b), self.a.perp_dot(p)) / self.area
    }

    /// And back.
    pub fn point(&self, c: Vec2) -> Vec2 {
        self.a * c.x + self.b * c.y
    }
}

#[derive(Debug)]
struct Tile {
    class: f64,
    /// Unit inward normals and offsets: inside where `normal . p >= offset`.
    edges: Box<[(Vec2, f64)]>,
}

impl Tile {
    /// From corners in either sense.
    fn new(class: u8, corners: &[Vec2]) -> Self {
        let middle = corners.iter().sum::<Vec2>() / corners.len() as f64;
        let edge = |i: usize| {
            let (p, q) = (corners[i], corners[(i + 1) % corners.len()]);
            let normal = (q - p).perp().normalize();
            let normal = if normal.dot(middle - p) < 0.0 { -normal } else { normal };
            (normal, normal.dot(p))
        };
        Tile { class: f64::from(class), edges: (0..corners.len()).map(edge).collect() }
    }

    /// The distance to the nearest edge line; negative outside.
    fn depth(&self, p: Vec2) -> f64 {
        self.edges.iter().fold(f64::INFINITY, |depth, (normal, offset)| depth.min(normal.dot(p) - offset))
    }
}

impl Periodic {
    pub(super) fn new(data: &TilingData) -> Self {
        let [a, b] = data.lattice;
        let lattice = Lattice::new(a.into(), b.into());
        let mut tiles = Vec::new();
        for (class, corners) in data.tiles {
            let corners: Vec<Vec2> = corners.iter().map(|&c| c.into()).collect();
            for shift in shifts_into_cell(&lattice, &corners) {
                let moved: Vec<Vec2> = corners.iter().map(|&c| c + shift).collect();
                tiles.push(Tile::new(*class, &moved));
            }
        }
        Periodic { classes: f64::from(data.classes), rho: data.rho, lattice, tiles: tiles.into() }
    }

    pub fn value(&self, x: f64, z: f64) -> f64 {
        let c = self.lattice.coordinates(Vec2::new(x, z));
        let p = self.lattice.point(c - c.floor());
        let (mut class, mut depth) = (0.0, f64::NEG_INFINITY);
        for tile in &self.tiles {
            let here = tile.depth(p);
            if here > depth {
                (class, depth) = (tile.class, here);
            }
            if depth > EPS6 {
                break;
            }
        }
        // The middle of a tile stays just above the class below it.
        let least = if class > 0.0 { EPS6 } else { 0.0 };
        (class + (1.0 - depth / self.rho).clamp(least, 1.0)) / self.classes
    }
}

/// The lattice vectors that bring some of the tile into the cell between 0 and both vectors.
fn shifts_into_cell(lattice: &Lattice, corners: &[Vec2]) -> Vec<Vec2> {
    let coordinates = || corners.iter().map(|&c| lattice.coordinates(c));
    let low = coordinates().fold(Vec2::INFINITY, Vec2::min);
    let high = coordinates().fold(Vec2::NEG_INFINITY, Vec2::max);
    // Overlap of low + i .. high + i with 0 .. 1.
    let range = |low: f64, high: f64| (-high).ceil() as i32..=(1.0 - low).floor() as i32;
    let mut shifts = Vec::new();
    for i in range(low.x, high.x) {
        for j in range(low.y, high.y) {
            shifts.push(lattice.point(Vec2::new(f64::from(i), f64::from(j))));
        }
    }
    shifts
}
