//! Leaves: shapes at their places, asked in world coordinates.
use raggio_math::{Aabb, Affine, Ray, Vec2, Vec3, transform};

use crate::index::transformed;
use crate::shapes::{Few, ShapeKind, Sphere};
use crate::tree::{Node, NodeRef};
use crate::{Hit, LocalHit, MaterialId, Surface};

/// A shape at its place.
#[derive(Clone, Copy)]
pub(crate) struct Leaf {
    pub(crate) prim: Prim,
    pub(crate) material: MaterialId,
    /// Turned inside out on the way down.
    pub(crate) inverted: bool,
}

/// Which shape, where.
#[derive(Clone, Copy)]
pub(crate) enum Prim {
    /// A sphere in world coordinates: index into [`Leaves::spheres`].
    Sphere(u32),
    /// A shape whose own coordinates are the world's: index into [`Leaves::shapes`].
    World(u32),
    /// A shape and its place: indices into [`Leaves::shapes`] and [`Leaves::places`].
    Placed { shape: u32, place: u32 },
}

/// A sphere that its transform has left round.
pub(crate) struct WorldSphere {
    pub(crate) sphere: Sphere,
    /// Place of a sphere that was turned, for the sake of its texture coordinates.
    pub(crate) place: Option<u32>,
}

/// All leaves of a scene and what they consist of, in flat arrays.
#[derive(Default)]
pub(crate) struct Leaves {
    pub(crate) leaves: Vec<Leaf>,
    pub(crate) spheres: Vec<WorldSphere>,
    pub(crate) shapes: Vec<ShapeKind>,
    /// `object_from_world`
    pub(crate) places: Vec<Affine>,
}

/// A ray in a shape's own coordinates with a direction of unit length.
struct LocalRay {
    ray: Ray,
    /// Local distance per world distance.
    stretch: f64,
}

/// How often a hit may come back that rounding has put on the edge of the range.
const ROUNDING_TRIES: usize = 8;

impl LocalRay {
    #[inline]
    fn new(ray: &Ray, object_from_world: &Affine) -> Self {
        let local = ray.transformed(object_from_world);
        let stretch = local.dir.length();
        LocalRay { ray: Ray::new(local.origin, local.dir / stretch), stretch }
    }

    /// The nearest hit within a range of world distances. Rounding on the way to local distances and back must not
    /// let a hit through that the range shuts out.
    #[inline]
    fn closest(
        &self,
        shape: &ShapeKind,
        range: (f64, f64),
        stops: impl Fn(&LocalHit) -> bool,
    ) -> Option<LocalHit> {
        let mut local_range = self.range(range);
        for _ in 0..ROUNDING_TRIES {
            let hit = shape.closest_or(&self.ray, local_range, &stops)?;
            let t = hit.t / self.stretch;
            if t > range.0 {
                return (t < range.1).then_some(hit);
            }
            // Some shapes keep their distances only to within rounding.
            local_range.0 = hit.t.max(local_range.0) * (1.0 + 4.0 * f64::EPSILON);
        }
        None
    }

    #[inline]
    fn range(&self, range: (f64, f64)) -> (f64, f64) {
        (range.0 * self.stretch, range.1 * self.stretch)
    }
}

impl Leaves {
    /// The nearest hit of one leaf, or any hit that `stops` says yes to.
    #[inline]
    pub(crate) fn closest(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        stops: &impl Fn(&Hit) -> bool,
    ) -> Option<Hit> {
        let leaf = &self.leaves[index as usize];
        let at = |t: f64, local: LocalHit| Hit { t, leaf: index, inverted: leaf.inverted, local };
        match leaf.prim {
            Prim::Sphere(s) => {
                self.spheres[s as usize].sphere.closest(ray, range).map(|local| at(local.t, local))
            }
            Prim::World(s) => self.shapes[s as usize]
                .closest_or(ray, range, |local| stops(&at(local.t, *local)))
                .map(|local| at(local.t, local)),
            Prim::Placed { shape, place } => {
                let local = LocalRay::new(ray, &self.places[place as usize]);
                let world = |hit: &LocalHit| at(hit.t / local.stretch, *hit);
                let hit = local.closest(&self.shapes[shape as usize], range, |hit| stops(&world(hit)))?;
                Some(world(&hit))
            }
        }
    }

    /// Collects every hit of one leaf in its shape's own coordinates, near ones first, where the shape has but a few;
    /// `None` where it may have more. Returns what to divide distances by.
    #[inline]
    fn few(&self, leaf: &Leaf, ray: &Ray, range: (f64, f64), out: &mut Few) -> Option<f64> {
        let (found, stretch) = match leaf.prim {
            Prim::Sphere(s) => {
                self.spheres[s as usize].sphere.few(ray, range, out);
                (true, 1.0)
            }
            Prim::World(s) => (self.shapes[s as usize].few(ray, range, out), 1.0),
            Prim::Placed { shape, place } => {
                let shape = &self.shapes[shape as usize];
                if !shape.has_few() {
                    return None;
                }
                let local = LocalRay::new(ray, &self.places[place as usize]);
                (shape.few(&local.ray, local.range(range), out), local.stretch)
            }
        };
        out.sort();
        found.then_some(stretch)
    }

