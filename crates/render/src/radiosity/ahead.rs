//! Rays of a gather that threads without work of their own shoot before their turn. A ray's answer counts if it is the
//! one that it would have given in its turn: it needed no new sample, no sample made meanwhile bears on what it looked
//! up, and random numbers stand where it found them. All others are shot again, so that the cache is the same for any
//! number of threads.
use rayon::prelude::*;
use smallvec::SmallVec;

use super::State;
use super::cache::{Query, Sample};
use super::gather::{Brought, Gather};
use crate::integrator::Tracer;
use crate::sampling::Streams;

/// So many rays are worth a thread's attention.
const FEWEST: usize = 8;

/// What a ray brings that was shot before its turn.
pub(super) struct Guess {
    brought: Brought,
    asked: Asked,
    /// The random numbers after it.
    streams: Streams,
}

/// What a ray wanted to know of the cache.
#[derive(Default)]
pub(super) struct Asked {
    /// By depth: where it looked.
    pub queries: SmallVec<[(u32, Query); 2]>,
    /// Was a new sample wanted?
    pub stuck: bool,
}

/// The answers to a gather's rays as they were when it began.
pub(super) struct Guesses {
    all: Vec<Guess>,
    /// The random numbers then.
    streams: Streams,
    /// How many samples there were then of those that are remembered.
    made: usize,
}

impl Tracer<'_> {
    /// Shoots all rays of a gather, if threads may help with that.
    pub(super) fn look_ahead(&self, gather: &Gather<'_>) -> Option<Guesses> {
        let state = self.radiosity.as_ref().filter(|_| self.photons.is_none())?;
        state.turns.filter(|turns| turns.is_anyone_idle())?;
        let room = self.stack_left();
        let all = gather.directions.par_iter().enumerate().with_min_len(FEWEST).map_init(
            || self.helper(room),
            |helper, (i, _)| {
                helper.streams = self.streams;
                let brought = helper.gather_ray(gather, i as u32);
                let asked = helper.radiosity.as_mut().and_then(|s| s.asked.replace(Asked::default()));
                Guess { brought, asked: asked.unwrap_or_default(), streams: helper.streams }
            },
        );
        Some(Guesses { all: all.collect(), streams: self.streams, made: state.made.len() })
    }

    /// A tracer for another thread that sees what this one sees. It makes no samples.
    fn helper(&self, room: usize) -> Tracer<'_> {
        let mut helper = self.fork(room);
        helper.radiosity = self.radiosity.as_ref().map(|state| State {
            before: Some(&state.own),
            own: super::Cache::default(),
            cursors: Vec::new(),
            asked: Some(Asked::default()),
            turns: None,
            made: Vec::new(),
            ..*state
        });
        helper
    }

    /// What ray number `i` brings, if that is what it would bring now.
    pub(super) fn foreseen(&mut self, guesses: &Guesses, i: u32) -> Option<Brought> {
        let guess = guesses.all.get(i as usize)?;
        let made = self.radiosity.as_ref()?.made.get(guesses.made..)?;
        let bears = |(depth, sample): &(u32, Sample)| {
            guess.asked.queries.iter().any(|(d, query)| d == depth && sample.counts_at(query))
        };
        if guess.asked.stuck || self.streams != guesses.streams || made.iter().any(bears) {
            return None;
        }
        self.streams = guess.streams;
        Some(guess.brought)
    }
}
