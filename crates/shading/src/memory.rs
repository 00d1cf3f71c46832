//! Pigments in use at several places of a texture are often asked at one point again and again, as a pattern and as an
//! entry of its map. What was found last is remembered, by each thread on its own.
use std::cell::RefCell;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread::LocalKey;

use raggio_image::Color;
use raggio_math::Vec3;

/// What a pigment gives: a colour, and whether there is one.
pub(crate) type Sample = (Color, bool);

/// As many pigments are remembered side by side.
const KEPT: usize = 16;

/// What all numbers begin after: 0 stands for none.
static LAST: AtomicU32 = AtomicU32::new(0);

/// The number of a pigment that is remembered. No other ever has it, in no other scene.
#[derive(Debug, Default)]
pub(crate) struct Number(AtomicU32);

impl Number {
    /// From now on there is one.
    pub fn give(&self) {
        if self.get().is_none() {
            self.0.store(LAST.fetch_add(1, Ordering::Relaxed) + 1, Ordering::Relaxed);
        }
    }

    /// The number, if there is one.
    #[inline]
    pub fn get(&self) -> Option<u32> {
        Some(self.0.load(Ordering::Relaxed)).filter(|&number| number != 0)
    }
}

/// The last answer of a pigment at some points.
#[derive(Clone, Copy)]
pub(crate) struct Known<const N: usize> {
    number: u32,
    points: [Vec3; N],
    samples: [Sample; N],
}

pub(crate) type Memory<const N: usize> = RefCell<[Known<N>; KEPT]>;

impl<const N: usize> Known<N> {
    const NOTHING: Known<N> =
        Known { number: 0, points: [Vec3::NAN; N], samples: [(Color::BLACK, false); N] };
}

thread_local! {
    pub(crate) static ONE: Memory<1> = const { RefCell::new([Known::NOTHING; KEPT]) };
    pub(crate) static FOUR: Memory<4> = const { RefCell::new([Known::NOTHING; KEPT]) };
}

/// What a pigment of a number gives at some points, from memory if that is where it was asked last.
pub(crate) fn remembered<const N: usize>(
    memory: &'static LocalKey<Memory<N>>,
    number: u32,
    points: [Vec3; N],
    ask: impl FnOnce() -> [Sample; N],
) -> [Sample; N] {
    let place = number as usize % KEPT;
    let known = memory.with_borrow(|all| {
        let known = &all[place];
        (known.number == number && known.points == points).then_some(known.samples)
    });
    known.unwrap_or_else(|| {
        let samples = ask();
        memory.with_borrow_mut(|all| all[place] = Known { number, points, samples });
        samples
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_same_pigment_at_the_same_place_is_remembered() {
        let (a, b) = (Number::default(), Number::default());
        a.give();
        b.give();
        let (a, b) = (a.get().unwrap(), b.get().unwrap());
        assert_ne!(a, b);
        let ask = |number: u32, p: Vec3, new: f32| {
            let sample = || [(Color { filter: new, ..Color::BLACK }, true)];
            remembered(&ONE, number, [p], sample)[0].0.filter
        };
        assert_eq!(ask(a, Vec3::X, 1.0), 1.0);
        assert_eq!(ask(b, Vec3::X, 2.0), 2.0);
        assert_eq!(ask(a, Vec3::X, 3.0), 1.0);
        assert_eq!(ask(a, Vec3::Y, 4.0), 4.0);
        assert_eq!(ask(a, Vec3::X, 5.0), 5.0);
        assert_eq!(ask(b, Vec3::X, 6.0), 2.0);
    }
}
