//! What may stand before a point light, by direction.
//!
//! All directions from a light are cut into the cells of a cube; each cell remembers what reaches into it (Haines and
//! Greenberg, "The light buffer", 1986). Cells are filled when first a shadow ray comes through them. A light far from
//! the scene sees it through a window, whose cells are as many as those of a face of the cube.
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use raggio_geometry::{Geometry, Nearest, RayClass, Shaft, Standing};
use raggio_math::{Aabb, Vec3};

/// Cells along the edge of a face at the first level.
const FIRST: usize = 8;
/// Levels; the next is asked where a cell holds too much.
const LEVELS: usize = 3;
/// A cell has so many columns of children, and as many rows, as a power of two.
const BRANCHING: usize = 2;
/// Children of a cell.
const CHILDREN: usize = 1 << (2 * BRANCHING);
/// Cells along the edge of a face at the last level.
const FINEST: usize = FIRST << (BRANCHING * (LEVELS - 1));
/// Cells are this much larger than their share, for rounding.
const MARGIN: f64 = 1e-6;
/// Where cells begin, in distances along the axis of a face. Nothing nearer than the shadow tolerance, which is longer
/// than this in every direction, casts a shadow.
const START: f64 = 5e-4;
/// Where they end, if the light stands at the origin: about as far as rays go.
const REACH: f64 = 4e7;

/// Cells are divided after so many rays: parts that few rays meet cost more than they spare.
const PATIENCE: u32 = 64;
/// For cells that are not divided.
const NEVER: u32 = u32::MAX;
/// No window is narrower than this, for rounding.
const NARROWEST: f64 = 1e-9;
/// Windows are this much wider than what is seen through them.
const FRAME: f64 = 1e-3;

/// The directions around a point light.
pub struct LightBuffer {
    light: Vec3,
    /// Points farther away than this may lie beyond the cells' ends.
    reach: f64,
    /// Where all that stands around is seen through one window, and that is small.
    window: Option<Window>,
    /// The cells of the first level.
    cells: Box<[OnceLock<Cell>]>,
}

/// Some directions.
struct Cell {
    nearest: Nearest,
    standing: Standing,
    /// How many rays are still to come before it is divided; none are waited for where what stands there is little.
    waits: AtomicU32,
    /// Its quarters' quarters.
    children: OnceLock<Children>,
}

type Children = Box<[OnceLock<Cell>; CHILDREN]>;

/// A rectangle of directions: `ahead` plus up to `across` and `along`, forwards and backwards.
#[derive(Clone, Copy)]
struct Face {
    ahead: Vec3,
    across: Vec3,
    along: Vec3,
}

/// What may stand between a light and a point.
pub struct Before<'a> {
    /// All that may.
    pub standing: &'a Standing,
    nearest: &'a Nearest,
    /// Where the point lies, as a share of the way through the space in which that stands.
    share: f64,
}

/// The face through which a distant light sees the scene.
struct Window {
    face: Face,
    /// What a direction is multiplied by, and divided by how far it goes ahead, for its place.
    to_place: (Vec3, Vec3),
    /// What stands beside it.
    outside: (Standing, Nearest),
}

/// A direction as a cell of the last level.
#[derive(Clone, Copy)]
struct Place {
    face: usize,
    column: usize,
    row: usize,
}

/// From -1 to 1 to a cell of the last level. What is not a number ends in the first cell.
#[inline]
fn cell(w: f64) -> usize {
    const HALF: f64 = FINEST as f64 / 2.0;
    ((w * HALF + HALF) as u32 as usize).min(FINEST - 1)
}

impl Place {
    /// The place on a cube, and how far the direction goes ahead of the light.
    #[inline]
    fn on_cube(d: Vec3) -> (Self, f64) {
        let (x, y, z) = (d.x.abs(), d.y.abs(), d.z.abs());
        let (face, size, u, v) = if x >= y && x >= z {
            (usize::from(d.x < 0.0), x, d.y, d.z)
        } else if y >= z {
            (2 + usize::from(d.y < 0.0), y, d.z, d.x)
        } else {
            (4 + usize::from(d.z < 0.0), z, d.x, d.y)
        };
        let scale = 1.0 / size;
        (Place { face, column: cell(u * scale), row: cell(v * scale) }, size)
    }

