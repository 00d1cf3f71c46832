//! The builder: binned surface area heuristic, splitting straight into eight children.
//!
//! Each node starts as one range of triangles and splits the child with the largest area until it has eight, after
//! Wald, Benthin, Boulos: "Getting Rid of Packets" (2008) and Wald: "On fast Construction of SAH-based BVHs" (2007).
//! Costs count leaf blocks of four, so leaves come out full.

use raggio_math::{Aabb, Vec3};

use super::{Block, LANES, LEAF, Node};

/// Deeper subtrees are cut in the middle, which halves them at each level.
const SAH_DEPTH: usize = 32;
/// Depth bound: the part cut by the heuristic and the part cut in the middle.
pub(crate) const MAX_DEPTH: usize = SAH_DEPTH + 32;
/// Most bins along an axis.
const BINS: usize = 32;
/// What visiting a node costs, in tests of a block.
const NODE_COST: f32 = 1.0;

type V3 = [f32; 3];

/// A box that grows.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    lo: [f32; 4],
    hi: [f32; 4],
}

impl Bounds {
    const EMPTY: Bounds = Bounds { lo: [f32::INFINITY; 4], hi: [f32::NEG_INFINITY; 4] };

    #[inline(always)]
    fn grow(&mut self, other: &Bounds) {
        for k in 0..4 {
            self.lo[k] = if other.lo[k] < self.lo[k] { other.lo[k] } else { self.lo[k] };
            self.hi[k] = if other.hi[k] > self.hi[k] { other.hi[k] } else { self.hi[k] };
        }
    }

    fn aabb(&self) -> Aabb {
        let corner = |c: &[f32; 4]| Vec3::new(f64::from(c[0]), f64::from(c[1]), f64::from(c[2]));
        Aabb { min: corner(&self.lo), max: corner(&self.hi) }
    }

    #[inline(always)]
    fn half_area(&self) -> f32 {
        let d = [self.hi[0] - self.lo[0], self.hi[1] - self.lo[1], self.hi[2] - self.lo[2]];
        if d[0] < 0.0 { 0.0 } else { d[0] * d[1] + d[1] * d[2] + d[2] * d[0] }
    }
}

/// A triangle while the tree is built: its box, and twice its centre is `lo + hi`.
#[derive(Clone, Copy, Debug)]
struct Prim {
    bounds: Bounds,
    triangle: u32,
}

/// Some triangles on their way into a child.
#[derive(Clone, Copy, Debug)]
struct Range {
    start: usize,
    end: usize,
    bounds: Bounds,
    /// Bounds of twice the centres.
    centres: Bounds,
}

impl Range {
    fn len(&self) -> usize {
        self.end - self.start
    }
}

struct Split {
    axis: usize,
    /// Bins below this go left.
    bin: usize,
    binning: Binning,
}

/// How twice a centre becomes a bin.
#[derive(Clone, Copy)]
struct Binning {
    count: usize,
    offset: [f32; 4],
    scale: [f32; 4],
}

impl Binning {
    fn new(range: &Range) -> Binning {
        let count = BINS.min(4 + range.len() / 20);
        let mut scale = [0.0; 4];
        for (k, scale) in scale.iter_mut().enumerate().take(3) {
            let size = range.centres.hi[k] - range.centres.lo[k];
            // A hair under `count`, so that the last centre falls into the last bin.
            *scale = if size > 1e-34 { 0.99 * count as f32 / size } else { 0.0 };
        }
        Binning { count, offset: range.centres.lo, scale }
    }

    #[inline(always)]
    fn bin(&self, prim: &Prim, axis: usize) -> usize {
        let c = prim.bounds.lo[axis] + prim.bounds.hi[axis];
        (((c - self.offset[axis]) * self.scale[axis]) as usize).min(self.count - 1)
    }
}

