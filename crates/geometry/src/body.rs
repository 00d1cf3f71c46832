//! Simple bodies in the world's coordinates: where a ray is inside of one, without the way over leaf, shape and place.
use raggio_math::{Affine, Ray, Vec3};

use crate::leaf::{Leaves, Prim};
use crate::shapes::{AxisRay, Cone, Cuboid, Plane, Quadric, ShapeKind, Sphere, Stretch};

/// Quadrics whose transform distorts by no more than this are multiplied out: what rounding does to them then is far
/// below all tolerances.
const MOST_DISTORTION: f64 = 1e3;

/// A body that a ray is inside of on one stretch, or beyond one.
pub(crate) enum Body {
    Ball(Sphere),
    Half(Plane),
    Box(Cuboid),
    Cone(Cone),
    /// A quadric about a centre of its own, so that bodies far from the origin lose no digits.
    Quadric {
        quadric: Quadric,
        centre: Vec3,
    },
    /// A box at a place, and the number of the place.
    PlacedBox(u32, Box<Placed<Cuboid>>),
    PlacedCone(Box<Placed<Cone>>),
    PlacedQuadric(Box<Placed<Quadric>>),
}

/// A shape at a place. It is kept apart, so that simpler bodies stay small.
pub(crate) struct Placed<T> {
    shape: T,
    object_from_world: Affine,
}

impl<T> Placed<T> {
    fn new(shape: T, object_from_world: Affine) -> Box<Self> {
        Box::new(Placed { shape, object_from_world })
    }
}

impl Body {
    /// The body of a leaf, its inversion not counted, if it is one of these.
    pub(crate) fn of(leaf: u32, leaves: &Leaves) -> Option<Body> {
        let place = |place: u32| leaves.places[place as usize];
        match leaves.leaves[leaf as usize].prim {
            Prim::Sphere { sphere, .. } => Some(Body::Ball(sphere)),
            Prim::Plane(plane) => Some(Body::Half(plane)),
            Prim::Box(cuboid) => Some(Body::Box(cuboid)),
            Prim::PlacedBox { cuboid, place: id, .. } => {
                Some(Body::PlacedBox(id, Placed::new(cuboid, place(id))))
            }
            Prim::World(shape) => Body::of_shape(&leaves.shapes[shape as usize], None),
            Prim::Placed { shape, place: id } => match &leaves.shapes[shape as usize] {
                ShapeKind::Box(cuboid) => Some(Body::PlacedBox(id, Placed::new(*cuboid, place(id)))),
                shape => Body::of_shape(shape, Some(place(id))),
            },
        }
    }

    fn of_shape(shape: &ShapeKind, place: Option<Affine>) -> Option<Body> {
        Some(match (shape, place) {
            (ShapeKind::Box(cuboid), None) => Body::Box(*cuboid),
            (ShapeKind::Cone(cone), _) if !cone.is_convex() => return None,
            (ShapeKind::Cone(cone), None) => Body::Cone(**cone),
            (ShapeKind::Cone(cone), Some(place)) => Body::PlacedCone(Placed::new(**cone, place)),
            (ShapeKind::Quadric(quadric), place) => Body::quadric(quadric, Vec3::ZERO, place),
            (ShapeKind::Sphere(sphere), place) => {
                let (centre, radius) = sphere.place();
                Body::quadric(&Quadric::ball(radius), centre, place)
            }
            _ => return None,
        })
    }

    /// A quadric about a point in its own coordinates.
    fn quadric(quadric: &Quadric, centre: Vec3, object_from_world: Option<Affine>) -> Body {
        let Some(object_from_world) = object_from_world else {
            return Body::Quadric { quadric: *quadric, centre };
        };
        let world_from_object = object_from_world.inverse();
        let size = |m: &Affine| m.matrix3.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
        if size(&object_from_world) * size(&world_from_object) <= MOST_DISTORTION {
            let centre = world_from_object.transform_point3(centre);
            return Body::Quadric { quadric: quadric.turned_by(&object_from_world.matrix3), centre };
        }
        Body::PlacedQuadric(Placed::new(*quadric, Affine::from_translation(-centre) * object_from_world))
    }

