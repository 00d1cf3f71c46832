//! The film: tiles handed to threads, put together to a picture.
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::api::{Film, Options, Region};
use crate::sampler::Sampler;
use crate::world::World;
use crate::{photons, radiosity};

/// Side of a tile in pixels. Anti-aliasing knows no neighbours beyond its tile and radiosity no new samples, so that the
/// picture depends on it.
const TILE: usize = 32;
/// The same where the picture does not depend on it: less is left to wait for at the end.
const SMALL_TILE: usize = 16;
/// The stack of a worker; rays may follow each other 256 levels deep and more.
const STACK_SIZE: usize = 256 << 20;
/// How much of it rays may use.
const STACK_FOR_RAYS: usize = 240 << 20;
/// The same where no workers can be had and the caller's thread has to do.
const STACK_OF_CALLER: usize = 512 << 10;

/// Colour and transmit of a pixel.
pub type Pixel = [f32; 4];

/// A rectangle of pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Tile {
    /// Columns.
    pub x: Range<usize>,
    /// Rows.
    pub y: Range<usize>,
}

impl Tile {
    /// How many pixels it has.
    pub fn area(&self) -> usize {
        self.x.len() * self.y.len()
    }
}

/// The tiles of a region, row by row.
fn tiles(region: &Region, side: usize) -> Vec<Tile> {
    let cut = |from: usize, to: usize| (from..to).step_by(side).map(move |a| a..(a + side).min(to));
    cut(region.top, region.bottom)
        .flat_map(|y| cut(region.left, region.right).map(move |x| Tile { x, y: y.clone() }))
        .collect()
}

impl World {
    /// Renders. `progress` is called from any thread with (pixels done, pixels in all); `cancel` stops at the next
    /// tile. The film has the size of the region.
    pub fn render(
        &self,
        options: &Options,
        cancel: &AtomicBool,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Film {
        let region = options.area();
        let alone = options.antialias.is_none() && self.radiosity.is_none();
        let tiles = tiles(&region, if alone { SMALL_TILE } else { TILE });
        let workers = rayon::ThreadPoolBuilder::new().num_threads(options.threads).stack_size(STACK_SIZE);
        let (pool, stack) = match workers.build() {
            Ok(pool) => (Ok(pool), STACK_FOR_RAYS),
            Err(_) => {
                let caller = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread();
                (caller.build(), STACK_OF_CALLER)
            }
        };
        let parts = match pool {
            Ok(pool) => pool.install(|| self.parts(options, &tiles, stack, cancel, progress)),
            Err(_) => vec![Vec::new(); tiles.len()],
        };
        assemble(&region, &tiles, &parts)
    }

    /// The pixels of all tiles, made by the pool of the thread that calls; nothing for those that were cut short.
    fn parts(
        &self,
        options: &Options,
        tiles: &[Tile],
        stack: usize,
        cancel: &AtomicBool,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Vec<Vec<Pixel>> {
        let photons = photons::shoot(self, options, stack, cancel);
        let cache = radiosity::pretrace(self, options, &photons, tiles, stack, cancel);
        let (done, total) = (AtomicUsize::new(0), tiles.iter().map(Tile::area).sum());
        let render = |tile: &Tile| {
            if cancel.load(Ordering::Relaxed) {
                return Vec::new();
            }
            let radiosity = self.radiosity.as_ref().map(|rules| radiosity::State::new(rules, &cache, false));
            let pixels = Sampler::new(self, options, stack, radiosity, &photons).tile(tile);
            progress(done.fetch_add(tile.area(), Ordering::Relaxed) + tile.area(), total);
            pixels
        };
        tiles.par_iter().with_max_len(1).map(render).collect()
    }
}

fn assemble(region: &Region, tiles: &[Tile], parts: &[Vec<Pixel>]) -> Film {
    let (width, height) = (region.right - region.left, region.bottom - region.top);
    let mut film = Film { width, height, pixels: vec![[0.0; 4]; width * height], cancelled: false };
    for (tile, part) in tiles.iter().zip(parts) {
        if part.is_empty() {
            film.cancelled = true;
            continue;
        }
        for (row, y) in part.chunks(tile.x.len()).zip(tile.y.clone()) {
            let start = (y - region.top) * width + tile.x.start - region.left;
            film.pixels[start..start + row.len()].copy_from_slice(row);
        }
    }
    film
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_a_region_once() {
        let region = Region { left: 5, top: 3, right: 80, bottom: 40 };
        let tiles = tiles(&region, TILE);
        assert_eq!(tiles[0], Tile { x: 5..37, y: 3..35 });
        assert_eq!(tiles.iter().map(Tile::area).sum::<usize>(), 75 * 37);
        let parts: Vec<_> = tiles
            .iter()
            .map(|t| {
                let pixel = |x: usize, y: usize| [x as f32, y as f32, 0.0, 0.0];
                t.y.clone().flat_map(|y| t.x.clone().map(move |x| pixel(x, y))).collect()
            })
            .collect();
        let film = assemble(&region, &tiles, &parts);
        assert!(!film.cancelled);
        for (i, pixel) in film.pixels.iter().enumerate() {
            assert_eq!(pixel[..2], [(5 + i % 75) as f32, (3 + i / 75) as f32]);
        }
    }
}
