//! Where light samples lie: a loose octree, whose cells look at eight of them at once.
use raggio_math::{Aabb, Vec3};
use smallvec::{SmallVec, smallvec};
use wide::f32x8;

use super::cache::{Query, Sample};

/// A loose octree: a sample lies in the smallest cell that, doubled about its centre, holds the sample's sphere.
#[derive(Default)]
pub(super) struct Octree {
    nodes: Vec<Node>,
    root: u32,
}

/// A cell of side `2^level` whose number along each axis is `index`.
struct Node {
    /// The middle.
    centre: Vec3,
    /// The side, which is half that of the doubled cell.
    side: f64,
    level: i32,
    index: [i64; 3],
    children: [u32; 8],
    is_leaf: bool,
    /// Where a search goes on for each of them: past nodes without samples that have but one child.
    next: [u32; 8],
    /// Where the doubled cells lie of the nodes with samples below each child; most nodes have none of their own.
    reaches: Reaches,
    /// The same of the node itself and all below.
    all: Aabb,
    samples: Vec<Sample>,
    /// Eight samples each: what most of them fail by.
    outlines: Vec<Outlines>,
    /// By sample: the radius in which it counts.
    radii: Vec<f64>,
}

/// Eight boxes, from the middle of a node.
struct Reaches {
    low: [Lanes; 3],
    high: [Lanes; 3],
}

/// Samples that are looked at together.
const WIDTH: usize = 8;

/// A number for each of them.
type Lanes = f32x8;

/// What is asked first of eight samples. What is not a number is not there.
struct Outlines {
    /// Where from the middle of their cell.
    place: [Lanes; 3],
    /// The mean distances.
    reach: Lanes,
    /// The surfaces' normals.
    n: [Lanes; 3],
}

/// What outlines are compared with.
struct Asked {
    error: Lanes,
    n: [Lanes; 3],
    /// Normals count that have more than this in common.
    least_cosine: Lanes,
}

/// No child.
const NONE: u32 = u32::MAX;
/// Cells are no smaller and no larger than these powers of two.
const LEVELS: std::ops::RangeInclusive<i32> = -40..=40;
/// Added to coordinates, so that cells on both sides of the origin have an ancestor in common.
const SHIFT: Vec3 = Vec3::splat(1e7);

impl Node {
    fn new(level: i32, index: [i64; 3]) -> Node {
        let side = 2f64.powi(level);
        let centre = Vec3::from_array(index.map(|i| (i as f64 + 0.5) * side));
        Node {
            centre,
            side,
            level,
            index,
            children: [NONE; 8],
            is_leaf: true,
            next: [NONE; 8],
            reaches: Reaches::NONE,
            all: Aabb::EMPTY,
            samples: Vec::new(),
            outlines: Vec::new(),
            radii: Vec::new(),
        }
    }

    fn push(&mut self, sample: Sample, radius: f64) {
        let lane = self.samples.len() % WIDTH;
        if lane == 0 {
            self.outlines.push(Outlines::NONE);
        }
        if let Some(outlines) = self.outlines.last_mut() {
            outlines.set(lane, sample.p + SHIFT - self.centre, &sample);
        }
        self.samples.push(sample);
        self.radii.push(radius);
        self.all = self.all.union(&self.doubled());
    }

    /// The cell, doubled about its middle.
    fn doubled(&self) -> Aabb {
        Aabb { min: self.centre - self.side, max: self.centre + self.side }
    }

    /// Visits the samples that may count at a point by their distance and normal.
    #[inline]
    fn visit(&self, p: Vec3, asked: &Asked, each: &mut impl FnMut(&Sample)) {
        let offset = (p - self.centre).abs();
        if self.samples.is_empty() || offset.max_element() > self.side {
            return;
        }
        let place = all_lanes(p - self.centre);
        // Rounding is far below a thousandth of the cell, in which everything lies.
        let slack = Lanes::splat(1e-3 * self.side as f32);
        let mut first = 0;
        for outlines in &self.outlines {
            let mut counting = outlines.counting(&place, slack, asked);
            while counting != 0 {
                each(&self.samples[first + counting.trailing_zeros() as usize]);
                counting &= counting - 1;
            }
            first += WIDTH;
        }
    }

