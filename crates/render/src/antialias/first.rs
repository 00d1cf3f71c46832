//! The samples that every pixel has: a lattice over the picture, taken before any pixel gets more. Tiles ask their
//! neighbours' samples too, which nobody takes twice so.
use std::time::{Duration, Instant};

use super::{Difference, Viewed};
use crate::api::{Antialias, AntialiasMethod, Region};
use crate::film::{Pixel, Tile};

/// The lattice of a region: a row and a column more than the region has.
pub struct First {
    /// The place of the first sample.
    start: (f64, f64),
    columns: usize,
    samples: Vec<Viewed>,
}

/// Part of the lattice.
#[derive(Default)]
pub struct Patch {
    samples: Vec<Viewed>,
    /// About how long more samples will take, where neighbours differ.
    pub effort: Duration,
}

/// Where a lattice starts and its size.
fn lattice(region: &Region, method: AntialiasMethod) -> ((f64, f64), Region) {
    let (left, top) = (region.left as f64, region.top as f64);
    let start = match method {
        // Pixels with the row above and the column at the left; or their corners.
        AntialiasMethod::NonRecursive => (left - 1.0, top - 1.0),
        AntialiasMethod::Recursive => (left - 0.5, top - 0.5),
    };
    let size = (region.right - region.left, region.bottom - region.top);
    (start, Region { left: 0, top: 0, right: size.0 + 1, bottom: size.1 + 1 })
}

impl First {
    /// The rows and columns of a region's lattice.
    pub fn extent(region: &Region, method: AntialiasMethod) -> Region {
        lattice(region, method).1
    }

    /// Takes the samples of some rows and columns.
    pub fn patch(
        region: &Region,
        antialias: &Antialias,
        part: &Tile,
        differs: &Difference,
        mut shoot: impl FnMut(f64, f64) -> Pixel,
    ) -> Patch {
        let began = Instant::now();
        let (start, _) = lattice(region, antialias.method);
        let mut samples: Vec<Viewed> = Vec::with_capacity(part.area());
        let mut unlike = 0;
        let columns = part.x.len();
        for y in part.y.clone() {
            for x in part.x.clone() {
                let sample = differs.view(shoot(start.0 + x as f64, start.1 + y as f64));
                let left = samples.last().filter(|_| x > part.x.start);
                let up = samples.len().checked_sub(columns).map(|i| &samples[i]);
                let edge = left.into_iter().chain(up).any(|other| differs.between(other, &sample));
                // An edge lies between two pixels.
                unlike += u32::from(edge) * 2;
                samples.push(sample);
            }
        }
        let share = f64::from(unlike) / part.area().max(1) as f64;
        let more = share.min(1.0) * f64::from(antialias.depth * antialias.depth);
        Patch { samples, effort: began.elapsed().mul_f64(more) }
    }

    /// Puts a lattice together.
    pub fn assemble(region: &Region, method: AntialiasMethod, parts: &[Tile], patches: &[Patch]) -> First {
        let (start, extent) = lattice(region, method);
        let columns = extent.right;
        let mut samples = vec![Viewed::default(); extent.area()];
        for (part, patch) in parts.iter().zip(patches) {
            for (row, y) in patch.samples.chunks(part.x.len().max(1)).zip(part.y.clone()) {
                let at = y * columns + part.x.start;
                samples[at..at + row.len()].copy_from_slice(row);
            }
        }
        First { start, columns, samples }
    }

    /// The sample at a place of the lattice.
    pub fn at(&self, x: f64, y: f64) -> Viewed {
        let (column, row) = ((x - self.start.0) as usize, (y - self.start.1) as usize);
        self.samples.get(row * self.columns + column).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::plain_difference;
    use super::*;

    #[test]
    fn every_sample_is_at_its_place_and_edges_take_effort() {
        let region = Region { left: 3, top: 5, right: 8, bottom: 7 };
        for (method, start) in
            [(AntialiasMethod::NonRecursive, (2.0, 4.0)), (AntialiasMethod::Recursive, (2.5, 4.5))]
        {
            let antialias = Antialias { method, threshold: 0.3, depth: 3, jitter: 0.0, gamma: 2.5 };
            assert_eq!(First::extent(&region, method), Region { left: 0, top: 0, right: 6, bottom: 3 });
            let parts = [Tile { x: 0..4, y: 0..3 }, Tile { x: 4..6, y: 0..3 }];
            let color = |x: f64, y: f64| [if x > 4.7 { 0.0 } else { 0.9 }, y as f32 * 1e-3, 0.0, 0.0];
            let take = |part| First::patch(&region, &antialias, part, &plain_difference(), color);
            let patches = [take(&parts[0]), take(&parts[1])];
            assert!(patches[0].effort > Duration::ZERO && patches[1].effort == Duration::ZERO);
            let first = First::assemble(&region, method, &parts, &patches);
            for (x, y) in (0..18).map(|i| (start.0 + f64::from(i % 6), start.1 + f64::from(i / 6))) {
                assert_eq!(first.at(x, y).pixel, color(x, y));
            }
        }
    }
}
