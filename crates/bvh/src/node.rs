//! The wide node: eight children's boxes side by side.

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
    const LEAF: u32 = 1 << 31;

    pub(crate) fn inner(index: usize) -> Self {
        Child(index as u32)
    }

    /// `count` is in `1..=MAX_LEAF`, `start` below 2^28.
    pub(crate) fn leaf(start: usize, count: usize) -> Self {
        Child(Self::LEAF | (start as u32) << 3 | (count as u32 - 1))
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

/// Eight boxes and what they hold. `sides[axis]` are the lower sides, `sides[axis + 3]` the upper ones. Unused places
/// have a box that nothing touches.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(crate) struct Node {
    pub(crate) sides: [[f32; WIDTH]; 6],
    pub(crate) children: [Child; WIDTH],
}

impl Node {
    pub(crate) const EMPTY: Node = Node {
        sides: [
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
        ],
        children: [Child(0); WIDTH],
    };
}