    /// The column and row at a level.
    #[inline]
    fn at(self, level: usize) -> (usize, usize) {
        let shift = BRANCHING * (LEVELS - 1 - level);
        (self.column >> shift, self.row >> shift)
    }

    /// Which child it lies in of a cell of the level before.
    #[inline]
    fn child(self, level: usize) -> usize {
        const MASK: usize = (1 << BRANCHING) - 1;
        let (column, row) = self.at(level);
        (row & MASK) << BRANCHING | (column & MASK)
    }
}

impl Before<'_> {
    /// Where nothing is known.
    pub const UNKNOWN: Before<'static> =
        Before { standing: &Standing::Anything, nearest: &Nearest::UNKNOWN, share: 1.0 };

    /// Is it nothing, but perhaps this leaf?
    #[inline]
    pub fn is_clear(&self, but: Option<u32>) -> bool {
        self.nearest.is_clear(self.share, but)
    }
}

impl LightBuffer {
    /// An empty buffer around a light.
    pub fn new(light: Vec3, geometry: &Geometry) -> Self {
        let window = Window::from(light, geometry);
        let faces = if window.is_some() { 1 } else { 6 };
        let cells = (0..faces * FIRST * FIRST).map(|_| OnceLock::new()).collect();
        LightBuffer { light, reach: REACH + light.length(), window, cells }
    }

    /// What may stand between the light and a point at a distance in a direction from it.
    pub fn towards(&self, direction: Vec3, distance: f64, geometry: &Geometry) -> Before<'_> {
        if distance > self.reach {
            return Before::UNKNOWN;
        }
        let (place, ahead) = match &self.window {
            None => Place::on_cube(direction),
            Some(window) => match window.place(direction) {
                Some(found) => found,
                None => {
                    let (standing, nearest) = &window.outside;
                    return Before { standing, nearest, share: 1.0 };
                }
            },
        };
        let (column, row) = place.at(0);
        let first = &self.cells[(place.face * FIRST + row) * FIRST + column];
        let mut cell = first.get_or_init(|| self.fill(place, 0, &Standing::Anything, geometry));
        for level in 1..LEVELS {
            let Some(children) = cell.divided() else { break };
            let around = &cell.standing;
            cell = children[place.child(level)].get_or_init(|| self.fill(place, level, around, geometry));
        }
        let share = distance * ahead / self.reach;
        Before { standing: &cell.standing, nearest: &cell.nearest, share }
    }

    #[cold]
    #[inline(never)]
    fn fill(&self, place: Place, level: usize, around: &Standing, geometry: &Geometry) -> Cell {
        let cell = place.at(level);
        let side = FIRST << (BRANCHING * level);
        let face = self.window.as_ref().map_or_else(|| Face::of_cube(place.face), |window| window.face);
        let at = |distance: f64| face.corners(cell, side).map(|d| self.light + d * distance);
        let shaft = Shaft::between(self.light, at(START), at(self.reach));
        let (standing, nearest) = geometry.standing_among(around, &shaft, RayClass::Shadow);
        let divisible = level + 1 < LEVELS && !standing.is_little();
        let waits = AtomicU32::new(if divisible { PATIENCE } else { NEVER });
        Cell { nearest, standing, waits, children: OnceLock::new() }
    }
}

impl Cell {
    /// Its parts, once there are any.
    #[inline]
    fn divided(&self) -> Option<&Children> {
        match self.waits.load(Relaxed) {
            0 => Some(self.children.get_or_init(|| Box::new(std::array::from_fn(|_| OnceLock::new())))),
            NEVER => None,
            // Rays of other threads may be missed, which does no harm.
            rays => {
                self.waits.store(rays - 1, Relaxed);
                None
            }
        }
    }
}

