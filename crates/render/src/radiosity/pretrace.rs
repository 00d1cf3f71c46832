//! The passes before the picture, which fill the cache (media and radiosity spec, section 3.7).
use std::sync::atomic::{AtomicBool, Ordering};

use raggio_math::noise;

use super::{Cache, State};
use crate::api::Options;
use crate::film::{Tile, Turns, in_turn};
use crate::photons;
use crate::sampler::Sampler;
use crate::world::World;

/// Fills the cache of a scene: coarse grids of camera rays, each finer than the one before. Runs in the pool of the
/// thread that calls.
pub fn pretrace(
    world: &World,
    options: &Options,
    photons: &photons::Maps,
    tiles: &[Tile],
    stack: usize,
    cancel: &AtomicBool,
) -> Cache {
    let Some(rules) = &world.radiosity else { return Cache::default() };
    let side = options.width.max(options.height) as f64;
    let first = side * f64::from(rules.settings.pretrace_start);
    let last = (side * f64::from(rules.settings.pretrace_end)).max(1.0);
    let passes = ((first / last).max(1.0).log2() + 1.0 - 1e-10).floor() as u32 + 1;
    let mut cache = Cache::new(rules.limit());
    let mut cursors: Vec<Vec<u32>> = Vec::new();
    for pass in 0..passes.min(252) {
        let step = (first / f64::from(1u32 << pass.min(30))).max(last);
        let groups = (1usize << pass.min(10)).min(tiles.len().max(1));
        let shared = &cache;
        let (order, turns) = ((0..groups).collect::<Vec<_>>(), Turns::new(groups));
        let work = |group: usize| {
            let mut state = State::new(rules, shared, true).with_helpers_of(&turns);
            if let Some(cursors) = cursors.get(group) {
                state.cursors.clone_from(cursors);
            }
            let mut sampler = Sampler::new(world, options, stack, Some(state), photons);
            for (number, tile) in tiles.iter().enumerate().skip(group).step_by(groups) {
                if !cancel.load(Ordering::Relaxed) {
                    grid(tile, number, pass, step, &mut |x, y| sampler.look(x, y));
                }
            }
            sampler.into_radiosity().map(|state| (state.own, state.cursors))
        };
        let made = in_turn(&order, &turns, work);
        cursors.clear();
        for (own, cursor) in made.into_iter().flatten() {
            cache.absorb(own);
            cursors.push(cursor);
        }
    }
    cache
}

/// Calls `look` for every place of a pass's grid in a tile.
fn grid(tile: &Tile, number: usize, pass: u32, step: f64, look: &mut dyn FnMut(f64, f64)) {
    /// How many numbers the pass draws from, over and over.
    const NUMBERS: usize = 2047;
    let mut next = 17 * (pass as usize + 1) + 13 * number;
    let mut random = || {
        next += 1;
        2.0 * noise::random(next % NUMBERS) - 1.0
    };
    let jitter = (step / 2.0).min(1.0);
    let start = |from: usize| ((from as f64 - 0.5) / step).ceil() * step;
    let middle = (step - 1.0) / 2.0;
    let mut y = start(tile.y.start);
    while y < tile.y.end as f64 {
        let mut x = start(tile.x.start);
        while x < tile.x.end as f64 {
            let dy = jitter * random();
            let dx = jitter * random();
            look(x + middle + dx, y + middle + dy);
            x += step;
        }
        y += step;
    }
}
