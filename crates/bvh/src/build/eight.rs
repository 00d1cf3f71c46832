//! The builder of trees over boxes: the surface area heuristic, splitting straight into eight children.
//!
//! Each node starts as one run of primitives and splits the child with the largest area until it has eight, after Wald,
//! Benthin, Boulos: "Getting Rid of Packets" (2008). Of a large tree the top is made first, then what hangs below it in
//! parts, from the last one to the first, so that the memory of primitives that have found their place can be given
//! back on the way. Threads share the work and change nothing of the result.
use rayon::prelude::*;

use super::bins::{Bins, split};
use super::boxes::Runs;
use super::prims::{Prim, Run};
use super::{BATCH, LARGE, PARTS, SMALL, Tree, append};
use crate::node::{Child, Node, WIDTH};

/// Deeper subtrees are cut in the middle, which halves them at each level.
const SAH_DEPTH: usize = 32;
/// Depth bound: the part cut by the heuristic and the part cut in the middle.
pub(crate) const MAX_DEPTH: usize = SAH_DEPTH + 32;

/// The upper part of a large tree.
enum Top {
    Node(Vec<(Run, Top)>),
    /// What is built later, at this depth.
    Part(usize),
}

/// A part that waits: its primitives and depth, and the node and the place there that it belongs to.
struct Waiting {
    run: Run,
    depth: usize,
    node: usize,
    slot: usize,
}

/// Builds trees whose leaves are runs of primitives.
pub(super) struct Builder {
    /// Most primitives that may share a leaf.
    pub(super) size: usize,
}

impl Builder {
    /// A tree over primitives, none without primitives.
    pub(super) fn build(&self, mut prims: Vec<Prim>) -> Tree<u32> {
        let mut tree = Tree::EMPTY;
        let all = Run::of(&prims);
        if prims.len() >= LARGE {
            self.large(prims, all, &mut tree);
        } else if !prims.is_empty() {
            self.reserve(prims.len(), &mut tree);
            self.node(&mut prims, &all, 0, &mut tree);
            tree.nodes.shrink_to_fit();
            tree.leaves.shrink_to_fit();
        }
        tree
    }

    /// Makes room for more nodes than are needed. Of large lists what is not written takes no memory, and cutting it off
    /// might copy the rest.
    fn reserve(&self, count: usize, tree: &mut Tree<u32>) {
        tree.reserve(count / (2 * self.size) + 1, count);
    }

    /// Does a run become a leaf?
    fn is_leaf(&self, run: &Run) -> bool {
        run.len <= self.size
    }

    /// The child word for a run: a leaf, or a node built below.
    fn child(&self, prims: &mut [Prim], run: &Run, depth: usize, tree: &mut Tree<u32>) -> u32 {
        match self.is_leaf(run) {
            true => leaf(prims, &mut tree.leaves),
            false => self.node(prims, run, depth, tree),
        }
    }

    fn node(&self, mut prims: &mut [Prim], run: &Run, depth: usize, tree: &mut Tree<u32>) -> u32 {
        let (children, count) = self.open(prims, run, depth);
        let index = tree.nodes.len();
        tree.nodes.push(Node::EMPTY);
        for (i, child) in children[..count].iter().enumerate() {
            let (own, rest) = prims.split_at_mut(child.len);
            prims = rest;
            let slot = rank(&children[..count], i);
            let word = self.child(own, child, depth + 1, tree);
            set(&mut tree.nodes[index], slot, child, word);
        }
        index as u32
    }

