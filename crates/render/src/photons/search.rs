//! The search for the nearest photons: blocks of eight that lie together, and boxes around eight of them or of boxes,
//! each eight looked at with one instruction per step where the processor can.
//!
//! What lies within the radius is written down as it comes; the nearest are picked out at the end, and now and then
//! when too much has come together. The radius of the search before tells about how far to look.
use std::hint::black_box;

use raggio_math::{Vec3, Wide, wide};

use crate::packed::{Lanes, Place, Tree, Visitor, WIDTH, around, below, each};

/// On surfaces, squared distances grow by so much for each unit of the way from the tangent plane.
const FLATTENING: f32 = 16.0;

/// Up to eight photons that follow each other in the map.
#[derive(Clone, Default)]
struct Block {
    p: [Lanes; 3],
    /// The number of the first.
    first: u32,
    /// Which of them POV-Ray's search may pass over, and where they begin among all such.
    shy: u8,
    first_shy: u32,
}

/// Where photons are.
#[derive(Default)]
pub(super) struct Index {
    blocks: Vec<Block>,
    tree: Tree,
    /// The photons that POV-Ray's search may pass over: their number, and the axis and place of the plane before them.
    shy: Vec<(u32, u8, f32)>,
}

/// The nearest photons of a search.
#[derive(Default)]
pub struct Nearest {
    /// Squared distance in the upper half, as a number that sorts like it, and the photon's number in the lower one; and
    /// room for more.
    found: Vec<u64>,
    /// How many there are.
    count: usize,
    /// Beyond it (squared) nothing counts.
    limit: f32,
    max: usize,
    /// Were there more than fit?
    full: bool,
}

impl Index {
    /// For the photons at these places, in the order of a balanced tree, of which some are shy.
    pub fn new(places: &[[f32; 3]], shy: Vec<(u32, u8, f32)>) -> Index {
        let mut depth = 0;
        // A block takes up the photon before its range as well.
        while places.len() >> depth >= WIDTH {
            depth += 1;
        }
        let mut blocks = Vec::with_capacity(1 << depth);
        cut(places, 0, (0, places.len()), depth, &mut blocks);
        for (i, &(number, ..)) in shy.iter().enumerate().rev() {
            let block = blocks.partition_point(|b| b.first <= number) - 1;
            let block = &mut blocks[block];
            block.shy |= 1 << (number - block.first);
            block.first_shy = i as u32;
        }
        let tree = Tree::new(blocks.iter().map(|b| around(&b.p, &b.p)).collect());
        Index { blocks, tree, shy }
    }
}

/// Cuts a range of the tree into blocks where the tree does. A block begins at `first`, which is the range's start or the
/// photon before it.
fn cut(places: &[[f32; 3]], first: usize, (s, e): (usize, usize), depth: u32, blocks: &mut Vec<Block>) {
    if depth == 0 || s == e {
        blocks.push(Block::new(first, &places[first..e]));
        return;
    }
    let mid = (s + e - 1) / 2;
    cut(places, first, (s, mid), depth - 1, blocks);
    cut(places, mid, (mid + 1, e), depth - 1, blocks);
}

/// One way through the boxes for all photons within the limit.
struct Look<'a> {
    index: &'a Index,
    p: Vec3,
    place: &'a Place,
    /// Flattens the search on surfaces.
    normal: Option<[f32; 3]>,
    /// For rounding.
    slack: f32,
    nearest: &'a mut Nearest,
}

impl Wide for Look<'_> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let (index, place) = (self.index, self.place);
        index.tree.walk(place, &mut self);
    }
}

impl Visitor for Look<'_> {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.nearest.limit
    }

    /// By how far the boxes are from the tangent plane at least.
    #[inline(always)]
    fn stretch(&self, low: &[Lanes; 3], high: &[Lanes; 3], squares: &mut Lanes) {
        let Some(n) = self.normal else { return };
        let (mut least, mut most) = ([0.0; WIDTH], [0.0; WIDTH]);
        for k in 0..3 {
            let (a, b) = (each(|i| n[k] * low[k][i]), each(|i| n[k] * high[k][i]));
            for i in 0..WIDTH {
                least[i] += if a[i] < b[i] { a[i] } else { b[i] };
                most[i] += if a[i] > b[i] { a[i] } else { b[i] };
            }
        }
        for (i, square) in squares.iter_mut().enumerate() {
            let away = if least[i] > -most[i] { least[i] } else { -most[i] };
            let away = away - self.slack;
            *square *= 1.0 + FLATTENING * if away > 0.0 { away } else { 0.0 };
        }
    }

    /// Writes down which of a block count.
    #[inline(always)]
    fn visit(&mut self, block: usize) {
        let block = &self.index.blocks[block];
        let squares = block.squares(self.place, self.normal);
        let limit = self.nearest.limit;
        let within = below(&squares, &[limit; WIDTH]);
        if within == 0 {
            return;
        }
        let mut near = [0; WIDTH];
        for (i, near) in near.iter_mut().enumerate() {
            *near = u32::from(squares[i] < limit);
        }
        // Kept together by `black_box`: what the compiler sees going separate ways it takes apart.
        let mut near = black_box(near);
        if within & block.shy != 0 {
            self.forget_hidden(block, within & block.shy, &mut near);
        }
        self.nearest.note(&near, &squares, block.first);
    }
}

