//! Leaves: shapes at their places, asked in world coordinates.
use raggio_math::{Aabb, Affine, Ray, Vec2, Vec3, transform};

use crate::convex::Convex;
use crate::index::transformed;
use crate::shapes::{Cuboid, Few, PlacedCuboid, Plane, ShapeKind, Sphere};
use crate::tree::{Node, NodeRef};
use crate::{Hit, LocalHit, MaterialId, Surface};

/// A shape at its place.
#[derive(Clone, Copy)]
pub(crate) struct Leaf {
    pub(crate) prim: Prim,
    pub(crate) material: MaterialId,
    /// Turned inside out on the way down.
    pub(crate) inverted: bool,
    /// Has it more textures than its material's, listed in [`crate::texturing::Parts`]?
    pub(crate) has_parts: bool,
    /// Does light that reaches its outer side from in front never meet it again? Flat and convex shapes.
    pub(crate) convex: bool,
    /// Do combinations see of it only what a ray meets first? So they do in POV-Ray of a mesh without an inside.
    pub(crate) first_only: bool,
    /// Of surfaces of one object at the same distance, that of the leaf with the highest rank is seen.
    pub(crate) rank: u32,
}

/// Which shape, where. The simplest are here and now, in world coordinates.
#[derive(Clone, Copy)]
pub(crate) enum Prim {
    /// A sphere that its transform has left round.
    Sphere {
        sphere: Sphere,
        /// Place of a sphere that was turned, for the sake of its texture coordinates.
        place: Option<u32>,
    },
    /// A plane.
    Plane(Plane),
    /// A box along the axes.
    Box(Cuboid),
    /// A box at a place: index into [`Leaves::places`]. Its rays keep the world's distances. The nearest hit is asked of
    /// one of [`Leaves::boxes`], which stands for both.
    PlacedBox { cuboid: Cuboid, place: u32, both: u32 },
    /// A shape whose own coordinates are the world's: index into [`Leaves::shapes`].
    World(u32),
    /// A shape and its place: indices into [`Leaves::shapes`] and [`Leaves::places`].
    Placed { shape: u32, place: u32 },
}

/// All leaves of a scene and what they consist of, in flat arrays.
#[derive(Default)]
pub(crate) struct Leaves {
    pub(crate) leaves: Vec<Leaf>,
    pub(crate) shapes: Vec<ShapeKind>,
    /// `object_from_world`
    pub(crate) places: Vec<Affine>,
    /// Boxes at places.
    pub(crate) boxes: Vec<PlacedCuboid>,
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

    #[inline]
    fn range(&self, range: (f64, f64)) -> (f64, f64) {
        (range.0 * self.stretch, range.1 * self.stretch)
    }
}

/// The nearest hit of a shape at a place within a range of world distances, with its own. Not inlined: a caller that asks
/// many leaves would make its ray ready for a place before it knows whether there is one.
#[inline(never)]
fn closest_placed(
    shape: &ShapeKind,
    object_from_world: &Affine,
    ray: &Ray,
    range: (f64, f64),
    stops: impl Fn(f64, &LocalHit) -> bool,
) -> Option<(f64, LocalHit)> {
    let local = LocalRay::new(ray, object_from_world);
    let stops = |hit: &LocalHit| stops(hit.t / local.stretch, hit);
    let mut local_range = local.range(range);
    for _ in 0..ROUNDING_TRIES {
        let hit = shape.closest_or(&local.ray, local_range, &stops)?;
        let t = hit.t / local.stretch;
        // Rounding on the way to local distances and back must not let a hit through that the range shuts out.
        if t > range.0 {
            return (t < range.1).then_some((t, hit));
        }
        // Some shapes keep their distances only to within rounding.
        local_range.0 = hit.t.max(local_range.0) * (1.0 + 4.0 * f64::EPSILON);
    }
    None
}

/// A shape's normal as a unit normal in the world.
#[inline(always)]
pub(crate) fn moved_normal(object_from_world: &Affine, n: Vec3) -> Vec3 {
    transform::normal_by_inverse(object_from_world, n).normalize_or(Vec3::X)
}

/// Puts a hit where it is wanted, and says whether there is one.
#[inline(always)]
pub(crate) fn put(found: Option<Hit>, out: &mut Hit) -> bool {
    found.map(|hit| *out = hit).is_some()
}