    /// Where the ray is inside. What `ready` keeps from body to body is of this ray.
    #[inline(always)]
    pub(crate) fn stretch(&self, ray: &Ray, ready: &mut Ready) -> Stretch {
        match self {
            Body::Ball(sphere) => sphere.stretch(ray),
            Body::Half(plane) => plane.stretch(ray),
            Body::Box(cuboid) => cuboid.stretch(ready.at(Ready::WORLD, || *ray)),
            Body::Cone(cone) => cone.stretch(ray),
            Body::Quadric { quadric, centre } => quadric.stretch(&Ray::new(ray.origin - *centre, ray.dir)),
            Body::PlacedBox(id, placed) => {
                placed.shape.stretch(ready.at(*id, || ray.transformed(&placed.object_from_world)))
            }
            Body::PlacedCone(placed) => placed.shape.stretch(&ray.transformed(&placed.object_from_world)),
            Body::PlacedQuadric(placed) => placed.shape.stretch(&ray.transformed(&placed.object_from_world)),
        }
    }

    /// Is it bounded, so that nothing outside the box of its surface is inside?
    pub(crate) fn is_bounded(&self) -> bool {
        use Body::{Ball, Box, Cone, PlacedBox, PlacedCone};
        matches!(self, Ball(_) | Box(_) | Cone(_) | PlacedBox(..) | PlacedCone(_))
    }

    /// Do its hits need words beyond their distance?
    pub(crate) fn has_parts(&self) -> bool {
        use Body::{Box, Cone, PlacedBox, PlacedCone};
        matches!(self, Box(_) | Cone(_) | PlacedBox(..) | PlacedCone(_))
    }
}

/// A ray made ready for boxes at the place of the last one: neighbours often share theirs.
pub(crate) struct Ready {
    place: u32,
    ray: AxisRay,
}

impl Ready {
    /// Stand for no place, and for nothing made ready.
    const WORLD: u32 = u32::MAX;
    const NOTHING: u32 = u32::MAX - 1;

    /// For another ray.
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Ready { place: Ready::NOTHING, ray: AxisRay::default() }
    }

    #[inline(always)]
    fn at(&mut self, place: u32, moved: impl FnOnce() -> Ray) -> &AxisRay {
        if self.place != place {
            *self = Ready { place, ray: AxisRay::new(&moved()) };
        }
        &self.ray
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_math::transform::{rotate, scale, translate};

    /// Both ends of a body's stretch against those of the shape at its place.
    #[test]
    fn placed_quadrics_end_where_their_equation_is_zero() {
        let saddle = Quadric::new(&[1.0, -0.5, 2.0, 0.3, -0.2, 0.1, 0.4, 0.5, -0.6, -1.0]);
        let rays = [(-3.0, 0.4, 0.2), (-2.0, -0.3, 0.3), (-4.0, 0.5, -0.4)];
        for (size, far) in [(0.5, 1.0), (2.0, 1.0), (2.0, 1e4)] {
            let world_from_object = translate(Vec3::new(3.0, -2.0, 1.0) * far)
                * rotate(Vec3::new(10.0, 20.0, 30.0))
                * scale(Vec3::new(size, 1.0, 1.5));
            let object_from_world = world_from_object.inverse();
            let body = Body::quadric(&saddle, Vec3::ZERO, Some(object_from_world));
            assert!(matches!(body, Body::Quadric { .. }));
            let placed = Body::PlacedQuadric(Placed::new(saddle, object_from_world));
            for (x, y, z) in rays {
                let origin = world_from_object.transform_point3(Vec3::new(x, y, z));
                let ray = Ray::new(origin, world_from_object.transform_vector3(Vec3::X).normalize());
                let stretch = |body: &Body| body.stretch(&ray, &mut Ready::new());
                let (a, b) = (stretch(&body), stretch(&placed));
                assert!((a.enter - b.enter).abs() < 1e-9 * far && (a.leave - b.leave).abs() < 1e-9 * far);
                assert_eq!(a.beyond, b.beyond);
                assert!(a.leave > a.enter);
            }
        }
        let thin = scale(Vec3::new(1e5, 1.0, 1.0));
        assert!(matches!(Body::quadric(&saddle, Vec3::ZERO, Some(thin)), Body::PlacedQuadric(..)));
    }
}
