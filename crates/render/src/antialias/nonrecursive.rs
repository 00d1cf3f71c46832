//! Method 1: pixels that differ from their left or upper neighbour get a grid of samples (light spec, section 2.2).
use super::{Difference, Shoot, Viewed, add, jittered};
use crate::film::{Pixel, Tile};

/// The method with its options.
pub struct NonRecursive {
    /// When neighbours differ.
    pub differs: Difference,
    /// Samples along a side of a pixel.
    pub depth: u32,
    /// Amount of jitter.
    pub jitter: f64,
}

/// A tile with the helper row above it and the helper column at its left.
struct Board {
    columns: usize,
    pixels: Vec<Viewed>,
    /// Is it refined, or may not be?
    settled: Vec<bool>,
}

impl NonRecursive {
    /// All pixels of a tile.
    pub fn tile(&self, tile: &Tile, shoot: &mut impl Shoot) -> Vec<Pixel> {
        let (columns, rows) = (tile.x.len() + 1, tile.y.len() + 1);
        let mut board = Board {
            columns,
            pixels: vec![Viewed::default(); columns * rows],
            settled: vec![false; columns * rows],
        };
        let place =
            |i: usize, j: usize| (tile.x.start as f64 + i as f64 - 1.0, tile.y.start as f64 + j as f64 - 1.0);
        for j in 0..rows {
            for i in 0..columns {
                if (i, j) == (0, 0) {
                    continue;
                }
                let here = j * columns + i;
                let (x, y) = place(i, j);
                board.pixels[here] = shoot.first(x, y);
                board.settled[here] = i == 0 || j == 0;
                if i > 0 && j > 0 {
                    self.compare(&mut board, here, (x, y), shoot);
                }
            }
        }
        let rows = board.pixels.chunks(columns).skip(1);
        rows.flat_map(|row| &row[1..]).map(|viewed| viewed.pixel).collect()
    }

    /// Compares a pixel with its neighbours and refines those that differ.
    fn compare(&self, board: &mut Board, here: usize, (x, y): (f64, f64), shoot: &mut impl Shoot) {
        let (left, up) = (here - 1, here - board.columns);
        let from_left = self.differs.between(&board.pixels[left], &board.pixels[here]);
        let from_up = self.differs.between(&board.pixels[up], &board.pixels[here]);
        let all =
            [(from_left, left, x - 1.0, y), (from_up, up, x, y - 1.0), (from_left || from_up, here, x, y)];
        for (differs, index, x, y) in all {
            if differs && !board.settled[index] {
                let refined = self.refined(board.pixels[index].pixel, x, y, shoot);
                board.pixels[index] = self.differs.view(refined);
                board.settled[index] = true;
            }
        }
    }

    /// The mean of the first sample and a grid of more.
    fn refined(&self, first: Pixel, x: f64, y: f64, shoot: &mut impl Shoot) -> Pixel {
        let n = f64::from(self.depth);
        let offset = |i: u32| -0.5 + 0.5 / n + f64::from(i) / n;
        let mut sum = first;
        for j in 0..self.depth {
            for i in 0..self.depth {
                add(&mut sum, jittered(x + offset(i), y + offset(j), self.jitter / n, shoot));
            }
        }
        let count = (self.depth * self.depth + 1) as f32;
        sum.map(|v| v / count)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Asked, plain_difference};
    use super::*;

    fn method(depth: u32) -> NonRecursive {
        NonRecursive { differs: plain_difference(), depth, jitter: 0.0 }
    }

    #[test]
    fn an_edge_refines_the_pixels_on_both_sides() {
        // White right of x = 1.25: the edge cuts pixel 1.
        let mut count = 0;
        let shoot = |x: f64, _: f64| {
            count += 1;
            let v = if x > 1.25 { 1.0 } else { 0.0 };
            [v, v, v, 0.0]
        };
        let got = method(3).tile(&Tile { x: 0..4, y: 0..1 }, &mut Asked(plain_difference(), shoot));
        // Of pixel 1's columns at 2/3, 1, 4/3 one is white: 3 of 9, the centre again is black.
        let expected = [0.0, 0.3, 1.0, 1.0];
        for (pixel, value) in got.iter().zip(expected) {
            assert!((pixel[0] - value).abs() < 1e-6, "{got:?}");
        }
        // The row above and the pixel at the left are traced as helpers; two pixels are refined, and pixel 3 is not
        // unlike the white mean of pixel 2.
        assert_eq!(count, 4 + 1 + 4 + 2 * 9);
    }

    #[test]
    fn even_pictures_stay_as_they_are() {
        let mut places = Vec::new();
        let shoot = |x: f64, y: f64| {
            places.push((x, y));
            [0.5, 0.25, 0.125, 0.0]
        };
        let got = method(3).tile(&Tile { x: 2..4, y: 1..3 }, &mut Asked(plain_difference(), shoot));
        assert_eq!(got, vec![[0.5, 0.25, 0.125, 0.0]; 4]);
        let expected = [(2., 0.), (3., 0.), (1., 1.), (2., 1.), (3., 1.), (1., 2.), (2., 2.), (3., 2.)];
        assert_eq!(places, expected);
    }
}