impl Leaves {
    /// Is a shape flat, or a solid without hollows?
    pub(crate) fn is_convex(&self, prim: &Prim) -> bool {
        match prim {
            Prim::Sphere { .. } | Prim::Plane(_) | Prim::Box(_) | Prim::PlacedBox { .. } => true,
            Prim::World(shape) | Prim::Placed { shape, .. } => matches!(
                self.shapes[*shape as usize],
                ShapeKind::Sphere(_)
                    | ShapeKind::Plane(_)
                    | ShapeKind::Box(_)
                    | ShapeKind::Cone(_)
                    | ShapeKind::Disc(_)
                    | ShapeKind::Polygon(_)
            ),
        }
    }

    /// The nearest hit of one leaf, or any hit that `stops` says yes to.
    #[inline]
    pub(crate) fn closest(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        stops: &impl Fn(&Hit) -> bool,
    ) -> Option<Hit> {
        let mut hit = Hit::NONE;
        self.closest_into(index, ray, range, stops, &mut hit).then_some(hit)
    }

    /// Puts the hit that [`Leaves::closest`] finds where it is wanted, and says whether there is one. (Handed on from
    /// place to place it would be read back in other parts than it was written, which takes long.)
    #[inline]
    pub(crate) fn closest_into(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        stops: &impl Fn(&Hit) -> bool,
        out: &mut Hit,
    ) -> bool {
        let leaf = &self.leaves[index as usize];
        let at = |t: f64, local: LocalHit| Hit { t, leaf: index, inverted: leaf.inverted, local };
        let own = |local: LocalHit| at(local.t, local);
        match &leaf.prim {
            Prim::Sphere { sphere, .. } => put(sphere.closest(ray, range).map(own), out),
            Prim::Plane(plane) => put(plane.closest(ray, range).map(own), out),
            Prim::Box(cuboid) => put(cuboid.closest(ray, range).map(own), out),
            Prim::PlacedBox { both, .. } => put(self.boxes[*both as usize].closest(ray, range).map(own), out),
            Prim::World(s) => {
                let shape = &self.shapes[*s as usize];
                put(shape.closest_or(ray, range, |local| stops(&own(*local))).map(own), out)
            }
            Prim::Placed { shape, place } => {
                let (shape, place) = (&self.shapes[*shape as usize], &self.places[*place as usize]);
                let found = closest_placed(shape, place, ray, range, |t, local| stops(&at(t, *local)));
                put(found.map(|(t, local)| at(t, local)), out)
            }
        }
    }

    /// [`Leaves::closest_into`] for loops. Not inlined: the compiler would take out of the loop what any shape may ask of
    /// the ray, and work it out for every leaf.
    #[inline(never)]
    pub(crate) fn closest_apart(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        stops: &impl Fn(&Hit) -> bool,
        out: &mut Hit,
    ) -> bool {
        self.closest_into(index, ray, range, stops, out)
    }

    /// Collects every hit of one leaf in its shape's own coordinates, near ones first, where the shape has but a few;
    /// `None` where it may have more. Returns what to divide distances by.
    #[inline]
    fn few(&self, leaf: &Leaf, ray: &Ray, range: (f64, f64), out: &mut Few) -> Option<f64> {
        match &leaf.prim {
            Prim::Sphere { sphere, .. } => sphere.few(ray, range, out),
            Prim::Plane(plane) => out.extend(plane.closest(ray, range), range),
            Prim::Box(cuboid) => cuboid.few(ray, range, out),
            Prim::PlacedBox { cuboid, place, .. } => {
                cuboid.few(&ray.transformed(&self.places[*place as usize]), range, out);
            }
            Prim::World(s) => return self.shapes[*s as usize].few(ray, range, out).then_some(1.0),
            Prim::Placed { shape, place } => {
                let shape = &self.shapes[*shape as usize];
                if !shape.has_few() {
                    return None;
                }
                let local = LocalRay::new(ray, &self.places[*place as usize]);
                return shape.few(&local.ray, local.range(range), out).then_some(local.stretch);
            }
        }
        Some(1.0)
    }

