//! Large nodes are taken out of the binary tree and put where they make the least surface, after Bittner, Hapala, Havran:
//! "Fast Insertion-Based Optimization of Bounding Volume Hierarchies" (2013). Cuts from above put large triangles among
//! small ones, where they make all nodes on the way large.
use super::MESH_DEPTH;
use super::binary::{Binary, NONE, ROOT};
use super::prims::Bounds;

/// How often the largest nodes are gone through: where one has left there may be room for another.
const ROUNDS: usize = 3;
/// One in so many nodes is large.
const SHARE: usize = 50;
/// What a move has to gain, as a share of the root's area.
const LEAST: f32 = 1e-6;

/// The best place that a search has found.
struct Best {
    gain: f32,
    place: u32,
}

impl Binary {
    /// Moves nodes so that rays meet fewer. `depth` is what lies above the tree.
    pub(super) fn reinsert(&mut self, depth: usize) {
        // What is too large for its area to be told stays as it was cut.
        if !self.node(ROOT).area().is_finite() {
            return;
        }
        let mut waiting = Vec::new();
        let largest = self.largest();
        for _ in 0..ROUNDS {
            for &node in &largest {
                self.improve(node, depth, &mut waiting);
            }
        }
    }

    /// The nodes with the largest boxes, the root aside.
    fn largest(&self) -> Vec<u32> {
        let mut nodes: Vec<(f32, u32)> =
            (1..self.nodes.len() as u32).map(|i| (self.node(i).area(), i)).collect();
        let count = nodes.len().div_ceil(SHARE);
        let order = |a: &(f32, u32), b: &(f32, u32)| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1));
        if count < nodes.len() {
            nodes.select_nth_unstable_by(count, order);
            nodes.truncate(count);
        }
        nodes.sort_unstable_by(order);
        nodes.into_iter().map(|(_, i)| i).collect()
    }

    /// Moves a node to its best place, if there is one that is better.
    fn improve(&mut self, node: u32, depth: usize, waiting: &mut Vec<(f32, u32)>) {
        let parent = self.node(node).parent;
        let above = self.node(parent).parent;
        let place = if above == NONE { NONE } else { self.best_place(node, waiting) };
        if place == NONE {
            return;
        }
        // Those who go through the tree keep what waits in room for so many levels.
        let height = self.node(node).height.max(self.node(place).height) as usize;
        if depth + self.depth(place) + 1 + height > MESH_DEPTH {
            return;
        }
        // The sibling takes the parent's place, and the parent goes with the node.
        self.replace(parent, self.sibling(node));
        self.refit(above);
        self.replace(place, parent);
        self.nodes[parent as usize].children = [place, node];
        self.nodes[place as usize].parent = parent;
        self.refit(parent);
    }

    /// How many nodes lie above one.
    pub(super) fn depth(&self, i: u32) -> usize {
        let above = |i: &u32| Some(self.node(*i).parent).filter(|&parent| parent != NONE);
        std::iter::successors(above(&i), above).count()
    }

    /// Beside which node another makes the least surface, [`NONE`] if it is well where it is. The search goes up, and
    /// from each node on the way down the other side.
    fn best_place(&self, node: u32, waiting: &mut Vec<(f32, u32)>) -> u32 {
        let own = self.node(node).bounds;
        let mut best = Best { gain: LEAST * self.node(ROOT).area(), place: NONE };
        let mut from = node;
        let mut pivot = self.node(node).parent;
        // The node's parent goes.
        let mut gain = self.node(pivot).area();
        let mut rest = Bounds::EMPTY;
        loop {
            let side = self.sibling(from);
            self.descend(side, gain, &own, &mut best, waiting);
            rest.grow(&self.node(side).bounds);
            (from, pivot) = (pivot, self.node(pivot).parent);
            if pivot == NONE {
                return best.place;
            }
            if from != self.node(node).parent {
                // Outside of what was gone through, that gets smaller.
                gain += self.node(from).area() - rest.half_area();
                best.offer(gain - rest.joined(&own).half_area(), from);
            }
        }
    }

    /// Looks for the best place in the tree below `top`, where leaving has gained so much.
    fn descend(&self, top: u32, gain: f32, own: &Bounds, best: &mut Best, waiting: &mut Vec<(f32, u32)>) {
        let least = own.half_area();
        waiting.push((gain, top));
        while let Some((gain, i)) = waiting.pop() {
            if gain - least <= best.gain {
                continue;
            }
            let node = self.node(i);
            let both = node.bounds.joined(own).half_area();
            best.offer(gain - both, i);
            // Below, this one grows.
            let gain = gain - (both - node.area());
            if !node.is_leaf() && gain - least > best.gain {
                waiting.extend(node.children.map(|child| (gain, child)));
            }
        }
    }
}

impl Best {
    #[inline(always)]
    fn offer(&mut self, gain: f32, place: u32) {
        if gain > self.gain {
            *self = Best { gain, place };
        }
    }
}
