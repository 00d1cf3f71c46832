//! The nodes of the tree, written down from the binary one.
use rayon::prelude::*;

use super::binary::{Binary, ROOT};
use super::{BATCH, LARGE, PARTS, SMALL, append};
use crate::node::{Child, Node};

/// What is written down later: a binary node, and the node and the place there that it belongs to.
pub(super) struct Waiting {
    pub(super) binary: u32,
    node: usize,
    slot: usize,
}

impl Waiting {
    /// Tells the parent where it is.
    pub(super) fn arrived(&self, nodes: &mut [Node], word: u32) {
        nodes[self.node].child[self.slot] = word;
    }
}

/// What of a binary tree is not written down at once.
enum Later {
    Nothing,
    Leaves,
    /// Inner nodes with at most so many primitives.
    Parts(usize),
}

/// Writes a binary tree down.
pub(super) struct Writer<'a> {
    binary: &'a Binary,
    later: Later,
}

impl<'a> Writer<'a> {
    /// Appends all of it. Of a large one the top comes first, then what hangs below it in parts, by all threads. Returns
    /// the root's word.
    pub(super) fn all(binary: &'a Binary, nodes: &mut Vec<Node>) -> u32 {
        let later = match binary.node(ROOT).len as usize {
            ..LARGE => Later::Nothing,
            len => Later::Parts(len.div_ceil(PARTS).max(SMALL)),
        };
        let mut waiting = Vec::new();
        let root = Writer { binary, later }.node(ROOT, nodes, &mut waiting);
        // Kept from batch to batch: fresh memory would have to be cleared for each.
        let mut parts: Vec<Vec<Node>> = (0..BATCH).map(|_| Vec::new()).collect();
        let part = Writer { binary, later: Later::Nothing };
        for batch in waiting.chunks(BATCH) {
            let work = batch.par_iter().zip(&mut parts);
            let roots: Vec<u32> =
                work.map(|(at, below)| part.node(at.binary, below, &mut Vec::new())).collect();
            for ((at, below), root) in batch.iter().zip(&mut parts).zip(roots) {
                let word = append(nodes, below, root, |leaf| leaf);
                at.arrived(nodes, word);
            }
        }
        root
    }

    /// Appends all but the leaves, and lists these.
    pub(super) fn top(binary: &'a Binary, nodes: &mut Vec<Node>) -> Vec<Waiting> {
        let mut waiting = Vec::new();
        Writer { binary, later: Later::Leaves }.node(ROOT, nodes, &mut waiting);
        waiting
    }

    /// Appends a node with what is below it, and lists what is not written down at once.
    fn node(&self, i: u32, nodes: &mut Vec<Node>, waiting: &mut Vec<Waiting>) -> u32 {
        let index = nodes.len();
        nodes.push(Node::EMPTY);
        let opened = self.binary.cheapest(i);
        for (at, &child) in opened.children().iter().enumerate() {
            let (slot, branch) = (self.rank(opened.children(), at), self.binary.node(child));
            nodes[index].set_bounds(slot, &branch.bounds);
            let later = match self.later {
                Later::Nothing => false,
                Later::Leaves => branch.is_leaf(),
                Later::Parts(most) => !branch.is_leaf() && branch.len as usize <= most,
            };
            nodes[index].child[slot] = if later {
                waiting.push(Waiting { binary: child, node: index, slot });
                Child::LEAF
            } else if branch.is_leaf() {
                Child::LEAF | branch.leaf
            } else {
                self.node(child, nodes, waiting)
            };
        }
        index as u32
    }

    /// The place of a child of a node: the one that holds least comes last.
    fn rank(&self, children: &[u32], at: usize) -> usize {
        let size = |at: usize| (self.binary.node(children[at]).len, at);
        (0..children.len()).filter(|&other| size(other) > size(at)).count()
    }
}
