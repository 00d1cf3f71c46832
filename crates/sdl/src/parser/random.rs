//! `seed` and `rand` (language spec, section 2.6).

/// All streams, by the number that `seed` gave.
#[derive(Debug, Default)]
pub struct Streams {
    states: Vec<u32>,
    /// Streams drawn from since [`Streams::remember`], with their states before.
    drawn: Vec<(usize, u32)>,
}

impl Streams {
    /// A new stream; its number.
    pub fn seed(&mut self, n: f64) -> f64 {
        self.states.push(n as i64 as u32);
        (self.states.len() - 1) as f64
    }

    /// The next number of a stream, 0 to 1; `None` where there is no such stream.
    pub fn next(&mut self, index: f64) -> Option<f64> {
        if !(index > -1.0 && index < self.states.len() as f64) {
            return None;
        }
        let state = &mut self.states[index as usize];
        self.drawn.push((index as usize, *state));
        *state = state.wrapping_mul(1_812_433_253).wrapping_add(12_345);
        Some(f64::from(*state) / f64::from(u32::MAX))
    }

    /// The states that [`Streams::restore`] goes back to.
    pub fn remember(&mut self) {
        self.drawn.clear();
    }

    /// Takes back every draw since [`Streams::remember`].
    pub fn restore(&mut self) {
        while let Some((index, state)) = self.drawn.pop() {
            self.states[index] = state;
        }
    }
}
