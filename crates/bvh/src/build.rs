//! Building: a binary tree by the surface area heuristic over bins, then eight children drawn up into each node.
use raggio_math::Aabb;

use crate::kernel;
use crate::node::{Child, MAX_LEAF, Node, WIDTH};
use crate::round::{down, up};
use crate::traverse::Bvh;

/// Bins per axis in the search for the best split (Wald 2007).
const BINS: usize = 16;

/// Under this depth splits are by halves, so that no input makes a deep tree.
const MAX_HEURISTIC_DEPTH: usize = 40;

/// No path from the root is longer: below the heuristic's depth halves of at most 2^28 primitives.
pub(crate) const MAX_DEPTH: usize = MAX_HEURISTIC_DEPTH + 29;

/// Sides beyond this do not fit the single-precision boxes.
const REACH: f64 = 1e30;

/// A tree and what it could not take.
pub struct Built {
    /// The tree over all bounded boxes.
    pub bvh: Bvh,
    /// Boxes with an infinite (or hopelessly far) side, in order: to be asked one by one.
    pub unbounded: Vec<u32>,
}

/// A box in single precision, and whose it is.
#[derive(Clone, Copy)]
struct Item {
    min: [f32; 3],
    max: [f32; 3],
    prim: u32,
}

/// A box that can grow.
#[derive(Clone, Copy)]
struct Bounds {
    min: [f32; 3],
    max: [f32; 3],
}

/// A node of the binary tree.
struct Binary {
    bounds: Bounds,
    split: Split,
}

enum Split {
    Leaf { start: usize, count: usize },
    Inner([usize; 2]),
}