    /// The nearest hit of one leaf that `counts` says yes to; of hits nearer to each other than `gap` only the first is
    /// asked about. Only for shapes with few hits: `None` for others.
    #[inline]
    pub(crate) fn closest_of_few(
        &self,
        index: u32,
        ray: &Ray,
        (mut from, to): (f64, f64),
        gap: f64,
        mut counts: impl FnMut(&Hit) -> bool,
    ) -> Option<Option<Hit>> {
        let leaf = &self.leaves[index as usize];
        let mut few = Few::default();
        let stretch = self.few(leaf, ray, (from, to), &mut few)?;
        while let Some(local) = few.pop_nearest() {
            let t = local.t / stretch;
            if t > from && t < to {
                let hit = Hit { t, leaf: index, inverted: leaf.inverted, local };
                if counts(&hit) {
                    return Some(Some(hit));
                }
                from = t + gap;
            }
        }
        Some(None)
    }

    /// The nearest hit of one leaf that `counts` says yes to; `None` for shapes that have no quick way to it.
    pub(crate) fn closest_counted(
        &self,
        index: u32,
        ray: &Ray,
        range: (f64, f64),
        counts: impl Fn(f64) -> bool,
    ) -> Option<Option<Hit>> {
        let leaf = &self.leaves[index as usize];
        let within = |t: f64| t > range.0 && t < range.1 && counts(t);
        let (found, stretch) = match &leaf.prim {
            Prim::World(s) => {
                (self.shapes[*s as usize].closest_counted(ray, range, &mut |t| within(t))?, 1.0)
            }
            Prim::Placed { shape, place } => {
                let local = LocalRay::new(ray, &self.places[*place as usize]);
                let mut counts = |t: f64| within(t / local.stretch);
                let shape = &self.shapes[*shape as usize];
                (shape.closest_counted(&local.ray, local.range(range), &mut counts)?, local.stretch)
            }
            _ => return None,
        };
        let hit = |local: LocalHit| Hit { t: local.t / stretch, leaf: index, inverted: leaf.inverted, local };
        Some(found.map(hit))
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
        let mut stretch = 1.0;
        match &leaf.prim {
            Prim::Sphere { sphere, .. } => sphere.hits(ray, range, buffer),
            Prim::Plane(plane) => plane.hits(ray, range, buffer),
            Prim::Box(cuboid) => cuboid.hits(ray, range, buffer),
            Prim::PlacedBox { cuboid, place, .. } => {
                cuboid.hits(&ray.transformed(&self.places[*place as usize]), range, buffer);
            }
            Prim::World(s) => self.shapes[*s as usize].hits(ray, range, buffer),
            Prim::Placed { shape, place } => {
                let local = LocalRay::new(ray, &self.places[*place as usize]);
                self.shapes[*shape as usize].hits(&local.ray, local.range(range), buffer);
                stretch = local.stretch;
            }
        }
        for &local in &buffer[start..] {
            let t = local.t / stretch;
            if t > range.0 && t < range.1 {
                out.push(Hit { t, leaf: index, inverted: leaf.inverted, local });
            }
        }
        buffer.truncate(start);
    }

    /// Is it plain that a ray is nowhere inside a leaf, nor meets its surface, within a range?
    pub(crate) fn plainly_misses(&self, index: u32, ray: &Ray, range: (f64, f64)) -> bool {
        match self.leaves[index as usize].prim {
            Prim::World(shape) => self.shapes[shape as usize].plainly_misses(ray, range),
            Prim::Placed { shape, place } => {
                let local = LocalRay::new(ray, &self.places[place as usize]);
                self.shapes[shape as usize].plainly_misses(&local.ray, local.range(range))
            }
            _ => false,
        }
    }

