//! Trees that are built once over blocks of eight: boxes around eight blocks, around eight of these, and so on. Each eight
//! are looked at with one instruction per step where the processor can.
use raggio_math::Vec3;

/// Items of a block, and children of a box.
pub const WIDTH: usize = 8;

/// Levels of boxes over as many items as can be counted.
const MOST_LEVELS: usize = 11;

/// Numbers for the eight of a block.
pub type Lanes = [f32; WIDTH];

/// The lower and the upper end of a box.
pub type Span = [[f32; 3]; 2];

/// A place in two parts, so that differences to places near it are not rounded.
pub struct Place {
    coarse: [f32; 3],
    fine: [f32; 3],
}

/// The boxes around eight blocks, or eight of these. What is not there is nowhere.
struct Boxes {
    low: [Lanes; 3],
    high: [Lanes; 3],
}

/// Boxes around boxes, up to a single one.
#[derive(Default)]
pub struct Tree {
    levels: Vec<Vec<Boxes>>,
}

/// Who looks at blocks.
pub trait Visitor {
    /// Squared distances from here on are too far.
    fn limit(&self) -> f32;
    /// Makes the squared distances of boxes greater that lie from `low` to `high`, where the way to all that they hold is
    /// farther for the visitor. To be `#[inline(always)]`.
    fn stretch(&self, low: &[Lanes; 3], high: &[Lanes; 3], squares: &mut Lanes);
    /// Looks at a block. To be `#[inline(always)]`.
    fn visit(&mut self, block: usize);
}

impl Place {
    /// For a point.
    pub fn new(p: Vec3) -> Place {
        let coarse = p.as_vec3();
        Place { coarse: coarse.to_array(), fine: (p - coarse.as_dvec3()).as_vec3().to_array() }
    }

    /// The ways from the place to others.
    #[inline(always)]
    pub fn to(&self, places: &[Lanes; 3]) -> [Lanes; 3] {
        [self.ways(0, &places[0]), self.ways(1, &places[1]), self.ways(2, &places[2])]
    }

    #[inline(always)]
    fn ways(&self, axis: usize, to: &Lanes) -> Lanes {
        let (coarse, fine) = (self.coarse[axis], self.fine[axis]);
        each(|i| (to[i] - coarse) - fine)
    }
}

/// Eight numbers, each by its number.
#[inline(always)]
pub fn each(f: impl Fn(usize) -> f32) -> Lanes {
    let mut lanes = [0.0; WIDTH];
    for (i, lane) in lanes.iter_mut().enumerate() {
        *lane = f(i);
    }
    lanes
}

/// Which of eight numbers are below limits.
#[inline(always)]
pub fn below(lanes: &Lanes, limits: &Lanes) -> u8 {
    let mut mask = 0;
    for (i, lane) in lanes.iter().enumerate() {
        mask |= u8::from(*lane < limits[i]) << i;
    }
    mask
}

/// The box around eight, given their lower and upper ends. What is not a number is not there.
pub fn around(low: &[Lanes; 3], high: &[Lanes; 3]) -> Span {
    let least = |lanes: &Lanes| lanes.iter().copied().fold(f32::INFINITY, f32::min);
    let most = |lanes: &Lanes| lanes.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    [low.each_ref().map(least), high.each_ref().map(most)]
}

impl Boxes {
    fn new(spans: &[Span]) -> Boxes {
        let side = |end: usize| {
            std::array::from_fn(|k| std::array::from_fn(|i| spans.get(i).map_or(f32::NAN, |s| s[end][k])))
        };
        Boxes { low: side(0), high: side(1) }
    }

    /// Which of them are near.
    #[inline(always)]
    fn near(&self, place: &Place, visitor: &impl Visitor) -> u8 {
        let (low, high) = (place.to(&self.low), place.to(&self.high));
        let mut squares = [0.0; WIDTH];
        for axis in 0..3 {
            for (i, square) in squares.iter_mut().enumerate() {
                let away = if low[axis][i] > -high[axis][i] { low[axis][i] } else { -high[axis][i] };
                // What is not there stays what it is, so that it is near nothing.
                let away = if away < 0.0 { 0.0 } else { away };
                *square += away * away;
            }
        }
        visitor.stretch(&low, &high, &mut squares);
        below(&squares, &[visitor.limit(); WIDTH])
    }
}

impl Tree {
    /// A tree over blocks with these boxes. Blocks that follow each other should lie together.
    pub fn new(mut spans: Vec<Span>) -> Tree {
        let mut levels = Vec::new();
        while !spans.is_empty() {
            let level: Vec<Boxes> = spans.chunks(WIDTH).map(Boxes::new).collect();
            spans = level.iter().map(|b| around(&b.low, &b.high)).collect();
            levels.push(level);
            if spans.len() == 1 {
                break;
            }
        }
        Tree { levels }
    }

    /// Shows a visitor all blocks that are near a place.
    #[inline(always)]
    pub fn walk(&self, place: &Place, visitor: &mut impl Visitor) {
        let Some(top) = self.levels.len().checked_sub(1) else { return };
        // What is left to do: at each level the number of the boxes, and which of them.
        let mut open = [(0, 0); MOST_LEVELS];
        let mut level = top;
        open[level] = (0, self.levels[level][0].near(place, visitor));
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
                visitor.visit(child);
            } else {
                level -= 1;
                open[level] = (child, self.levels[level][child].near(place, visitor));
            }
        }
    }
}