    /// Builds a large tree, and gives the memory of `prims` back on the way.
    fn large(&self, mut prims: Vec<Prim>, all: Run, tree: &mut Tree<u32>) {
        self.reserve(all.len, tree);
        let limit = all.len.div_ceil(PARTS).max(SMALL);
        let top = self.top(&mut prims, &all, 0, limit);
        let mut waiting = Vec::new();
        place(top, &mut tree.nodes, &mut waiting);
        // Kept from batch to batch: fresh memory would have to be cleared for each.
        let mut parts: Vec<Tree<u32>> = (0..BATCH).map(|_| Tree::EMPTY).collect();
        while !waiting.is_empty() {
            let batch = waiting.split_off(waiting.len().saturating_sub(BATCH));
            let start = prims.len() - batch.iter().map(|part| part.run.len).sum::<usize>();
            let mut rest = &mut prims[start..];
            let mut work = Vec::new();
            for part in batch {
                let (own, others) = rest.split_at_mut(part.run.len);
                work.push((own, part));
                rest = others;
            }
            let built: Vec<(u32, Waiting)> = work
                .into_par_iter()
                .zip(&mut parts)
                .map(|((own, part), below)| (self.child(own, &part.run, part.depth, below), part))
                .collect();
            for ((root, part), below) in built.into_iter().zip(&mut parts) {
                let by = tree.leaves.len();
                tree.leaves.append(&mut below.leaves);
                let moved = |word| Child::from_word(word).moved(by).word();
                let word = append(&mut tree.nodes, &mut below.nodes, root, moved);
                set(&mut tree.nodes[part.node], part.slot, &part.run, word);
            }
            prims.truncate(start);
            prims.shrink_to_fit();
        }
    }

    /// Cuts a run into up to eight, which lie one behind the other: always the one that is most likely to be hit.
    fn open(&self, prims: &mut [Prim], run: &Run, depth: usize) -> ([Run; WIDTH], usize) {
        let mut children = [*run; WIDTH];
        if prims.len() <= WIDTH {
            // Of primitives that a ray enters at one place the first is then asked first.
            prims.sort_unstable_by_key(Prim::number);
            for (prim, child) in prims.chunks(1).zip(&mut children) {
                *child = Run::of(prim);
            }
            return (children, prims.len());
        }
        let mut bins = Bins::EMPTY;
        let mut count = 1;
        while count < WIDTH {
            let area = |i: usize| children[i].bounds.half_area();
            let inner = (0..count).filter(|&i| !self.is_leaf(&children[i]));
            let Some(i) = inner.max_by(|&a, &b| area(a).total_cmp(&area(b))) else { break };
            let start: usize = children[..i].iter().map(|child| child.len).sum();
            let own = &mut prims[start..start + children[i].len];
            let halves = split::<Runs>(own, &children[i], depth < SAH_DEPTH, &mut bins);
            children.copy_within(i + 1..count, i + 2);
            (children[i], children[i + 1]) = halves;
            count += 1;
        }
        (children, count)
    }

    /// The part of a tree above runs of at most `limit`.
    fn top(&self, mut prims: &mut [Prim], run: &Run, depth: usize, limit: usize) -> Top {
        if run.len <= limit {
            return Top::Part(depth);
        }
        let (children, count) = self.open(prims, run, depth);
        let mut work = Vec::new();
        for child in &children[..count] {
            let (own, rest) = prims.split_at_mut(child.len);
            work.push((own, *child));
            prims = rest;
        }
        Top::Node(
            work.into_par_iter()
                .map(|(own, child)| (child, self.top(own, &child, depth + 1, limit)))
                .collect(),
        )
    }
}

/// The place of the `i`-th child of a node: those that hold least come first.
fn rank(children: &[Run], i: usize) -> usize {
    let size = |j: usize| (children[j].len, j);
    (0..children.len()).filter(|&j| size(j) < size(i)).count()
}

/// Appends a leaf and returns its child word.
fn leaf(prims: &[Prim], leaves: &mut Vec<u32>) -> u32 {
    let start = leaves.len();
    leaves.extend(prims.iter().map(Prim::number));
    Child::leaf(start, prims.len()).word()
}

/// Makes the nodes of the upper part, and lists what waits, in the order of the primitives. Returns the root's word.
fn place(top: Top, nodes: &mut Vec<Node>, waiting: &mut Vec<Waiting>) -> u32 {
    let Top::Node(children) = top else { return Child::LEAF };
    let index = nodes.len();
    nodes.push(Node::EMPTY);
    let runs: Vec<Run> = children.iter().map(|(run, _)| *run).collect();
    for (i, (run, below)) in children.into_iter().enumerate() {
        let slot = rank(&runs, i);
        match below {
            Top::Part(depth) => waiting.push(Waiting { run, depth, node: index, slot }),
            below => {
                let word = place(below, nodes, waiting);
                set(&mut nodes[index], slot, &run, word);
            }
        }
    }
    index as u32
}

fn set(node: &mut Node, slot: usize, run: &Run, word: u32) {
    node.child[slot] = word;
    node.set_bounds(slot, &run.bounds);
}
