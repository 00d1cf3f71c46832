//! Shapes made ready, each once however often it is placed; the simplest ones moved into the world.
use std::sync::Arc;

use raggio_math::{Aabb, Affine, Mat3, Vec3, transform};
use raggio_scene::Shape;
use rustc_hash::FxHashMap;

use crate::index::transformed;
use crate::leaf::{Leaves, Prim};
use crate::shapes::{self, Cuboid, PlacedCuboid, Plane, ShapeKind, Sphere};
use crate::{BuildError, Surface};

/// Remembers which shapes and places are there already.
#[derive(Default)]
pub(crate) struct ShapePool {
    /// By address of the scene's shape, which the scene keeps alive.
    shapes: FxHashMap<usize, u32>,
    last_place: Option<(Affine, u32)>,
    /// How many Julia fractals were made ready.
    fractals: usize,
}

/// A shape at its place, and the boxes around it.
pub(crate) struct PlacedShape {
    pub(crate) prim: Prim,
    /// The shape itself has been turned inside out, as far as asked.
    pub(crate) inverted: bool,
    /// Box of the surface.
    pub(crate) surface: Aabb,
    /// Outside this box nothing is inside.
    pub(crate) inside: Aabb,
    /// Outside this box everything is inside.
    pub(crate) outside: Aabb,
}

impl ShapePool {
    /// Puts a shape at its place. The result's `inverted` is what remains to be inverted.
    pub(crate) fn place(
        &mut self,
        leaves: &mut Leaves,
        shape: &Arc<Shape>,
        world_from_object: &Affine,
        inverted: bool,
    ) -> Result<PlacedShape, BuildError> {
        match &**shape {
            Shape::Plane { normal, distance } => {
                Ok(place_plane(*normal, *distance, world_from_object, inverted))
            }
            Shape::Sphere { center, radius } => match uniform_scale(world_from_object) {
                Some(scale) => {
                    let sphere = Sphere::new(world_from_object.transform_point3(*center), radius * scale);
                    let place = (!is_plain(&world_from_object.matrix3, scale))
                        .then(|| self.place_id(leaves, world_from_object));
                    Ok(boxed(Prim::Sphere { sphere, place }, inverted, sphere.bounds(), sphere.bounds()))
                }
                None => self.place_general(leaves, shape, world_from_object, inverted),
            },
            Shape::Box { min, max } if most_stretch(world_from_object) <= MOST_STRETCH => {
                Ok(self.place_box(leaves, Cuboid::new(*min, *max), world_from_object, inverted))
            }
            _ => self.place_general(leaves, shape, world_from_object, inverted),
        }
    }

    /// A box goes into the world where its transform only moves and stretches it.
    fn place_box(
        &mut self,
        leaves: &mut Leaves,
        cuboid: Cuboid,
        world_from_object: &Affine,
        inverted: bool,
    ) -> PlacedShape {
        let m = &world_from_object.matrix3;
        let scale = Vec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z);
        if *m == Mat3::from_diagonal(scale) && scale.cmpgt(Vec3::ZERO).all() {
            let moved = cuboid.moved(scale, world_from_object.translation);
            return boxed(Prim::Box(moved), inverted, moved.bounds(), moved.bounds());
        }
        let bounds = transformed(&cuboid.bounds(), world_from_object);
        let place = self.place_id(leaves, world_from_object);
        leaves.boxes.push(PlacedCuboid::new(&cuboid, &leaves.places[place as usize]));
        let both = leaves.boxes.len() as u32 - 1;
        boxed(Prim::PlacedBox { cuboid, place, both }, inverted, bounds, bounds)
    }

    fn place_general(
        &mut self,
        leaves: &mut Leaves,
        shape: &Arc<Shape>,
        world_from_object: &Affine,
        inverted: bool,
    ) -> Result<PlacedShape, BuildError> {
        if let Some(moved) = shapes::moved(shape, world_from_object) {
            leaves.shapes.push(moved);
            let id = leaves.shapes.len() as u32 - 1;
            return Ok(placed_shape(leaves, Prim::World(id), id, &Affine::IDENTITY, inverted));
        }
        let inverse = if inverted { shapes::inverse(shape) } else { None };
        let turned = inverse.is_some();
        let id = match inverse {
            Some(inverse) => {
                leaves.shapes.push(inverse);
                leaves.shapes.len() as u32 - 1
            }
            None => self.shape_id(leaves, shape)?,
        };
        let prim = match *world_from_object == Affine::IDENTITY {
            true => Prim::World(id),
            false => Prim::Placed { shape: id, place: self.place_id(leaves, world_from_object) },
        };
        let mut placed = placed_shape(leaves, prim, id, world_from_object, inverted && !turned);
        if turned {
            placed.outside = placed.surface;
        }
        Ok(placed)
    }

    fn shape_id(&mut self, leaves: &mut Leaves, shape: &Arc<Shape>) -> Result<u32, BuildError> {
        // A mesh is shared even where the shape around it was copied.
        let (address, shared) = match &**shape {
            Shape::Mesh(mesh) => (Arc::as_ptr(mesh) as usize, true),
            _ => (Arc::as_ptr(shape) as usize, Arc::strong_count(shape) > 1),
        };
        if let Some(&id) = self.shapes.get(&address) {
            return Ok(id);
        }
        leaves.shapes.push(shapes::build(shape, self.fractals)?);
        self.fractals += usize::from(matches!(&**shape, Shape::Julia(_)));
        let id = leaves.shapes.len() as u32 - 1;
        if shared {
            self.shapes.insert(address, id);
        }
        Ok(id)
    }

    /// Neighbours in a scene often share their place.
    fn place_id(&mut self, leaves: &mut Leaves, world_from_object: &Affine) -> u32 {
        match self.last_place {
            Some((last, id)) if last == *world_from_object => id,
            _ => {
                leaves.places.push(world_from_object.inverse());
                let id = leaves.places.len() as u32 - 1;
                self.last_place = Some((*world_from_object, id));
                id
            }
        }
    }
}

