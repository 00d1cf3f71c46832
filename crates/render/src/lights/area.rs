//! Area lights: the grid of samples and its recursive average (light spec, section 5.3).
use raggio_geometry::{Lanes, RAYS, Screen, Standing, Verdict};
use raggio_image::Rgb;
use raggio_math::{Vec3, Wide, wide};
use raggio_scene as scene;

use super::LightSource;
use super::shadow::SHADOW_TOLERANCE;
use crate::sampling::Stream;

/// The most samples along an axis, so that their number stays countable.
const MOST: u32 = 4096;

/// The most samples of a light whose places are worked out before.
const MOST_KNOWN: u32 = 1 << 16;

/// The samples of an area light.
pub struct AreaGrid {
    axis1: Vec3,
    axis2: Vec3,
    /// Samples along the first axis.
    pub size1: u32,
    /// Samples along the second axis.
    pub size2: u32,
    /// Levels that are always divided.
    pub adaptive: u32,
    /// Are samples moved at random?
    pub jitter: bool,
    circular: bool,
    orient: bool,
    /// Where the grid's points lie along the axes, where that is always the same, otherwise their columns and rows;
    /// rows along the first axis.
    known: Vec<(f64, f64)>,
    /// The grid's points in the order in which they are asked if none stands out, level by level: as many as are looked
    /// at together lie close to each other. Empty stands for the order of numbers.
    order: Vec<u32>,
    /// By grid point: its place in that order.
    places: Vec<u32>,
    /// Does every sample light the surface by its own direction?
    pub illumination: bool,
    /// Do photons leave from all of it?
    pub photons: bool,
    /// How many samples are taken where nothing stands in the way.
    pub open_samples: u32,
}

impl AreaGrid {
    /// Makes a grid ready.
    pub fn new(area: &scene::AreaLight) -> AreaGrid {
        let (size1, size2) = (area.size1.clamp(1, MOST), area.size2.clamp(1, MOST));
        let adaptive = area.adaptive.unwrap_or(100);
        let order = order([size1, size2], adaptive);
        let mut grid = AreaGrid {
            axis1: area.axis1,
            axis2: area.axis2,
            size1,
            size2,
            adaptive,
            open_samples: order.1,
            jitter: area.jitter,
            circular: (area.circular || area.orient) && area.size1 > 1 && area.size2 > 1,
            orient: area.orient,
            known: Vec::new(),
            order: Vec::new(),
            places: Vec::new(),
            illumination: area.area_illumination,
            photons: area.photons_area,
        };
        if grid.samples() <= MOST_KNOWN {
            grid.known = (0..grid.samples()).map(|cell| grid.unmoved(cell)).collect();
            grid.places = vec![0; order.0.len()];
            for (place, &cell) in order.0.iter().enumerate() {
                grid.places[cell as usize] = place as u32;
            }
            grid.order = order.0;
        }
        grid
    }

    /// The grid's axes as seen from a point; `to_light` is the unit vector towards the light's centre.
    pub fn axes(&self, to_light: Vec3) -> (Vec3, Vec3) {
        if !self.orient {
            return (self.axis1, self.axis2);
        }
        let length = self.axis1.length();
        let helper = if (to_light.z.abs() - 1.0).abs() < 0.01 { Vec3::Y } else { Vec3::Z };
        let unit = |v: Vec3| v.try_normalize().unwrap_or(Vec3::X);
        let axis1 = unit(to_light.cross(helper)) * length;
        (axis1, unit(to_light.cross(axis1)) * length)
    }

    /// The corners, in order around it, of a patch that holds all samples.
    pub fn corners(&self, axes: (Vec3, Vec3)) -> [Vec3; 4] {
        let half = |n: u32| {
            let cell = if n > 1 { 1.0 / f64::from(n - 1) } else { 0.0 };
            0.5 + if self.jitter { 0.5 * cell } else { 0.0 } + 0.002
        };
        let (a, b) = (axes.0 * half(self.size1), axes.1 * half(self.size2));
        [-a - b, a - b, a + b, b - a]
    }

    /// How many samples there are.
    fn samples(&self) -> u32 {
        self.size1 * self.size2
    }

    /// Uses up the random numbers of a look at the light. Every sample has its own two of them, looked at or not.
    pub fn pass_over(&self, random: &mut Stream) {
        if self.jitter {
            random.skip(2 * self.samples());
        }
    }

