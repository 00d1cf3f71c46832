//! The leaves: blocks of a few triangles. Those of most meshes share their corners, which are kept once, so that six of
//! them take two lines of the processor's cache. Where triangles hang together nowhere, four keep their corners each.

use raggio_math::wide;

use super::corners::{Corners, Points};
use crate::build::Bounds;

/// Most triangles in a shared block. Six that hang together edge by edge have eight points at most.
const SHARED: usize = 6;

/// Triangles in a loose block.
const LOOSE: usize = 4;

/// Points in a block.
pub(crate) const POINTS: usize = 8;

/// Most corners of the triangles in a block of any kind.
pub(crate) const MOST_CORNERS: usize = 3 * SHARED;

/// Most points in a block of any kind.
#[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
pub(crate) const MOST_POINTS: usize = 3 * LOOSE;

/// How far the third corner of the first four lanes is up in its word, and that of the last two in theirs.
pub(crate) const THIRD: u32 = 18;

/// A leaf.
pub(crate) trait Block: Copy + Send + Sync {
    /// Most triangles.
    const LANES: usize;
    /// Most points that are corners.
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    const POINTS: usize;
    /// Is it a [`Loose`] one? Otherwise it is [`Shared`].
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    const LOOSE: bool;
    /// What visiting a node costs, in tests of a block.
    const NODE_COST: f32;

    /// A block of the triangles given by their index and corners, if there is room for them.
    fn of(triangles: impl Iterator<Item = (u32, [u32; 3])>, vertices: &[[f32; 3]]) -> Option<Self>;

    /// Index of the triangle in a lane; `u32::MAX` in unused lanes.
    fn triangle(&self, lane: usize) -> u32;

    /// Which point is a corner of the triangle in a lane.
    fn corner_point(&self, lane: usize, k: usize) -> usize;

    /// Where a point is.
    fn point(&self, point: usize) -> [f32; 3];

    /// Where a corner of the triangle in a lane is.
    #[inline(always)]
    fn corner(&self, lane: usize, k: usize) -> [f32; 3] {
        self.point(self.corner_point(lane, k))
    }

    /// Moves a corner.
    fn set_corner(&mut self, lane: usize, k: usize, p: [f32; 3]);

    /// The lanes that are in use.
    #[inline(always)]
    fn lanes(&self) -> usize {
        (0..Self::LANES).take_while(|&lane| self.triangle(lane) != u32::MAX).count()
    }

    /// A box around all triangles.
    fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        for (lane, k) in (0..self.lanes()).flat_map(|lane| [(lane, 0), (lane, 1), (lane, 2)]) {
            let [x, y, z] = self.corner(lane, k);
            let p = [x, y, z, 0.0];
            bounds.grow(&Bounds { lo: p, hi: p });
        }
        bounds
    }

    /// Takes new places of the vertices. False where corners that were one point have parted.
    fn refit(&mut self, vertices: &[[f32; 3]], triangles: &[[u32; 3]]) -> bool {
        let all = |block: &Self, each: &mut dyn FnMut(usize, usize, [f32; 3])| {
            for lane in 0..block.lanes() {
                for (k, &vertex) in triangles[block.triangle(lane) as usize].iter().enumerate() {
                    each(lane, k, vertices[vertex as usize]);
                }
            }
        };
        let mut moved = *self;
        all(self, &mut |lane, k, p| moved.set_corner(lane, k, p));
        let mut whole = true;
        all(self, &mut |lane, k, p| whole &= moved.corner(lane, k) == p);
        *self = moved;
        whole
    }
}

/// Up to four triangles with corners of their own; those in unused lanes are not numbers, which no test lets pass.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct Loose {
    /// `corner[k][axis][lane]`
    corner: [[[f32; LOOSE]; 3]; 3],
    triangle: [u32; LOOSE],
}

/// Up to six triangles. Unused lanes have one point for all corners, which no test lets pass.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Shared {
    /// `place[axis][point]`
    place: [[f32; POINTS]; 3],
    triangle: [u32; SHARED],
    /// Which points are corners, three bits each: the first corners of all lanes in the first word, the second ones in
    /// the second, the third ones above them, those of four lanes in the first word and of two in the second.
    pub(super) corner: [u32; 2],
}

impl Block for Loose {
    const LANES: usize = LOOSE;
    const POINTS: usize = MOST_POINTS;
    const LOOSE: bool = true;
    const NODE_COST: f32 = 1.0;

