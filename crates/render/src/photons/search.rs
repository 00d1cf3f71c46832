//! The search for the nearest photons: blocks of eight that lie together, and boxes around eight of them or of boxes,
//! each eight looked at with one instruction per step where the processor can.
//!
//! What lies within the radius is written down as it comes; the nearest are picked out at the end, and now and then
//! when too much has come together. The radius of the search before tells about how far to look.
use raggio_math::{Vec3, Wide, wide};

/// Photons of a block, and children of a box.
const WIDTH: usize = 8;

/// Levels of boxes over as many photons as can be counted.
const MOST_LEVELS: usize = 11;

/// Numbers for the eight of a block.
type Lanes = [f32; WIDTH];

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

/// The boxes around eight blocks, or eight of these. What is not there is nowhere.
#[derive(Clone)]
struct Boxes {
    low: [Lanes; 3],
    high: [Lanes; 3],
}

/// Where photons are.
#[derive(Default)]
pub(super) struct Index {
    blocks: Vec<Block>,
    /// Boxes around blocks, boxes around eight of these, and so on up to a single one.
    levels: Vec<Vec<Boxes>>,
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

/// A place in two parts, so that differences to places near it are not rounded, and what flattens the search on
/// surfaces.
struct Place {
    coarse: [f32; 3],
    fine: [f32; 3],
    p: Vec3,
    normal: Option<[f32; 3]>,
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
        let mut levels = Vec::new();
        let mut spans: Vec<[[f32; 3]; 2]> = blocks.iter().map(|b| bounds(&b.p, &b.p)).collect();
        while !spans.is_empty() {
            let level: Vec<Boxes> = spans.chunks(WIDTH).map(Boxes::new).collect();
            spans = level.iter().map(|b| bounds(&b.low, &b.high)).collect();
            levels.push(level);
            if spans.len() == 1 {
                break;
            }
        }
        Index { blocks, levels, shy }
    }

    /// Writes down which of a block count.
    #[inline(always)]
    fn take(&self, block: usize, place: &Place, nearest: &mut Nearest) {
        let squares = self.blocks[block].squares(place);
        let mut near = below(&squares, nearest.limit);
        let doubtful = near & self.blocks[block].shy;
        if doubtful != 0 {
            near &= !self.hidden(block, doubtful, place, nearest.limit);
        }
        nearest.note(near, &squares, self.blocks[block].first);
    }

    /// Which of some shy photons POV-Ray does not find: those on the wrong side of a plane that is too far away.
    #[cold]
    fn hidden(&self, block: usize, doubtful: u8, place: &Place, limit: f32) -> u8 {
        let Block { first, first_shy, .. } = self.blocks[block];
        let mut hidden = 0;
        for &(number, axis, plane) in
            self.shy[first_shy as usize..].iter().take_while(|s| s.0 < first + WIDTH as u32)
        {
            let offset = place.p[usize::from(axis)] - f64::from(plane);
            if offset < 0.0 && offset * offset >= f64::from(limit) {
                hidden |= 1 << (number - first);
            }
        }
        hidden & doubtful
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
    place: &'a Place,
    nearest: &'a mut Nearest,
}

impl Wide for Look<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Look { index, place, nearest } = self;
        let Some(top) = index.levels.len().checked_sub(1) else { return };
        // What is left to do: at each level the number of the boxes, and which of them.
        let mut open = [(0, 0); MOST_LEVELS];
        let mut level = top;
        open[level] = (0, index.levels[level][0].near(place, nearest.limit));
        loop {
            let (number, near) = &mut open[level];
            if *near == 0 {
                level += 1;
                if level > top {
                    return;
                }
                continue;
            }
            let child = *number * WIDTH + near.trailing_zeros() as usize;
            *near &= *near - 1;
            if level == 0 {
                index.take(child, place, nearest);
            } else {
                level -= 1;
                open[level] = (child, index.levels[level][child].near(place, nearest.limit));
            }
        }
    }
}