impl Look<'_> {
    /// Takes out what of some shy photons POV-Ray does not find.
    #[inline(never)]
    fn forget_hidden(&self, block: &Block, doubtful: u8, near: &mut [u32; WIDTH]) {
        let hidden = self.hidden(block, doubtful);
        for (i, near) in near.iter_mut().enumerate() {
            *near &= !u32::from(hidden >> i & 1);
        }
    }

    /// Which of some shy photons POV-Ray does not find: those on the wrong side of a plane that is too far away.
    #[cold]
    fn hidden(&self, block: &Block, doubtful: u8) -> u8 {
        let (first, last) = (block.first, block.first + WIDTH as u32);
        let shy = self.index.shy[block.first_shy as usize..].iter().take_while(|s| s.0 < last);
        let mut hidden = 0;
        for &(number, axis, plane) in shy {
            let offset = self.p[usize::from(axis)] - f64::from(plane);
            if offset < 0.0 && offset * offset >= f64::from(self.nearest.limit) {
                hidden |= 1 << (number - first);
            }
        }
        hidden & doubtful
    }
}

impl Block {
    fn new(first: usize, places: &[[f32; 3]]) -> Block {
        let lane = |k: usize| std::array::from_fn(|i| places.get(i).map_or(f32::NAN, |p| p[k]));
        Block { p: [lane(0), lane(1), lane(2)], first: first as u32, ..Block::default() }
    }

    /// Squared distances; they grow away from the tangent plane on surfaces.
    #[inline(always)]
    fn squares(&self, place: &Place, normal: Option<[f32; 3]>) -> Lanes {
        let [x, y, z] = place.to(&self.p);
        let squares = each(|i| x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        match normal {
            Some(n) => {
                each(|i| squares[i] * (1.0 + FLATTENING * (n[0] * x[i] + n[1] * y[i] + n[2] * z[i]).abs()))
            }
            None => squares,
        }
    }
}

impl Nearest {
    /// Finds the nearest photons within a radius, at most `max`; distances on surfaces, which have a normal, grow away
    /// from the tangent plane. `likely` is how far they are thought to reach; only speed depends on it, and it is told
    /// how far they do reach.
    pub(super) fn search(
        &mut self,
        index: &Index,
        (p, normal): (Vec3, Option<Vec3>),
        radius: f64,
        max: usize,
        likely: &mut f64,
    ) {
        let (place, flat) = (Place::new(p), normal.map(|n| n.as_vec3().to_array()));
        let whole = (radius * radius) as f32;
        // A little more room, so that it mostly is enough.
        let mut limit = whole.min((1.25 * *likely * *likely) as f32);
        self.max = max;
        self.found.resize(2 * max + 8 * WIDTH, 0);
        loop {
            self.count = 0;
            self.full = false;
            self.limit = limit;
            let slack = 1e-5 * radius as f32;
            wide(Look { index, p, place: &place, normal: flat, slack, nearest: self });
            if self.count > max {
                self.thin_out();
            }
            if self.full || limit >= whole {
                break;
            }
            limit = whole.min(3.0 * limit);
        }
        *likely = self.radius(f64::INFINITY);
    }

    /// Writes down some of the eight photons from a number on. All are written, and those that do not count written over.
    #[inline(always)]
    fn note(&mut self, near: &[u32; WIDTH], squares: &Lanes, first: u32) {
        let mut keys = [0; WIDTH];
        for (i, key) in keys.iter_mut().enumerate() {
            *key = (u64::from(squares[i].to_bits()) << 32) | u64::from(first.wrapping_add(i as u32));
        }
        let keys = black_box(keys);
        let Some(room) = self.found.get_mut(self.count..).and_then(|rest| rest.first_chunk_mut::<WIDTH>())
        else {
            return;
        };
        let mut noted = 0;
        for (i, &key) in keys.iter().enumerate() {
            room[noted % WIDTH] = key;
            noted += near[i] as usize;
        }
        self.count += noted;
        if self.count + WIDTH > self.found.len() {
            self.thin_out();
        }
    }

    /// Keeps the nearest, as many as are wanted.
    fn thin_out(&mut self) {
        let (_, &mut last, _) = self.found[..self.count].select_nth_unstable(self.max - 1);
        self.count = self.max;
        self.limit = f32::from_bits((last >> 32) as u32);
        self.full = true;
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// The numbers of the photons found.
    pub fn numbers(&self) -> impl Iterator<Item = u32> {
        self.found[..self.count].iter().map(|&key| key as u32)
    }

    /// The radius that the photons found fill.
    pub fn radius(&self, asked: f64) -> f64 {
        if self.full { f64::from(self.limit).sqrt() } else { asked }
    }
}
