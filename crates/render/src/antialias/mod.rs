//! Anti-aliasing: more samples where neighbours differ (light spec, section 2).
mod first;
mod nonrecursive;
mod recursive;

use raggio_image::Curve;
use raggio_scene::GammaMode;

pub use first::{First, Patch};
pub use nonrecursive::NonRecursive;
pub use recursive::Recursive;

use crate::film::Pixel;
use crate::sampling::jitter2d;

/// Takes samples of the picture.
pub trait Shoot {
    /// At a place of the lattice of which every pixel has a sample.
    fn first(&mut self, x: f64, y: f64) -> Viewed;
    /// Anywhere.
    fn more(&mut self, x: f64, y: f64) -> Pixel;
}

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

    /// A pixel with what a display makes of it, which is worth keeping: powers are slow.
    pub fn view(&self, pixel: Pixel) -> Viewed {
        let seen = |v: f32| {
            let light = if self.srgb { Curve::Srgb.decode(v) } else { v };
            light.max(0.0).powf(self.exponent)
        };
        Viewed { pixel, seen: [seen(pixel[0]), seen(pixel[1]), seen(pixel[2])] }
    }

    /// Do they?
    pub fn between(&self, a: &Viewed, b: &Viewed) -> bool {
        if a.pixel == b.pixel {
            return self.threshold <= 0.0;
        }
        let colors: f32 = (0..3).map(|i| (a.seen[i] - b.seen[i]).abs()).sum();
        colors + (a.pixel[3] - b.pixel[3]).abs() >= self.threshold
    }
}

/// A pixel and how bright it looks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Viewed {
    /// Its colour and transmit.
    pub pixel: Pixel,
    seen: [f32; 3],
}

/// A sample moved by jitter of that amount.
fn jittered(x: f64, y: f64, amount: f64, shoot: &mut impl Shoot) -> Pixel {
    if amount == 0.0 {
        return shoot.more(x, y);
    }
    let (jx, jy) = jitter2d(x, y);
    shoot.more(x + jx * amount, y + jy * amount)
}

fn add(sum: &mut Pixel, pixel: Pixel) {
    sum.iter_mut().zip(pixel).for_each(|(sum, value)| *sum += value);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of a function, all of them taken when they are asked for.
    pub struct Asked<F>(pub Difference, pub F);

    impl<F: FnMut(f64, f64) -> Pixel> Shoot for Asked<F> {
        fn first(&mut self, x: f64, y: f64) -> Viewed {
            self.0.view((self.1)(x, y))
        }
        fn more(&mut self, x: f64, y: f64) -> Pixel {
            (self.1)(x, y)
        }
    }

    pub fn plain_difference() -> Difference {
        Difference::new(GammaMode::Working(Curve::Linear), 2.5, 0.3)
    }
}
