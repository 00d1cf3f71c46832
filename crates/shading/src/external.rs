//! Pigments and patterns as user functions.
use std::any::Any;
use std::sync::Arc;

use raggio_function::{Bounds, External};
use raggio_math::Vec3;
use raggio_scene as scene;

use crate::{Context, Noise, Pattern, Pigment};

/// `function { pigment { ... } }`: five components, red, green, blue, filter and transmit.
#[derive(Debug)]
pub struct PigmentFunction {
    source: Arc<scene::Pigment>,
    pigment: Pigment,
}

impl PigmentFunction {
    /// Compiles the pigment.
    pub fn new(source: Arc<scene::Pigment>, noise: Noise) -> Self {
        let pigment = Pigment::compile(&source, noise);
        PigmentFunction { source, pigment }
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
        self.pigment.sample(point(args), &Context::NONE).0.to_array()
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