    /// Takes in a child, or what is new below it: where a search goes on there, and the box around all samples' cells.
    fn adopt(&mut self, slot: usize, child: u32, next: u32, below: &Aabb) {
        self.children[slot] = child;
        self.is_leaf = false;
        self.next[slot] = next;
        self.reaches.set(slot, below.min - self.centre, below.max - self.centre);
        self.all = self.all.union(below);
    }

    /// Where a search goes on that comes to this node, which has that number.
    fn entrance(&self, number: u32) -> u32 {
        let mut children = self.next.iter().filter(|&&next| next != NONE);
        match (children.next(), children.next()) {
            (Some(&only), None) if self.samples.is_empty() => only,
            _ => number,
        }
    }

    /// The children below which samples may reach the point: a bit each, found without looking at them.
    #[inline]
    fn reaching(&self, p: Vec3) -> u32 {
        // Rounding is below a millionth of the cell.
        self.reaches.holding(&all_lanes(p - self.centre), Lanes::splat(1e-6 * self.side as f32))
    }
}

impl Reaches {
    const NONE: Reaches =
        Reaches { low: [Lanes::new([f32::INFINITY; 8]); 3], high: [Lanes::new([f32::NEG_INFINITY; 8]); 3] };

    fn set(&mut self, slot: usize, low: Vec3, high: Vec3) {
        let (low, high) = (low.as_vec3().to_array(), high.as_vec3().to_array());
        for k in 0..3 {
            self.low[k].as_mut_array()[slot] = low[k];
            self.high[k].as_mut_array()[slot] = high[k];
        }
    }

    /// Which of them hold a point, or nearly: a bit each.
    #[inline]
    fn holding(&self, place: &[Lanes; 3], slack: Lanes) -> u32 {
        let within =
            |k: usize| (self.low[k] - slack).simd_le(place[k]) & (self.high[k] + slack).simd_ge(place[k]);
        (within(0) & within(1) & within(2)).to_bitmask()
    }
}

fn index_at(p: Vec3, level: i32) -> [i64; 3] {
    let side = 2f64.powi(level);
    [p.x, p.y, p.z].map(|v| (v / side).floor() as i64)
}

impl Asked {
    fn new(query: &Query) -> Asked {
        // Twice the root of what is missing to a cosine of 1 is to stay below the error.
        let least = 1.0 - 0.25 * query.error * query.error;
        Asked {
            error: Lanes::splat(query.error as f32),
            n: all_lanes(query.n),
            least_cosine: Lanes::splat(least as f32 - 1e-4),
        }
    }
}

/// A vector's coordinates, each in all lanes.
#[inline]
fn all_lanes(v: Vec3) -> [Lanes; 3] {
    let v = v.as_vec3();
    [Lanes::splat(v.x), Lanes::splat(v.y), Lanes::splat(v.z)]
}

impl Outlines {
    const NONE: Outlines = {
        let none = Lanes::new([f32::NAN; WIDTH]);
        Outlines { place: [none; 3], reach: none, n: [none; 3] }
    };

    fn set(&mut self, lane: usize, place: Vec3, sample: &Sample) {
        let (place, n) = (place.as_vec3().to_array(), sample.n.as_vec3().to_array());
        for k in 0..3 {
            self.place[k].as_mut_array()[lane] = place[k];
            self.n[k].as_mut_array()[lane] = n[k];
        }
        self.reach.as_mut_array()[lane] = sample.mean_distance as f32;
    }

    /// Which of them may count: a bit each.
    #[inline]
    fn counting(&self, place: &[Lanes; 3], slack: Lanes, asked: &Asked) -> u32 {
        let (x, y, z) = (self.place[0] - place[0], self.place[1] - place[1], self.place[2] - place[2]);
        let reach = self.reach * asked.error + slack;
        let near = (x * x + y * y + z * z).simd_lt(reach * reach);
        let cosine = self.n[0] * asked.n[0] + self.n[1] * asked.n[1] + self.n[2] * asked.n[2];
        (near & cosine.simd_gt(asked.least_cosine)).to_bitmask()
    }
}

