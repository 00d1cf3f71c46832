//! The passes before the picture, which fill the cache (media and radiosity spec, section 3.7).
use std::iter::StepBy;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use raggio_math::noise;
use rayon::prelude::*;

use super::{Cache, State};
use crate::api::Options;
use crate::film::Tile;
use crate::photons;
use crate::sampler::Sampler;
use crate::world::World;

/// Numbers of tiles.
type Group = StepBy<Range<usize>>;

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
        for groups in rounds(pass, tiles.len()) {
            let (shared, known) = (&cache, &cursors);
            let work = |(slot, numbers): (usize, Group)| {
                let mut state = State::new(rules, shared, true);
                if let Some(cursors) = known.get(slot) {
                    state.cursors.clone_from(cursors);
                }
                let mut sampler = Sampler::new(world, options, stack, Some(state), photons);
                for number in numbers {
                    if !cancel.load(Ordering::Relaxed) {
                        grid(&tiles[number], number, pass, step, &mut |x, y| sampler.look(x, y));
                    }
                }
                sampler.into_radiosity().map(|state| (state.own, state.cursors))
            };
            let made: Vec<_> = groups.into_par_iter().enumerate().with_max_len(1).map(work).collect();
            for (slot, (own, cursor)) in made.into_iter().flatten().enumerate() {
                cache.absorb(own);
                match cursors.get_mut(slot) {
                    Some(known) => *known = cursor,
                    None => cursors.push(cursor),
                }
            }
        }
    }
    cache
}

/// The most groups of a round in the first pass.
const MOST_AT_FIRST: usize = 16;

/// The numbers of tiles by round and group. Rounds follow each other, each seeing what those before found; the groups of
/// a round are worked on at once and see nothing of each other. Pass k has 2^k groups in one round. In the first pass,
/// when nothing is known yet, every tile is a group and rounds grow with what is known, so that little is found twice.
fn rounds(pass: u32, tiles: usize) -> Vec<Vec<Group>> {
    if pass > 0 {
        let groups = (1usize << pass.min(10)).min(tiles.max(1));
        return vec![(0..groups).map(|group| (group..tiles).step_by(groups)).collect()];
    }
    let mut rounds = Vec::new();
    let mut done = 0;
    while done < tiles {
        let next = (done + done.div_ceil(2).clamp(1, MOST_AT_FIRST)).min(tiles);
        rounds.push((done..next).map(|tile| (tile..tile + 1).step_by(1)).collect());
        done = next;
    }
    rounds
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pass_looks_at_every_tile_once() {
        for pass in 0..4 {
            let mut all: Vec<usize> = rounds(pass, 23).into_iter().flatten().flatten().collect();
            all.sort_unstable();
            assert_eq!(all, (0..23).collect::<Vec<_>>());
        }
        let sizes: Vec<usize> = rounds(0, 23).iter().map(Vec::len).collect();
        assert_eq!(sizes, [1, 1, 1, 2, 3, 4, 6, 5]);
    }
}