fn placed_shape(
    leaves: &Leaves,
    prim: Prim,
    id: u32,
    world_from_object: &Affine,
    inverted: bool,
) -> PlacedShape {
    let shape = &leaves.shapes[id as usize];
    let surface = placed_box(shape, world_from_object);
    let inside = match shape.is_solid() {
        true if shape.inside_bounds() == shape.bounds() => surface,
        true => transformed(&shape.inside_bounds(), world_from_object),
        false => Aabb::EMPTY,
    };
    // What has no inside has none turned inside out either; but the sides of a mesh change places.
    let turned = inverted && (shape.is_solid() || matches!(shape, ShapeKind::Mesh(_)));
    PlacedShape { inverted: turned, ..boxed(prim, inverted && shape.is_solid(), surface, inside) }
}

/// The box around a shape at its place.
fn placed_box(shape: &ShapeKind, world_from_object: &Affine) -> Aabb {
    let loose = transformed(&shape.bounds(), world_from_object);
    let rows = world_from_object.matrix3.transpose();
    let rows = [rows.x_axis, rows.y_axis, rows.z_axis];
    let reach = |sign: f64| -> Option<Vec3> {
        let [x, y, z] = rows.map(|row| shape.reach(row * sign));
        Some(Vec3::new(x?, y?, z?) * sign + world_from_object.translation)
    };
    match (reach(-1.0), reach(1.0)) {
        (Some(min), Some(max)) if !loose.is_empty() => loose.intersection(&Aabb { min, max }),
        _ => loose,
    }
}

fn boxed(prim: Prim, inverted: bool, surface: Aabb, inside: Aabb) -> PlacedShape {
    let (inside, outside) = match inverted {
        false => (inside, Aabb::INFINITE),
        true => (Aabb::INFINITE, inside),
    };
    PlacedShape { prim, inverted, surface, inside, outside }
}

/// A plane goes into the world for good; `inverse` turns the plane itself round.
fn place_plane(normal: Vec3, distance: f64, world_from_object: &Affine, inverted: bool) -> PlacedShape {
    let n = transform::normal_by_inverse(&world_from_object.inverse(), normal).normalize_or(normal);
    let d = n.dot(world_from_object.transform_point3(normal * distance));
    let (n, d) = if inverted { (-n, -d) } else { (n, d) };
    let plane = Plane::new(n, d);
    PlacedShape {
        prim: Prim::Plane(plane),
        inverted: false,
        surface: Aabb::INFINITE,
        inside: plane.inside_bounds(),
        outside: Plane::new(-n, -d).inside_bounds(),
    }
}

/// Up to so much stretching the least distances of shapes stay below what any ray reports.
const MOST_STRETCH: f64 = 100.0;

/// No transformed vector is longer by more than this.
fn most_stretch(t: &Affine) -> f64 {
    let m = &t.matrix3;
    (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt()
}

/// By how much a transform stretches, if by the same in all directions.
pub(crate) fn uniform_scale(t: &Affine) -> Option<f64> {
    let m = &t.matrix3;
    let square = m.transpose() * *m;
    let s2 = square.x_axis.x;
    let off = square - Mat3::from_diagonal(Vec3::splat(s2));
    let uniform = off.to_cols_array().iter().all(|e| e.abs() <= 1e-12 * s2);
    (uniform && s2.is_finite()).then(|| s2.sqrt())
}

/// Is the linear part nothing but a scale?
fn is_plain(m: &Mat3, scale: f64) -> bool {
    *m == Mat3::from_diagonal(Vec3::new(m.x_axis.x, m.x_axis.x, m.x_axis.x)) && m.x_axis.x == scale
}
