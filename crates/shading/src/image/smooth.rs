//! `smooth` pictures: where many of the picture's pixels lie within one of the camera's, what is seen is their mean. Halved
//! copies of the picture (Williams 1983) are looked up along the longer side of what the camera's pixel covers (Feline,
//! McCormack et al. 1999), so that a floor seen at a flat angle stays sharp across the view.
use raggio_image::{Color, Layout, Mosaic, Rgb};
use raggio_math::{Vec2, Vec3};

use super::{Image, Place, Texels};

/// The points beside the one in the middle of a footprint lie this part of the footprint's axes away: what is repeated
/// thousands of times within it is still followed.
pub const FOOTPRINT_STEP: f64 = 1.0 / 4096.0;

/// Look-ups along the longer axis, at most. Where more would be needed the picture is blurred further.
const MOST_TAPS: f64 = 16.0;

/// Copies of a picture, each half the size of the one before; the first is the picture's half.
#[derive(Debug)]
pub(super) struct Pyramid {
    levels: Vec<Level>,
}

#[derive(Debug)]
struct Level {
    width: usize,
    height: usize,
    layout: Layout,
    colors: Box<[Color]>,
}

/// A sum of colours by weight.
#[derive(Clone, Copy, Default)]
struct Sum {
    rgb: Rgb,
    filter: f32,
    transmit: f32,
}

impl Sum {
    #[inline]
    fn add(&mut self, color: Color, weight: f64) {
        let weight = weight as f32;
        self.rgb += color.rgb * weight;
        self.filter += color.filter * weight;
        self.transmit += color.transmit * weight;
    }

    fn color(self) -> Color {
        Color { rgb: self.rgb, filter: self.filter, transmit: self.transmit }
    }
}

impl Pyramid {
    /// All copies of a picture, down to one pixel.
    pub fn new(texels: &Texels, mosaic: &Mosaic) -> Self {
        let mut levels: Vec<Level> = Vec::new();
        let (mut w, mut h) = (mosaic.width(), mosaic.height());
        while w > 1 || h > 1 {
            let size = (w.div_ceil(2), h.div_ceil(2));
            let level = match levels.last() {
                None => shrunk((w, h), size, mosaic.layout(), |i| texels.get(i)),
                Some(level) => shrunk((w, h), size, level.layout, |i| level.colors[i]),
            };
            (w, h) = size;
            levels.push(level);
        }
        Pyramid { levels }
    }
}

/// A smaller copy of what lies by a layout: each pixel is the mean of the area that it covers. It is in tiles, too, if the
/// original is.
fn shrunk(from: (usize, usize), to: (usize, usize), laid: Layout, get: impl Fn(usize) -> Color) -> Level {
    let layout = if laid.is_tiled() { Layout::tiles(to.0) } else { Layout::rows(to.0) };
    let mut colors = vec![Color::BLACK; layout.samples(to.1)].into_boxed_slice();
    for y in 0..to.1 {
        for x in 0..to.0 {
            let mut sum = Sum::default();
            for (j, wy) in covered(y, from.1, to.1) {
                for (i, wx) in covered(x, from.0, to.0) {
                    sum.add(get(laid.index(i, j)), wx * wy);
                }
            }
            colors[layout.index(x, y)] = sum.color();
        }
    }
    Level { width: to.0, height: to.1, layout, colors }
}

/// The pixels of a row of `from` that pixel `i` of `to` covers, with their parts of it.
fn covered(i: usize, from: usize, to: usize) -> impl Iterator<Item = (usize, f64)> {
    let ratio = from as f64 / to as f64;
    let (start, end) = (i as f64 * ratio, (i + 1) as f64 * ratio);
    let last = (end.ceil() as usize).min(from);
    (start as usize..last).map(move |k| {
        let part = (end.min((k + 1) as f64) - start.max(k as f64)).max(0.0);
        (k, part / ratio)
    })
}