impl Block {
    fn new(first: usize, places: &[[f32; 3]]) -> Block {
        let lane = |k: usize| std::array::from_fn(|i| places.get(i).map_or(f32::NAN, |p| p[k]));
        Block { p: [lane(0), lane(1), lane(2)], first: first as u32, ..Block::default() }
    }

    /// Squared distances; they grow away from the tangent plane on surfaces.
    #[inline(always)]
    fn squares(&self, place: &Place) -> Lanes {
        let mut squares = [0.0; WIDTH];
        let mut away = [0.0; WIDTH];
        let normal = place.normal.unwrap_or_default();
        for k in 0..3 {
            for i in 0..WIDTH {
                let d = (self.p[k][i] - place.coarse[k]) - place.fine[k];
                squares[i] += d * d;
                away[i] += normal[k] * d;
            }
        }
        if place.normal.is_some() {
            for i in 0..WIDTH {
                squares[i] *= 1.0 + 16.0 * away[i].abs();
            }
        }
        squares
    }
}

impl Boxes {
    fn new(spans: &[[[f32; 3]; 2]]) -> Boxes {
        let lanes = |end: usize, k: usize| {
            std::array::from_fn(|i| spans.get(i).map_or(f32::NAN, |span: &[[f32; 3]; 2]| span[end][k]))
        };
        let side = |end: usize| [lanes(end, 0), lanes(end, 1), lanes(end, 2)];
        Boxes { low: side(0), high: side(1) }
    }

    /// Which of them reach into the sphere of the search.
    #[inline(always)]
    fn near(&self, place: &Place, limit: f32) -> u8 {
        let mut squares = [0.0; WIDTH];
        for k in 0..3 {
            for i in 0..WIDTH {
                let below = (self.low[k][i] - place.coarse[k]) - place.fine[k];
                let above = place.fine[k] - (self.high[k][i] - place.coarse[k]);
                let away = if below > above { below } else { above };
                // What is not there stays what it is, so that it is near nothing.
                let away = if away < 0.0 { 0.0 } else { away };
                squares[i] += away * away;
            }
        }
        below(&squares, limit)
    }
}

/// The box around eight, given their lower and upper ends.
fn bounds(low: &[Lanes; 3], high: &[Lanes; 3]) -> [[f32; 3]; 2] {
    let least = |lanes: &Lanes| lanes.iter().copied().fold(f32::INFINITY, f32::min);
    let most = |lanes: &Lanes| lanes.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    [std::array::from_fn(|k| least(&low[k])), std::array::from_fn(|k| most(&high[k]))]
}

/// Which of eight numbers are below a limit.
#[inline(always)]
fn below(lanes: &Lanes, limit: f32) -> u8 {
    lanes.iter().enumerate().fold(0, |mask, (i, &v)| mask | (u8::from(v < limit) << i))
}

impl Place {
    fn new(p: Vec3, normal: Option<Vec3>) -> Place {
        let coarse = p.as_vec3();
        let fine = (p - coarse.as_dvec3()).as_vec3();
        Place {
            coarse: coarse.to_array(),
            fine: fine.to_array(),
            p,
            normal: normal.map(|n| n.as_vec3().to_array()),
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
        let place = Place::new(p, normal);
        let whole = (radius * radius) as f32;
        // A little more room, so that it mostly is enough.
        let mut limit = whole.min((1.25 * *likely * *likely) as f32);
        self.max = max;
        self.found.resize(2 * max + 8 * WIDTH, 0);
        loop {
            self.count = 0;
            self.full = false;
            self.limit = limit;
            wide(Look { index, place: &place, nearest: self });
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
    fn note(&mut self, mask: u8, squares: &Lanes, first: u32) {
        let mut end = self.count;
        for (i, &square) in squares.iter().enumerate() {
            self.found[end] = (u64::from(square.to_bits()) << 32) | u64::from(first + i as u32);
            end += usize::from(mask >> i & 1);
        }
        self.count = end;
        if end + WIDTH > self.found.len() {
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
