//! A small tree of boxes for the parts inside one shape: components of a blob, triangles of a patch, glyphs of a text.
use raggio_math::{Aabb, Ray, Vec3};

/// Parts per leaf.
const LEAF: usize = 2;

/// Boxes in depth-first order; each knows where to go on when it is missed, so that a visit needs no stack.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    nodes: Vec<Node>,
    /// Indices of the parts, in the order of the leaves.
    parts: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    /// The next node when this one is missed or done.
    skip: u32,
    /// The leaf's parts; empty for an inner node.
    first: u32,
    count: u32,
}

impl Tree {
    /// A tree over the boxes of parts; empty boxes are left out.
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let mut parts: Vec<u32> =
            (0..boxes.len() as u32).filter(|&i| !boxes[i as usize].is_empty()).collect();
        let mut nodes = Vec::new();
        if !parts.is_empty() {
            build(boxes, &mut parts, 0, &mut nodes);
        }
        Tree { nodes, parts }
    }

    /// The box around everything.
    pub(crate) fn bounds(&self) -> Aabb {
        self.nodes.first().map_or(Aabb::EMPTY, |n| n.bounds)
    }

    /// Calls `each` with the parts whose leaf boxes meet the ray. `each` gets the index of a part and answers with the
    /// range of distances that still matters.
    #[inline]
    pub(crate) fn visit_ray(
        &self,
        ray: &Ray,
        mut range: (f64, f64),
        mut each: impl FnMut(usize) -> (f64, f64),
    ) {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            let met = node.bounds.hit(ray).is_some_and(|(near, far)| near < range.1 && far > range.0);
            if !met {
                at = node.skip as usize;
                continue;
            }
            for &part in &self.parts[node.first as usize..(node.first + node.count) as usize] {
                range = each(part as usize);
            }
            at += 1;
        }
    }

    /// Calls `each` with the parts whose leaf boxes hold the point.
    #[inline]
    pub(crate) fn visit_point(&self, p: Vec3, mut each: impl FnMut(usize)) {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            if !node.bounds.contains(p) {
                at = node.skip as usize;
                continue;
            }
            for &part in &self.parts[node.first as usize..(node.first + node.count) as usize] {
                each(part as usize);
            }
            at += 1;
        }
    }
}

/// Appends the tree over `parts`, which start at place `first` of the whole list. Splits at the median of the longest
/// axis of the centres.
fn build(boxes: &[Aabb], parts: &mut [u32], first: usize, nodes: &mut Vec<Node>) {
    let bounds = parts.iter().fold(Aabb::EMPTY, |b, &i| b.union(&boxes[i as usize]));
    let at = nodes.len();
    // A hair wider, so that rounding in the box test loses nothing.
    let margin = 1e-12 * bounds.min.abs().max(bounds.max.abs()).max_element();
    nodes.push(Node { bounds: bounds.grown(margin), skip: 0, first: first as u32, count: 0 });
    if parts.len() <= LEAF {
        nodes[at].count = parts.len() as u32;
    } else {
        let centres = Aabb::around(parts.iter().map(|&i| boxes[i as usize].centre()));
        let size = centres.size();
        let axis = if size.x >= size.y.max(size.z) {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let key = |i: &u32| boxes[*i as usize].centre()[axis];
        let half = parts.len() / 2;
        parts.select_nth_unstable_by(half, |a, b| key(a).total_cmp(&key(b)));
        let (left, right) = parts.split_at_mut(half);
        build(boxes, left, first, nodes);
        build(boxes, right, first + half, nodes);
    }
    nodes[at].skip = nodes.len() as u32;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn visits_exactly_what_a_plain_search_would() {
        let boxes: Vec<Aabb> = (0..50)
            .map(|i| {
                let at = Vec3::new(f64::from(i * 7 % 11), f64::from(i * 5 % 13), f64::from(i * 3 % 17));
                Aabb::new(at, at + Vec3::splat(0.75))
            })
            .collect();
        let tree = Tree::new(&boxes);
        for k in 0..40 {
            let dir = Vec3::new(1.0, 0.1 * f64::from(k % 5), -0.2 + 0.1 * f64::from(k % 7)).normalize();
            let ray = Ray::new(Vec3::new(-2.0, 0.3 * f64::from(k), 4.0), dir);
            let mut found = [false; 50];
            tree.visit_ray(&ray, (0.0, 1e7), |i| {
                found[i] = true;
                (0.0, 1e7)
            });
            for (i, b) in boxes.iter().enumerate() {
                assert!(found[i] || b.hit(&ray).is_none(), "part {i} lost");
            }
            let p = boxes[k as usize].centre();
            let mut mine = false;
            tree.visit_point(p, |i| mine |= i == k as usize);
            assert!(mine);
        }
        assert!(Tree::new(&[]).bounds().is_empty());
    }
}
