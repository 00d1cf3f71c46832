//! How the binary tree becomes one with eight children a node.
//!
//! The cheapest way is found by dynamic programming, after Ylitie, Karras, Laine: "Efficient Incoherent Ray Traversal on
//! GPUs Through Compressed Wide BVHs" (2017): for each binary node, what all nodes below it cost where it takes one to eight
//! places in its parent.
use super::binary::Binary;
use crate::node::WIDTH;

/// What the nodes below a binary node cost where it takes at most so many places; the first is not looked at.
type Costs = [f32; WIDTH + 1];

/// Bits of a share: how many of a number of places the first child takes. 0 where the node had better take one place.
const BITS: usize = 4;

/// The children of a node of the tree, in the order of their primitives.
pub(super) struct Opened {
    list: [u32; WIDTH],
    len: usize,
}

impl Opened {
    const NONE: Opened = Opened { list: [0; WIDTH], len: 0 };

    fn push(&mut self, i: u32) {
        self.list[self.len] = i;
        self.len += 1;
    }

    pub(super) fn children(&self) -> &[u32] {
        &self.list[..self.len]
    }
}

impl Binary {
    /// Finds the cheapest way to open the tree below a node. Each node costs its surface; what leaves cost is the same in
    /// any way.
    pub(super) fn price(&mut self, i: u32) -> Costs {
        let node = *self.node(i);
        if node.is_leaf() {
            return [0.0; WIDTH + 1];
        }
        if node.height == 1 {
            // Most nodes: two leaves, which want two places.
            self.nodes[i as usize].shares = (0..WIDTH - 1).fold(0, |all, at| all | 1 << (BITS * at));
            let mut costs = [0.0; WIDTH + 1];
            costs[1] = node.area();
            return costs;
        }
        let [first, second] = node.children.map(|child| self.price(child));
        let mut costs = [f32::INFINITY; WIDTH + 1];
        let mut shares = [0; WIDTH + 1];
        for places in 2..=WIDTH {
            (costs[places], shares[places]) = (first[1] + second[places - 1], 1);
            for share in 2..places {
                let cost = first[share] + second[places - share];
                if cost < costs[places] {
                    (costs[places], shares[places]) = (cost, share as u32);
                }
            }
        }
        let closed = costs[WIDTH] + node.area();
        for places in 1..WIDTH {
            if closed <= costs[places] {
                (costs[places], shares[places]) = (closed, 0);
            }
        }
        self.nodes[i as usize].shares =
            (2..=WIDTH).fold(0, |all, places| all | shares[places] << (BITS * (places - 2)));
        costs
    }

    /// The children of a node in the cheapest way.
    pub(super) fn cheapest(&self, i: u32) -> Opened {
        let mut opened = Opened::NONE;
        self.gather(i, WIDTH, &mut opened);
        opened
    }

    fn gather(&self, i: u32, places: usize, opened: &mut Opened) {
        let node = self.node(i);
        let share =
            if places < 2 { 0 } else { (node.shares >> (BITS * (places - 2))) as usize & ((1 << BITS) - 1) };
        if share == 0 {
            return opened.push(i);
        }
        let [first, second] = node.children;
        self.gather(first, share, opened);
        self.gather(second, places - share, opened);
    }
}