    /// A box around the part of a node's surface that lies within a box and behind some planes, and whether the solid is
    /// turned inside out; `None` where nothing better than its own box is known.
    pub(crate) fn bounds_within(
        &self,
        node: NodeRef,
        within: &Aabb,
        behind: Option<&Convex>,
    ) -> Option<(Aabb, bool)> {
        let Node::Leaf(leaf) = node.node() else { return None };
        let ShapeKind::Quadric(quadric) = self.shape(leaf)? else { return None };
        let turned = quadric.is_turned() || self.leaves[leaf as usize].inverted;
        let Prim::Placed { place, .. } = self.leaves[leaf as usize].prim else {
            let held = behind.map_or(*within, |planes| planes.bounds_within(within));
            return Some((quadric.bounds_within(&held), turned));
        };
        // Planes that are slanted in the world often stand straight beside the quadric.
        let object_from_world = &self.places[place as usize];
        let within = transformed(within, object_from_world);
        let held = behind.map_or(within, |planes| planes.planes_in(object_from_world).bounds_within(&within));
        let part = quadric.bounds_within(&held);
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
    #[inline]
    pub(crate) fn inside(&self, index: u32, p: Vec3) -> bool {
        let leaf = &self.leaves[index as usize];
        let moved = |place: u32| self.places[place as usize].transform_point3(p);
        let inside = match &leaf.prim {
            Prim::Sphere { sphere, .. } => sphere.inside(p),
            Prim::Plane(plane) => plane.inside(p),
            Prim::Box(cuboid) => cuboid.inside(p),
            Prim::PlacedBox { cuboid, place, .. } => cuboid.inside(moved(*place)),
            Prim::World(s) => return self.shapes[*s as usize].holds(p, leaf.inverted),
            Prim::Placed { shape, place } => {
                return self.shapes[*shape as usize].holds(moved(*place), leaf.inverted);
            }
        };
        inside != leaf.inverted
    }

    /// A point of the world in the coordinates of the shape of a leaf.
    pub(crate) fn local_point(&self, leaf: u32, p: Vec3) -> Vec3 {
        match self.leaves[leaf as usize].prim {
            Prim::Placed { place, .. } | Prim::PlacedBox { place, .. } => {
                self.places[place as usize].transform_point3(p)
            }
            _ => p,
        }
    }

    /// The unit normal in the world at a hit, the leaf's inversion counted.
    #[inline(always)]
    pub(crate) fn normal(&self, hit: &Hit, p: Vec3) -> Vec3 {
        let n = match &self.leaves[hit.leaf as usize].prim {
            Prim::Sphere { sphere, .. } => sphere.normal(p, &hit.local),
            Prim::Plane(plane) => plane.normal(p, &hit.local),
            Prim::Box(cuboid) => cuboid.normal(p, &hit.local),
            Prim::PlacedBox { both, .. } => self.boxes[*both as usize].normal(&hit.local),
            Prim::World(s) => self.shapes[*s as usize].normal(p, &hit.local),
            Prim::Placed { shape, place } => {
                let place = &self.places[*place as usize];
                moved_normal(
                    place,
                    self.shapes[*shape as usize].normal(place.transform_point3(p), &hit.local),
                )
            }
        };
        if hit.inverted { -n } else { n }
    }

    /// Texture coordinates at a hit; shapes without a rule of their own take x and y of the point.
    pub(crate) fn uv(&self, hit: &Hit, p: Vec3) -> Vec2 {
        let local = || self.local_point(hit.leaf, p);
        let uv = match &self.leaves[hit.leaf as usize].prim {
            Prim::Sphere { sphere, place } => {
                let offset = sphere.normal(p, &hit.local) * sphere.sign();
                Some(Sphere::uv_of(match place {
                    Some(place) => self.places[*place as usize].transform_vector3(offset),
                    None => offset,
                }))
            }
            Prim::Plane(_) => None,
            Prim::Box(cuboid) | Prim::PlacedBox { cuboid, .. } => cuboid.uv(local(), &hit.local),
            Prim::World(shape) | Prim::Placed { shape, .. } => {
                self.shapes[*shape as usize].uv(local(), &hit.local)
            }
        };
        uv.unwrap_or(Vec2::new(p.x, p.y))
    }

    /// The shape of a leaf, unless it is one of the simplest.
    pub(crate) fn shape(&self, leaf: u32) -> Option<&ShapeKind> {
        match self.leaves[leaf as usize].prim {
            Prim::World(shape) | Prim::Placed { shape, .. } => Some(&self.shapes[shape as usize]),
            _ => None,
        }
    }

    /// Is the node a plane?
    pub(crate) fn is_plane(&self, node: NodeRef) -> bool {
        matches!(node.node(), Node::Leaf(leaf) if matches!(self.leaves[leaf as usize].prim, Prim::Plane(_)))
    }

    /// Is asking whether a point is in the node as quick as asking its boxes?
    pub(crate) fn is_quick(&self, node: NodeRef) -> bool {
        matches!(node.node(), Node::Leaf(leaf)
            if matches!(self.leaves[leaf as usize].prim, Prim::Sphere { .. } | Prim::Plane(_) | Prim::Box(_)))
    }
}
