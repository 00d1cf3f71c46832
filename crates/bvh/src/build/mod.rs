//! The builder of meshes' trees; [`eight`] builds those over boxes.
//!
//! Triangles are cut in two again and again by the surface area heuristic. In the binary tree large nodes are then moved
//! to where they disturb least, and of it one with eight children a node is made in which rays meet the fewest nodes. Of
//! a large mesh the top is made first, then what hangs below it in chunks, from the last one to the first, so that the
//! memory of triangles that have found their place can be given back on the way. Threads share the work and change
//! nothing of the result.
mod binary;
mod bins;
mod boxes;
mod collapse;
mod eight;
mod emit;
mod pages;
mod prims;
mod reinsert;

use crate::node::{Child, Node};
use binary::{Binary, Cutter};
pub(crate) use bins::Cost;
pub use boxes::Built;
pub(crate) use eight::MAX_DEPTH as BOXES_DEPTH;
use emit::Writer;
use prims::Run;
pub(crate) use prims::{Bounds, Prim};

/// Deeper subtrees are cut in the middle, which halves them at each level.
const SAH_DEPTH: usize = 64;
/// Depth bound: the part cut by the heuristic and the part cut in the middle.
pub(crate) const MESH_DEPTH: usize = SAH_DEPTH + 32;
/// Smaller trees are built at once.
pub(crate) const LARGE: usize = 1 << 14;
/// Most primitives whose binary tree is kept at a time.
const CHUNK: usize = 1 << 18;
/// A large tree is made in about this many parts or more, unless they would be smaller than [`SMALL`].
const PARTS: usize = 256;
const SMALL: usize = 1 << 10;
/// Parts that are made side by side.
const BATCH: usize = 8;

/// The leaves of a mesh's tree: what is kept of their primitives.
pub(crate) trait Leaves: Cost + Sync {
    /// What the tree's list of leaves is made of.
    type Leaf: Send;

    /// Most primitives that may share a leaf.
    fn size(&self) -> usize;

    /// How long the list of leaves becomes at most, or nearly always, for so many primitives.
    fn room(&self, count: usize) -> usize;

    /// A leaf of all of these, if there is room in one. There always is for two.
    fn leaf(&self, prims: &[Prim]) -> Option<Self::Leaf>;
}

/// Nodes and leaves in the making, or a part of them. The root is the first node.
pub(crate) struct Tree<T> {
    pub(crate) nodes: Vec<Node>,
    pub(crate) leaves: Vec<T>,
}

/// A tree over primitives (none without primitives), and a box around them.
pub(crate) fn build<L: Leaves>(kind: &L, prims: Vec<Prim>) -> (Tree<L::Leaf>, Bounds) {
    build_by(kind, prims, CHUNK)
}

/// [`build`] in chunks of at most so many primitives.
fn build_by<L: Leaves>(kind: &L, mut prims: Vec<Prim>, chunk: usize) -> (Tree<L::Leaf>, Bounds) {
    let mut tree = Tree::EMPTY;
    let all = Run::of(&prims);
    if all.len == 0 {
        return (tree, all.bounds);
    }
    tree.reserve(all.len / (2 * kind.size()) + 1, kind.room(all.len));
    if all.len <= chunk {
        whole(kind, &mut prims, 0, &mut tree, Binary::NONE);
    } else {
        chunks(kind, prims, chunk, &mut tree);
    }
    if all.len < LARGE {
        tree.nodes.shrink_to_fit();
        tree.leaves.shrink_to_fit();
    }
    (tree, all.bounds)
}

/// Appends the tree over some primitives, which lies at this depth. Returns the root's word, and the binary tree, in whose
/// place the next may come: fresh memory takes long to get.
fn whole<L: Leaves>(
    kind: &L,
    prims: &mut [Prim],
    depth: usize,
    tree: &mut Tree<L::Leaf>,
    other: Binary,
) -> (u32, Binary) {
    let binary = Cutter { kind, limit: 0 }.tree(prims, depth, other, &mut tree.leaves).improved(depth);
    (Writer::all(&binary, &mut tree.nodes), binary)
}

/// Builds a large tree, and gives the memory of `prims` back on the way.
fn chunks<L: Leaves>(kind: &L, mut prims: Vec<Prim>, most: usize, tree: &mut Tree<L::Leaf>) {
    let cutter = Cutter { kind, limit: most };
    let top = cutter.tree(&mut prims, 0, Binary::NONE, &mut tree.leaves).improved(0);
    let mut binary = Binary::NONE;
    let mut waiting = Writer::top(&top, &mut tree.nodes);
    waiting.sort_unstable_by_key(|chunk| top.node(chunk.binary).start);
    for chunk in waiting.into_iter().rev() {
        let start = top.node(chunk.binary).start as usize;
        let word;
        (word, binary) = whole(kind, &mut prims[start..], top.depth(chunk.binary), tree, binary);
        chunk.arrived(&mut tree.nodes, word);
        prims.truncate(start);
        prims.shrink_to_fit();
    }
}

impl<T> Tree<T> {
    const EMPTY: Tree<T> = Tree { nodes: Vec::new(), leaves: Vec::new() };

    /// Makes room for so many nodes and leaves. Of large lists what is not written takes no memory, and cutting it off
    /// might copy the rest.
    fn reserve(&mut self, nodes: usize, leaves: usize) {
        self.nodes.reserve(nodes);
        self.leaves.reserve(leaves);
        pages::ask_for_large(&self.nodes);
        pages::ask_for_large(&self.leaves);
    }
}

/// Appends other nodes, leaving these their memory, and returns what has become of the word of their root. `moved` gives
/// the word of a leaf that has moved.
fn append(nodes: &mut Vec<Node>, others: &mut Vec<Node>, root: u32, moved: impl Fn(u32) -> u32) -> u32 {
    let by = nodes.len() as u32;
    let moved = |word: u32| if word & Child::LEAF == 0 { word + by } else { moved(word) };
    for word in others.iter_mut().flat_map(|node| &mut node.child) {
        *word = moved(*word);
    }
    nodes.append(others);
    moved(root)
}

#[cfg(test)]
mod tests;
