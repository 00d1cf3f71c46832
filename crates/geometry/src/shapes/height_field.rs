//! The height field: two triangles per cell of a grid over the unit square (shapes spec, section 4).
//!
//! A quadtree of least and greatest heights over the cells is walked from the near end of the ray to the far end. In a
//! triangle the ray's height over the ground is linear, so signs at the ends of its stretch tell of a hit, and
//! neighbours agree about their common edge.
use std::sync::Arc;

use raggio_math::{Aabb, Ray, Vec3};
use smallvec::SmallVec;

use super::collect::{Collect, searched_from};
use crate::{LocalHit, Surface};

const LEAST: f64 = 1e-6;
/// Heights of samples in the unit cube.
const FULL: f64 = 65536.0;
/// The surface is kept from a little below the water.
const SHORE: f64 = 0.001;

/// A height field, ready to be hit.
#[derive(Clone, Debug)]
pub(crate) struct HeightField {
    field: Arc<raggio_scene::HeightField>,
    /// `levels[k]` joins blocks of 2^k by 2^k cells: columns, and (least, greatest) height by row.
    levels: Vec<Level>,
    /// Normals at the samples, scaled to 32767, of smooth fields.
    normals: Vec<[i16; 3]>,
    /// From sample units (columns, heights, rows) to the unit cube.
    scale: Vec3,
    /// In heights: what lies lower is cut away.
    bottom: f64,
}

#[derive(Clone, Debug)]
struct Level {
    columns: usize,
    rows: usize,
    spans: Vec<(u16, u16)>,
}

/// A ray in sample units.
struct Walk {
    ray: Ray,
    /// One over each part of the direction.
    inverse: Vec3,
}

/// A block of cells and the stretch of the ray over its square.
#[derive(Clone, Copy)]
struct Block {
    level: usize,
    i: usize,
    j: usize,
    lo: f64,
    hi: f64,
}

impl Walk {
    /// The part of a stretch between two planes across an axis.
    fn clipped(&self, (lo, hi): (f64, f64), axis: usize, slab: (f64, f64)) -> Option<(f64, f64)> {
        let o = self.ray.origin[axis];
        if self.ray.dir[axis] == 0.0 {
            return (slab.0 <= o && o <= slab.1).then_some((lo, hi));
        }
        let (a, b) = ((slab.0 - o) * self.inverse[axis], (slab.1 - o) * self.inverse[axis]);
        let (lo, hi) = (lo.max(a.min(b)), hi.min(a.max(b)));
        (lo <= hi).then_some((lo, hi))
    }

    /// On which side of a plane across an axis the ray starts, and where it changes to the other. Blocks that have
    /// nothing beyond the plane are left out of account by `beyond`.
    fn sides(&self, block: &Block, axis: usize, plane: f64, beyond: bool) -> (usize, f64) {
        let (o, d) = (self.ray.origin[axis], self.ray.dir[axis]);
        if !beyond {
            return (0, block.hi);
        }
        if d == 0.0 {
            return (usize::from(o >= plane), block.hi);
        }
        (usize::from(d < 0.0), ((plane - o) * self.inverse[axis]).max(block.lo).min(block.hi))
    }
}

impl HeightField {
    /// Makes a field ready. One without a cell is never hit.
    pub(crate) fn new(field: Arc<raggio_scene::HeightField>) -> Self {
        let (columns, rows) = (field.width.saturating_sub(1), field.depth.saturating_sub(1));
        let levels = if columns == 0 || rows == 0 { Vec::new() } else { levels(&field, columns, rows) };
        let normals = if field.smooth { sample_normals(&field) } else { Vec::new() };
        let lowest = field.heights.iter().min().copied().map_or(0.0, f64::from);
        let bottom = (FULL * field.water_level).max(lowest) - SHORE;
        let scale = Vec3::new(1.0 / columns.max(1) as f64, 1.0 / FULL, 1.0 / rows.max(1) as f64);
        HeightField { field, levels, normals, scale, bottom }
    }

    fn height(&self, i: usize, j: usize) -> f64 {
        f64::from(self.field.heights[j * self.field.width + i])
    }

