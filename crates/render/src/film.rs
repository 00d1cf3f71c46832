//! The film: tiles handed to threads, put together to a picture.
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use crate::antialias::{First, Patch};
use crate::api::{Antialias, Film, Options, Region};
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
        let canvas = Canvas::new(&region);
        match pool {
            Ok(pool) => pool.install(|| self.paint(options, &tiles, stack, cancel, progress, &canvas)),
            Err(_) => canvas.leave(),
        }
        canvas.into_film()
    }

    /// Paints all tiles, by the pool of the thread that calls.
    fn paint(
        &self,
        options: &Options,
        tiles: &[Tile],
        stack: usize,
        cancel: &AtomicBool,
        progress: &(dyn Fn(usize, usize) + Sync),
        canvas: &Canvas<'_>,
    ) {
        let photons = photons::shoot(self, options, stack, cancel);
        let cache = radiosity::pretrace(self, options, &photons, tiles, stack, cancel);
        let sampler = || {
            let radiosity = self.radiosity.as_ref().map(|rules| radiosity::State::new(rules, &cache, false));
            Sampler::new(self, options, stack, radiosity, &photons)
        };
        let all = Progress { total: options.area().area(), halves: AtomicUsize::new(0), tell: progress };
        let cancelled = || cancel.load(Ordering::Relaxed);
        // With radiosity a sample depends on those before it in its tile.
        let early = options.antialias.filter(|_| self.radiosity.is_none());
        let known = early.map(|antialias| first_samples(options, &antialias, &sampler, &cancelled, &all));
        let order = match &known {
            Some((_, efforts)) => heaviest_first(tiles, efforts, &options.area()),
            None => (0..tiles.len()).collect(),
        };
        in_turn(&order, &Turns::new(order.len()), |i| {
            if cancelled() {
                return canvas.leave();
            }
            let first = known.as_ref().map(|(first, _)| first);
            canvas.put(&tiles[i], &sampler().tile(&tiles[i], first));
            all.advance(tiles[i].area() * if first.is_some() { 1 } else { 2 });
        });
    }
}

/// The film while threads put tiles on it. What a tile holds goes to its place at once: kept until the end, it would
/// have to be read and written once more, from memory that the system had to make ready for it.
struct Canvas<'r> {
    region: &'r Region,
    film: Mutex<Film>,
}

impl<'r> Canvas<'r> {
    fn new(region: &'r Region) -> Self {
        let (width, height) = (region.right - region.left, region.bottom - region.top);
        let pixels = vec![[0.0; 4]; width * height];
        Canvas { region, film: Mutex::new(Film { width, height, pixels, cancelled: false }) }
    }

    /// The pixels of a tile, row by row.
    fn put(&self, tile: &Tile, pixels: &[Pixel]) {
        let mut film = self.film.lock().unwrap_or_else(PoisonError::into_inner);
        for (row, y) in pixels.chunks(tile.x.len()).zip(tile.y.clone()) {
            let start = (y - self.region.top) * film.width + tile.x.start - self.region.left;
            film.pixels[start..start + row.len()].copy_from_slice(row);
        }
    }

    /// Some tile stays empty.
    fn leave(&self) {
        self.film.lock().unwrap_or_else(PoisonError::into_inner).cancelled = true;
    }

    fn into_film(self) -> Film {
        self.film.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

/// How far a picture is; each pixel counts half when it has its first sample.
struct Progress<'a> {
    total: usize,
    halves: AtomicUsize,
    tell: &'a (dyn Fn(usize, usize) + Sync),
}

impl Progress<'_> {
    fn advance(&self, halves: usize) {
        (self.tell)((self.halves.fetch_add(halves, Ordering::Relaxed) + halves) / 2, self.total);
    }
}

/// Takes the samples that every pixel has, and tells by small tile about how long more will take.
fn first_samples<'w>(
    options: &Options,
    antialias: &Antialias,
    sampler: &(impl Fn() -> Sampler<'w> + Sync),
    cancelled: &(impl Fn() -> bool + Sync),
    all: &Progress<'_>,
) -> (First, Vec<Duration>) {
    let region = options.area();
    let parts = tiles(&First::extent(&region, antialias.method), SMALL_TILE);
    let (width, height) = (region.right - region.left, region.bottom - region.top);
    let inside = |range: &Range<usize>, end: usize| range.end.min(end) - range.start.min(end);
    let order: Vec<usize> = (0..parts.len()).collect();
    let patches = in_turn(&order, &Turns::new(order.len()), |i| {
        if cancelled() {
            return Patch::default();
        }
        let part = &parts[i];
        let patch = sampler().patch(&region, part, antialias);
        all.advance(inside(&part.x, width) * inside(&part.y, height));
        patch
    });
    let first = First::assemble(&region, antialias.method, &parts, &patches);
    (first, patches.iter().map(|patch| patch.effort).collect())
}