impl Face {
    fn of_cube(face: usize) -> Face {
        let axis = face / 2;
        let sign = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
        let [x, y, z] = [0, 1, 2].map(|k| Vec3::AXES[(axis + k) % 3]);
        Face { ahead: x * sign, across: y, along: z }
    }

    /// The upright face through which a box is seen from a point, if that is no wider than a face of a cube.
    fn around(b: &Aabb, eye: Vec3) -> Option<Face> {
        let ahead = (b.centre() - eye).try_normalize()?;
        let across = ahead.cross(Vec3::Y).try_normalize().unwrap_or(Vec3::X);
        let along = across.cross(ahead);
        let (mut half_u, mut half_v) = (NARROWEST, NARROWEST);
        for i in 0..8 {
            let pick = |k: usize| if i >> k & 1 == 0 { b.min[k] } else { b.max[k] };
            let d = Vec3::new(pick(0), pick(1), pick(2)) - eye;
            let depth = d.dot(ahead);
            if depth <= 0.0 {
                return None;
            }
            half_u = half_u.max(d.dot(across).abs() / depth);
            half_v = half_v.max(d.dot(along).abs() / depth);
        }
        let wider = 1.0 + FRAME;
        let face = Face { ahead, across: across * (half_u * wider), along: along * (half_v * wider) };
        (half_u * wider <= 1.0 && half_v * wider <= 1.0).then_some(face)
    }

    /// The corners of a cell in order around it.
    fn corners(&self, (column, row): (usize, usize), side: usize) -> [Vec3; 4] {
        let edge = |i: usize, out: f64| 2.0 * i as f64 / side as f64 - 1.0 + out * MARGIN;
        let (u, v) = ([edge(column, -1.0), edge(column + 1, 1.0)], [edge(row, -1.0), edge(row + 1, 1.0)]);
        [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(i, j)| self.ahead + self.across * u[i] + self.along * v[j])
    }
}

impl Window {
    /// The window of a light through which it sees all objects but the boundless ones and those around it; `None` where
    /// it would be wider than a face of a cube.
    fn from(light: Vec3, geometry: &Geometry) -> Option<Window> {
        let (beside, around, nearest) = geometry.seen_from(light, RayClass::Shadow);
        let face = Face::around(&beside, light)?;
        let dual = |v: Vec3| v / v.length_squared();
        let to_place = (dual(face.across), dual(face.along));
        matches!(around, Standing::Listed(_)).then_some(Window { face, to_place, outside: (around, nearest) })
    }

