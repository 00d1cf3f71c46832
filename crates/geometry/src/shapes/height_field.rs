//! The height field: two triangles per cell of a grid over the unit square (shapes spec, section 4).
//!
//! Least and greatest heights of blocks of cells, of 1, 2, 4 and more a side, let the ray step over all that is not near it
//! (Tevs, Ihrke and Seidel, "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering", 2008). In a
//! triangle the ray's height over the ground is linear, so signs at the ends of its stretch tell of a hit, and
//! neighbours agree about their common edge.
use std::sync::Arc;

use raggio_math::{Aabb, Ray, Vec3};

use super::collect::{Collect, searched_from};
use super::revolve::clip_to_slab;
use crate::{LocalHit, Surface};
use steps::{Block, Steps};

const LEAST: f64 = 1e-6;
/// Heights of samples in the unit cube.
const FULL: f64 = 65536.0;
/// The surface is kept from a little below the water.
const SHORE: f64 = 0.001;

/// The heights of a block that has none over water.
const NOTHING: (u16, u16) = (u16::MAX, 0);

/// A height field, ready to be hit.
#[derive(Clone, Debug)]
pub(crate) struct HeightField {
    field: Arc<raggio_scene::HeightField>,
    /// `levels[k]` joins blocks of 2^k by 2^k cells.
    levels: Vec<Level>,
    /// Least and greatest heights of the blocks of all levels, by row; the wrong way round where all is under water.
    spans: Vec<(u16, u16)>,
    /// Normals at the samples, scaled to 32767, of smooth fields.
    normals: Vec<[i16; 3]>,
    /// From sample units (columns, heights, rows) to the unit cube.
    scale: Vec3,
    /// In heights: what lies lower is cut away.
    bottom: f64,
}

#[derive(Clone, Copy, Debug)]
struct Level {
    columns: usize,
    rows: usize,
    /// Its first in [`HeightField::spans`].
    first: usize,
}

impl HeightField {
    /// Makes a field ready. One without a cell is never hit.
    pub(crate) fn new(field: Arc<raggio_scene::HeightField>) -> Self {
        let (columns, rows) = (field.width.saturating_sub(1), field.depth.saturating_sub(1));
        let lowest = field.heights.iter().min().copied().map_or(0.0, f64::from);
        let bottom = (FULL * field.water_level).max(lowest) - SHORE;
        let (levels, spans) = match columns == 0 || rows == 0 {
            true => (Vec::new(), Vec::new()),
            false => levels(&field, columns, rows, bottom),
        };
        let normals = if field.smooth { sample_normals(&field) } else { Vec::new() };
        let scale = Vec3::new(1.0 / columns.max(1) as f64, 1.0 / FULL, 1.0 / rows.max(1) as f64);
        HeightField { field, levels, spans, normals, scale, bottom }
    }

    fn height(&self, i: usize, j: usize) -> f64 {
        f64::from(self.field.heights[j * self.field.width + i])
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let ray = Ray::new(ray.origin / self.scale, ray.dir / self.scale);
        let Some((start, mut end)) = self.stretch(&ray, to.range()) else { return };
        let (grid, top) = (self.levels[0], self.levels.len() as u32 - 1);
        let mut steps = Steps::new(&ray, start, (grid.columns, grid.rows), top);
        loop {
            let block = steps.block();
            let hi = if block.exit < end { block.exit } else { end };
            if self.may_meet(&ray, &block, steps.at, hi) {
                if block.level > 0 {
                    steps.refine();
                    continue;
                }
                self.search_cell(&ray, (block.i, block.j), (steps.at, hi), to);
                end = end.min(to.range().1);
            }
            if block.exit >= end || !steps.leave(&block) {
                return;
            }
        }
    }

    /// The stretch of the ray in the box around all.
    fn stretch(&self, ray: &Ray, range: (f64, f64)) -> Option<(f64, f64)> {
        let top = self.levels.last()?;
        let (low, high) = self.spans[top.first];
        let Level { columns, rows, .. } = self.levels[0];
        let (o, d) = (ray.origin, ray.dir);
        let range = clip_to_slab(o.x, d.x, (0.0, columns as f64), range)?;
        let range = clip_to_slab(o.z, d.z, (0.0, rows as f64), range)?;
        clip_to_slab(o.y, d.y, (f64::from(low) - SHORE, f64::from(high) + SHORE), range)
    }