    /// Where a grid point lies without jitter and roundness.
    pub fn plain_offset(&self, u: u32, v: u32) -> Vec3 {
        let place = |k: u32, n: u32| if n > 1 { f64::from(k) / f64::from(n - 1) - 0.5 } else { 0.0 };
        self.axis1 * place(u, self.size1) + self.axis2 * place(v, self.size2)
    }

    /// Where a grid point, counted along the first axis first, lies from the light's centre.
    pub fn offset(&self, axes: (Vec3, Vec3), cell: u32, random: &Stream) -> Vec3 {
        let (u, v) = self.raw_spot(cell, random);
        let (s, t) = if self.jitter { self.place(u, v) } else { (u, v) };
        axes.0 * s + axes.1 * t
    }

    /// Where a grid point lies along the axes, or with jitter: its column and row so moved.
    #[inline]
    fn raw_spot(&self, cell: u32, random: &Stream) -> (f64, f64) {
        let (u, v) = self.known.get(cell as usize).copied().unwrap_or_else(|| self.unmoved(cell));
        if !self.jitter {
            return (u, v);
        }
        let mut random = *random;
        random.skip(2 * cell);
        (u + (random.next() - 0.5), v + (random.next() - 0.5))
    }

    /// The same without jitter.
    fn unmoved(&self, cell: u32) -> (f64, f64) {
        let (u, v) = (f64::from(cell % self.size1), f64::from(cell / self.size1));
        if self.jitter { (u, v) } else { self.place(u, v) }
    }

    /// Where along the axes a point of the grid lies.
    #[inline(always)]
    fn place(&self, u: f64, v: f64) -> (f64, f64) {
        let place = |k: f64, n: u32| if n > 1 { k / f64::from(n - 1) - 0.5 } else { 0.0 };
        let (s, t) = (place(u, self.size1), place(v, self.size2));
        if !self.circular {
            return (s, t);
        }
        let (s, t) = (s + 0.001, t + 0.001);
        let round = s.abs().max(t.abs()) / (s * s + t * t).sqrt().max(1e-300);
        (s * round, t * round)
    }
}

/// What was found out already for the present surface point.
#[derive(Default)]
pub struct AreaScratch {
    stamp: u32,
    /// Values of grid points.
    cells: Vec<(u32, Rgb)>,
    /// What is known at once of as many grid points in a row.
    rows: Vec<(u32, Verdict)>,
    /// What may stand between the point and the light.
    pub standing: Standing,
    /// The simple things among that.
    pub screen: Screen,
}

impl AreaScratch {
    fn begin(&mut self, cells: usize) {
        self.stamp = self.stamp.wrapping_add(1);
        if self.cells.len() < cells || self.stamp == 0 {
            self.cells.clear();
            self.cells.resize(cells, (0, Rgb::ZERO));
            self.rows.clear();
            self.rows.resize(cells.div_ceil(RAYS), (0, Verdict::default()));
            self.stamp = 1;
        }
    }
}

/// A look at an area light from a surface point.
pub struct View<'a> {
    /// The light.
    pub light: &'a LightSource,
    /// Its grid.
    pub grid: &'a AreaGrid,
    /// The point.
    pub p: Vec3,
    /// The direction to the light's centre.
    pub to_light: Vec3,
    /// Are simple things in the way, which the memory holds?
    pub screened: bool,
    /// The light where nothing stops it.
    pub open: Rgb,
    /// Where the random numbers are.
    pub random: Stream,
}

