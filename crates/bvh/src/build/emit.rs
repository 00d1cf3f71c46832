//! The nodes and leaves of the tree, written down from the binary one.
use rayon::prelude::*;

use super::binary::{Binary, ROOT};
use super::bins::Prim;
use super::{BATCH, LARGE, Leaves, PARTS, SMALL, Tree};
use crate::node::{Child, Node};

/// What is written down later: a binary node, and the node and the place there that it belongs to.
pub(super) struct Waiting {
    pub(super) binary: u32,
    node: usize,
    slot: usize,
}

impl Waiting {
    /// Tells the parent where it is.
    pub(super) fn arrived<T>(&self, tree: &mut Tree<T>, word: u32) {
        tree.nodes[self.node].child[self.slot] = word;
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
pub(super) struct Writer<'a, L> {
    kind: &'a L,
    binary: &'a Binary,
    prims: &'a [Prim],
    later: Later,
}

impl<'a, L: Leaves> Writer<'a, L> {
    /// Appends all of it to a tree. Of a large one the top comes first, then what hangs below it in parts, by all threads.
    /// Returns the root's word.
    pub(super) fn all(kind: &'a L, binary: &'a Binary, prims: &'a [Prim], tree: &mut Tree<L::Leaf>) -> u32 {
        let later = match prims.len() < LARGE {
            true => Later::Nothing,
            false => Later::Parts(prims.len().div_ceil(PARTS).max(SMALL)),
        };
        let top = Writer { kind, binary, prims, later };
        let mut waiting = Vec::new();
        let root = top.node(ROOT, tree, &mut waiting);
        // Kept from batch to batch: fresh memory would have to be cleared for each.
        let mut parts: Vec<Tree<L::Leaf>> = (0..BATCH).map(|_| Tree::EMPTY).collect();
        let part = Writer { later: Later::Nothing, ..top };
        for batch in waiting.chunks(BATCH) {
            let work = batch.par_iter().zip(&mut parts);
            let roots: Vec<u32> =
                work.map(|(at, below)| part.node(at.binary, below, &mut Vec::new())).collect();
            for ((at, below), root) in batch.iter().zip(&mut parts).zip(roots) {
                let word = tree.append(below, root, L::moved);
                at.arrived(tree, word);
            }
        }
        root
    }

    /// Appends all but the leaves, and lists these.
    pub(super) fn top(kind: &'a L, binary: &'a Binary, tree: &mut Tree<L::Leaf>) -> Vec<Waiting> {
        let mut waiting = Vec::new();
        Writer { kind, binary, prims: &[], later: Later::Leaves }.node(ROOT, tree, &mut waiting);
        waiting
    }

    /// Appends a node with what is below it, and lists what is not written down at once.
    fn node(&self, i: u32, tree: &mut Tree<L::Leaf>, waiting: &mut Vec<Waiting>) -> u32 {
        let index = tree.nodes.len();
        tree.nodes.push(Node::EMPTY);
        let opened = self.binary.cheapest(i);
        for (at, &child) in opened.children().iter().enumerate() {
            let (slot, branch) = (self.rank(opened.children(), at), self.binary.node(child));
            tree.nodes[index].set_bounds(slot, &branch.bounds);
            let later = match self.later {
                Later::Nothing => false,
                Later::Leaves => branch.is_leaf(),
                Later::Parts(most) => !branch.is_leaf() && branch.len as usize <= most,
            };
            tree.nodes[index].child[slot] = if later {
                waiting.push(Waiting { binary: child, node: index, slot });
                Child::LEAF
            } else if branch.is_leaf() {
                self.kind.add(&self.prims[branch.range()], &mut tree.leaves)
            } else {
                self.node(child, tree, waiting)
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