pub(crate) struct Builder<'a> {
    vertices: &'a [V3],
    triangles: &'a [[u32; 3]],
    prims: Vec<Prim>,
    nodes: Vec<Node>,
    blocks: Vec<Block>,
}

impl<'a> Builder<'a> {
    pub(crate) fn new(vertices: &'a [V3], triangles: &'a [[u32; 3]]) -> Self {
        let prims = triangles.iter().enumerate().map(|(i, t)| prim(vertices, t, i as u32)).collect();
        Builder { vertices, triangles, prims, nodes: Vec::new(), blocks: Vec::new() }
    }

    /// Nodes, blocks, the word of the root, and a box around everything.
    pub(crate) fn build(mut self) -> (Vec<Node>, Vec<Block>, u32, Aabb) {
        if self.prims.is_empty() {
            self.nodes.push(EMPTY_NODE);
            return (self.nodes, self.blocks, 0, Aabb::EMPTY);
        }
        self.nodes.reserve(self.prims.len() / 12 + 1);
        self.blocks.reserve(self.prims.len() / 3 + 1);
        let all = self.range(0, self.prims.len());
        let root = self.child(&all, 0);
        self.nodes.shrink_to_fit();
        self.blocks.shrink_to_fit();
        (self.nodes, self.blocks, root, all.bounds.aabb())
    }

    fn range(&self, start: usize, end: usize) -> Range {
        let mut range = Range { start, end, bounds: Bounds::EMPTY, centres: Bounds::EMPTY };
        for prim in &self.prims[start..end] {
            range.bounds.grow(&prim.bounds);
            range.centres.grow(&twice_centre(prim));
        }
        range
    }

    /// The child word for a range: a leaf, or a node built below.
    fn child(&mut self, range: &Range, depth: usize) -> u32 {
        if range.len() <= LANES { self.leaf(range) } else { self.node(range, depth) }
    }

    fn leaf(&mut self, range: &Range) -> u32 {
        let prims = &self.prims[range.start..range.end];
        let mut block = Block { corner: [[[f32::NAN; LANES]; 3]; 3], triangle: [u32::MAX; LANES] };
        for (lane, prim) in prims.iter().enumerate() {
            block.triangle[lane] = prim.triangle;
            for (k, &v) in self.triangles[prim.triangle as usize].iter().enumerate() {
                for axis in 0..3 {
                    block.corner[k][axis][lane] = self.vertices[v as usize][axis];
                }
            }
        }
        self.blocks.push(block);
        LEAF | (self.blocks.len() - 1) as u32
    }

    fn node(&mut self, range: &Range, depth: usize) -> u32 {
        let mut children = [*range; 8];
        let mut count = 1;
        while count < 8 {
            // Open the child whose box is most likely to be hit.
            let largest = (0..count)
                .filter(|&i| children[i].len() > LANES)
                .max_by(|&a, &b| children[a].bounds.half_area().total_cmp(&children[b].bounds.half_area()));
            let Some(i) = largest else { break };
            let (left, right) = self.split(&children[i], depth);
            children[i] = left;
            children[count] = right;
            count += 1;
        }
        let index = self.nodes.len();
        self.nodes.push(EMPTY_NODE);
        for (slot, child) in children[..count].iter().enumerate() {
            let word = self.child(child, depth + 1);
            let node = &mut self.nodes[index];
            node.child[slot] = word;
            for axis in 0..3 {
                node.bounds[axis][slot] = child.bounds.lo[axis];
                node.bounds[axis + 3][slot] = child.bounds.hi[axis];
            }
        }
        index as u32
    }

    fn split(&mut self, range: &Range, depth: usize) -> (Range, Range) {
        let best = if depth < SAH_DEPTH { self.best_split(range) } else { None };
        match best {
            Some(split) => self.partition(range, &split),
            None => {
                let middle = range.start + range.len() / 2;
                (self.range(range.start, middle), self.range(middle, range.end))
            }
        }
    }