    /// The place of a direction, if it goes through, and how far it goes ahead of the light.
    #[inline]
    fn place(&self, d: Vec3) -> Option<(Place, f64)> {
        let ahead = d.dot(self.face.ahead);
        let scale = 1.0 / ahead;
        let (u, v) = (d.dot(self.to_place.0) * scale, d.dot(self.to_place.1) * scale);
        (scale > 0.0 && u.abs() <= 1.0 && v.abs() <= 1.0)
            .then(|| (Place { face: 0, column: cell(u), row: cell(v) }, ahead))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_geometry::{BlockerGuess, Hit, Obstacles, Segment};
    use raggio_math::Ray;
    use raggio_scene::{Csg, Object, ObjectKind, Shape};
    use std::sync::Arc;

    /// Where a ray went through surfaces that stop nothing.
    struct Met(Vec<f64>);

    impl Obstacles for Met {
        fn stops(&self, _leaf: u32) -> bool {
            false
        }
        fn is_plain(&self, _leaf: u32) -> bool {
            true
        }
        fn meets(&mut self, hit: &Hit) -> bool {
            self.0.push(hit.t);
            false
        }
    }

    #[test]
    fn every_blocker_is_in_the_cell_of_its_direction() {
        compare_with_all(Vec3::new(0.3, 6.0, -0.2), 200);
        // As far away as the sun from a planet in kilometres.
        compare_with_all(Vec3::new(0.3e9, 1.4e9, -0.2e9), 100);
    }

    /// Forty balls.
    fn balls() -> Geometry {
        let mut children = Vec::new();
        let place = |i: usize| (Vec3::new(7.0, 5.0, 3.0) * (i as f64 * 0.61)).map(|x| x.sin() * 4.0);
        for i in 0..40 {
            let shape = Arc::new(Shape::Sphere { center: place(i), radius: 0.2 + 0.01 * i as f64 });
            children.push(Arc::new(Object::new(ObjectKind::Shape(shape))));
        }
        let all = Object::new(ObjectKind::Csg { op: Csg::Union, children: Arc::new(children) });
        Geometry::of_object(&Arc::new(all)).unwrap()
    }

    /// A point well spread over what is around the balls.
    fn point(i: usize) -> Vec3 {
        (Vec3::new(3.0, 11.0, 17.0) * (i as f64 * 0.37)).map(|x| x.cos() * 6.0)
    }

    /// A buffer around a light which so many rays have gone through that its cells are divided.
    fn used_buffer(light: Vec3, geometry: &Geometry) -> LightBuffer {
        let buffer = LightBuffer::new(light, geometry);
        for p in (0..200_000).map(point) {
            buffer.towards((p - light).normalize(), (p - light).length(), geometry);
        }
        buffer
    }

    /// Where a shadow ray meets surfaces.
    fn met(geometry: &Geometry, ray: &Ray, distance: f64, own: Option<u32>, standing: &Standing) -> Vec<f64> {
        let mut met = Met(Vec::new());
        let segment = Segment { ray, range: (1e-3, distance - 1e-3), gap: 1e-3, own };
        assert!(!geometry.is_stopped(&segment, standing, &mut BlockerGuess::default(), &mut met));
        met.0.sort_by(f64::total_cmp);
        met.0
    }

    /// Blockers found with a buffer around a light and without; at least so many points shall have one.
    fn compare_with_all(light: Vec3, least: usize) {
        let geometry = balls();
        let buffer = used_buffer(light, &geometry);
        let (mut blocked, mut clear) = (0, 0);
        for p in (0..3000).map(point) {
            let way = light - p;
            let ray = Ray::new(p, way.normalize());
            let expected = met(&geometry, &ray, way.length(), None, &Standing::Anything);
            let before = buffer.towards(-ray.dir, way.length(), &geometry);
            assert_eq!(met(&geometry, &ray, way.length(), None, before.standing), expected, "{p}");
            assert!(expected.is_empty() || !before.is_clear(None), "{p}");
            blocked += usize::from(!expected.is_empty());
            clear += usize::from(before.is_clear(None));
        }
        assert!(blocked > least && clear > 1000 && blocked < 2800, "{blocked} {clear}");
    }

    #[test]
    fn balls_do_not_stand_in_their_own_light() {
        let (geometry, light) = (balls(), Vec3::new(30.0, 60.0, -20.0));
        let buffer = used_buffer(light, &geometry);
        let (mut blocked, mut clear) = (0, 0);
        for i in 0..30_000 {
            let seen = Ray::new(point(i), (point(i + 7) - point(i)).normalize());
            let Some(hit) = geometry.closest(&seen, (1e-3, 1e3), RayClass::Any) else { continue };
            let surface = geometry.interaction(&seen, &hit);
            let way = light - surface.p;
            let ray = Ray::new(surface.p, way.normalize());
            if surface.n.dot(ray.dir) < 1e-4 {
                continue;
            }
            let before = buffer.towards(-ray.dir, way.length(), &geometry);
            let expected = met(&geometry, &ray, way.length(), None, &Standing::Anything);
            assert!(geometry.is_convex(hit.leaf));
            let own = Some(hit.leaf);
            assert_eq!(met(&geometry, &ray, way.length(), own, before.standing), expected, "{i}");
            assert!(expected.is_empty() || !before.is_clear(own), "{i}");
            blocked += usize::from(!expected.is_empty());
            clear += usize::from(before.is_clear(own));
        }
        assert!(blocked > 100 && clear > 300, "{blocked} {clear}");
    }
}