impl Octree {
    /// Takes in a sample that counts within `radius`.
    pub fn insert(&mut self, sample: Sample, radius: f64) {
        let level = ((2.0 * radius).max(1e-12).log2().ceil() as i32).clamp(*LEVELS.start(), *LEVELS.end());
        let p = sample.p + SHIFT;
        let mut node = self.grow_around(p, level);
        let mut way: SmallVec<[(u32, usize); 64]> = SmallVec::new();
        while self.nodes[node as usize].level > level {
            let (slot, child) = self.child_at(node, p);
            way.push((node, slot));
            node = child;
        }
        self.nodes[node as usize].push(sample, radius);
        for (parent, slot) in way.into_iter().rev() {
            let child = &self.nodes[node as usize];
            let (next, below) = (child.entrance(node), child.all);
            self.nodes[parent as usize].adopt(slot, node, next, &below);
            node = parent;
        }
    }

    /// Makes the root hold the point's cell of that level.
    fn grow_around(&mut self, p: Vec3, level: i32) -> u32 {
        if self.nodes.is_empty() {
            self.nodes.push(Node::new(level, index_at(p, level)));
            return 0;
        }
        loop {
            let root = &self.nodes[self.root as usize];
            let holds = root.level >= level && index_at(p, root.level) == root.index;
            if holds || root.level >= 2 * LEVELS.end() {
                return self.root;
            }
            let mut parent = Node::new(root.level + 1, root.index.map(|i| i >> 1));
            parent.adopt(octant(root.index), self.root, root.entrance(self.root), &root.all);
            self.root = self.nodes.len() as u32;
            self.nodes.push(parent);
        }
    }

    /// The child in which a point lies, and its place.
    fn child_at(&mut self, node: u32, p: Vec3) -> (usize, u32) {
        let level = self.nodes[node as usize].level - 1;
        let index = index_at(p, level);
        let slot = octant(index);
        let child = self.nodes[node as usize].children[slot];
        if child != NONE {
            return (slot, child);
        }
        self.nodes.push(Node::new(level, index));
        (slot, self.nodes.len() as u32 - 1)
    }

    /// Visits every sample whose cell may reach the point, unless it plainly does not count there.
    pub fn visit(&self, query: &Query, mut each: impl FnMut(&Sample)) {
        if self.nodes.is_empty() {
            return;
        }
        let (p, asked) = (query.p + SHIFT, Asked::new(query));
        let mut stack: SmallVec<[u32; 64]> = smallvec![self.nodes[self.root as usize].entrance(self.root)];
        while let Some(top) = stack.pop() {
            let node = &self.nodes[top as usize];
            node.visit(p, &asked, &mut each);
            let mut reaching = if node.is_leaf { 0 } else { node.reaching(p) };
            while reaching != 0 {
                stack.push(node.next[reaching.trailing_zeros() as usize]);
                reaching &= reaching - 1;
            }
        }
    }

    /// All samples with the radii in which they count.
    pub fn into_samples(self) -> impl Iterator<Item = (Sample, f64)> {
        self.nodes.into_iter().flat_map(|node| node.samples.into_iter().zip(node.radii))
    }
}

fn octant(index: [i64; 3]) -> usize {
    ((index[0] & 1) | ((index[1] & 1) << 1) | ((index[2] & 1) << 2)) as usize
}

#[cfg(test)]
mod tests {
    use super::super::cache::tests::sample;
    use super::*;

    #[test]
    fn every_sample_is_found_within_its_radius() {
        let mut tree = Octree::default();
        let mut all = Vec::new();
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as f64 / f64::from(1u32 << 31) - 0.5
        };
        for _ in 0..300 {
            let p = Vec3::new(random(), random(), random()) * 100.0;
            let radius = 0.01 + random().abs() * 10.0;
            tree.insert(Sample { mean_distance: radius / 5.0, ..sample(p) }, radius);
            all.push((p, radius));
        }
        for _ in 0..300 {
            let p = Vec3::new(random(), random(), random()) * 100.0;
            let mut found = Vec::new();
            let query = Query { p, n: Vec3::Y, error: 5.0, sharp: false };
            tree.visit(&query, |s| found.push(s.p));
            for (q, radius) in &all {
                assert!((*q - p).length() > *radius || found.contains(q));
            }
            assert!(found.len() < 300);
        }
    }
}