    fn search(&self, ray: &Ray, to: &mut impl Collect) {
        let ray = Ray::new(ray.origin / self.scale, ray.dir / self.scale);
        let walk = Walk { inverse: ray.dir.recip(), ray };
        let Some(whole) = self.whole(&walk, to.range()) else { return };
        // Blocks still to be walked, nearest on top.
        let mut stack: SmallVec<[Block; 32]> = SmallVec::new();
        stack.push(whole);
        while let Some(block) = stack.pop() {
            let block = Block { hi: block.hi.min(to.range().1), ..block };
            if block.lo > block.hi || !self.may_meet(&ray, &block) {
                continue;
            }
            if block.level == 0 {
                self.search_cell(&ray, &block, to);
            } else {
                self.push_children(&walk, &block, &mut stack);
            }
        }
    }

    /// The whole field and the stretch of the ray in its box.
    fn whole(&self, walk: &Walk, range: (f64, f64)) -> Option<Block> {
        let level = self.levels.len().checked_sub(1)?;
        let (low, high) = self.levels[level].spans[0];
        let range = walk.clipped(range, 0, (0.0, self.levels[0].columns as f64))?;
        let range = walk.clipped(range, 2, (0.0, self.levels[0].rows as f64))?;
        let (lo, hi) = walk.clipped(range, 1, (f64::from(low) - SHORE, f64::from(high) + SHORE))?;
        Some(Block { level, i: 0, j: 0, lo, hi })
    }

    /// Does the ray come to the heights of a block while it is over it?
    #[inline]
    fn may_meet(&self, ray: &Ray, block: &Block) -> bool {
        let level = &self.levels[block.level];
        let (low, high) = level.spans[block.j * level.columns + block.i];
        let y = |t: f64| ray.origin.y + ray.dir.y * t;
        let (a, b) = (y(block.lo), y(block.hi));
        let top = f64::from(high) + SHORE;
        a.max(b) >= f64::from(low) - SHORE && a.min(b) <= top && top >= self.bottom
    }

    /// Up to three of the four blocks below one, those that the ray is over, the farthest first.
    fn push_children(&self, walk: &Walk, block: &Block, stack: &mut SmallVec<[Block; 32]>) {
        let level = block.level - 1;
        let below = &self.levels[level];
        let (i, j) = (2 * block.i, 2 * block.j);
        let plane = |k: usize| ((k + 1) << level) as f64;
        let (di, tx) = walk.sides(block, 0, plane(i), i + 1 < below.columns);
        let (dj, tz) = walk.sides(block, 2, plane(j), j + 1 < below.rows);
        let mut push = |di: usize, dj: usize, lo: f64, hi: f64| {
            if lo < hi {
                stack.push(Block { level, i: i + di, j: j + dj, lo, hi });
            }
        };
        push(1 - di, 1 - dj, tx.max(tz), block.hi);
        if tx < tz {
            push(1 - di, dj, tx, tz);
        } else {
            push(di, 1 - dj, tz, tx);
        }
        push(di, dj, block.lo, tx.min(tz));
    }

    fn search_cell(&self, ray: &Ray, block: &Block, to: &mut impl Collect) {
        let &Block { i, j, lo, hi, .. } = block;
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
fn levels(field: &raggio_scene::HeightField, columns: usize, rows: usize) -> Vec<Level> {
    let at = |i: usize, j: usize| field.heights[j * field.width + i];
    let cell = |k: usize| {
        let (i, j) = (k % columns, k / columns);
        let corners = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        corners.iter().fold((u16::MAX, 0), |(lo, hi), &h| (lo.min(h), hi.max(h)))
    };
    let mut levels = vec![Level { columns, rows, spans: (0..columns * rows).map(cell).collect() }];
    while let Some(below) = levels.last().filter(|l| l.spans.len() > 1) {
        let (columns, rows) = (below.columns.div_ceil(2), below.rows.div_ceil(2));
        let mut spans = vec![(u16::MAX, 0); columns * rows];
        for (k, &(lo, hi)) in below.spans.iter().enumerate() {
            let block = &mut spans[(k / below.columns / 2) * columns + (k % below.columns) / 2];
            *block = (block.0.min(lo), block.1.max(hi));
        }
        levels.push(Level { columns, rows, spans });
    }
    levels
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
                let (low, high) = top.spans[0];
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