    /// Does the ray come to the heights of a block between two distances?
    #[inline(always)]
    fn may_meet(&self, ray: &Ray, block: &Block, lo: f64, hi: f64) -> bool {
        let level = &self.levels[block.level as usize];
        let (low, high) = self.spans[level.first + block.j * level.columns + block.i];
        let (a, b) = (ray.origin.y + ray.dir.y * lo, ray.origin.y + ray.dir.y * hi);
        let (low, high) = (f64::from(low) - SHORE, f64::from(high) + SHORE);
        let (least, most) = if a < b { (a, b) } else { (b, a) };
        (most >= low) & (least <= high)
    }

    fn search_cell(&self, ray: &Ray, (i, j): (usize, usize), (lo, hi): (f64, f64), to: &mut impl Collect) {
        // Where the ray crosses the diagonal from (i + 1, j) to (i, j + 1).
        let (o, d) = (ray.origin, ray.dir);
        let before = (o.x - i as f64) + (o.z - j as f64) - 1.0;
        let along = d.x + d.z;
        let parallel = along == 0.0;
        let cut = if parallel { hi } else { (-before / along).max(lo).min(hi) };
        let starts_upper = if parallel { before > 0.0 } else { along < 0.0 };
        self.search_triangle(ray, (i, j), starts_upper, (lo, cut), to);
        self.search_triangle(ray, (i, j), !starts_upper, (cut, hi), to);
    }

    /// One triangle, on the stretch of the ray over it.
    fn search_triangle(
        &self,
        ray: &Ray,
        cell: (usize, usize),
        upper: bool,
        (a, b): (f64, f64),
        to: &mut impl Collect,
    ) {
        if a >= b {
            return;
        }
        let over = |t: f64| {
            let p = ray.at(t);
            p.y - self.facet_height(cell, upper, p.x - cell.0 as f64, p.z - cell.1 as f64)
        };
        let (fa, fb) = (over(a), over(b));
        if (fa < 0.0) == (fb < 0.0) {
            return;
        }
        let t = a + (b - a) * fa / (fa - fb);
        if ray.at(t).y >= self.bottom {
            let part = (cell.1 * self.field.width + cell.0) as u32;
            to.push(LocalHit { t, part, u: f64::from(u8::from(upper)), v: 0.0 });
        }
    }

    /// The height of one of a cell's two facets, or of its plane outside, at cell fractions a, b.
    fn facet_height(&self, (i, j): (usize, usize), upper: bool, a: f64, b: f64) -> f64 {
        let (right, up) = (self.height(i + 1, j), self.height(i, j + 1));
        if upper {
            let corner = self.height(i + 1, j + 1);
            corner + (1.0 - a) * (up - corner) + (1.0 - b) * (right - corner)
        } else {
            let corner = self.height(i, j);
            corner + a * (right - corner) + b * (up - corner)
        }
    }

    /// The normal in sample units of the facet of a hit.
    fn facet_normal(&self, (i, j): (usize, usize), upper: bool) -> Vec3 {
        let (right, up) = (self.height(i + 1, j), self.height(i, j + 1));
        if upper {
            let corner = self.height(i + 1, j + 1);
            Vec3::new(up - corner, 1.0, right - corner)
        } else {
            let corner = self.height(i, j);
            Vec3::new(corner - right, 1.0, corner - up)
        }
    }

    fn smooth_normal(&self, (i, j): (usize, usize), a: f64, b: f64) -> Vec3 {
        let at = |i: usize, j: usize| {
            let [x, y, z] = self.normals[j * self.field.width + i].map(f64::from);
            (Vec3::new(x, y, z) / self.scale).normalize_or(Vec3::Y)
        };
        let near = at(i, j).lerp(at(i + 1, j), a);
        let far = at(i, j + 1).lerp(at(i + 1, j + 1), a);
        near.lerp(far, b)
    }
}

