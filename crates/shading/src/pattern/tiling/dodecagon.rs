//! Tilings 22 to 24: regular dodecagons with triangles, or with squares and hexagons, between them. All edges are 1.
use raggio_math::Vec2;

use super::EPS6;
use super::periodic::Lattice;

const SQRT_3: f64 = 1.732_050_807_568_877_2;
/// From a dodecagon's middle to its edges.
const INRADIUS: f64 = 1.0 + SQRT_3 / 2.0;

/// What lies between the dodecagons.
#[derive(Debug)]
pub(in crate::pattern) enum Dodecagons {
    WithTriangles,
    /// Squares of 1 or 3 classes, and hexagons.
    WithSquares {
        classes: u8,
    },
}

/// The three dodecagons about a point. `middles[0]` and `middles[1]` lie in one row, in either order;
/// `middles[0]` and `middles[2]` lie on a link that rises at 60 degrees.
struct Surroundings {
    middles: [Vec2; 3],
    /// Does the triangle of the three middles point to +z?
    upward: bool,
}

impl Surroundings {
    fn of(p: Vec2, origin: Vec2, spacing: f64) -> Self {
        let lattice = Lattice::new(Vec2::new(spacing, 0.0), Vec2::new(spacing / 2.0, spacing * SQRT_3 / 2.0));
        let c = lattice.coordinates(p - origin);
        let cell = c.floor();
        let f = c - cell;
        let upward = f.x + f.y < 1.0;
        let corners = if upward { [(0., 0.), (1., 0.), (0., 1.)] } else { [(1., 1.), (0., 1.), (1., 0.)] };
        Surroundings { middles: corners.map(|(i, j)| origin + lattice.point(cell + Vec2::new(i, j))), upward }
    }
}

/// The twelve outward normals, the first along x.
fn normals() -> impl Iterator<Item = (usize, Vec2)> {
    const H: f64 = SQRT_3 / 2.0;
    const FIRST: [Vec2; 3] = [Vec2::new(1.0, 0.0), Vec2::new(H, 0.5), Vec2::new(0.5, H)];
    (0..12).map(|i| {
        let n = FIRST[i % 3];
        let turned = match i / 3 {
            0 => n,
            1 => n.perp(),
            2 => -n,
            _ => -n.perp(),
        };
        (i, turned)
    })
}

/// The distance to the nearest edge of the dodecagon about the origin; negative outside.
fn depth(q: Vec2) -> f64 {
    normals().fold(f64::INFINITY, |d, (_, n)| d.min(INRADIUS - n.dot(q)))
}

impl Dodecagons {
    pub fn value(&self, x: f64, z: f64) -> f64 {
        let p = Vec2::new(x, z);
        match self {
            Dodecagons::WithTriangles => with_triangles(p),
            Dodecagons::WithSquares { classes } => with_squares(p, f64::from(*classes)),
        }
    }
}

fn with_triangles(p: Vec2) -> f64 {
    let around = Surroundings::of(p, Vec2::splat(INRADIUS), 2.0 * INRADIUS);
    for middle in around.middles {
        if depth(p - middle) >= 0.0 {
            return (3.0000001 - nearness_in_dodecagon(p - middle)) / 3.0;
        }
    }
    let nearest_edge = around.middles.iter().fold(f64::INFINITY, |d, &m| d.min(-depth(p - m)));
    // Between three middles that point up the tile points down.
    let class = if around.upward { 1.0 } else { 0.0 };
    (class + 1.0 - (2.0 * SQRT_3 * nearest_edge).min(1.0)) / 3.0
}

/// Three of the twelve edges have a shallower bevel.
fn nearness_in_dodecagon(q: Vec2) -> f64 {
    normals().fold(1.0, |m: f64, (i, n)| {
        let steepness = if matches!(i, 0 | 6 | 9) { 3.0 } else { 2.0 * SQRT_3 };
        m.min(steepness * (INRADIUS - n.dot(q)))
    })
}

fn with_squares(p: Vec2, square_classes: f64) -> f64 {
    let classes = square_classes + 2.0;
    let origin = Vec2::new(1.5 + SQRT_3 / 2.0, 1.0 + SQRT_3);
    let around = Surroundings::of(p, origin, 3.0 + SQRT_3);
    for middle in around.middles {
        let d = depth(p - middle);
        if d >= 0.0 {
            return (classes + EPS6 - (2.0 * d).min(1.0)) / classes;
        }
    }
    let [a, b, c] = around.middles;
    for (i, (from, to)) in [(a, b), (a, c), (b, c)].into_iter().enumerate() {
        let along = (to - from).normalize_or_zero();
        let q = p - (from + to) / 2.0;
        let d = 0.5 - q.dot(along).abs().max(q.perp_dot(along).abs());
        if d >= 0.0 {
            let class = 1.0 + (i as f64).min(square_classes - 1.0);
            return (class + 1.0 - 2.0 * d) / classes;
        }
    }
    let centre = (a + b + c) / 3.0;
    let edge = |m: Vec2| (m - centre).normalize_or_zero().dot(p - centre).abs();
    let d = SQRT_3 / 2.0 - around.middles.into_iter().map(edge).fold(0.0, f64::max);
    (1.0 - (2.0 * d).clamp(0.0, 1.0)) / classes
}
