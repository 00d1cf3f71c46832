//! The builder of both trees: the surface area heuristic, splitting straight into eight children.
//!
//! Each node starts as one run of primitives and splits the child with the largest area until it has eight, after Wald,
//! Benthin, Boulos: "Getting Rid of Packets" (2008). Of a large tree the top is made first, then what hangs below it in
//! parts, from the last one to the first, so that the memory of primitives that have found their place can be given
//! back on the way. Threads share the work and change nothing of the result.
mod bins;
mod boxes;
mod pages;

use rayon::prelude::*;

use crate::node::{Child, Node, WIDTH};
pub(crate) use bins::{Bounds, Prim};
use bins::{Run, split};
pub use boxes::Built;

/// Deeper subtrees are cut in the middle, which halves them at each level.
const SAH_DEPTH: usize = 32;
/// Depth bound: the part cut by the heuristic and the part cut in the middle.
pub(crate) const MAX_DEPTH: usize = SAH_DEPTH + 32;
/// Smaller trees are built at once.
pub(crate) const LARGE: usize = 1 << 14;
/// A large tree is built in about this many parts or more, unless they would be smaller than [`SMALL`].
const PARTS: usize = 256;
const SMALL: usize = 1 << 10;
/// Runs of fewer full leaves are at the bottom of a tree.
const BOTTOM: usize = 50;
/// Runs of at most so many full leaves become a node of leaves.
const NODE: usize = 6;
/// A child with more than this share of a run's area is large.
const LARGE_PART: f32 = 0.4;
/// Parts that are built side by side before their memory is given back.
const BATCH: usize = 8;

/// The leaves of a tree: what is kept of their primitives.
pub(crate) trait Leaves: Sync {
    /// What the tree's list of leaves is made of.
    type Leaf: Send;
    /// Bins along an axis for the shortest runs; at most 8.
    const FEWEST_BINS: usize;

    /// Is a leaf of one as good as any? Otherwise it had better be full.
    const ALONE: bool;

    /// Does the child that holds least come last in a node? Otherwise it comes first.
    const SMALLEST_LAST: bool;

    /// Most primitives that may share a leaf.
    fn size(&self) -> usize;

    /// How long the list of leaves becomes at most, or nearly always, for so many primitives.
    fn room(&self, count: usize) -> usize;

    /// What asking so many primitives costs.
    fn cost(count: u32) -> f32;

    /// Is there room in a leaf for all of these? There always is for two.
    fn fits(&self, prims: &[Prim]) -> bool;

    /// Appends a leaf and returns its child word.
    fn add(&self, prims: &[Prim], leaves: &mut Vec<Self::Leaf>) -> u32;

    /// The word of a leaf before which `by` others have been put.
    fn moved(word: u32, by: usize) -> u32;
}

/// Nodes and leaves in the making, or a part of them. The root is the first node.
pub(crate) struct Tree<T> {
    pub(crate) nodes: Vec<Node>,
    pub(crate) leaves: Vec<T>,
}

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

struct Builder<'a, L: Leaves> {
    kind: &'a L,
    /// See [`Leaves::size`].
    size: usize,
}

/// A tree over primitives (none without primitives), and a box around them.
pub(crate) fn build<L: Leaves>(kind: &L, mut prims: Vec<Prim>) -> (Tree<L::Leaf>, Bounds) {
    let mut tree = Tree::EMPTY;
    let builder = Builder { kind, size: kind.size() };
    let all = builder.judged(&prims, Run::of(&prims));
    if prims.len() >= LARGE {
        builder.large(prims, all, &mut tree);
    } else if !prims.is_empty() {
        builder.reserve(prims.len(), &mut tree);
        builder.node(&mut prims, &all, 0, &mut tree);
        tree.nodes.shrink_to_fit();
        tree.leaves.shrink_to_fit();
    }
    (tree, all.bounds)
}