impl Bounds {
    const EMPTY: Bounds = Bounds { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    fn add(&mut self, min: &[f32; 3], max: &[f32; 3]) {
        for k in 0..3 {
            self.min[k] = self.min[k].min(min[k]);
            self.max[k] = self.max[k].max(max[k]);
        }
    }

    fn half_area(&self) -> f32 {
        let s = |k: usize| (self.max[k] - self.min[k]).max(0.0);
        s(0) * s(1) + s(1) * s(2) + s(2) * s(0)
    }
}

impl Item {
    /// Twice the centre along an axis, halved before adding so that it cannot overflow.
    fn centre(&self, axis: usize) -> f32 {
        0.5 * self.min[axis] + 0.5 * self.max[axis]
    }
}

impl Bvh {
    /// Builds a tree over boxes; a primitive is its index in `boxes`. Empty boxes are left out, unbounded ones handed
    /// back. `leaf_size` (at most 8) is how many primitives may share a leaf: 1 for costly ones, more for cheap ones.
    pub fn build(boxes: &[Aabb], leaf_size: usize) -> Built {
        let mut unbounded = Vec::new();
        let mut items = Vec::with_capacity(boxes.len());
        for (prim, b) in boxes.iter().enumerate() {
            if b.is_empty() {
                continue;
            }
            match b.min.min_element() > -REACH && b.max.max_element() < REACH {
                true => items.push(item(b, prim as u32)),
                false => unbounded.push(prim as u32),
            }
        }
        let mut builder =
            Builder { nodes: Vec::with_capacity(items.len()), leaf_size: leaf_size.clamp(1, MAX_LEAF) };
        let wide = match items.is_empty() {
            true => Vec::new(),
            false => {
                let root = builder.split(&mut items, 0, 0);
                widen(&builder.nodes, root)
            }
        };
        let prims = items.iter().map(|i| i.prim).collect();
        Built { bvh: Bvh { nodes: wide, prims, simd: kernel::simd_available() }, unbounded }
    }
}

fn item(b: &Aabb, prim: u32) -> Item {
    Item {
        min: [down(b.min.x), down(b.min.y), down(b.min.z)],
        max: [up(b.max.x), up(b.max.y), up(b.max.z)],
        prim,
    }
}

struct Builder {
    nodes: Vec<Binary>,
    leaf_size: usize,
}

impl Builder {
    /// Makes the subtree over `items`, which stand at `start` in the whole, and returns its root.
    fn split(&mut self, items: &mut [Item], start: usize, depth: usize) -> usize {
        let (mut bounds, mut centres) = (Bounds::EMPTY, Bounds::EMPTY);
        for item in items.iter() {
            let c = [item.centre(0), item.centre(1), item.centre(2)];
            bounds.add(&item.min, &item.max);
            centres.add(&c, &c);
        }
        let index = self.nodes.len();
        self.nodes.push(Binary { bounds, split: Split::Leaf { start, count: items.len() } });
        if items.len() > self.leaf_size {
            let middle = match depth < MAX_HEURISTIC_DEPTH {
                true => partition(items, &centres),
                false => items.len() / 2,
            };
            let (left, right) = items.split_at_mut(middle);
            let children = [self.split(left, start, depth + 1), self.split(right, start + middle, depth + 1)];
            self.nodes[index].split = Split::Inner(children);
        }
        index
    }
}

/// Orders `items` so that the two halves of the best split are apart, and returns where the second begins.
fn partition(items: &mut [Item], centres: &Bounds) -> usize {
    let Some((axis, bin)) = best_split(items, centres) else {
        return items.len() / 2;
    };
    let scale = bin_scale(centres, axis);
    let mut middle = 0;
    for i in 0..items.len() {
        if bin_of(&items[i], centres, axis, scale) <= bin {
            items.swap(i, middle);
            middle += 1;
        }
    }
    middle
}

fn bin_scale(centres: &Bounds, axis: usize) -> f32 {
    BINS as f32 / (centres.max[axis] - centres.min[axis])
}

fn bin_of(item: &Item, centres: &Bounds, axis: usize, scale: f32) -> usize {
    (((item.centre(axis) - centres.min[axis]) * scale) as usize).min(BINS - 1)
}

/// The axis and the last bin on the left of the cheapest split; `None` where all centres fall together.
fn best_split(items: &[Item], centres: &Bounds) -> Option<(usize, usize)> {
    let mut best: Option<(f32, usize, usize)> = None;
    for axis in 0..3 {
        let scale = bin_scale(centres, axis);
        if !(scale.is_finite() && scale > 0.0) {
            continue;
        }
        let mut bins = [(Bounds::EMPTY, 0usize); BINS];
        for item in items {
            let bin = &mut bins[bin_of(item, centres, axis, scale)];
            bin.0.add(&item.min, &item.max);
            bin.1 += 1;
        }
        let (cost, at) = cheapest(&bins);
        if best.is_none_or(|b| cost < b.0) {
            best = Some((cost, axis, at));
        }
    }
    best.map(|(_, axis, at)| (axis, at))
}

/// The cost of the cheapest split between bins, and the last bin on its left. The first and the last bin are never
/// empty (they hold the extreme centres), so both sides have members wherever the split is.
fn cheapest(bins: &[(Bounds, usize); BINS]) -> (f32, usize) {
    let mut right_cost = [0.0; BINS];
    let (mut bounds, mut count) = (Bounds::EMPTY, 0);
    for i in (1..BINS).rev() {
        bounds.add(&bins[i].0.min, &bins[i].0.max);
        count += bins[i].1;
        right_cost[i - 1] = bounds.half_area() * count as f32;
    }
    let mut best = (f32::INFINITY, BINS / 2 - 1);
    (bounds, count) = (Bounds::EMPTY, 0);
    for i in 0..BINS - 1 {
        bounds.add(&bins[i].0.min, &bins[i].0.max);
        count += bins[i].1;
        let cost = bounds.half_area() * count as f32 + right_cost[i];
        if cost < best.0 {
            best = (cost, i);
        }
    }
    best
}

/// Draws the binary tree's grandchildren up until every node has eight children.
fn widen(binary: &[Binary], root: usize) -> Vec<Node> {
    let mut wide = Vec::new();
    widen_node(binary, root, &mut wide);
    wide
}

fn widen_node(binary: &[Binary], root: usize, wide: &mut Vec<Node>) -> usize {
    let mut slots = Vec::with_capacity(WIDTH);
    slots.push(root);
    while slots.len() < WIDTH {
        let area = |slot: &usize| binary[*slot].bounds.half_area();
        let inner = |i: &usize| matches!(binary[slots[*i]].split, Split::Inner(_));
        let widest =
            (0..slots.len()).filter(inner).max_by(|a, b| area(&slots[*a]).total_cmp(&area(&slots[*b])));
        let Some(i) = widest else { break };
        if let Split::Inner([left, right]) = binary[slots[i]].split {
            slots[i] = left;
            slots.push(right);
        }
    }
    let index = wide.len();
    wide.push(Node::EMPTY);
    for (place, slot) in slots.into_iter().enumerate() {
        let child = match binary[slot].split {
            Split::Leaf { start, count } => Child::leaf(start, count),
            Split::Inner(_) => Child::inner(widen_node(binary, slot, wide)),
        };
        let node = &mut wide[index];
        for k in 0..3 {
            node.sides[k][place] = binary[slot].bounds.min[k];
            node.sides[k + 3][place] = binary[slot].bounds.max[k];
        }
        node.children[place] = child;
    }
    index
}