impl View<'_> {
    /// The mean light: `shadowed` answers for one point of the light.
    pub fn average(
        &self,
        scratch: &mut AreaScratch,
        mut shadowed: impl FnMut(Vec3, &Standing) -> Rgb,
    ) -> Rgb {
        let grid = self.grid;
        scratch.begin(grid.samples() as usize);
        let axes = grid.axes(self.to_light);
        if let Some(light) = self.alike(axes, scratch) {
            return light;
        }
        let mut corner = |u: u32, v: u32| {
            let cell = v * grid.size1 + u;
            let known = &scratch.cells[cell as usize];
            if known.0 == scratch.stamp {
                return known.1;
            }
            let value = match self.at_once(axes, cell, scratch) {
                Some(true) => self.open,
                Some(false) => Rgb::ZERO,
                None => {
                    shadowed(self.light.position + grid.offset(axes, cell, &self.random), &scratch.standing)
                }
            };
            scratch.cells[cell as usize] = (scratch.stamp, value);
            value
        };
        divide(&mut corner, [0, 0], [grid.size1 - 1, grid.size2 - 1], 0, grid.adaptive)
    }

    /// The light, if it plainly arrives from all points that are asked anyway, or from none of them.
    fn alike(&self, axes: (Vec3, Vec3), scratch: &mut AreaScratch) -> Option<Rgb> {
        if !self.screened {
            return None;
        }
        let (mut free, mut stopped) = (true, true);
        let open = self.grid.open_samples as usize;
        for row in 0..open.div_ceil(RAYS) {
            let asked = ((1 << (open - row * RAYS).min(RAYS)) - 1) as u8;
            let verdict = self.verdict(axes, row, scratch);
            free &= verdict.free & asked == asked;
            stopped &= verdict.stopped & asked == asked;
            if !free && !stopped {
                return None;
            }
        }
        Some(if free { self.open } else { Rgb::ZERO })
    }

    /// What is known at once of a row of grid points.
    #[inline]
    fn verdict(&self, axes: (Vec3, Vec3), row: usize, scratch: &mut AreaScratch) -> Verdict {
        let known = &mut scratch.rows[row];
        if known.0 != scratch.stamp {
            *known = (scratch.stamp, scratch.screen.verdict(&self.row(axes, row), SHADOW_TOLERANCE));
        }
        known.1
    }

    /// Does the light of a grid point arrive, if that is clear? Grid points are looked at in rows.
    #[inline]
    fn at_once(&self, axes: (Vec3, Vec3), cell: u32, scratch: &mut AreaScratch) -> Option<bool> {
        if !self.screened {
            return None;
        }
        let place = self.grid.places.get(cell as usize).map_or(cell, |&place| place) as usize;
        let (row, bit) = (place / RAYS, 1 << (place % RAYS));
        let verdict = self.verdict(axes, row, scratch);
        match (verdict.stopped & bit != 0, verdict.free & bit != 0) {
            (false, false) => None,
            (stopped, _) => Some(!stopped),
        }
    }

    /// The points of a row about the surface point; what comes after the last does not matter.
    fn row(&self, axes: (Vec3, Vec3), row: usize) -> [Lanes; 3] {
        let (grid, first) = (self.grid, row * RAYS);
        let last = grid.samples() as usize - 1;
        let mut spots = Spots { view: self, axes, u: [0.0; RAYS], v: [0.0; RAYS] };
        for k in 0..RAYS {
            let place = (first + k).min(last);
            let cell = grid.order.get(place).map_or(place as u32, |&cell| cell);
            (spots.u[k], spots.v[k]) = grid.raw_spot(cell, &self.random);
        }
        wide(spots)
    }
}

/// Points of the grid, as [`AreaGrid::raw_spot`] has them.
struct Spots<'a> {
    view: &'a View<'a>,
    axes: (Vec3, Vec3),
    u: Lanes,
    v: Lanes,
}

impl Wide for Spots<'_> {
    /// The same points about the surface point.
    type Output = [Lanes; 3];

    #[inline(always)]
    fn run(self) -> [Lanes; 3] {
        let Spots { view, axes: (axis1, axis2), mut u, mut v } = self;
        if view.grid.jitter {
            for k in 0..RAYS {
                (u[k], v[k]) = view.grid.place(u[k], v[k]);
            }
        }
        let centre = view.light.position - view.p;
        let mut points = [[0.0; RAYS]; 3];
        for (axis, points) in points.iter_mut().enumerate() {
            for k in 0..RAYS {
                points[k] = centre[axis] + (axis1[axis] * u[k] + axis2[axis] * v[k]);
            }
        }
        points
    }
}

/// Grid points in the order in which they are first asked where all answer alike, level by level, and how many are
/// asked before answers matter.
fn order(size: [u32; 2], adaptive: u32) -> (Vec<u32>, u32) {
    let mut asked = vec![false; (size[0] * size[1]) as usize];
    let (mut order, mut open) = (Vec::new(), 0);
    for level in adaptive.. {
        let before = order.len();
        let mut corner = |u: u32, v: u32| {
            let cell = v * size[0] + u;
            if !std::mem::replace(&mut asked[cell as usize], true) {
                order.push(cell);
            }
            Rgb::ONE
        };
        divide(&mut corner, [0, 0], [size[0] - 1, size[1] - 1], 0, level);
        if level == adaptive {
            open = order.len() as u32;
        }
        if order.len() == before || order.len() == asked.len() {
            break;
        }
    }
    (order, open)
}

