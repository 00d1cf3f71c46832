//! What may stand before a point light, by direction.
//!
//! All directions from a light are cut into the cells of a cube; each cell remembers what reaches into it (Haines and
//! Greenberg, "The light buffer", 1986). Cells are filled when first a shadow ray comes through them.
use std::sync::OnceLock;

use raggio_geometry::{Geometry, RayClass, Shaft, Standing};
use raggio_math::Vec3;

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

/// The directions around a point light.
pub struct LightBuffer {
    light: Vec3,
    /// Points farther away than this may lie beyond the cells' ends.
    reach: f64,
    /// The cells of the first level.
    cells: Box<[OnceLock<Cell>]>,
}

/// Some directions.
struct Cell {
    standing: Standing,
    /// Its quarters' quarters, unless what stands there is little.
    children: Option<Box<[OnceLock<Cell>; CHILDREN]>>,
}

/// A direction as a cell of the last level.
#[derive(Clone, Copy)]
struct Place {
    face: usize,
    column: usize,
    row: usize,
}

impl Place {
    #[inline]
    fn new(d: Vec3) -> Self {
        const HALF: f64 = FINEST as f64 / 2.0;
        let (x, y, z) = (d.x.abs(), d.y.abs(), d.z.abs());
        let (face, size, u, v) = if x >= y && x >= z {
            (usize::from(d.x < 0.0), x, d.y, d.z)
        } else if y >= z {
            (2 + usize::from(d.y < 0.0), y, d.z, d.x)
        } else {
            (4 + usize::from(d.z < 0.0), z, d.x, d.y)
        };
        let scale = HALF / size;
        // What is not a number ends in the first cell.
        let cell = |w: f64| ((w * scale + HALF) as u32 as usize).min(FINEST - 1);
        Place { face, column: cell(u), row: cell(v) }
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

impl LightBuffer {
    /// An empty buffer around a light.
    pub fn new(light: Vec3) -> Self {
        let cells = (0..6 * FIRST * FIRST).map(|_| OnceLock::new()).collect();
        LightBuffer { light, reach: REACH + light.length(), cells }
    }

    /// What may stand between the light and a point at a distance in a direction from it.
    pub fn towards(&self, direction: Vec3, distance: f64, geometry: &Geometry) -> &Standing {
        if distance > self.reach {
            return &Standing::Anything;
        }
        let place = Place::new(direction);
        let (column, row) = place.at(0);
        let first = &self.cells[(place.face * FIRST + row) * FIRST + column];
        let mut cell = first.get_or_init(|| self.fill(place, 0, geometry));
        for level in 1..LEVELS {
            let Some(children) = &cell.children else { break };
            cell = children[place.child(level)].get_or_init(|| self.fill(place, level, geometry));
        }
        &cell.standing
    }

    #[cold]
    fn fill(&self, place: Place, level: usize, geometry: &Geometry) -> Cell {
        let (column, row) = place.at(level);
        let side = FIRST << (BRANCHING * level);
        let at = |distance: f64| corners(self.light, (place.face, column, row), side, distance);
        let shaft = Shaft::between(self.light, at(START), at(self.reach));
        let standing = geometry.standing_in(&shaft, RayClass::Shadow);
        let split = level + 1 < LEVELS && !standing.is_little();
        let children = split.then(|| Box::new(std::array::from_fn(|_| OnceLock::new())));
        Cell { standing, children }
    }
}

/// The corners of a cell at a distance along the axis of its face, in order around it.
fn corners(light: Vec3, (face, u, v): (usize, usize, usize), side: usize, distance: f64) -> [Vec3; 4] {
    let axis = face / 2;
    let edge = |i: usize, out: f64| 2.0 * i as f64 / side as f64 - 1.0 + out * MARGIN;
    let (u, v) = ([edge(u, -1.0), edge(u + 1, 1.0)], [edge(v, -1.0), edge(v + 1, 1.0)]);
    [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(i, j)| {
        let mut d = Vec3::ZERO;
        d[axis] = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
        d[(axis + 1) % 3] = u[i];
        d[(axis + 2) % 3] = v[j];
        light + d * distance
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_geometry::{BlockerGuess, Hit};
    use raggio_math::Ray;
    use raggio_scene::{Csg, Object, ObjectKind, Shape};
    use std::sync::Arc;

    #[test]
    fn every_blocker_is_in_the_cell_of_its_direction() {
        compare_with_all(Vec3::new(0.3, 6.0, -0.2), 200);
        // As far away as the sun from a planet in kilometres.
        compare_with_all(Vec3::new(0.3e9, 1.4e9, -0.2e9), 100);
    }

    /// Blockers found with a buffer around a light and without; at least so many points shall have one.
    fn compare_with_all(light: Vec3, least: usize) {
        let mut children = Vec::new();
        let place = |i: usize| (Vec3::new(7.0, 5.0, 3.0) * (i as f64 * 0.61)).map(|x| x.sin() * 4.0);
        for i in 0..40 {
            let shape = Arc::new(Shape::Sphere { center: place(i), radius: 0.2 + 0.01 * i as f64 });
            children.push(Arc::new(Object::new(ObjectKind::Shape(shape))));
        }
        let all = Object::new(ObjectKind::Csg { op: Csg::Union, children: Arc::new(children) });
        let geometry = Geometry::of_object(&Arc::new(all)).unwrap();
        let buffer = LightBuffer::new(light);
        let mut blocked = 0;
        for i in 0..3000 {
            let p = (Vec3::new(3.0, 11.0, 17.0) * (i as f64 * 0.37)).map(|x| x.cos() * 6.0);
            let way = light - p;
            let (ray, range) = (Ray::new(p, way.normalize()), (1e-3, way.length() - 1e-3));
            let ask = |standing: &Standing| {
                let all = |_: &Hit| false;
                let hit = geometry.blocker(
                    &ray,
                    range,
                    RayClass::Shadow,
                    standing,
                    &mut BlockerGuess::default(),
                    all,
                );
                hit.map(|hit| hit.t)
            };
            let expected = ask(&Standing::Anything);
            assert_eq!(ask(buffer.towards(-ray.dir, way.length(), &geometry)), expected, "{p}");
            blocked += usize::from(expected.is_some());
        }
        assert!(blocked > least && blocked < 2800, "{blocked}");
    }
}