/// The numbers of tiles, those that will take longest first, so that no thread is left with a long one at the end.
fn heaviest_first(tiles: &[Tile], efforts: &[Duration], region: &Region) -> Vec<usize> {
    // Small tiles of the lattice of first samples, which has one column more than the region.
    let columns = (region.right - region.left + 1).div_ceil(SMALL_TILE);
    let effort = |tile: &Tile| -> Duration {
        let small = |range: &Range<usize>, start: usize| {
            (range.start - start) / SMALL_TILE..(range.end - start).div_ceil(SMALL_TILE)
        };
        let (x, y) = (small(&tile.x, region.left), small(&tile.y, region.top));
        y.flat_map(|y| x.clone().map(move |x| y * columns + x)).filter_map(|i| efforts.get(i)).sum()
    };
    let mut order: Vec<usize> = (0..tiles.len()).collect();
    order.sort_by_cached_key(|&i| std::cmp::Reverse(effort(&tiles[i])));
    order
}

/// Pieces of work, which threads take one by one.
pub(crate) struct Turns {
    next: AtomicUsize,
    count: usize,
}

impl Turns {
    /// So many pieces.
    pub fn new(count: usize) -> Turns {
        Turns { next: AtomicUsize::new(0), count }
    }

    fn take(&self) -> Option<usize> {
        let turn = self.next.fetch_add(1, Ordering::Relaxed);
        (turn < self.count).then_some(turn)
    }

    /// Did a thread come away with nothing?
    pub fn is_anyone_idle(&self) -> bool {
        self.next.load(Ordering::Relaxed) > self.count
    }
}

/// Works on `0..n` in the order given, each thread of the pool taking the next when it is done with one. The results
/// come by number.
pub(crate) fn in_turn<T: Send>(order: &[usize], turns: &Turns, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let made = rayon::broadcast(|_| {
        let mut made = Vec::new();
        while let Some(&i) = turns.take().and_then(|turn| order.get(turn)) {
            made.push((i, work(i)));
        }
        made
    });
    let mut all: Vec<(usize, T)> = made.into_iter().flatten().collect();
    all.sort_unstable_by_key(|(i, _)| *i);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_follow_the_order_and_results_the_numbers() {
        let order = [3, 1, 0, 2];
        let turn = AtomicUsize::new(0);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
        let made =
            pool.install(|| in_turn(&order, &Turns::new(4), |i| (i, turn.fetch_add(1, Ordering::Relaxed))));
        assert_eq!(made, [(0, 2), (1, 1), (2, 3), (3, 0)]);
    }

    #[test]
    fn the_heaviest_tile_goes_first() {
        let region = Region { left: 7, top: 0, right: 71, bottom: 32 };
        let tiles = tiles(&region, TILE);
        // Five small tiles in a row of the lattice, three rows.
        let mut efforts = vec![Duration::ZERO; 15];
        efforts[5 + 3] = Duration::from_millis(2);
        assert_eq!(heaviest_first(&tiles, &efforts, &region), [1, 0]);
        efforts[1] = Duration::from_millis(3);
        assert_eq!(heaviest_first(&tiles, &efforts, &region), [0, 1]);
    }

    #[test]
    fn tiles_cover_a_region_once() {
        let region = Region { left: 5, top: 3, right: 80, bottom: 40 };
        let tiles = tiles(&region, TILE);
        assert_eq!(tiles[0], Tile { x: 5..37, y: 3..35 });
        assert_eq!(tiles.iter().map(Tile::area).sum::<usize>(), 75 * 37);
        let canvas = Canvas::new(&region);
        for t in tiles.iter().rev() {
            let pixel = |x: usize, y: usize| [x as f32, y as f32, 0.0, 0.0];
            let pixels: Vec<_> = t.y.clone().flat_map(|y| t.x.clone().map(move |x| pixel(x, y))).collect();
            canvas.put(t, &pixels);
        }
        let film = canvas.into_film();
        assert!(!film.cancelled);
        for (i, pixel) in film.pixels.iter().enumerate() {
            assert_eq!(pixel[..2], [(5 + i % 75) as f32, (3 + i / 75) as f32]);
        }
    }
}
