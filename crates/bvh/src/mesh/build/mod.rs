//! The builder: the surface area heuristic, splitting straight into eight children.
//!
//! Each node starts as one run of triangles and splits the child with the largest area until it has eight, after Wald,
//! Benthin, Boulos: "Getting Rid of Packets" (2008). Of a large mesh the top is made first, then what hangs below it in
//! parts, from the last one to the first, so that the memory of triangles that have found their place can be given back
//! on the way. Threads share the work and change nothing of the result.
mod bins;

use raggio_math::Aabb;
use rayon::prelude::*;

use super::{Block, LANES, LEAF, Node};
use bins::{Prim, Run, split};

/// Deeper subtrees are cut in the middle, which halves them at each level.
const SAH_DEPTH: usize = 32;
/// Depth bound: the part cut by the heuristic and the part cut in the middle.
pub(crate) const MAX_DEPTH: usize = SAH_DEPTH + 32;
/// Smaller meshes are built at once.
const LARGE: usize = 1 << 17;
/// A large mesh is built in about this many parts, or more.
const PARTS: usize = 256;
/// Parts that are built side by side before their memory is given back.
const BATCH: usize = 8;

type V3 = [f32; 3];

/// Nodes and blocks in the making, or a part of them.
#[derive(Default)]
pub(super) struct Tree {
    pub(super) nodes: Vec<Node>,
    pub(super) blocks: Vec<Block>,
    pub(super) root: u32,
}

/// The upper part of a large tree.
enum Top {
    Node(Vec<(Run, Top)>),
    /// What is built later, at this depth.
    Part(usize),
}

/// A part that waits: its triangles and depth, and the node and the place there that it belongs to.
struct Waiting {
    run: Run,
    depth: usize,
    node: usize,
    slot: usize,
}

struct Builder<'a> {
    vertices: &'a [V3],
    triangles: &'a [[u32; 3]],
}

/// A tree over triangles, and a box around them.
pub(super) fn build(vertices: &[V3], triangles: &[[u32; 3]]) -> (Tree, Aabb) {
    let builder = Builder { vertices, triangles };
    let prim = |(i, t): (usize, &[u32; 3])| Prim::new(builder.corners(t), i as u32);
    let mut prims: Vec<Prim> = match triangles.len() < LARGE {
        true => triangles.iter().enumerate().map(prim).collect(),
        false => triangles.par_iter().enumerate().map(prim).collect(),
    };
    let mut tree = Tree::default();
    if prims.is_empty() {
        tree.nodes.push(EMPTY_NODE);
        return (tree, Aabb::EMPTY);
    }
    // More than are needed. Of large lists what is not written takes no memory, and cutting it off might copy the rest.
    tree.nodes.reserve(prims.len() / 8 + 1);
    tree.blocks.reserve(prims.len() / 2 + 1);
    let all = Run::of(&prims);
    if prims.len() < LARGE {
        tree.root = builder.child(&mut prims, &all, 0, &mut tree);
        tree.nodes.shrink_to_fit();
        tree.blocks.shrink_to_fit();
    } else {
        builder.large(prims, all, &mut tree);
    }
    (tree, all.bounds.aabb())
}

impl Builder<'_> {
    fn corners(&self, triangle: &[u32; 3]) -> [V3; 3] {
        let [a, b, c] = *triangle;
        [self.vertices[a as usize], self.vertices[b as usize], self.vertices[c as usize]]
    }

    /// The child word for a run: a leaf, or a node built below.
    fn child(&self, prims: &mut [Prim], run: &Run, depth: usize, tree: &mut Tree) -> u32 {
        if run.len <= LANES { self.leaf(prims, tree) } else { self.node(prims, run, depth, tree) }
    }

    fn leaf(&self, prims: &[Prim], tree: &mut Tree) -> u32 {
        let mut block = Block { corner: [[[f32::NAN; LANES]; 3]; 3], triangle: [u32::MAX; LANES] };
        for (lane, prim) in prims.iter().enumerate() {
            block.triangle[lane] = prim.triangle();
            for (k, corner) in self.corners(&self.triangles[prim.triangle() as usize]).iter().enumerate() {
                for (row, &value) in block.corner[k].iter_mut().zip(corner) {
                    row[lane] = value;
                }
            }
        }
        tree.blocks.push(block);
        LEAF | (tree.blocks.len() - 1) as u32
    }

    fn node(&self, mut prims: &mut [Prim], run: &Run, depth: usize, tree: &mut Tree) -> u32 {
        let (children, count) = open(prims, run, depth);
        let index = tree.nodes.len();
        tree.nodes.push(EMPTY_NODE);
        for (i, child) in children[..count].iter().enumerate() {
            let (own, rest) = prims.split_at_mut(child.len);
            prims = rest;
            // The smallest first: rays that seek just any hit take children as they come.
            let before = |(j, other): &(usize, &Run)| (other.len, *j) < (child.len, i);
            let slot = children[..count].iter().enumerate().filter(before).count();
            let word = self.child(own, child, depth + 1, tree);
            tree.nodes[index].set(slot, child, word);
        }
        index as u32
    }

    /// Builds a large tree, and gives the memory of `prims` back on the way.
    fn large(&self, mut prims: Vec<Prim>, all: Run, tree: &mut Tree) {
        let limit = all.len.div_ceil(PARTS);
        let top = top(&mut prims, &all, 0, limit);
        let mut waiting = Vec::new();
        tree.root = place(top, tree, &mut waiting);
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
            let built: Vec<(Tree, Waiting)> = work
                .into_par_iter()
                .map(|(own, part)| {
                    let mut below = Tree::default();
                    below.root = self.child(own, &part.run, part.depth, &mut below);
                    (below, part)
                })
                .collect();
            for (below, part) in built {
                let word = tree.append(below);
                tree.nodes[part.node].set(part.slot, &part.run, word);
            }
            prims.truncate(start);
            prims.shrink_to_fit();
        }
    }
}