impl Image {
    /// The mean colour of what a footprint covers: a point, and points [`FOOTPRINT_STEP`] along its axes.
    pub fn color_over(&self, points: &[Vec3; 3]) -> Option<Color> {
        let place = self.place(points[0])?;
        let Some(pyramid) = &self.pyramid else { return Some(self.color_at(place)) };
        let [a, b] = [points[1], points[2]].map(|p| self.step_to(place, p));
        let (long, short) = if a.length_squared() > b.length_squared() { (a, b) } else { (b, a) };
        let length = long.length();
        // Enlarged pictures look as ever.
        if length.is_nan() || length <= 1.0 {
            return Some(self.color_at(place));
        }
        let width = short.length().clamp(1.0, length);
        let taps = (length / width).ceil().min(MOST_TAPS);
        let level = (length / taps).max(width).log2();
        let mut sum = Sum::default();
        for k in 0..taps as usize {
            let way = (k as f64 + 0.5) / taps - 0.5;
            let at = Vec2::new(place.x, place.y) + long * way;
            self.add_between_levels(pyramid, at, level, 1.0 / taps, &mut sum);
        }
        Some(self.finish(sum.color()))
    }

    /// The step in pixels that a footprint takes whose axis ends beyond `p`.
    fn step_to(&self, from: Place, p: Vec3) -> Vec2 {
        let Some(to) = self.place(p) else { return Vec2::ZERO };
        let mosaic = &self.map.source.mosaic;
        let nearest = |d: f64, size: usize| d - size as f64 * (d / size as f64).round();
        let step = Vec2::new(nearest(to.x - from.x, mosaic.width()), nearest(to.y - from.y, mosaic.height()));
        step / FOOTPRINT_STEP
    }

    /// Adds the colour at a place between two copies; 0 is the picture itself.
    fn add_between_levels(&self, pyramid: &Pyramid, at: Vec2, level: f64, weight: f64, sum: &mut Sum) {
        let level = level.clamp(0.0, pyramid.levels.len() as f64);
        let finer = level.floor();
        let part = level - finer;
        self.add_level(pyramid, at, finer as usize, weight * (1.0 - part), sum);
        if part > 0.0 {
            self.add_level(pyramid, at, finer as usize + 1, weight * part, sum);
        }
    }

    fn add_level(&self, pyramid: &Pyramid, at: Vec2, level: usize, weight: f64, sum: &mut Sum) {
        let mosaic = &self.map.source.mosaic;
        let whole = (mosaic.width(), mosaic.height());
        let copy = level.checked_sub(1).and_then(|i| pyramid.levels.get(i));
        let (width, height) = copy.map_or(whole, |l| (l.width, l.height));
        let layout = copy.map_or(mosaic.layout(), |l| l.layout);
        let scale = Vec2::new(width as f64, height as f64);
        let at = at / Vec2::new(whole.0 as f64, whole.1 as f64) * scale - Vec2::splat(0.5);
        let (corner, f) = (at.floor(), at - at.floor());
        let fit = |i: f64, size: usize| {
            let most = size as f64;
            (if self.map.once { i.clamp(0.0, most - 1.0) } else { i.rem_euclid(most) }) as usize % size
        };
        for (dy, wy) in [(0.0, 1.0 - f.y), (1.0, f.y)] {
            for (dx, wx) in [(0.0, 1.0 - f.x), (1.0, f.x)] {
                let i = layout.index(fit(corner.x + dx, width), fit(corner.y + dy, height));
                let color = copy.map_or_else(|| self.texels.get(i), |l| l.colors[i]);
                sum.add(color, weight * wx * wy);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_a_shrunk_row_add_up() {
        for (from, to) in [(8, 4), (7, 4), (5, 3), (1, 1), (2, 1)] {
            let mut total = vec![0.0; from];
            for i in 0..to {
                let parts: Vec<_> = covered(i, from, to).collect();
                assert!((parts.iter().map(|p| p.1).sum::<f64>() - 1.0).abs() < 1e-12, "{from} {to}");
                parts.into_iter().for_each(|(k, part)| total[k] += part);
            }
            let each = to as f64 / from as f64;
            assert!(total.iter().all(|t| (t - each).abs() < 1e-12), "{from} {to} {total:?}");
        }
    }
}
