//! The tree in the making, with two children a node: cut from above by the surface area heuristic.
use super::bins::{Bins, Bounds, Prim, Run, split};
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
    /// Levels below.
    pub(super) height: u32,
    /// How it is best opened, see [`super::collapse`].
    pub(super) shares: u32,
}

impl Branch {
    fn new(run: &Run, start: usize) -> Branch {
        let (children, parent) = ([NONE; 2], NONE);
        let (len, start) = (run.len as u32, start as u32);
        Branch { bounds: run.bounds, children, parent, len, start, height: 0, shares: 0 }
    }

    #[inline(always)]
    pub(super) fn is_leaf(&self) -> bool {
        self.children[0] == NONE
    }

    #[inline(always)]
    pub(super) fn area(&self) -> f32 {
        self.bounds.half_area()
    }

    /// Where its primitives are, if it stands where it was cut.
    pub(super) fn range(&self) -> std::ops::Range<usize> {
        self.start as usize..(self.start + self.len) as usize
    }
}

/// A binary tree over a list of primitives.
pub(super) struct Binary {
    pub(super) nodes: Vec<Branch>,
}

/// What is cut how far.
pub(super) struct Cutter<'a, L> {
    pub(super) kind: &'a L,
    /// Runs of so many primitives, and what may become a leaf of the tree, become leaves.
    pub(super) limit: usize,
}

impl<L: Leaves> Cutter<'_, L> {
    /// Cuts a list of primitives, which is put in the order of the leaves. `depth` is what lies above.
    pub(super) fn tree(&self, prims: &mut [Prim], depth: usize) -> Binary {
        let run = self.judged(prims, Run::of(prims));
        let mut tree = Binary { nodes: self.apart(prims, &run, 0, depth) };
        for i in 0..tree.nodes.len() {
            for child in tree.nodes[i].children.into_iter().filter(|&child| child != NONE) {
                tree.nodes[child as usize].parent = i as u32;
            }
        }
        tree
    }

    /// The tree over a run that begins at `start`, in a list of its own.
    fn apart(&self, prims: &mut [Prim], run: &Run, start: usize, depth: usize) -> Vec<Branch> {
        let mut nodes = Vec::with_capacity(2 * self.kind.room(run.len));
        self.cut(prims, run, start, depth, &mut nodes, &mut Bins::EMPTY.clone());
        nodes
    }

    /// A run of which is known whether it may become a leaf.
    fn judged(&self, prims: &[Prim], mut run: Run) -> Run {
        let fits = || run.len <= self.kind.size() && self.kind.fits(prims);
        run.leaf = run.len <= self.limit || fits();
        run
    }

    /// Appends the tree over a run that begins at `start`, and says where it is.
    fn cut(
        &self,
        prims: &mut [Prim],
        run: &Run,
        start: usize,
        depth: usize,
        nodes: &mut Vec<Branch>,
        bins: &mut Bins,
    ) -> u32 {
        let index = nodes.len();
        nodes.push(Branch::new(run, start));
        if run.leaf {
            return index as u32;
        }
        let (left, right) = split::<L>(prims, run, depth < SAH_DEPTH, bins);
        let (first, second) = prims.split_at_mut(left.len);
        let (left, right) = (self.judged(first, left), self.judged(second, right));
        let (middle, depth) = (start + left.len, depth + 1);
        let children = if run.len < LARGE {
            let a = self.cut(first, &left, start, depth, nodes, bins);
            [a, self.cut(second, &right, middle, depth, nodes, bins)]
        } else {
            let (a, b) = rayon::join(
                || self.cut(first, &left, start, depth, nodes, bins),
                || self.apart(second, &right, middle, depth),
            );
            [a, append(nodes, b)]
        };
        let height = children.map(|child| nodes[child as usize].height).into_iter().max();
        nodes[index].children = children;
        nodes[index].height = 1 + height.unwrap_or(0);
        index as u32
    }
}

/// Appends a tree of its own, and says where its root is.
fn append(nodes: &mut Vec<Branch>, other: Vec<Branch>) -> u32 {
    let root = nodes.len() as u32;
    nodes.extend(other.into_iter().map(|mut node| {
        if !node.is_leaf() {
            node.children = node.children.map(|child| child + root);
        }
        node
    }));
    root
}

impl Binary {
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
