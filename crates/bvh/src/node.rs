//! The wide node: eight children's boxes side by side.
use raggio_math::{Aabb, Vec3};

use crate::build::Bounds;

/// Children per node.
pub(crate) const WIDTH: usize = 8;

/// Most primitives that one leaf can hold.
pub(crate) const MAX_LEAF: usize = 8;

/// A child: the index of an inner node, or a run of primitives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Child(u32);

/// What a [`Child`] stands for.
pub(crate) enum Kind {
    Inner(usize),
    Leaf(std::ops::Range<usize>),
}

impl Child {
    /// Marks the word of a leaf.
    pub(crate) const LEAF: u32 = 1 << 31;

    pub(crate) fn inner(index: usize) -> Self {
        Child(index as u32)
    }

    /// `count` is in `1..=MAX_LEAF`, `start` below 2^28.
    pub(crate) fn leaf(start: usize, count: usize) -> Self {
        Child(Self::LEAF | (start as u32) << 3 | (count as u32 - 1))
    }

    /// A leaf whose run has moved up by so many primitives.
    pub(crate) fn moved(self, by: usize) -> Self {
        Child(self.0 + ((by as u32) << 3))
    }

    /// The child as a number.
    #[inline(always)]
    pub(crate) fn word(self) -> u32 {
        self.0
    }

    /// From [`Child::word`].
    #[inline(always)]
    pub(crate) fn from_word(word: u32) -> Self {
        Child(word)
    }

    #[inline(always)]
    pub(crate) fn kind(self) -> Kind {
        if self.0 & Self::LEAF == 0 {
            return Kind::Inner(self.0 as usize);
        }
        let start = (self.0 & !Self::LEAF) as usize >> 3;
        Kind::Leaf(start..start + (self.0 & 7) as usize + 1)
    }
}

/// Eight boxes and what they hold. Unused places have a box that nothing touches.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct Node {
    /// Least corners, one row an axis, then greatest corners: rows 0..3 and 3..6.
    pub(crate) bounds: [[f32; WIDTH]; 6],
    /// Indices of nodes, or what each kind of tree marks with [`Child::LEAF`].
    pub(crate) child: [u32; WIDTH],
}

impl Node {
    pub(crate) const EMPTY: Node = Node {
        bounds: [
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
        ],
        child: [Child::LEAF; WIDTH],
    };

    /// The box of a place.
    pub(crate) fn child_box(&self, i: usize) -> Aabb {
        let corner = |first: usize| Vec3::from([0, 1, 2].map(|k| f64::from(self.bounds[first + k][i])));
        Aabb { min: corner(0), max: corner(3) }
    }

    /// The places that are in use, with their boxes.
    pub(crate) fn children(&self) -> impl Iterator<Item = (usize, Aabb)> + '_ {
        (0..WIDTH).map(|i| (i, self.child_box(i))).filter(|(_, b)| !b.is_empty())
    }

    /// A box around all of it.
    pub(crate) fn bounds(&self) -> Bounds {
        let least = |row: &[f32; WIDTH]| row.iter().copied().fold(f32::INFINITY, f32::min);
        let most = |row: &[f32; WIDTH]| row.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let [a, b, c, d, e, f] = &self.bounds;
        Bounds { lo: [least(a), least(b), least(c), 0.0], hi: [most(d), most(e), most(f), 0.0] }
    }

    /// Gives a place its box.
    pub(crate) fn set_bounds(&mut self, place: usize, bounds: &Bounds) {
        for axis in 0..3 {
            self.bounds[axis][place] = bounds.lo[axis];
            self.bounds[axis + 3][place] = bounds.hi[axis];
        }
    }

    /// A child in a tree over boxes.
    #[inline(always)]
    pub(crate) fn child(&self, place: usize) -> Child {
        Child(self.child[place])
    }
}