/// Cuts a run into up to eight, which lie one behind the other: always the one that is most likely to be hit.
fn open(prims: &mut [Prim], run: &Run, depth: usize) -> ([Run; 8], usize) {
    let mut children = [*run; 8];
    let mut count = 1;
    while count < 8 {
        let largest = (0..count)
            .filter(|&i| children[i].len > LANES)
            .max_by(|&a, &b| children[a].bounds.half_area().total_cmp(&children[b].bounds.half_area()));
        let Some(i) = largest else { break };
        let start: usize = children[..i].iter().map(|child| child.len).sum();
        let own = &mut prims[start..start + children[i].len];
        let (left, right) = split(own, &children[i], depth < SAH_DEPTH);
        children.copy_within(i + 1..count, i + 2);
        (children[i], children[i + 1]) = (left, right);
        count += 1;
    }
    (children, count)
}

/// The part of a tree above runs of at most `limit`.
fn top(mut prims: &mut [Prim], run: &Run, depth: usize, limit: usize) -> Top {
    if run.len <= limit {
        return Top::Part(depth);
    }
    let (children, count) = open(prims, run, depth);
    let mut work = Vec::new();
    for child in &children[..count] {
        let (own, rest) = prims.split_at_mut(child.len);
        work.push((own, *child));
        prims = rest;
    }
    Top::Node(work.into_par_iter().map(|(own, child)| (child, top(own, &child, depth + 1, limit))).collect())
}

/// Makes the nodes of the upper part, and lists what waits, in the order of the triangles.
fn place(top: Top, tree: &mut Tree, waiting: &mut Vec<Waiting>) -> u32 {
    let Top::Node(children) = top else { return LEAF };
    let index = tree.nodes.len();
    tree.nodes.push(EMPTY_NODE);
    for (slot, (run, below)) in children.into_iter().enumerate() {
        match below {
            Top::Part(depth) => waiting.push(Waiting { run, depth, node: index, slot }),
            below => {
                let word = place(below, tree, waiting);
                tree.nodes[index].set(slot, &run, word);
            }
        }
    }
    index as u32
}

impl Tree {
    /// Adds another tree and returns the word of its root.
    fn append(&mut self, mut other: Tree) -> u32 {
        let (nodes, blocks) = (self.nodes.len() as u32, self.blocks.len() as u32);
        let moved = |word: u32| if word & LEAF == 0 { word + nodes } else { word + blocks };
        for word in other.nodes.iter_mut().flat_map(|node| &mut node.child) {
            *word = moved(*word);
        }
        self.nodes.append(&mut other.nodes);
        self.blocks.append(&mut other.blocks);
        moved(other.root)
    }
}

impl Node {
    fn set(&mut self, slot: usize, run: &Run, word: u32) {
        self.child[slot] = word;
        for axis in 0..3 {
            self.bounds[axis][slot] = run.bounds.lo[axis];
            self.bounds[axis + 3][slot] = run.bounds.hi[axis];
        }
    }
}

const EMPTY_NODE: Node = Node {
    bounds: [
        [f32::INFINITY; 8],
        [f32::INFINITY; 8],
        [f32::INFINITY; 8],
        [f32::NEG_INFINITY; 8],
        [f32::NEG_INFINITY; 8],
        [f32::NEG_INFINITY; 8],
    ],
    child: [LEAF; 8],
};
