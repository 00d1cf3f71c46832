//! Pigments and patterns as user functions.
use std::any::Any;
use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use raggio_function::{Bounds, External};
use raggio_math::Vec3;
use raggio_scene as scene;

use crate::{Context, Noise, Pattern, Pigment};

/// `function { pigment { ... } }`: five components, red, green, blue, filter and transmit.
#[derive(Debug)]
pub struct PigmentFunction {
    source: Arc<scene::Pigment>,
    pigment: Pigment,
    /// Which of all pigment functions it is.
    number: u32,
}

/// The number of the next pigment function.
static NEXT: AtomicU32 = AtomicU32::new(1);

/// An answer of a pigment function: its number, the bits of the point, and the colour.
type Answer = (u32, [u64; 3], [f64; 5]);

thread_local! {
    /// The last answers, by number modulo their count: scenes ask `f(x,y,z).red`, then green, then blue.
    static LAST: [Cell<Answer>; 4] = const { [const { Cell::new((0, [0; 3], [0.0; 5])) }; 4] };
}

impl PigmentFunction {
    /// Compiles the pigment.
    pub fn new(source: Arc<scene::Pigment>, noise: Noise) -> Self {
        let pigment = Pigment::compile(&source, noise);
        PigmentFunction { source, pigment, number: NEXT.fetch_add(1, Ordering::Relaxed) }
    }

    /// The pigment as the scene has it.
    pub fn source(&self) -> &Arc<scene::Pigment> {
        &self.source
    }
}

/// `function { pattern { ... } }`: the value before any map.
#[derive(Debug)]
pub struct PatternFunction {
    source: Arc<scene::Pattern>,
    pattern: Pattern,
}

impl PatternFunction {
    /// Compiles the pattern.
    pub fn new(source: Arc<scene::Pattern>, noise: Noise) -> Self {
        let pattern = Pattern::compile(&source, noise);
        PatternFunction { source, pattern }
    }

    /// The pattern as the scene has it.
    pub fn source(&self) -> &Arc<scene::Pattern> {
        &self.source
    }
}

fn point(args: &[f64]) -> Vec3 {
    let at = |k: usize| args.get(k).copied().unwrap_or(0.0);
    Vec3::new(at(0), at(1), at(2))
}

fn place(args: &[Bounds]) -> [Bounds; 3] {
    std::array::from_fn(|k| args.get(k).copied().unwrap_or(Bounds::constant(0.0)))
}

impl External for PigmentFunction {
    fn eval(&self, args: &[f64]) -> [f64; 5] {
        let p = point(args);
        let bits = p.to_array().map(f64::to_bits);
        LAST.with(|last| {
            let last = &last[self.number as usize % last.len()];
            let (number, known, color) = last.get();
            if number == self.number && known == bits {
                return color;
            }
            let color = self.pigment.sample(p, &Context::NONE).0.to_array();
            last.set((self.number, bits, color));
            color
        })
    }

    fn enclose(&self, args: &[Bounds]) -> [Bounds; 5] {
        self.pigment.enclose(place(args))
    }

    fn components(&self) -> usize {
        5
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

impl External for PatternFunction {
    fn eval(&self, args: &[f64]) -> [f64; 5] {
        [self.pattern.eval(point(args), &Context::NONE), 0.0, 0.0, 0.0, 0.0]
    }

    fn enclose(&self, args: &[Bounds]) -> [Bounds; 5] {
        let mut answer = [Bounds::constant(0.0); 5];
        answer[0] = self.pattern.enclose(place(args));
        answer
    }

    fn components(&self) -> usize {
        1
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}
