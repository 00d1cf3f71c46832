//! What may stand before a point light, by direction.
//!
//! All directions from a light are cut into the cells of a cube; each cell remembers what reaches into it (Haines and
//! Greenberg, "The light buffer", 1986). Cells are filled when first a shadow ray comes through them.
use std::sync::OnceLock;

use raggio_geometry::{Geometry, RayClass, Shaft, Standing};
use raggio_math::Vec3;

/// Cells along the edge of a face at each level; the next is asked where a cell holds too much.
const SIDES: [usize; 3] = [8, 32, 128];
/// Children of a cell.
const CHILDREN: usize = 16;
/// Cells are this much larger than their share, for rounding.
const MARGIN: f64 = 1e-6;
/// Where cells begin and end, in distances along the axis of a face. Nothing nearer than the shadow tolerance, which
/// is longer than this in every direction, casts a shadow; nothing is farther away than rays go.
const RANGE: (f64, f64) = (5e-4, 4e7);

/// The directions around a point light.
pub struct LightBuffer {
    light: Vec3,
    /// The cells of the first level.
    cells: Box<[OnceLock<Cell>]>,
}

/// Some directions.
struct Cell {
    standing: Standing,
    /// Its quarters' quarters, unless what stands there is little.
    children: Option<Box<[OnceLock<Cell>; CHILDREN]>>,
}

/// A direction as a place on a cube.
struct Place {
    face: usize,
    /// From 0 to 1 over the face.
    u: f64,
    v: f64,
}

impl Place {
    #[inline]
    fn new(direction: Vec3) -> Self {
        let size = direction.abs();
        let axis = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let scale = 0.5 / size[axis];
        Place {
            face: 2 * axis + usize::from(direction[axis] < 0.0),
            u: direction[(axis + 1) % 3] * scale + 0.5,
            v: direction[(axis + 2) % 3] * scale + 0.5,
        }
    }

    /// The column and row at a level. What is not a number ends in the first cell.
    #[inline]
    fn cell(&self, side: usize) -> (usize, usize) {
        let at = |x: f64| ((x * side as f64) as usize).min(side - 1);
        (at(self.u), at(self.v))
    }
}

impl LightBuffer {
    /// An empty buffer around a light.
    pub fn new(light: Vec3) -> Self {
        LightBuffer { light, cells: (0..6 * SIDES[0] * SIDES[0]).map(|_| OnceLock::new()).collect() }
    }

    /// What may stand between the light and points in a direction from it.
    pub fn towards(&self, direction: Vec3, geometry: &Geometry) -> &Standing {
        let place = Place::new(direction);
        let (u, v) = place.cell(SIDES[0]);
        let first = &self.cells[(place.face * SIDES[0] + v) * SIDES[0] + u];
        let mut cell = first.get_or_init(|| self.fill(&place, 0, geometry));
        for (level, &side) in SIDES.iter().enumerate().skip(1) {
            let Some(children) = &cell.children else { break };
            let (u, v) = place.cell(side);
            cell = children[v % 4 * 4 + u % 4].get_or_init(|| self.fill(&place, level, geometry));
        }
        &cell.standing
    }

    fn fill(&self, place: &Place, level: usize, geometry: &Geometry) -> Cell {
        let (u, v) = place.cell(SIDES[level]);
        let at = |distance: f64| corners(self.light, (place.face, u, v), SIDES[level], distance);
        let shaft = Shaft::between(self.light, at(RANGE.0), at(RANGE.1));
        let standing = geometry.standing_in(&shaft, RayClass::Shadow);
        let split = level + 1 < SIDES.len() && !standing.is_little();
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
    use raggio_geometry::{BlockerGuess, Hit, Obstacles};
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
        let mut children = Vec::new();
        let place = |i: usize| (Vec3::new(7.0, 5.0, 3.0) * (i as f64 * 0.61)).map(|x| x.sin() * 4.0);
        for i in 0..40 {
            let shape = Arc::new(Shape::Sphere { center: place(i), radius: 0.2 + 0.01 * i as f64 });
            children.push(Arc::new(Object::new(ObjectKind::Shape(shape))));
        }
        let all = Object::new(ObjectKind::Csg { op: Csg::Union, children: Arc::new(children) });
        let geometry = Geometry::of_object(&Arc::new(all)).unwrap();
        let light = Vec3::new(0.3, 6.0, -0.2);
        let buffer = LightBuffer::new(light);
        let mut blocked = 0;
        for i in 0..3000 {
            let p = (Vec3::new(3.0, 11.0, 17.0) * (i as f64 * 0.37)).map(|x| x.cos() * 6.0);
            let way = light - p;
            let (ray, range) = (Ray::new(p, way.normalize()), (1e-3, way.length() - 1e-3));
            let ask = |standing: &Standing| {
                let mut met = Met(Vec::new());
                let guess = &mut BlockerGuess::default();
                assert!(!geometry.is_stopped(&ray, range, 1e-3, standing, guess, &mut met));
                met.0.sort_by(f64::total_cmp);
                met.0
            };
            let expected = ask(&Standing::Anything);
            assert_eq!(ask(buffer.towards(-ray.dir, &geometry)), expected, "{p}");
            blocked += usize::from(!expected.is_empty());
        }
        assert!(blocked > 200 && blocked < 2800, "{blocked}");
    }
}
