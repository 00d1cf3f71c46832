//! Depth of field: where on the lens samples lie, and when there are enough (light spec, section 1.3).
use raggio_image::grey;
use raggio_math::{Vec3, noise::hash};
use raggio_scene as scene;
use raggio_shading::{Context, Noise, Pigment};

use crate::sampling::{chi_square_quantile, disc, halton, jitter2d};

/// A lens with its samples laid out.
pub struct Lens {
    x_axis: Vec3,
    y_axis: Vec3,
    half_aperture: f64,
    /// Focal distance in units of the direction's length.
    focus: f64,
    points: Vec<(f64, f64)>,
    /// Where in the pixel samples lie, by the cell of the pixel's grid: its column, then its row.
    places: Vec<(f64, f64)>,
    max_jitter: f64,
    min_samples: usize,
    /// How many samples are taken before each test.
    groups: &'static [usize],
    /// By number of samples taken: the variance under which to stop.
    thresholds: Vec<f64>,
}

/// A pixel has so many columns of cells, and as many rows.
const CELLS: usize = 16;

/// One sample on the lens and in the pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LensSample {
    /// Where in the pixel.
    pub x: f64,
    /// Where in the pixel.
    pub y: f64,
    /// Offset on the lens, in world units along the lens's axes.
    lens: (f64, f64),
}

impl Lens {
    /// Lays out a camera's lens.
    pub fn new(blur: &scene::FocalBlur, camera: &scene::Camera, noise: Noise) -> Lens {
        let n = blur.max_samples as usize;
        let unit = |v: Vec3| v.try_normalize().unwrap_or(Vec3::ZERO);
        let x_axis = unit(camera.up.cross(camera.direction));
        let (list, groups) = grid(n);
        let points = match &blur.bokeh {
            Some(pigment) => shaped(n, &Pigment::compile(pigment, noise)),
            None => filled(list, n),
        };
        let max_jitter = match n {
            7 => 0.144338,
            19 => 0.096225,
            37 => 0.0721688,
            _ => 0.5 / (n as f64).sqrt(),
        };
        Lens {
            x_axis,
            y_axis: unit(camera.direction.cross(x_axis)),
            half_aperture: blur.aperture / 2.0,
            focus: blur.focal_distance / camera.direction.length(),
            points,
            places: places(),
            max_jitter,
            min_samples: blur.min_samples as usize,
            groups,
            thresholds: thresholds(blur, n),
        }
    }

    /// No ray starts farther from the eye.
    pub fn reach(&self) -> f64 {
        let farthest = self.points.iter().map(|&(x, y)| x.abs().max(y.abs())).fold(0.0, f64::max);
        2.0 * self.half_aperture.abs() * (farthest + 2.0 * self.max_jitter)
    }

    /// The samples of a pixel at most.
    pub fn count(&self) -> usize {
        self.points.len()
    }

    /// Sample `k` of the pixel around a place.
    pub fn sample(&self, x: f64, y: f64, k: usize) -> LensSample {
        let seed = (313.0 * x + 11.0).floor() as i64 + (311.0 * y + 17.0).floor() as i64 + k as i64;
        let (dx, dy) = self.places[CELLS * (hash(seed) % CELLS) + hash(seed + 1) % CELLS];
        let on_lens = jitter2d(x + dx + 0.5, y + dy - 0.5);
        let (gx, gy) = self.points[k];
        let move_by = |g: f64, j: f64| self.half_aperture * (g + 2.0 * self.max_jitter * j);
        LensSample { x: x + dx, y: y + dy, lens: (move_by(gx, on_lens.0), move_by(gy, on_lens.1)) }
    }

    /// Origin and direction of the ray through the lens that meets the straight ray in the plane in focus.
    pub fn shifted(&self, sample: &LensSample, eye: Vec3, dir: Vec3) -> (Vec3, Vec3) {
        let delta = self.x_axis * sample.lens.0 - self.y_axis * sample.lens.1;
        (eye + delta, dir * self.focus - delta)
    }