    /// The nearest hit of one leaf that `counts` says yes to. Only for shapes with few hits: `None` for others.
    #[inline]
    pub(crate) fn closest_of_few(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        counts: impl Fn(&Hit) -> bool,
    ) -> Option<Option<Hit>> {
        let leaf = &self.leaves[index as usize];
        let mut few = Few::default();
        let stretch = self.few(leaf, ray, range, &mut few)?;
        for &local in few.as_slice() {
            let hit = Hit { t: local.t / stretch, leaf: index, inverted: leaf.inverted, local };
            if hit.t > range.0 && hit.t < range.1 && counts(&hit) {
                return Some(Some(hit));
            }
        }
        Some(None)
    }

    /// Appends every hit of one leaf. `buffer` is room for the shape's answers, left as it was found.
    pub(crate) fn hits(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        buffer: &mut Vec<LocalHit>,
        out: &mut Vec<Hit>,
    ) {
        let leaf = &self.leaves[index as usize];
        let start = buffer.len();
        let stretch = match leaf.prim {
            Prim::Sphere(s) => {
                self.spheres[s as usize].sphere.hits(ray, range, buffer);
                1.0
            }
            Prim::World(s) => {
                self.shapes[s as usize].hits(ray, range, buffer);
                1.0
            }
            Prim::Placed { shape, place } => {
                let local = LocalRay::new(ray, &self.places[place as usize]);
                self.shapes[shape as usize].hits(&local.ray, local.range(range), buffer);
                local.stretch
            }
        };
        for &local in &buffer[start..] {
            let t = local.t / stretch;
            if t > range.0 && t < range.1 {
                out.push(Hit { t, leaf: index, inverted: leaf.inverted, local });
            }
        }
        buffer.truncate(start);
    }

    /// A box around the part of a node's surface that lies within a box, and whether the solid is turned inside out;
    /// `None` where nothing better than its own box is known.
    pub(crate) fn bounds_within(&self, node: NodeRef, within: &Aabb) -> Option<(Aabb, bool)> {
        let Node::Leaf(leaf) = node.node() else { return None };
        let ShapeKind::Quadric(quadric) = self.shape(leaf)? else { return None };
        let turned = quadric.is_turned() || self.leaves[leaf as usize].inverted;
        let Prim::Placed { place, .. } = self.leaves[leaf as usize].prim else {
            return Some((quadric.bounds_within(within), turned));
        };
        let object_from_world = &self.places[place as usize];
        let part = quadric.bounds_within(&transformed(within, object_from_world));
        Some((transformed(&part, &object_from_world.inverse()), turned))
    }

    /// Roughly what questions to a node cost, for their order.
    pub(crate) fn cost(&self, node: NodeRef) -> u32 {
        match node.node() {
            Node::Group(_) => 8,
            Node::Leaf(leaf) => self.shape(leaf).map_or(0, ShapeKind::cost),
        }
    }

    /// Is the point in the leaf, its inversion counted?
    pub(crate) fn inside(&self, index: u32, p: Vec3) -> bool {
        let leaf = &self.leaves[index as usize];
        let inside = match leaf.prim {
            Prim::Sphere(s) => self.spheres[s as usize].sphere.inside(p),
            Prim::World(s) => self.shapes[s as usize].inside(p),
            Prim::Placed { shape, place } => {
                self.shapes[shape as usize].inside(self.places[place as usize].transform_point3(p))
            }
        };
        inside != leaf.inverted
    }

    /// The hit in the shape's own coordinates.
    pub(crate) fn local_point(&self, ray: &Ray, hit: &Hit) -> Vec3 {
        match self.leaves[hit.leaf as usize].prim {
            Prim::Placed { place, .. } => {
                LocalRay::new(ray, &self.places[place as usize]).ray.at(hit.local.t)
            }
            _ => ray.at(hit.t),
        }
    }

    /// The unit normal in the world, the leaf's inversion counted, given the point in the shape's coordinates.
    pub(crate) fn normal(&self, hit: &Hit, local_point: Vec3) -> Vec3 {
        let n = match self.leaves[hit.leaf as usize].prim {
            Prim::Sphere(s) => self.spheres[s as usize].sphere.normal(local_point, &hit.local),
            Prim::World(s) => self.shapes[s as usize].normal(local_point, &hit.local),
            Prim::Placed { shape, place } => {
                let n = self.shapes[shape as usize].normal(local_point, &hit.local);
                transform::normal_by_inverse(&self.places[place as usize], n).normalize_or(Vec3::X)
            }
        };
        if hit.inverted { -n } else { n }
    }

    /// Texture coordinates; shapes without a rule of their own take x and y of the world point.
    pub(crate) fn uv(&self, hit: &Hit, local_point: Vec3, world_point: Vec3) -> Vec2 {
        let uv = match self.leaves[hit.leaf as usize].prim {
            Prim::Sphere(s) => {
                let WorldSphere { sphere, place } = &self.spheres[s as usize];
                let offset = sphere.normal(local_point, &hit.local) * sphere.sign();
                Some(Sphere::uv_of(match place {
                    Some(place) => self.places[*place as usize].transform_vector3(offset),
                    None => offset,
                }))
            }
            Prim::World(shape) | Prim::Placed { shape, .. } => {
                self.shapes[shape as usize].uv(local_point, &hit.local)
            }
        };
        uv.unwrap_or(Vec2::new(world_point.x, world_point.y))
    }

    /// The shape of a leaf, unless it is a sphere in world coordinates.
    pub(crate) fn shape(&self, leaf: u32) -> Option<&ShapeKind> {
        match self.leaves[leaf as usize].prim {
            Prim::Sphere(_) => None,
            Prim::World(shape) | Prim::Placed { shape, .. } => Some(&self.shapes[shape as usize]),
        }
    }
}
