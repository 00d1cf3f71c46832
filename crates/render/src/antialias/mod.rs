//! Anti-aliasing: more samples where neighbours differ (light spec, section 2).
mod nonrecursive;
mod recursive;

use raggio_image::Curve;
use raggio_scene::GammaMode;

pub use nonrecursive::NonRecursive;
pub use recursive::Recursive;

use crate::film::Pixel;
use crate::sampling::jitter2d;

/// Takes a sample of the picture at a place.
pub type Shoot<'a> = dyn FnMut(f64, f64) -> Pixel + 'a;

/// Decides whether two colours differ too much.
#[derive(Clone, Copy, Debug)]
pub struct Difference {
    /// From the working space to light, where that is the sRGB curve.
    srgb: bool,
    exponent: f32,
    threshold: f32,
}

impl Difference {
    /// Compares as seen through a display of that gamma.
    pub fn new(mode: GammaMode, gamma: f32, threshold: f32) -> Difference {
        let (srgb, exponent) = match mode {
            GammaMode::Working(Curve::Power(g)) => (false, g / gamma),
            GammaMode::Working(Curve::Srgb) => (true, 1.0 / gamma),
            GammaMode::Working(Curve::Linear) | GammaMode::None => (false, 1.0 / gamma),
        };
        Difference { srgb, exponent, threshold }
    }

    /// Do they?
    pub fn between(&self, a: &Pixel, b: &Pixel) -> bool {
        if a == b {
            return self.threshold <= 0.0;
        }
        let seen = |v: f32| {
            let light = if self.srgb { Curve::Srgb.decode(v) } else { v };
            light.max(0.0).powf(self.exponent)
        };
        let colors: f32 = (0..3).map(|i| (seen(a[i]) - seen(b[i])).abs()).sum();
        colors + (a[3] - b[3]).abs() >= self.threshold
    }
}

/// A sample moved by jitter of that amount.
fn jittered(x: f64, y: f64, amount: f64, shoot: &mut Shoot<'_>) -> Pixel {
    if amount == 0.0 {
        return shoot(x, y);
    }
    let (jx, jy) = jitter2d(x, y);
    shoot(x + jx * amount, y + jy * amount)
}

fn add(sum: &mut Pixel, pixel: Pixel) {
    sum.iter_mut().zip(pixel).for_each(|(sum, value)| *sum += value);
}