impl<L: Leaves> Builder<'_, L> {
    /// Makes room for more than is needed. Of large lists what is not written takes no memory, and cutting it off might
    /// copy the rest.
    fn reserve(&self, count: usize, tree: &mut Tree<L::Leaf>) {
        tree.nodes.reserve(count / (2 * self.size) + 1);
        tree.leaves.reserve(self.kind.room(count));
        pages::ask_for_large(&tree.nodes);
        pages::ask_for_large(&tree.leaves);
    }

    /// A run of which is known whether it may become a leaf.
    fn judged(&self, prims: &[Prim], mut run: Run) -> Run {
        run.leaf = run.len <= self.size && self.kind.fits(prims);
        run
    }

    /// The child word for a run: a leaf, or a node built below.
    fn child(&self, prims: &mut [Prim], run: &Run, depth: usize, tree: &mut Tree<L::Leaf>) -> u32 {
        match run.leaf {
            true => self.kind.add(prims, &mut tree.leaves),
            false => self.node(prims, run, depth, tree),
        }
    }

    fn node(&self, mut prims: &mut [Prim], run: &Run, depth: usize, tree: &mut Tree<L::Leaf>) -> u32 {
        let (children, count) = self.open(prims, run, depth);
        let index = tree.nodes.len();
        tree.nodes.push(Node::EMPTY);
        for (i, child) in children[..count].iter().enumerate() {
            let (own, rest) = prims.split_at_mut(child.len);
            prims = rest;
            let slot = rank::<L>(&children[..count], i);
            let word = self.child(own, child, depth + 1, tree);
            set(&mut tree.nodes[index], slot, child, word);
        }
        index as u32
    }

    /// Builds a large tree, and gives the memory of `prims` back on the way.
    fn large(&self, mut prims: Vec<Prim>, all: Run, tree: &mut Tree<L::Leaf>) {
        self.reserve(all.len, tree);
        let limit = all.len.div_ceil(PARTS).max(SMALL);
        let top = self.top(&mut prims, &all, 0, limit);
        let mut waiting = Vec::new();
        place::<L>(top, &mut tree.nodes, &mut waiting);
        // Kept from batch to batch: fresh memory would have to be cleared for each.
        let mut parts: Vec<Tree<L::Leaf>> = (0..BATCH).map(|_| Tree::EMPTY).collect();
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
                let word = tree.append::<L>(below, root);
                set(&mut tree.nodes[part.node], part.slot, &part.run, word);
            }
            prims.truncate(start);
            prims.shrink_to_fit();
        }
    }

    /// Cuts a run into up to eight, which lie one behind the other: always the one that is most likely to be hit.
    fn open(&self, prims: &mut [Prim], run: &Run, depth: usize) -> ([Run; WIDTH], usize) {
        let mut children = [*run; WIDTH];
        if L::ALONE && prims.len() <= WIDTH {
            // Of primitives that a ray enters at one place the first is then asked first.
            prims.sort_unstable_by_key(Prim::number);
            for (prim, child) in prims.chunks(1).zip(&mut children) {
                *child = self.judged(prim, Run::of(prim));
            }
            return (children, prims.len());
        }
        let mut count = 1;
        while count < WIDTH {
            let Some(i) = self.next(run, &children[..count]) else { break };
            let start: usize = children[..i].iter().map(|child| child.len).sum();
            let own = &mut prims[start..start + children[i].len];
            let (left, right) = split::<L>(own, &children[i], depth < SAH_DEPTH);
            children.copy_within(i + 1..count, i + 2);
            let (first, second) = own.split_at(left.len);
            (children[i], children[i + 1]) = (self.judged(first, left), self.judged(second, right));
            count += 1;
        }
        (children, count)
    }

    /// The child to cut next. At the bottom of the tree a child that can become a node of leaves stays whole, unless it
    /// is large or all its leaves find a place: two nodes with few leaves each take more room, and more time.
    fn next(&self, run: &Run, children: &[Run]) -> Option<usize> {
        let area = |i: usize| children[i].bounds.half_area();
        let bottom = !L::ALONE && children.len() > 1 && run.len < BOTTOM * self.size;
        let node = |i: usize| {
            bottom && children[i].len <= NODE * self.size && area(i) < LARGE_PART * run.bounds.half_area()
        };
        let places = (self.size - 1) * (WIDTH + 1 - children.len());
        (0..children.len())
            .filter(|&i| !(children[i].leaf || node(i) && children[i].len > places))
            .max_by(|&a, &b| node(b).cmp(&node(a)).then(area(a).total_cmp(&area(b))))
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

/// The place of the `i`-th child of a node, by how much the children hold.
fn rank<L: Leaves>(children: &[Run], i: usize) -> usize {
    let size = |j: usize| (children[j].len, j);
    let smaller = (0..children.len()).filter(|&j| size(j) < size(i)).count();
    if L::SMALLEST_LAST { children.len() - 1 - smaller } else { smaller }
}

/// Makes the nodes of the upper part, and lists what waits, in the order of the primitives. Returns the root's word.
fn place<L: Leaves>(top: Top, nodes: &mut Vec<Node>, waiting: &mut Vec<Waiting>) -> u32 {
    let Top::Node(children) = top else { return Child::LEAF };
    let index = nodes.len();
    nodes.push(Node::EMPTY);
    let runs: Vec<Run> = children.iter().map(|(run, _)| *run).collect();
    for (i, (run, below)) in children.into_iter().enumerate() {
        let slot = rank::<L>(&runs, i);
        match below {
            Top::Part(depth) => waiting.push(Waiting { run, depth, node: index, slot }),
            below => {
                let word = place::<L>(below, nodes, waiting);
                set(&mut nodes[index], slot, &run, word);
            }
        }
    }
    index as u32
}

impl<T> Tree<T> {
    const EMPTY: Tree<T> = Tree { nodes: Vec::new(), leaves: Vec::new() };

    /// Takes all of another tree, leaving that its memory, and returns the word of its root.
    fn append<L: Leaves<Leaf = T>>(&mut self, other: &mut Tree<T>, root: u32) -> u32 {
        let (nodes, leaves) = (self.nodes.len() as u32, self.leaves.len());
        let moved = |word: u32| if word & Child::LEAF == 0 { word + nodes } else { L::moved(word, leaves) };
        for word in other.nodes.iter_mut().flat_map(|node| &mut node.child) {
            *word = moved(*word);
        }
        self.nodes.append(&mut other.nodes);
        self.leaves.append(&mut other.leaves);
        moved(root)
    }
}

fn set(node: &mut Node, slot: usize, run: &Run, word: u32) {
    node.child[slot] = word;
    node.set_bounds(slot, &run.bounds);
}
