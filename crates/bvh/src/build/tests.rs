//! Laws of the meshes' builder, with leaves of two boxes.
use super::binary::{NONE, ROOT};
use super::*;
use crate::node::WIDTH;

struct Pairs;

impl Cost for Pairs {
    const FEWEST_BINS: usize = 4;

    fn cost(count: u32) -> f32 {
        count as f32
    }
}

impl Leaves for Pairs {
    type Leaf = Vec<u32>;

    fn size(&self) -> usize {
        2
    }

    fn room(&self, count: usize) -> usize {
        count
    }

    fn leaf(&self, prims: &[Prim]) -> Option<Vec<u32>> {
        Some(prims.iter().map(Prim::number).collect())
    }
}

/// Small boxes all over the place, with a long one among every five.
fn boxes(count: u32) -> Vec<Prim> {
    let part = |i: u32, share: f64| (f64::from(i) * share).fract() as f32;
    let prim = |i: u32| {
        let centre = [part(i, 0.618_034), part(i, 0.754_878), part(i, 0.569_84)];
        let size =
            [0, 1, 2].map(|k| if i.is_multiple_of(5) && i as usize / 5 % 3 == k { 0.5 } else { 0.003 });
        let corner = |sign: f32| [0, 1, 2, 3].map(|k| if k < 3 { centre[k] + sign * size[k] } else { 0.0 });
        Prim::new(Bounds { lo: corner(-1.0), hi: corner(1.0) }, i)
    };
    (0..count).map(prim).collect()
}

fn within(inner: &Bounds, outer: &Bounds) -> bool {
    (0..3).all(|k| inner.lo[k] >= outer.lo[k] && inner.hi[k] <= outer.hi[k])
}

/// Lists the primitives below a node, all of which lie in its box.
fn list(tree: &Tree<Vec<u32>>, word: u32, depth: usize, found: &mut Vec<u32>) {
    assert!(depth < MESH_DEPTH);
    let (node, all) =
        (&tree.nodes[word as usize], boxes(tree.leaves.iter().map(Vec::len).sum::<usize>() as u32));
    for (slot, _) in node.children() {
        let row = |k: usize| node.bounds[k][slot];
        let own = Bounds { lo: [row(0), row(1), row(2), 0.0], hi: [row(3), row(4), row(5), 0.0] };
        let word = node.child[slot];
        let start = found.len();
        match word & Child::LEAF {
            0 => list(tree, word, depth + 1, found),
            _ => found.extend(&tree.leaves[(word & !Child::LEAF) as usize]),
        }
        assert!(found[start..].iter().all(|&i| within(all[i as usize].bounds(), &own)));
    }
}

#[test]
fn every_primitive_is_in_one_leaf_and_in_all_boxes_above() {
    for (count, chunk) in [(1, 100), (2, 100), (9, 100), (300, 1000), (300, 50), (2500, 5000), (2500, 300)] {
        let (tree, bounds) = build_by(&Pairs, boxes(count), chunk);
        let mut found = Vec::new();
        list(&tree, 0, 0, &mut found);
        found.sort_unstable();
        assert!(found.into_iter().eq(0..count), "{count} {chunk}");
        assert!(within(&tree.nodes[0].bounds(), &bounds));
    }
}

/// One thread alone makes one list of nodes, several make parts of it.
#[test]
#[cfg_attr(miri, ignore = "takes hours there")]
fn the_tree_is_the_same_for_any_number_of_threads() {
    let built = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let (tree, _) = pool.install(|| build_by(&Pairs, boxes(60_000), 50_000));
        let nodes: Vec<_> = tree.nodes.iter().map(|node| (node.bounds, node.child)).collect();
        (nodes, tree.leaves)
    };
    assert!(built(1) == built(3));
}

/// The surface of all inner nodes.
fn surface(tree: &Binary) -> f32 {
    tree.nodes.iter().filter(|node| !node.is_leaf()).map(|node| node.area()).sum()
}

#[test]
fn moved_nodes_make_less_surface_and_leave_a_tree() {
    let mut tree = Cutter { kind: &Pairs, limit: 0 }.tree(&mut boxes(3000), 0, Binary::NONE, &mut Vec::new());
    let before = surface(&tree);
    tree.reinsert(0);
    assert!(surface(&tree) < 0.97 * before, "{} {before}", surface(&tree));
    let mut below = vec![0; tree.nodes.len()];
    for (i, node) in tree.nodes.iter().enumerate().filter(|(_, node)| !node.is_leaf()) {
        let children = node.children.map(|child| *tree.node(child));
        assert!(children.iter().all(|child| child.parent == i as u32 && within(&child.bounds, &node.bounds)));
        assert_eq!(node.len, children[0].len + children[1].len);
        assert_eq!(node.height, 1 + children[0].height.max(children[1].height));
        node.children.iter().for_each(|&child| below[child as usize] += 1);
    }
    assert!(below[0] == 0 && below[1..].iter().all(|&parents| parents == 1));
    assert!(tree.nodes[0].parent == NONE && tree.nodes[0].len == 3000);
}

/// A tree as high as may be grows no higher.
#[test]
fn moves_keep_to_the_bound_of_the_depth() {
    let mut tree = Cutter { kind: &Pairs, limit: 0 }.tree(&mut boxes(3000), 0, Binary::NONE, &mut Vec::new());
    let height = tree.nodes[0].height as usize;
    tree.reinsert(MESH_DEPTH - height);
    assert!(tree.nodes[0].height as usize <= height);
}

/// What the nodes cost of a tree with eight children a node that is made of some of the binary nodes, which are given as
/// bits in the order of their numbers. `None` where a node has more children.
fn cost_of(tree: &Binary, kept: u32) -> Option<f32> {
    if kept & 1 == 0 {
        return None;
    }
    let inner: Vec<u32> = (0..tree.nodes.len() as u32).filter(|&i| !tree.node(i).is_leaf()).collect();
    let is_kept =
        |i: u32| tree.node(i).is_leaf() || kept >> inner.iter().position(|&j| j == i).unwrap() & 1 == 1;
    let mut children = vec![0; tree.nodes.len()];
    for i in (1..tree.nodes.len() as u32).filter(|&i| is_kept(i)) {
        let mut above = tree.node(i).parent;
        while !is_kept(above) {
            above = tree.node(above).parent;
        }
        children[above as usize] += 1;
    }
    let cost = inner.iter().filter(|&&i| is_kept(i)).map(|&i| tree.node(i).area()).sum();
    children.iter().all(|&count| count <= WIDTH).then_some(cost)
}

#[test]
fn no_other_way_to_open_a_tree_is_cheaper() {
    for count in [3, 14, 17, 20, 23] {
        let mut tree =
            Cutter { kind: &Pairs, limit: 0 }.tree(&mut boxes(count), 0, Binary::NONE, &mut Vec::new());
        let inner = tree.nodes.iter().filter(|node| !node.is_leaf()).count();
        assert!(inner < 16);
        let least = (0..1 << inner).filter_map(|kept| cost_of(&tree, kept)).fold(f32::INFINITY, f32::min);
        let price = tree.price(ROOT)[1];
        assert!((price - least).abs() <= 1e-5 * least, "{count}: {price} {least}");
        let mut waiting = vec![ROOT];
        let mut written = 0.0;
        while let Some(i) = waiting.pop() {
            written += tree.node(i).area();
            waiting.extend(tree.cheapest(i).children().iter().filter(|&&child| !tree.node(child).is_leaf()));
        }
        assert!((written - least).abs() <= 1e-5 * least, "{count}: {written} {least}");
    }
}
