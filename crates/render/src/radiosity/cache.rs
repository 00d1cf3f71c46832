//! The cache of light samples: an octree for each depth, and how much a sample counts at a point.
use raggio_image::Rgb;
use raggio_math::Vec3;

/// Diffuse light at a place.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Where.
    pub p: Vec3,
    /// The surface's normal.
    pub n: Vec3,
    /// The mean light from all around.
    pub light: Rgb,
    /// The harmonic mean of the distances to what is seen.
    pub mean_distance: f64,
    /// The least of them.
    pub nearest: f64,
    /// The direction of the least.
    pub toward: Vec3,
    /// How well the light is known.
    pub quality: f32,
}

/// What is asked of the cache.
pub struct Query {
    /// Where.
    pub p: Vec3,
    /// The surface's normal.
    pub n: Vec3,
    /// The greatest error.
    pub error: f64,
    /// Weights fall off as in the final picture.
    pub sharp: bool,
}

/// Weighted samples.
#[derive(Default)]
pub struct Found {
    /// The weighted sum of light.
    pub sum: Rgb,
    /// The sum of weights.
    pub weight: f32,
}

/// Samples with less weight do not count.
const LEAST_WEIGHT: f64 = 1e-3;

/// Samples of all depths.
#[derive(Default)]
pub struct Cache {
    trees: Vec<Octree>,
}

impl Cache {
    /// An empty cache for so many depths.
    pub fn new(depths: u32) -> Cache {
        Cache { trees: (0..depths).map(|_| Octree::default()).collect() }
    }

    /// Adds to `found` what counts at a point.
    pub fn look_up(&self, depth: u32, query: &Query, found: &mut Found) {
        let Some(tree) = self.trees.get(depth as usize) else { return };
        tree.visit(query, &mut |sample| {
            let weight = sample.weight(query);
            if weight > LEAST_WEIGHT {
                let weight = weight as f32 * sample.quality;
                found.sum += sample.light * weight;
                found.weight += weight;
            }
        });
    }

    /// Keeps a sample that counts within `radius`.
    pub fn insert(&mut self, depth: u32, sample: Sample, radius: f64) {
        if let Some(tree) = self.trees.get_mut(depth as usize) {
            tree.insert(sample, radius);
        }
    }

    /// Takes over all samples of another cache.
    pub fn absorb(&mut self, other: Cache) {
        for (tree, other) in self.trees.iter_mut().zip(other.trees) {
            for (sample, radius) in
                other.nodes.into_iter().flat_map(|node| node.samples.into_iter().zip(node.radii))
            {
                tree.insert(sample, radius);
            }
        }
    }
}

impl Sample {
    /// Does the sample count at a point?
    pub fn counts_at(&self, query: &Query) -> bool {
        self.weight(query) > LEAST_WEIGHT
    }

    /// How much the sample counts; 0 where it does not fit.
    fn weight(&self, query: &Query) -> f64 {
        let offset = query.p - self.p;
        let farthest = self.mean_distance * query.error;
        let square = offset.length_squared();
        if square >= farthest * farthest {
            return 0.0;
        }
        let x = square.sqrt();
        let away = if x > 1e-6 { offset / x } else { Vec3::ZERO };
        let mut reach = self.mean_distance;
        let closing = self.toward.dot(away);
        if closing > 0.0 {
            reach = closing * self.nearest + (1.0 - closing) * self.mean_distance;
            if x >= reach * query.error {
                return 0.0;
            }
        }
        let turn = 2.0 * (1.0 - query.n.dot(self.n)).abs().sqrt();
        let error = x / reach + turn;
        if error >= query.error {
            return 0.0;
        }
        // What lies before the sample's surface may see other things.
        let front = (query.n + self.n).try_normalize().map_or(0.0, |m| away.dot(m));
        if x > 1e-6 && front <= -0.05 {
            return 0.0;
        }
        let y = error / query.error;
        let weight = match (query.sharp, y < 0.5) {
            (false, _) => 1.0 - y,
            (true, true) => 1.0 - 2.0 * y * y,
            (true, false) => 2.0 * (1.0 - y) * (1.0 - y),
        };
        if x > 1e-6 && front <= 0.0 { weight * (1.0 + front / 0.05) } else { weight }
    }
}

