//! The tree in the making, with two children a node: cut from above by the surface area heuristic.
use super::bins::{Bins, split};
use super::prims::{Bounds, Prim, Run};
use super::{LARGE, Leaves, SAH_DEPTH};

/// Marks what has no parent, and leaves by their first child.
pub(super) const NONE: u32 = u32::MAX;

/// Where the root is.
pub(super) const ROOT: u32 = 0;

/// A node of the binary tree.
#[derive(Clone, Copy)]
pub(super) struct Branch {
    pub(super) bounds: Bounds,
    /// [`NONE`] in leaves.
    pub(super) children: [u32; 2],
    pub(super) parent: u32,
    /// Primitives below.
    pub(super) len: u32,
    /// Where its primitives begin, if it stands where it was cut.
    pub(super) start: u32,
    /// Its place in the list of leaves, if it is one that is not cut further.
    pub(super) leaf: u32,
    /// Levels below.
    pub(super) height: u32,
    /// How it is best opened, see [`super::collapse`].
    pub(super) shares: u32,
}

impl Branch {
    fn new(run: &Run, start: usize) -> Branch {
        let (children, parent) = ([NONE; 2], NONE);
        let (len, start) = (run.len as u32, start as u32);
        Branch { bounds: run.bounds, children, parent, len, start, leaf: NONE, height: 0, shares: 0 }
    }

    #[inline(always)]
    pub(super) fn is_leaf(&self) -> bool {
        self.children[0] == NONE
    }

    #[inline(always)]
    pub(super) fn area(&self) -> f32 {
        self.bounds.half_area()
    }
}

/// A binary tree over a list of primitives.
pub(super) struct Binary {
    pub(super) nodes: Vec<Branch>,
}

/// What is cut how far.
pub(super) struct Cutter<'a, L> {
    pub(super) kind: &'a L,
    /// Runs of so many primitives stay as they are; otherwise all is cut until it fits into leaves.
    pub(super) limit: usize,
}

/// A part of the tree in the making.
struct Part<T> {
    nodes: Vec<Branch>,
    leaves: Vec<T>,
    bins: Bins,
}

impl<L: Leaves> Cutter<'_, L> {
    /// Cuts a list of primitives, and appends the leaves as it comes to them. `depth` is what lies above; the tree takes the
    /// place of another that is wanted no more.
    pub(super) fn tree(
        &self,
        prims: &mut [Prim],
        depth: usize,
        other: Binary,
        leaves: &mut Vec<L::Leaf>,
    ) -> Binary {
        let mut part = Part { nodes: other.nodes, leaves: std::mem::take(leaves), bins: Bins::EMPTY };
        part.nodes.clear();
        part.nodes.reserve(2 * self.kind.room(prims.len()));
        self.cut(prims, &Run::of(prims), 0, depth, &mut part);
        *leaves = part.leaves;
        let mut tree = Binary { nodes: part.nodes };
        for i in 0..tree.nodes.len() {
            for child in tree.nodes[i].children.into_iter().filter(|&child| child != NONE) {
                tree.nodes[child as usize].parent = i as u32;
            }
        }
        tree
    }

    /// The leaf of a run that is not cut further.
    fn leaf(&self, prims: &[Prim]) -> Option<L::Leaf> {
        if prims.len() <= self.kind.size() { self.kind.leaf(prims) } else { None }
    }

    /// Appends the tree over a run that begins at `start`, and says where it is.
    fn cut(
        &self,
        prims: &mut [Prim],
        run: &Run,
        start: usize,
        depth: usize,
        part: &mut Part<L::Leaf>,
    ) -> u32 {
        let index = part.nodes.len();
        part.nodes.push(Branch::new(run, start));
        if run.len <= self.limit {
            return index as u32;
        }
        if let Some(leaf) = self.leaf(prims) {
            part.nodes[index].leaf = part.leaves.len() as u32;
            part.leaves.push(leaf);
            return index as u32;
        }
        let (left, right) = split::<L>(prims, run, depth < SAH_DEPTH, &mut part.bins);
        let (first, second) = prims.split_at_mut(left.len);
        let (middle, depth) = (start + left.len, depth + 1);
        // Fresh memory takes long to get: a thread that works alone keeps to one part.
        let children = if run.len < LARGE || rayon::current_num_threads() == 1 {
            let a = self.cut(first, &left, start, depth, part);
            [a, self.cut(second, &right, middle, depth, part)]
        } else {
            let mut other = Part::NONE;
            other.nodes.reserve(2 * self.kind.room(right.len));
            let (a, b) = rayon::join(
                || self.cut(first, &left, start, depth, part),
                || self.cut(second, &right, middle, depth, &mut other),
            );
            [a, part.append(other, b)]
        };
        let height = children.map(|child| part.nodes[child as usize].height).into_iter().max();
        part.nodes[index].children = children;
        part.nodes[index].height = 1 + height.unwrap_or(0);
        index as u32
    }
}

impl<T> Part<T> {
    const NONE: Part<T> = Part { nodes: Vec::new(), leaves: Vec::new(), bins: Bins::EMPTY };

    /// Takes all of another part, and says where its root is now.
    fn append(&mut self, mut other: Part<T>, root: u32) -> u32 {
        let (nodes, leaves) = (self.nodes.len() as u32, self.leaves.len() as u32);
        self.nodes.extend(other.nodes.into_iter().map(|mut node| {
            let moved = |place: u32, by: u32| if place == NONE { NONE } else { place + by };
            node.children = node.children.map(|child| moved(child, nodes));
            node.leaf = moved(node.leaf, leaves);
            node
        }));
        self.leaves.append(&mut other.leaves);
        root + nodes
    }
}

impl Binary {
    pub(super) const NONE: Binary = Binary { nodes: Vec::new() };

    /// Ready to be written down: nodes are moved, and how they are best opened is known. `depth` is what lies above.
    pub(super) fn improved(mut self, depth: usize) -> Binary {
        self.reinsert(depth);
        self.price(ROOT);
        self
    }

    #[inline(always)]
    pub(super) fn node(&self, i: u32) -> &Branch {
        &self.nodes[i as usize]
    }

    /// The other child of the parent.
    #[inline(always)]
    pub(super) fn sibling(&self, i: u32) -> u32 {
        let [a, b] = self.node(self.node(i).parent).children;
        if a == i { b } else { a }
    }

    /// Puts a node into the place of another.
    pub(super) fn replace(&mut self, old: u32, new: u32) {
        let parent = self.node(old).parent;
        self.nodes[new as usize].parent = parent;
        if parent != NONE {
            let children = &mut self.nodes[parent as usize].children;
            children[usize::from(children[1] == old)] = new;
        }
    }

    /// Brings a node, and all above it, up to what is below.
    pub(super) fn refit(&mut self, mut i: u32) {
        while i != NONE {
            let [a, b] = self.node(i).children.map(|child| *self.node(child));
            let node = &mut self.nodes[i as usize];
            node.bounds = a.bounds.joined(&b.bounds);
            node.len = a.len + b.len;
            node.height = 1 + a.height.max(b.height);
            i = node.parent;
        }
    }
}