    /// How many samples to take after `done` of them, before the next test.
    pub fn group(&self, done: usize) -> usize {
        let mut start = 0;
        for &size in self.groups {
            if start == done {
                return size.min(self.count() - done);
            }
            start += size;
        }
        4.min(self.count() - done)
    }

    /// Are `done` samples with these sums and sums of squares enough?
    pub fn enough(&self, done: usize, sum: &[f64; 4], squares: &[f64; 4]) -> bool {
        let n = done as f64;
        let variance = |i: usize| (squares[i] / n - (sum[i] / n) * (sum[i] / n)) / n;
        done >= self.count()
            || (done >= self.min_samples && (0..4).all(|i| variance(i) < self.thresholds[done]))
    }
}

/// A place in each cell of a pixel.
fn places() -> Vec<(f64, f64)> {
    let middle = |cell: usize| (2 * cell + 1) as f64 / (2 * CELLS) as f64 - 0.5;
    let place = |i: usize| {
        let (x, y) = (middle(i / CELLS), middle(i % CELLS));
        let jitter = jitter2d(x, y);
        (x + (jitter.0 - 0.5) / CELLS as f64, y + (jitter.1 - 0.5) / CELLS as f64)
    };
    (0..CELLS * CELLS).map(place).collect()
}

fn thresholds(blur: &scene::FocalBlur, n: usize) -> Vec<f64> {
    let last = chi_square_quantile(blur.confidence, n as f64 - 1.0);
    (0..=n)
        .map(|k| {
            let scaled = blur.variance * chi_square_quantile(blur.confidence, k as f64) / last;
            if scaled.is_finite() { scaled } else { 0.0 }
        })
        .collect()
}

/// The regular list that suits `n` samples, with the sizes of its groups.
fn grid(n: usize) -> (Vec<(f64, f64)>, &'static [usize]) {
    match n {
        37.. => (grid37(), &[7, 6, 6, 4, 4, 4, 4, 2]),
        19.. => (grid19(), &[7, 6, 6]),
        7.. => (grid7(), &[7]),
        _ => (vec![(-0.25, 0.25), (0.25, 0.25), (-0.25, -0.25), (0.25, -0.25)], &[]),
    }
}

fn grid7() -> Vec<(f64, f64)> {
    let (s, h) = (0.288675, 0.144338);
    vec![(-s, 0.0), (0.0, 0.0), (s, 0.0), (-h, 0.25), (-h, -0.25), (h, 0.25), (h, -0.25)]
}

fn grid19() -> Vec<(f64, f64)> {
    let (a, b, c, d, e, f) = (0.192450, 0.333333, 0.384900, 0.288675, 0.166667, 0.096225);
    vec![
        (-a, b),
        (-a, -b),
        (a, b),
        (a, -b),
        (c, 0.0),
        (-c, 0.0),
        (0.0, 0.0),
        (0.0, b),
        (0.0, -b),
        (-d, e),
        (-d, -e),
        (d, e),
        (d, -e),
        (-f, e),
        (-f, -e),
        (f, e),
        (f, -e),
        (-a, 0.0),
        (a, 0.0),
    ]
}

fn grid37() -> Vec<(f64, f64)> {
    let mut list = vec![(0.0, 0.0)];
    for scale in [3.0, 2.0, 1.0] {
        let (p, q) = (scale * 0.072169, scale * 0.125);
        list.extend([(-p, q), (p, -q), (-p, -q), (p, q), (-2.0 * p, 0.0), (2.0 * p, 0.0)]);
    }
    for (p, q) in [(0.360844, 0.125), (0.288675, 0.25), (0.072169, 0.375), (0.216506, 0.125)] {
        list.extend([(-p, q), (-p, -q), (p, q), (p, -q)]);
    }
    list.extend([(0.0, 0.25), (0.0, -0.25)]);
    list
}