    fn of(triangles: impl Iterator<Item = (u32, [u32; 3])>, vertices: &[[f32; 3]]) -> Option<Loose> {
        let mut block = Loose { corner: [[[f32::NAN; LOOSE]; 3]; 3], triangle: [u32::MAX; LOOSE] };
        for (lane, (triangle, corners)) in triangles.enumerate() {
            block.triangle[lane] = triangle;
            for (k, &vertex) in corners.iter().enumerate() {
                block.set_corner(lane, k, vertices[vertex as usize]);
            }
        }
        Some(block)
    }

    #[inline(always)]
    fn triangle(&self, lane: usize) -> u32 {
        self.triangle[lane & (LOOSE - 1)]
    }

    #[inline(always)]
    fn corner_point(&self, lane: usize, k: usize) -> usize {
        k * LOOSE + lane
    }

    #[inline(always)]
    fn point(&self, point: usize) -> [f32; 3] {
        let [x, y, z] = &self.corner[point / LOOSE];
        let lane = point % LOOSE;
        [x[lane], y[lane], z[lane]]
    }

    fn set_corner(&mut self, lane: usize, k: usize, p: [f32; 3]) {
        for (row, value) in self.corner[k].iter_mut().zip(p) {
            row[lane] = value;
        }
    }
}

impl Block for Shared {
    const LANES: usize = SHARED;
    const POINTS: usize = POINTS;
    const LOOSE: bool = false;
    const NODE_COST: f32 = 2.0;

    /// Corners that lie in one place are one point.
    fn of(triangles: impl Iterator<Item = (u32, [u32; 3])>, vertices: &[[f32; 3]]) -> Option<Shared> {
        let (mut triangle, mut corner) = ([u32::MAX; SHARED], [0; 2]);
        let mut corners = Corners::all_at([0.0; 3]);
        for (lane, (number, vertex)) in triangles.enumerate() {
            if lane == 0 {
                corners = Corners::all_at(vertices[vertex[0] as usize]);
            }
            triangle[lane] = number;
            for k in 0..3 {
                corners.set(3 * lane + k, vertices[vertex[k] as usize]);
            }
        }
        let Points { place, which } = wide(&corners)?;
        for (i, &point) in which.iter().enumerate() {
            let (word, up) = Shared::bits(i / 3, i % 3);
            corner[word] |= u32::from(point) << up;
        }
        Some(Shared { place, triangle, corner })
    }

    #[inline(always)]
    fn triangle(&self, lane: usize) -> u32 {
        self.triangle[lane.min(SHARED - 1)]
    }

    #[inline(always)]
    fn corner_point(&self, lane: usize, k: usize) -> usize {
        let (word, up) = Shared::bits(lane, k);
        (self.corner[word] >> up) as usize & (POINTS - 1)
    }

    #[inline(always)]
    fn point(&self, point: usize) -> [f32; 3] {
        [self.place[0][point], self.place[1][point], self.place[2][point]]
    }

    fn set_corner(&mut self, lane: usize, k: usize, p: [f32; 3]) {
        self.put(self.corner_point(lane, k), p);
    }
}

impl Shared {
    fn put(&mut self, point: usize, p: [f32; 3]) {
        for (row, value) in self.place.iter_mut().zip(p) {
            row[point] = value;
        }
    }

    /// Where a corner of a lane has its bits: the word, and how far up.
    #[inline(always)]
    fn bits(lane: usize, k: usize) -> (usize, u32) {
        match (k, lane) {
            (2, 4..) => (1, THIRD + 3 * (lane as u32 - 4)),
            (2, _) => (0, THIRD + 3 * lane as u32),
            _ => (k, 3 * lane as u32),
        }
    }
}

/// The leaves of a mesh's tree.
#[derive(Debug)]
pub(crate) enum Blocks {
    /// Of triangles that hang together.
    Shared(Vec<Shared>),
    /// Of single ones.
    Loose(Vec<Loose>),
}

/// Does something with the blocks, of whichever kind they are.
macro_rules! with_blocks {
    ($blocks:expr, $list:ident => $then:expr) => {
        match $blocks {
            $crate::mesh::block::Blocks::Shared($list) => $then,
            $crate::mesh::block::Blocks::Loose($list) => $then,
        }
    };
}