    /// The cheapest cut between bins, over all axes; `None` where all centres coincide.
    fn best_split(&self, range: &Range) -> Option<Split> {
        let binning = Binning::new(range);
        let mut bins = [[(Bounds::EMPTY, 0u32); BINS]; 3];
        for prim in &self.prims[range.start..range.end] {
            for (axis, bins) in bins.iter_mut().enumerate() {
                let bin = &mut bins[binning.bin(prim, axis)];
                bin.0.grow(&prim.bounds);
                bin.1 += 1;
            }
        }
        let mut best: Option<(f32, usize, usize)> = None;
        for (axis, bins) in bins.iter().enumerate().filter(|(axis, _)| binning.scale[*axis] > 0.0) {
            let (cost, bin) = cheapest_cut(&bins[..binning.count]);
            if cost < best.map_or(f32::INFINITY, |b| b.0) {
                best = Some((cost, axis, bin));
            }
        }
        best.map(|(_, axis, bin)| Split { axis, bin, binning })
    }

    fn partition(&mut self, range: &Range, split: &Split) -> (Range, Range) {
        let mut left =
            Range { start: range.start, end: range.start, bounds: Bounds::EMPTY, centres: Bounds::EMPTY };
        let mut right = Range { start: range.end, end: range.end, ..left };
        let prims = &mut self.prims;
        while left.end < right.start {
            let prim = prims[left.end];
            if split.binning.bin(&prim, split.axis) < split.bin {
                left.bounds.grow(&prim.bounds);
                left.centres.grow(&twice_centre(&prim));
                left.end += 1;
            } else {
                right.bounds.grow(&prim.bounds);
                right.centres.grow(&twice_centre(&prim));
                right.start -= 1;
                prims.swap(left.end, right.start);
            }
        }
        (left, right)
    }
}

const EMPTY_NODE: Node = Node {
    bounds: [
        [f32::INFINITY; 8],
        [f32::INFINITY; 8],
        [f32::INFINITY; 8],
        [f32::NEG_INFINITY; 8],
        [f32::NEG_INFINITY; 8],
        [f32::NEG_INFINITY; 8],
    ],
    child: [LEAF; 8],
};

fn prim(vertices: &[V3], triangle: &[u32; 3], index: u32) -> Prim {
    let mut bounds = Bounds::EMPTY;
    for &v in triangle {
        let p = vertices[v as usize];
        let p = [p[0], p[1], p[2], 0.0];
        bounds.grow(&Bounds { lo: p, hi: p });
    }
    Prim { bounds, triangle: index }
}

#[inline(always)]
fn twice_centre(prim: &Prim) -> Bounds {
    let mut c = [0.0; 4];
    for (k, c) in c.iter_mut().enumerate() {
        *c = prim.bounds.lo[k] + prim.bounds.hi[k];
    }
    Bounds { lo: c, hi: c }
}

/// Cost and place of the cheapest cut of one axis; infinite where every cut leaves a side empty.
fn cheapest_cut(bins: &[(Bounds, u32)]) -> (f32, usize) {
    let blocks = |count: u32| count.div_ceil(LANES as u32) as f32;
    let mut right_cost = [0.0f32; BINS];
    let (mut bounds, mut count) = (Bounds::EMPTY, 0);
    for (i, bin) in bins.iter().enumerate().rev() {
        bounds.grow(&bin.0);
        count += bin.1;
        right_cost[i] =
            if count == 0 { f32::INFINITY } else { bounds.half_area() * (NODE_COST + blocks(count)) };
    }
    let (mut bounds, mut count) = (Bounds::EMPTY, 0);
    let mut best = (f32::INFINITY, 0);
    for i in 1..bins.len() {
        bounds.grow(&bins[i - 1].0);
        count += bins[i - 1].1;
        if count == 0 {
            continue;
        }
        let cost = bounds.half_area() * (NODE_COST + blocks(count)) + right_cost[i];
        if cost < best.0 {
            best = (cost, i);
        }
    }
    best
}