/// Fills up a list with points of the disc that keep apart.
fn filled(mut list: Vec<(f64, f64)>, n: usize) -> Vec<(f64, f64)> {
    list.truncate(n);
    let side = 2 * (n as f64 / std::f64::consts::PI).sqrt().ceil() as usize + 1;
    let cell = |v: f64| (((v + 0.5) * side as f64).max(0.0) as usize).min(side - 1);
    let mut taken = vec![false; side * side];
    for &(x, y) in &list {
        taken[cell(y) * side + cell(x)] = true;
    }
    let mut supply = 10 * n;
    let mut index = 0;
    while list.len() < n {
        index += 1;
        let (x, y) = disc(halton(2, index), halton(3, index));
        let crowded = taken[cell(y) * side + cell(x)] || x * x + y * y > 0.25;
        supply = supply.saturating_sub(1);
        if crowded && supply > n - list.len() {
            continue;
        }
        taken[cell(y) * side + cell(x)] = true;
        list.push((x, y));
    }
    list
}

/// Points distributed as a pigment's brightness over the square.
fn shaped(n: usize, pigment: &Pigment) -> Vec<(f64, f64)> {
    let mut list = Vec::with_capacity(n);
    let mut index = 0;
    let mut tries = 1000 * n;
    while list.len() < n {
        index += 1;
        tries = tries.saturating_sub(1);
        let v = (halton(2, index) - 0.5, halton(3, index) - 0.5);
        let color = pigment.eval(Vec3::new(v.0 + 0.5, v.1 + 0.5, 0.0), &Context::NONE);
        let chance = f64::from(color.map_or(0.0, |c| grey(c.rgb)));
        if tries == 0 || halton(5, index) < chance {
            list.push(v);
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_have_their_lengths_and_lie_on_the_lens() {
        for n in [3, 4, 7, 10, 19, 30, 37, 60, 100] {
            let list = filled(grid(n).0, n);
            assert_eq!(list.len(), n);
            assert!(list.iter().all(|p| p.0 * p.0 + p.1 * p.1 <= 0.2501), "{n}");
        }
        let mut sorted = grid37();
        sorted.sort_by(|a, b| a.partial_cmp(b).unwrap());
        sorted.dedup();
        assert_eq!(sorted.len(), 37);
    }

    #[test]
    fn groups_follow_the_list_and_then_go_by_four() {
        let blur = scene::FocalBlur {
            aperture: 1.0,
            min_samples: 0,
            max_samples: 25,
            confidence: 0.9,
            variance: 1e-4,
            focal_distance: 5.0,
            bokeh: None,
        };
        let camera = super::super::tests::camera(scene::CameraKind::Perspective);
        let lens = Lens::new(&blur, &camera, Noise { generator: 2, waves: 10 });
        let mut done = 0;
        let mut sizes = Vec::new();
        while done < lens.count() {
            sizes.push(lens.group(done));
            done += lens.group(done);
        }
        assert_eq!(sizes, [7, 6, 6, 4, 2]);
        assert!(lens.enough(7, &[0.7; 4], &[0.07; 4]));
        assert!(!lens.enough(7, &[3.5; 4], &[3.5; 4]));
    }

    #[test]
    fn every_ray_of_the_lens_meets_in_the_plane_in_focus() {
        let blur = scene::FocalBlur {
            aperture: 0.8,
            min_samples: 0,
            max_samples: 19,
            confidence: 0.9,
            variance: 1e-4,
            focal_distance: 5.0,
            bokeh: None,
        };
        let camera = super::super::tests::camera(scene::CameraKind::Perspective);
        let lens = Lens::new(&blur, &camera, Noise { generator: 2, waves: 10 });
        let dir = camera.direction + camera.right * 0.1;
        let target = camera.location + dir * lens.focus;
        for k in 0..19 {
            let (origin, d) = lens.shifted(&lens.sample(3.0, 4.0, k), camera.location, dir);
            assert!((origin + d - target).length() < 1e-12);
            assert!((origin - camera.location).length() > 1e-9);
        }
    }
}