/// The mean over the rectangle of grid indices from `low` to `high`.
fn divide(
    corner: &mut impl FnMut(u32, u32) -> Rgb,
    low: [u32; 2],
    high: [u32; 2],
    level: u32,
    adaptive: u32,
) -> Rgb {
    let mut values =
        [corner(low[0], low[1]), corner(high[0], low[1]), corner(low[0], high[1]), corner(high[0], high[1])];
    let divisible = high[0] - low[0] > 1 || high[1] - low[1] > 1;
    let differs = |a: usize, b: usize| (values[a] - values[b]).abs().element_sum() > 0.1;
    if divisible && (level < adaptive || differs(0, 1) || differs(1, 3) || differs(3, 2) || differs(2, 0)) {
        let middle = |k: usize| ((low[k] + high[k]) / 2, (low[k] + high[k]).div_ceil(2));
        let ((u1, u2), (v1, v2)) = (middle(0), middle(1));
        let quarters =
            [(low, [u1, v1]), ([u2, low[1]], [high[0], v1]), ([low[0], v2], [u1, high[1]]), ([u2, v2], high)];
        for (value, (low, high)) in values.iter_mut().zip(quarters) {
            *value = divide(corner, low, high, level + 1, adaptive);
        }
    }
    values.iter().sum::<Rgb>() * 0.25
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The weight of every grid point of an `n` by 1 grid, all corners alike.
    fn weights(n: u32, adaptive: u32) -> Vec<f32> {
        (0..n)
            .map(|lit| {
                let mut corner = |u: u32, _| if u == lit { Rgb::ONE } else { Rgb::ZERO };
                divide(&mut corner, [0, 0], [n - 1, 0], 0, adaptive).x
            })
            .collect()
    }

    #[test]
    fn grid_points_weigh_as_leaf_corners() {
        assert_eq!(weights(3, 100), [0.25, 0.5, 0.25]);
        assert_eq!(weights(4, 100), [0.25; 4]);
        assert_eq!(weights(5, 100), [0.125, 0.25, 0.25, 0.25, 0.125]);
        assert_eq!(weights(1, 100), [1.0]);
    }

    #[test]
    fn the_order_begins_with_what_is_always_asked_and_holds_all() {
        let (all, open) = order([5, 3], 0);
        assert_eq!((&all[..4], open), (&[0, 4, 10, 14][..], 4));
        for (size, adaptive, expected) in
            [([9, 9], 1, 9), ([9, 9], 2, 25), ([17, 5], 100, 85), ([1, 1], 3, 1)]
        {
            let (mut all, open) = order(size, adaptive);
            all.sort_unstable();
            assert!(all.into_iter().eq(0..size[0] * size[1]));
            assert_eq!(open, expected);
        }
    }

    #[test]
    fn adaptive_zero_misses_a_blocker_in_the_middle() {
        let mut corner = |u: u32, v: u32| if (u, v) == (2, 2) { Rgb::ZERO } else { Rgb::ONE };
        assert_eq!(divide(&mut corner, [0, 0], [4, 4], 0, 0), Rgb::ONE);
        let mut corner = |u: u32, v: u32| if (u, v) == (2, 2) { Rgb::ZERO } else { Rgb::ONE };
        assert!(divide(&mut corner, [0, 0], [4, 4], 0, 1).x < 1.0);
    }

    #[test]
    fn circular_grids_keep_to_a_disc_and_orient_faces_the_point() {
        let grid = AreaGrid::new(&scene::AreaLight {
            axis1: Vec3::X * 2.0,
            axis2: Vec3::Y * 2.0,
            size1: 9,
            size2: 9,
            adaptive: None,
            jitter: false,
            circular: true,
            orient: true,
            area_illumination: false,
            photons_area: false,
        });
        let to_light = Vec3::new(1.0, 2.0, 3.0).normalize();
        let axes = grid.axes(to_light);
        assert!(axes.0.dot(to_light).abs() < 1e-12 && axes.1.dot(to_light).abs() < 1e-12);
        let random = Stream::default();
        for u in 0..9 {
            for v in 0..9 {
                assert!(grid.offset(axes, v * 9 + u, &random).length() < 1.01);
            }
        }
    }
}
