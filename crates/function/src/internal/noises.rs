//! Noise.
use raggio_math::Vec3;

use super::Args;

/// The noise that parameter number `parameter` names; 0, and with it every fraction below 1, is the first generator.
fn generator(a: &Args, parameter: usize) -> impl Fn(Vec3) -> f64 + use<> {
    let g = generator_number(a.p[parameter]);
    move |p| raggio_math::noise::noise(g, p)
}

/// The generator that a parameter names.
pub(crate) fn generator_number(parameter: f64) -> u8 {
    (parameter as i64 & 3).max(1) as u8
}

fn point(a: &Args) -> Vec3 {
    Vec3::new(a.x, a.y, a.z)
}

/// What numbers without a function give.
pub(super) fn nothing(_: &Args) -> f64 {
    0.0
}

pub(super) fn noise_generator(a: &Args) -> f64 {
    generator(a, 1)(point(a))
}