/// Least and greatest heights of cells, then of ever larger blocks, up to a single one.
fn levels(
    field: &raggio_scene::HeightField,
    columns: usize,
    rows: usize,
    bottom: f64,
) -> (Vec<Level>, Vec<(u16, u16)>) {
    let at = |i: usize, j: usize| field.heights[j * field.width + i];
    let cell = |k: usize| {
        let (i, j) = (k % columns, k / columns);
        let corners = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        let (lo, hi) = corners.iter().fold(NOTHING, |(lo, hi), &h| (lo.min(h), hi.max(h)));
        if f64::from(hi) + SHORE >= bottom { (lo, hi) } else { NOTHING }
    };
    let mut level = Level { columns, rows, first: 0 };
    let mut spans: Vec<_> = (0..columns * rows).map(cell).collect();
    let mut levels = vec![level];
    while level.columns * level.rows > 1 {
        let below = level;
        level =
            Level { columns: below.columns.div_ceil(2), rows: below.rows.div_ceil(2), first: spans.len() };
        spans.resize(level.first + level.columns * level.rows, NOTHING);
        for k in 0..below.columns * below.rows {
            let (lo, hi) = spans[below.first + k];
            let block = level.first + (k / below.columns / 2) * level.columns + (k % below.columns) / 2;
            spans[block] = (spans[block].0.min(lo), spans[block].1.max(hi));
        }
        levels.push(level);
    }
    (levels, spans)
}

/// The sums of the unit normals of the up to four facets that have their right angle at a sample.
fn sample_normals(field: &raggio_scene::HeightField) -> Vec<[i16; 3]> {
    let (width, depth) = (field.width, field.depth);
    let at = |i: usize, j: usize| f64::from(field.heights[j * width + i]);
    let normal = |k: usize| {
        let (i, j) = (k % width, k / width);
        let here = at(i, j);
        let rise_right = (i + 1 < width).then(|| here - at(i + 1, j));
        let rise_left = (i > 0).then(|| at(i - 1, j) - here);
        let rise_up = (j + 1 < depth).then(|| here - at(i, j + 1));
        let rise_down = (j > 0).then(|| at(i, j - 1) - here);
        let pairs =
            [(rise_right, rise_up), (rise_left, rise_up), (rise_left, rise_down), (rise_right, rise_down)];
        let sum: Vec3 = pairs.iter().filter_map(|&(x, z)| Some(Vec3::new(x?, 1.0, z?).normalize())).sum();
        let n = sum.normalize_or(Vec3::Y) * 32767.0;
        [n.x as i16, n.y as i16, n.z as i16]
    };
    (0..width * depth).map(normal).collect()
}

impl Surface for HeightField {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        match self.levels.last() {
            None => Aabb::EMPTY,
            Some(top) => {
                let (low, high) = self.spans[top.first];
                let low = self.bottom.max(f64::from(low) - SHORE);
                Aabb {
                    min: Vec3::new(0.0, low / FULL, 0.0),
                    max: Vec3::new(1.0, (f64::from(high) + SHORE) / FULL, 1.0),
                }
            }
        }
    }

    fn inside_bounds(&self) -> Aabb {
        let mut bounds = self.bounds();
        if !bounds.is_empty() {
            bounds.min.y = f64::NEG_INFINITY;
        }
        bounds
    }

    fn inside(&self, p: Vec3) -> bool {
        let in_square = (0.0..1.0).contains(&p.x) && (0.0..1.0).contains(&p.z);
        if self.levels.is_empty() || !in_square {
            return false;
        }
        let q = p / self.scale;
        let (i, j) = (q.x as usize, q.z as usize);
        let (a, b) = (q.x - i as f64, q.z - j as f64);
        q.y < self.bottom || q.y < self.facet_height((i, j), a + b > 1.0, a, b)
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        let cell = (hit.part as usize % self.field.width, hit.part as usize / self.field.width);
        let n = if self.field.smooth {
            let q = p / self.scale;
            self.smooth_normal(cell, q.x - cell.0 as f64, q.z - cell.1 as f64)
        } else {
            self.facet_normal(cell, hit.u > 0.5) / self.scale
        };
        n.try_normalize().unwrap_or(Vec3::Y)
    }
}

mod steps;
