//! Method 2: squares whose corners differ are quartered (light spec, section 2.3).
use super::{Difference, Shoot, Viewed, add, jittered};
use crate::film::{Pixel, Tile};

/// The method with its options, and memory for the points of one pixel.
pub struct Recursive {
    differs: Difference,
    /// How often a pixel may be quartered.
    levels: u32,
    /// How far inner points may move.
    jitter: f64,
    /// Points along a side of a pixel at the finest level.
    side: usize,
    /// Points of the present pixel that are known, each with the number of the pixel that it was taken for.
    known: Vec<(u32, Viewed)>,
    pixel: u32,
}

/// A square of a pixel in units of the finest level.
#[derive(Clone, Copy)]
struct Square {
    i: usize,
    j: usize,
    size: usize,
}

impl Recursive {
    /// The method for a depth in 1..=9.
    pub fn new(differs: Difference, depth: u32, jitter: f64) -> Self {
        let depth = depth.clamp(1, 9);
        let side = (1 << (depth - 1)) + 1;
        Recursive {
            differs,
            levels: depth - 1,
            jitter: jitter / (f64::from(1 << depth) + 1.0),
            side,
            known: vec![(0, Viewed::default()); side * side],
            pixel: 0,
        }
    }

    /// All pixels of a tile.
    pub fn tile(&mut self, tile: &Tile, shoot: &mut impl Shoot) -> Vec<Pixel> {
        let columns = tile.x.len() + 1;
        let mut corners = Vec::with_capacity(columns * (tile.y.len() + 1));
        for y in tile.y.start..=tile.y.end {
            for x in tile.x.start..=tile.x.end {
                corners.push(shoot.first(x as f64 - 0.5, y as f64 - 0.5));
            }
        }
        let mut pixels = Vec::with_capacity(tile.area());
        for (row, y) in tile.y.clone().enumerate() {
            for (column, x) in tile.x.clone().enumerate() {
                let at = row * columns + column;
                let own = [corners[at], corners[at + 1], corners[at + columns], corners[at + columns + 1]];
                pixels.push(self.pixel(own, x as f64, y as f64, shoot));
            }
        }
        pixels
    }

    fn pixel(&mut self, corners: [Viewed; 4], x: f64, y: f64, shoot: &mut impl Shoot) -> Pixel {
        self.pixel += 1;
        let size = self.side - 1;
        let indices = [0, size, size * self.side, size * self.side + size];
        for (index, corner) in indices.into_iter().zip(corners) {
            self.known[index] = (self.pixel, corner);
        }
        if size == 1 || self.levels == 0 {
            return mean(&corners.map(|corner| corner.pixel));
        }
        self.square(Square { i: 0, j: 0, size }, self.levels, (x, y), shoot)
    }

    /// The mean over a square.
    fn square(&mut self, s: Square, level: u32, pixel: (f64, f64), shoot: &mut impl Shoot) -> Pixel {
        let places = [(s.i, s.j), (s.i + s.size, s.j), (s.i, s.j + s.size), (s.i + s.size, s.j + s.size)];
        let corners = places.map(|(i, j)| self.point(i, j, pixel, shoot));
        let differs = (0..4).any(|a| (0..a).any(|b| self.differs.between(&corners[a], &corners[b])));
        if level == 0 || !differs {
            return mean(&corners.map(|corner| corner.pixel));
        }
        let half = s.size / 2;
        let quarters = [(0, 0), (half, 0), (0, half), (half, half)];
        let parts = quarters.map(|(di, dj)| {
            self.square(Square { i: s.i + di, j: s.j + dj, size: half }, level - 1, pixel, shoot)
        });
        mean(&parts)
    }

    /// A point of the present pixel, shot at most once.
    fn point(&mut self, i: usize, j: usize, (x, y): (f64, f64), shoot: &mut impl Shoot) -> Viewed {
        let index = j * self.side + i;
        if self.known[index].0 != self.pixel {
            let place = |k: usize| k as f64 / (self.side - 1) as f64 - 0.5;
            let value = jittered(x + place(i), y + place(j), self.jitter, shoot);
            self.known[index] = (self.pixel, self.differs.view(value));
        }
        self.known[index].1
    }
}

fn mean(parts: &[Pixel; 4]) -> Pixel {
    let mut sum = [0.0; 4];
    parts.iter().for_each(|part| add(&mut sum, *part));
    sum.map(|v| v * 0.25)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Asked, plain_difference};
    use super::*;

    fn rendered(depth: u32, edge: f64) -> (Vec<Pixel>, usize) {
        let mut count = 0;
        let differs = plain_difference();
        let shoot = |x: f64, _: f64| {
            count += 1;
            let v = if x > edge { 1.0 } else { 0.0 };
            [v, v, v, 0.0]
        };
        let pixels =
            Recursive::new(differs, depth, 0.0).tile(&Tile { x: 0..2, y: 0..1 }, &mut Asked(differs, shoot));
        (pixels, count)
    }

    #[test]
    fn flat_pixels_are_the_mean_of_their_corners() {
        let (pixels, count) = rendered(3, 10.0);
        assert_eq!(pixels, vec![[0.0; 4]; 2]);
        assert_eq!(count, 6);
    }

    #[test]
    fn edges_are_quartered_down_to_the_depth() {
        // Corners at -0.5, 0.5, 1.5; the edge at 0.3 cuts pixel 0 only.
        let (pixels, _) = rendered(1, 0.3);
        assert!((pixels[0][0] - 0.5).abs() < 1e-6 && pixels[1][0] == 1.0);
        // Depth 2: halves at 0; the right half is cut again: (0 + 0.5) / 2.
        let (pixels, count) = rendered(2, 0.3);
        assert!((pixels[0][0] - 0.25).abs() < 1e-6);
        assert_eq!(count, 6 + 5);
        // Depth 3: quarters at 0.25: only the last is cut.
        assert!((rendered(3, 0.3).0[0][0] - 0.125).abs() < 1e-6);
    }
}
