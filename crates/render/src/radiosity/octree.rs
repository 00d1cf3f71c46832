//! Where light samples lie: a loose octree, whose cells look at eight of them at once.
use raggio_math::Vec3;
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
    /// One over a quarter of the side, which is a power of two.
    per_quarter: f64,
    level: i32,
    index: [i64; 3],
    children: [u32; 8],
    /// Which of them there are, a bit each.
    present: u8,
    samples: Vec<Sample>,
    /// Eight samples each: what most of them fail by.
    outlines: Vec<Outlines>,
    /// By sample: the radius in which it counts.
    radii: Vec<f64>,
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
            per_quarter: 4.0 / side,
            level,
            index,
            children: [NONE; 8],
            present: 0,
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
    }

    /// Visits the samples that may count at a point by their distance and normal.
    #[inline]
    fn visit(&self, p: Vec3, asked: &Asked, each: &mut impl FnMut(&Sample)) {
        if self.samples.is_empty() {
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

    fn adopt(&mut self, slot: usize, child: u32) {
        self.children[slot] = child;
        self.present |= 1 << slot;
    }

    /// Which children's doubled cells hold the point: a bit each, found without looking at them.
    #[inline]
    fn reaching(&self, p: Vec3) -> u8 {
        let offset = (p - self.centre) * self.per_quarter;
        // By axis: the children on the upper side, and those on the lower side.
        const UPPER: [u8; 3] = [0b1010_1010, 0b1100_1100, 0b1111_0000];
        let all = |which: bool| 0u8.wrapping_sub(u8::from(which));
        let side =
            |x: f64, upper: u8| all(x.abs() <= 3.0) & ((upper & all(x >= -1.0)) | (!upper & all(x <= 1.0)));
        side(offset.x, UPPER[0]) & side(offset.y, UPPER[1]) & side(offset.z, UPPER[2])
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
        while self.nodes[node as usize].level > level {
            node = self.child_at(node, p);
        }
        self.nodes[node as usize].push(sample, radius);
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
            parent.adopt(octant(root.index), self.root);
            self.root = self.nodes.len() as u32;
            self.nodes.push(parent);
        }
    }

    fn child_at(&mut self, node: u32, p: Vec3) -> u32 {
        let level = self.nodes[node as usize].level - 1;
        let index = index_at(p, level);
        let slot = octant(index);
        let child = self.nodes[node as usize].children[slot];
        if child != NONE {
            return child;
        }
        let new = self.nodes.len() as u32;
        self.nodes.push(Node::new(level, index));
        self.nodes[node as usize].adopt(slot, new);
        new
    }

    /// Visits every sample whose cell may reach the point, unless it plainly does not count there.
    pub fn visit(&self, query: &Query, mut each: impl FnMut(&Sample)) {
        if self.nodes.is_empty() {
            return;
        }
        let (p, asked) = (query.p + SHIFT, Asked::new(query));
        let mut stack: SmallVec<[u32; 64]> = smallvec![self.root];
        while let Some(top) = stack.pop() {
            let node = &self.nodes[top as usize];
            node.visit(p, &asked, &mut each);
            let mut reaching = node.present & node.reaching(p);
            while reaching != 0 {
                stack.push(node.children[reaching.trailing_zeros() as usize]);
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