/// A loose octree: a sample lies in the smallest cell that, doubled about its centre, holds the sample's sphere.
#[derive(Default)]
struct Octree {
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
    /// By sample: what most of them fail by.
    outlines: Vec<Outline>,
    /// By sample: the radius in which it counts.
    radii: Vec<f64>,
}

/// What is asked first of a sample.
#[derive(Clone, Copy)]
struct Outline {
    /// Where from the middle of its cell.
    place: [f32; 3],
    /// The mean distance.
    reach: f32,
    /// The surface's normal.
    n: [f32; 3],
}

/// What outlines are compared with.
struct Asked {
    error: f32,
    n: [f32; 3],
    /// Normals count that have at least this in common.
    least_cosine: f32,
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
        self.outlines.push(Outline {
            place: (sample.p + SHIFT - self.centre).as_vec3().to_array(),
            reach: sample.mean_distance as f32,
            n: sample.n.as_vec3().to_array(),
        });
        self.samples.push(sample);
        self.radii.push(radius);
    }

    /// Visits the samples that may count at a point by their distance and normal.
    #[inline]
    fn visit(&self, p: Vec3, asked: &Asked, each: &mut impl FnMut(&Sample)) {
        if self.samples.is_empty() {
            return;
        }
        let place = (p - self.centre).as_vec3().to_array();
        // Rounding is far below a thousandth of the cell, in which everything lies.
        let slack = 1e-3 * self.side as f32;
        for (sample, outline) in self.samples.iter().zip(&self.outlines) {
            if outline.may_count(place, slack, asked) {
                each(sample);
            }
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
            error: query.error as f32,
            n: query.n.as_vec3().to_array(),
            least_cosine: least as f32 - 1e-4,
        }
    }
}

impl Outline {
    #[inline]
    fn may_count(&self, place: [f32; 3], slack: f32, asked: &Asked) -> bool {
        let [x, y, z] = self.place;
        let (dx, dy, dz) = (x - place[0], y - place[1], z - place[2]);
        let reach = self.reach * asked.error + slack;
        let cosine = self.n[0] * asked.n[0] + self.n[1] * asked.n[1] + self.n[2] * asked.n[2];
        (dx * dx + dy * dy + dz * dz < reach * reach) & (cosine > asked.least_cosine)
    }
}

impl Octree {
    fn insert(&mut self, sample: Sample, radius: f64) {
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

    /// Visits every sample whose cell may reach the point.
    fn visit(&self, query: &Query, each: &mut impl FnMut(&Sample)) {
        if self.nodes.is_empty() {
            return;
        }
        let (p, asked) = (query.p + SHIFT, Asked::new(query));
        let mut stack: smallvec::SmallVec<[u32; 64]> = smallvec::smallvec![self.root];
        while let Some(top) = stack.pop() {
            let node = &self.nodes[top as usize];
            node.visit(p, &asked, each);
            let mut reaching = node.present & node.reaching(p);
            while reaching != 0 {
                stack.push(node.children[reaching.trailing_zeros() as usize]);
                reaching &= reaching - 1;
            }
        }
    }
}

fn octant(index: [i64; 3]) -> usize {
    ((index[0] & 1) | ((index[1] & 1) << 1) | ((index[2] & 1) << 2)) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(p: Vec3) -> Sample {
        Sample {
            p,
            n: Vec3::Y,
            light: Rgb::ONE,
            mean_distance: 2.0,
            nearest: 2.0,
            toward: Vec3::Y,
            quality: 1.0,
        }
    }

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
            tree.visit(&query, &mut |s| found.push(s.p));
            for (q, radius) in &all {
                assert!((*q - p).length() > *radius || found.contains(q));
            }
            assert!(found.len() < 300);
        }
    }

    #[test]
    fn weights_fall_from_one_to_nothing() {
        let query = |x: f64, sharp| Query { p: Vec3::X * x, n: Vec3::Y, error: 1.0, sharp };
        let s = sample(Vec3::ZERO);
        assert_eq!(s.weight(&query(0.0, false)), 1.0);
        assert!((s.weight(&query(1.0, false)) - 0.5).abs() < 1e-12);
        assert!((s.weight(&query(0.5, true)) - 0.875).abs() < 1e-12);
        assert_eq!(s.weight(&query(2.0, true)), 0.0);
        let behind = Query { p: Vec3::new(0.5, -0.5, 0.0), n: Vec3::Y, error: 1.0, sharp: false };
        assert_eq!(s.weight(&behind), 0.0);
    }
}
