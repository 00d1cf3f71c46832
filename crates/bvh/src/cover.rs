//! A few boxes around everything.
use raggio_math::Aabb;

use crate::node::{Kind, Node};
use crate::{BoxRow, Bvh};

/// A box, and what is in it.
type Part = (Aabb, Kind);

impl BoxRow {
    /// All its boxes.
    pub fn cover(&self) -> Vec<Aabb> {
        self.node.children().map(|(_, b)| b).collect()
    }
}

impl Bvh {
    /// At most so many boxes, eight or more, in which all primitives lie: those of the nodes at the top, the largest
    /// opened first.
    pub fn cover(&self, most: usize) -> Vec<Aabb> {
        let mut parts = self.nodes.first().map_or_else(Vec::new, children);
        while let Some((place, node)) = largest(&parts) {
            let below = children(&self.nodes[node]);
            if parts.len() - 1 + below.len() > most {
                break;
            }
            parts.swap_remove(place);
            parts.extend(below);
        }
        parts.into_iter().map(|(b, _)| b).collect()
    }
}

/// The place of the largest box that can be opened, and its node.
fn largest(parts: &[Part]) -> Option<(usize, usize)> {
    let nodes = parts.iter().enumerate().filter_map(|(place, (b, kind))| match kind {
        Kind::Inner(node) => Some((b.half_area(), place, *node)),
        Kind::Leaf(_) => None,
    });
    nodes.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place, node)| (place, node))
}

fn children(node: &Node) -> Vec<Part> {
    node.children().map(|(i, b)| (b, node.child(i).kind())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::Vec3;

    #[test]
    fn every_box_lies_in_one_of_the_cover() {
        let at = |i: usize| (Vec3::new(7.0, 5.0, 3.0) * (i as f64 * 0.61)).map(|x| x.sin() * 9.0);
        let boxes: Vec<Aabb> = (0..500).map(|i| Aabb { min: at(i), max: at(i) + 0.3 }).collect();
        let within = |b: &Aabb, cover: &[Aabb]| cover.iter().any(|c| c.contains(b.min) && c.contains(b.max));
        let bvh = Bvh::build(&boxes, 1).bvh;
        for most in [8, 16, 40] {
            let cover = bvh.cover(most);
            assert!(cover.len() <= most && 2 * cover.len() > most, "{} of {most}", cover.len());
            assert!(boxes.iter().all(|b| within(b, &cover)));
        }
        let few = BoxRow::new(&boxes[..5]).cover();
        assert!(few.len() == 5 && boxes[..5].iter().all(|b| within(b, &few)));
        assert!(Bvh::build(&[], 1).bvh.cover(8).is_empty());
    }
}
