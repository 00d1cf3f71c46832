//! The way of a ray over a grid: from block to block, large ones where nothing is near, cell by cell where something is.
use raggio_math::Ray;

/// A ray over the cells of one axis of the grid, in sample units.
struct Axis {
    origin: f64,
    dir: f64,
    /// One over the direction, and where planes are counted from: a ray along them never reaches one.
    inverse: f64,
    from: f64,
    /// 1 for a ray that runs upwards.
    up: i32,
    /// The cell that the ray is over, and how many there are.
    cell: i32,
    count: i32,
}

/// Blocks of this level are looked at first. Most rays begin on the surface, or high over it, where a few steps lead to
/// larger ones.
const FIRST_LEVEL: u32 = 3;

/// A ray on its way.
pub(super) struct Steps {
    x: Axis,
    z: Axis,
    /// Blocks are of `2^level` by `2^level` cells.
    level: u32,
    top: u32,
    /// Where the ray has come to.
    pub(super) at: f64,
}

/// The block that a ray is over.
pub(super) struct Block {
    pub(super) level: u32,
    pub(super) i: usize,
    pub(super) j: usize,
    /// Where the ray leaves it.
    pub(super) exit: f64,
    /// Along x?
    across_x: bool,
}

impl Axis {
    fn new(origin: f64, dir: f64, at: f64, count: usize) -> Self {
        let count = count as i32;
        let cell = ((origin + dir * at) as i32).clamp(0, count - 1);
        let (inverse, from) = if dir == 0.0 { (1.0, f64::NEG_INFINITY) } else { (1.0 / dir, origin) };
        Axis { origin, dir, inverse, from, up: i32::from(dir >= 0.0), cell, count }
    }

    /// Where the ray comes to a plane between two cells.
    #[inline(always)]
    fn reaches(&self, plane: i32) -> f64 {
        (f64::from(plane) - self.from) * self.inverse
    }

    /// The plane at which the ray leaves its block.
    #[inline(always)]
    fn next_plane(&self, level: u32) -> i32 {
        ((self.cell >> level) + self.up) << level
    }

    /// Goes on to a place within its block.
    #[inline(always)]
    fn advance(&mut self, at: f64, level: u32) {
        if self.dir == 0.0 {
            return;
        }
        let first = (self.cell >> level) << level;
        let last = (first + (1 << level) - 1).min(self.count - 1);
        let mut cell = ((self.origin + self.dir * at) as i32).clamp(first, last);
        // Planes say which cell the ray is over; places say so but for rounding.
        if self.reaches(cell + 1 - self.up) > at {
            cell += 1 - 2 * self.up;
        }
        self.cell = cell.clamp(first, last);
    }

    /// Goes over the plane at which the ray leaves its block, while it stays in its block of the other axis. Answers the
    /// level to go on with, or `None` where it leaves the grid.
    #[inline(always)]
    fn cross(&mut self, other: &mut Axis, at: f64, level: u32, top: u32) -> Option<u32> {
        let plane = self.next_plane(level);
        self.cell = plane - 1 + self.up;
        if self.cell < 0 || self.cell >= self.count {
            return None;
        }
        if level > 0 {
            other.advance(at, level);
        }
        // Out of the larger block as well.
        let leaves_larger = plane >> level & 1 == 0;
        Some(if leaves_larger && level < top { level + 1 } else { level })
    }
}

impl Steps {
    /// A ray that is over the grid at a distance. `top` is the level of the block that is the whole grid.
    pub(super) fn new(ray: &Ray, at: f64, (columns, rows): (usize, usize), top: u32) -> Self {
        let (o, d) = (ray.origin, ray.dir);
        let (x, z) = (Axis::new(o.x, d.x, at, columns), Axis::new(o.z, d.z, at, rows));
        Steps { x, z, level: top.min(FIRST_LEVEL), top, at }
    }

    /// The block that the ray is over.
    #[inline(always)]
    pub(super) fn block(&self) -> Block {
        let Steps { x, z, level, .. } = self;
        let (tx, tz) = (x.reaches(x.next_plane(*level)), z.reaches(z.next_plane(*level)));
        let across_x = tx <= tz;
        let exit = if across_x { tx } else { tz };
        Block {
            level: *level,
            i: (x.cell >> level) as usize,
            j: (z.cell >> level) as usize,
            exit: if exit > self.at { exit } else { self.at },
            across_x,
        }
    }

    /// Looks at smaller blocks.
    #[inline(always)]
    pub(super) fn refine(&mut self) {
        self.level -= 1;
    }

    /// Leaves the block; false where the ray leaves the grid.
    #[inline(always)]
    pub(super) fn leave(&mut self, block: &Block) -> bool {
        self.at = block.exit;
        let Steps { x, z, level, top, at } = self;
        let next = if block.across_x { x.cross(z, *at, *level, *top) } else { z.cross(x, *at, *level, *top) };
        self.level = next.unwrap_or(0);
        next.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::Vec3;

    /// Whichever blocks are passed by, the ray is in the middle of its stretch over the block that it is said to be
    /// over, and no stretch is left out.
    #[test]
    fn blocks_follow_the_ray_without_gaps() {
        let (columns, rows, top) = (13, 7, 4);
        let mut blocks = 0;
        for k in 0..4000u32 {
            let turn = Vec3::new(f64::from(k).cos(), 0.3, f64::from(k).sin());
            let dir = [turn, Vec3::new(turn.x, 0.0, 0.0), Vec3::new(0.0, 0.0, turn.z)][k as usize % 3];
            let start = Vec3::new(f64::from(k % 53) * 0.25, 0.0, f64::from(k % 29) * 0.25);
            let ray = Ray::new(start.min(Vec3::new(13.0, 0.0, 7.0)), dir);
            let mut steps = Steps::new(&ray, 0.0, (columns, rows), top);
            loop {
                let block = steps.block();
                if block.level > 0 && !(block.i + block.j + k as usize).is_multiple_of(3) {
                    steps.refine();
                    continue;
                }
                let size = f64::from(1 << block.level);
                let middle = ray.at(0.5 * (steps.at + block.exit));
                if block.exit > steps.at + 1e-9 && block.exit < 1e9 {
                    let (x, z) = (middle.x / size - block.i as f64, middle.z / size - block.j as f64);
                    assert!((0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&z), "{ray:?}: {middle}");
                    blocks += 1;
                }
                let at = block.exit;
                if !steps.leave(&block) {
                    break;
                }
                assert_eq!(steps.at, at);
            }
        }
        assert!(blocks > 10_000, "{blocks}");
    }
}
