//! Every kind of shape, one file each; registered here once.
mod bicubic;
mod blob;
mod box_;
mod collect;
mod cone;
mod container;
mod disc;
mod extruded;
mod height_field;
mod hypercomplex;
mod isosurface;
mod julia;
mod lathe;
mod mesh;
mod nurbs;
mod outline;
mod ovus;
mod parametric;
mod parts;
mod plane;
mod plane_tree;
mod poly;
mod polygon;
mod prism;
mod quadric;
mod quaternion;
#[cfg(test)]
mod recorded_tests;
mod revolve;
mod sheet;
mod sor;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
mod text;
mod torus;
mod triangle;

use raggio_math::{Aabb, Affine, Ray, Vec2, Vec3};
use raggio_scene::Shape;

use crate::index::padded;
use crate::shape_pool::uniform_scale;
use crate::texturing::PartUses;
use crate::{BuildError, LocalHit, Surface};

pub(crate) use blob::acting;
pub(crate) use box_::{AxisRay, Cuboid, PlacedCuboid};
pub(crate) use cone::Cone;
pub(crate) use disc::Disc;
pub(crate) use julia::radius as julia_radius;
pub(crate) use mesh::MeshShape;
pub(crate) use plane::Plane;
pub(crate) use polygon::Polygon;
pub(crate) use quadric::Quadric;
pub(crate) use sphere::Sphere;
pub(crate) use triangle::Triangle;

/// Makes the closed enum over all kinds and forwards every question to the kind at hand, without virtual calls.
macro_rules! shape_kinds {
    ($($kind:ident($type:ty),)*) => {
        /// A shape of any kind, ready to be hit.
        pub(crate) enum ShapeKind {
            $($kind($type),)*
        }

        impl Surface for ShapeKind {
            fn bounds(&self) -> Aabb {
                match self { $(ShapeKind::$kind(s) => s.bounds(),)* }
            }
            fn reach(&self, along: Vec3) -> Option<f64> {
                match self { $(ShapeKind::$kind(s) => s.reach(along),)* }
            }
            fn inside_bounds(&self) -> Aabb {
                match self { $(ShapeKind::$kind(s) => s.inside_bounds(),)* }
            }
            fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
                match self { $(ShapeKind::$kind(s) => s.hits(ray, range, out),)* }
            }
            fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
                match self { $(ShapeKind::$kind(s) => s.closest(ray, range),)* }
            }
            fn closest_counted(
                &self,
                ray: &Ray,
                range: (f64, f64),
                counts: &mut dyn FnMut(f64) -> bool,
            ) -> Option<Option<LocalHit>> {
                match self { $(ShapeKind::$kind(s) => s.closest_counted(ray, range, counts),)* }
            }
            fn inside(&self, p: Vec3) -> bool {
                match self { $(ShapeKind::$kind(s) => s.inside(p),)* }
            }
            fn is_solid(&self) -> bool {
                match self { $(ShapeKind::$kind(s) => s.is_solid(),)* }
            }
            fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
                match self { $(ShapeKind::$kind(s) => s.normal(p, hit),)* }
            }
            fn uv(&self, p: Vec3, hit: &LocalHit) -> Option<Vec2> {
                match self { $(ShapeKind::$kind(s) => s.uv(p, hit),)* }
            }
        }
    };
}

// Kinds with more than some 200 bytes of their own belong in a `Box`, so that small ones stay small.
shape_kinds! {
    Bicubic(Box<bicubic::Bicubic>),
    Blob(blob::Blob),
    Box(Cuboid),
    Cone(Box<Cone>),
    Disc(Disc),
    HeightField(Box<height_field::HeightField>),
    Isosurface(Box<isosurface::Isosurface>),
    Julia(Box<julia::Julia>),
    Lathe(lathe::Lathe),
    Mesh(Box<MeshShape>),
    Nurbs(Box<nurbs::NurbsPatch>),
    Ovus(ovus::Ovus),
    Parametric(Box<parametric::Parametric>),
    Plane(Plane),
    Poly(poly::Poly),
    Polygon(Box<Polygon>),
    Prism(Box<prism::Prism>),
    Quadric(Box<Quadric>),
    Sor(sor::Sor),
    Sphere(Sphere),
    SphereSweep(sphere_sweep::SphereSweep),
    Superellipsoid(superellipsoid::Superellipsoid),
    Text(text::Text),
    Torus(torus::Torus),
    Triangle(Box<Triangle>),
}

/// Makes a shape ready, after so many Julia `fractals`. Shapes that cannot be hit at all (no radius, no area) are valid
/// and simply never hit.
pub(crate) fn build(shape: &Shape, fractals: usize) -> Result<ShapeKind, BuildError> {
    Ok(match shape {
        Shape::Sphere { center, radius } => ShapeKind::Sphere(Sphere::new(*center, *radius)),
        Shape::Plane { normal, distance } => ShapeKind::Plane(Plane::new(*normal, *distance)),
        Shape::Box { min, max } => ShapeKind::Box(Cuboid::new(*min, *max)),
        Shape::Cylinder { base, cap, radius, open } => {
            ShapeKind::Cone(Box::new(Cone::cylinder(*base, *cap, *radius, *open)))
        }
        Shape::Cone { base, base_radius, cap, cap_radius, open } => {
            ShapeKind::Cone(Box::new(Cone::new(*base, *base_radius, *cap, *cap_radius, *open)))
        }
        Shape::Disc { center, normal, radius, hole } => {
            ShapeKind::Disc(Disc::new(*center, *normal, *radius, *hole))
        }
        Shape::Quadric(coefficients) => ShapeKind::Quadric(Box::new(Quadric::new(coefficients))),
        Shape::Triangle { points } => triangle(points, None, &Affine::IDENTITY),
        Shape::SmoothTriangle { points, normals } => triangle(points, Some(normals), &Affine::IDENTITY),
        Shape::Polygon { loops } => ShapeKind::Polygon(Box::new(Polygon::new(loops))),
        Shape::Mesh(mesh) => ShapeKind::Mesh(Box::new(MeshShape::new(mesh))),
        Shape::Torus { major, minor } => ShapeKind::Torus(torus::Torus::new(*major, *minor)),
        Shape::Poly { degree, coefficients } => ShapeKind::Poly(poly::Poly::new(*degree, coefficients)),
        Shape::Superellipsoid { e, n } => {
            ShapeKind::Superellipsoid(superellipsoid::Superellipsoid::new(*e, *n))
        }
        Shape::Ovus { bottom, top } => ShapeKind::Ovus(ovus::Ovus::new(*bottom, *top)),
        Shape::BicubicPatch { flatness, u_steps, v_steps, points, uv, .. } => {
            patch(points, *flatness, (*u_steps, *v_steps), **uv)
        }
        Shape::HeightField(field) => {
            ShapeKind::HeightField(Box::new(height_field::HeightField::new(field.clone())))
        }
        Shape::Blob(blob) => ShapeKind::Blob(blob::Blob::new(blob, &Affine::IDENTITY)),
        Shape::Julia(julia) => ShapeKind::Julia(Box::new(julia::Julia::new(julia, fractals))),
        Shape::Lathe { curves, .. } => ShapeKind::Lathe(lathe::Lathe::new(curves)),
        Shape::Sor { points, open } => ShapeKind::Sor(sor::Sor::new(points, *open)),
        Shape::Prism(prism) => ShapeKind::Prism(Box::new(prism::Prism::new(prism))),
        Shape::SphereSweep { kind, spheres, tolerance } => {
            ShapeKind::SphereSweep(sphere_sweep::SphereSweep::new(*kind, spheres, *tolerance))
        }
        Shape::Text { glyphs, depth } => ShapeKind::Text(text::Text::new(glyphs, *depth)),
        Shape::Isosurface(iso) => isosurface(iso, &Affine::IDENTITY),
        Shape::Nurbs(n) => ShapeKind::Nurbs(Box::new(nurbs::NurbsPatch::new(n))),
        Shape::Parametric(p) => ShapeKind::Parametric(Box::new(parametric::Parametric::new(p))),
    })
}

fn triangle(points: &[Vec3; 3], normals: Option<&[Vec3; 3]>, place: &Affine) -> ShapeKind {
    ShapeKind::Triangle(Box::new(Triangle::new(*points, normals.copied(), place)))
}

/// Shapes that are kept in the world's coordinates instead of at a place; `None` for all others.
pub(crate) fn moved(shape: &Shape, world_from_object: &Affine) -> Option<ShapeKind> {
    match shape {
        Shape::Triangle { points } => Some(triangle(points, None, world_from_object)),
        Shape::SmoothTriangle { points, normals } => Some(triangle(points, Some(normals), world_from_object)),
        // Their flatness, least distance and accuracy are measured in the world.
        Shape::BicubicPatch { flatness, u_steps, v_steps, points, uv, .. }
            if !is_rigid(world_from_object) =>
        {
            let points = points.map(|row| row.map(|p| world_from_object.transform_point3(p)));
            Some(patch(&points, *flatness, (*u_steps, *v_steps), **uv))
        }
        Shape::Blob(blob) if !is_rigid(world_from_object) => {
            Some(ShapeKind::Blob(blob::Blob::new(blob, world_from_object)))
        }
        // It turns its rays itself.
        Shape::Isosurface(iso) => Some(isosurface(iso, world_from_object)),
        Shape::Cylinder { base, cap, radius, open } => {
            moved_cone(&Cone::cylinder(*base, *cap, *radius, *open), world_from_object)
        }
        Shape::Cone { base, base_radius, cap, cap_radius, open } => {
            moved_cone(&Cone::new(*base, *base_radius, *cap, *cap_radius, *open), world_from_object)
        }
        Shape::Disc { center, normal, radius, hole } => {
            let scale = uniform_scale(world_from_object)?;
            let disc = Disc::new(*center, *normal, *radius, *hole).moved(world_from_object, scale);
            Some(ShapeKind::Disc(disc))
        }
        _ => None,
    }
}

/// Cones and cylinders whose transform leaves them round go into the world.
fn moved_cone(cone: &Cone, world_from_object: &Affine) -> Option<ShapeKind> {
    let scale = uniform_scale(world_from_object)?;
    Some(ShapeKind::Cone(Box::new(cone.moved(world_from_object, scale))))
}

fn patch(points: &[[Vec3; 4]; 4], flatness: f64, steps: (u32, u32), uv: [Vec2; 4]) -> ShapeKind {
    ShapeKind::Bicubic(Box::new(bicubic::Bicubic::new(points, flatness, steps.0, steps.1, uv)))
}

fn isosurface(iso: &raggio_scene::Isosurface, place: &Affine) -> ShapeKind {
    ShapeKind::Isosurface(Box::new(isosurface::Isosurface::new(iso, place)))
}

/// Does the transform keep all distances?
fn is_rigid(t: &Affine) -> bool {
    let product = t.matrix3.transpose() * t.matrix3;
    product.abs_diff_eq(raggio_math::Mat3::IDENTITY, 1e-9)
}

/// Shapes that `inverse` changes in themselves; `None` for all others, whose inside and normal are turned by whoever
/// asks.
pub(crate) fn inverse(shape: &Shape) -> Option<ShapeKind> {
    match shape {
        Shape::Quadric(coefficients) => {
            Some(ShapeKind::Quadric(Box::new(Quadric::new(coefficients).inverse())))
        }
        _ => None,
    }
}

/// Where a ray is inside a simple body: between two distances, or before the one and beyond the other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    pub(crate) enter: f64,
    pub(crate) leave: f64,
    /// Is the inside what lies beyond both ends?
    pub(crate) beyond: bool,
}

impl Stretch {
    /// Inside nowhere.
    pub(crate) const NOWHERE: Self =
        Stretch { enter: f64::INFINITY, leave: f64::NEG_INFINITY, beyond: false };
    /// Inside everywhere.
    pub(crate) const EVERYWHERE: Self = Stretch { beyond: true, ..Stretch::NOWHERE };

    /// Inside between two distances.
    #[inline(always)]
    pub(crate) fn between(ends: Option<(f64, f64)>) -> Self {
        ends.map_or(Stretch::NOWHERE, |(enter, leave)| Stretch { enter, leave, beyond: false })
    }
}

/// The most hits of a shape that finds them all together: the four of a double cone or a torus.
pub(crate) const FEW: usize = 4;

/// Hits of a simple shape, without memory of their own.
#[derive(Default)]
pub(crate) struct Few {
    hits: [(f64, u32); FEW],
    len: usize,
}

impl Few {
    /// Adds a hit, if it is in the range. More than [`FEW`] are not kept.
    #[inline(always)]
    pub(crate) fn push(&mut self, t: f64, part: u32, range: (f64, f64)) {
        if t > range.0 && t < range.1 && self.len < FEW {
            self.hits[self.len] = (t, part);
            self.len += 1;
        }
    }

    /// Adds a hit, if there is one.
    #[inline(always)]
    pub(crate) fn extend(&mut self, hit: Option<LocalHit>, range: (f64, f64)) {
        if let Some(hit) = hit {
            self.push(hit.t, hit.part, range);
        }
    }

    /// Takes the nearest hit out.
    #[inline(always)]
    pub(crate) fn pop_nearest(&mut self) -> Option<LocalHit> {
        self.len = self.len.checked_sub(1)?;
        let mut first = self.len;
        for i in 0..self.len {
            if self.hits[i].0 < self.hits[first].0 {
                first = i;
            }
        }
        let (t, part) = self.hits[first];
        self.hits[first] = self.hits[self.len];
        Some(LocalHit { part, ..LocalHit::at(t) })
    }

    /// All hits, in the order in which they came.
    pub(crate) fn into_hits(self, out: &mut Vec<LocalHit>) {
        out.extend(self.hits[..self.len].iter().map(|&(t, part)| LocalHit { part, ..LocalHit::at(t) }));
    }
}

impl ShapeKind {
    /// Adds all hits within the range, if the shape has but a few and finds them together; or returns false.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) -> bool {
        match self {
            ShapeKind::Box(s) => s.few(ray, range, out),
            ShapeKind::Cone(s) => s.few(ray, range, out),
            ShapeKind::Quadric(s) => s.few(ray, range, out),
            ShapeKind::Torus(s) => s.few(ray, range, out),
            ShapeKind::Plane(s) => out.extend(s.closest(ray, range), range),
            ShapeKind::Disc(s) => out.extend(s.closest(ray, range), range),
            _ => return false,
        }
        true
    }

    /// Does [`ShapeKind::few`] know the shape?
    #[inline]
    pub(crate) fn has_few(&self) -> bool {
        use ShapeKind::{Box, Cone, Disc, Plane, Quadric, Torus};
        matches!(self, Box(_) | Cone(_) | Disc(_) | Plane(_) | Quadric(_) | Torus(_))
    }

    /// The nearest hit, or any that `stops` says yes to where it is quicker to end there.
    #[inline]
    pub(crate) fn closest_or(
        &self,
        ray: &Ray,
        range: (f64, f64),
        stops: impl FnMut(&LocalHit) -> bool,
    ) -> Option<LocalHit> {
        match self {
            ShapeKind::Mesh(mesh) => mesh.closest_or(ray, range, stops),
            ShapeKind::Julia(julia) => julia.closest_or(ray, range, stops),
            _ => self.closest(ray, range),
        }
    }

    /// Is its search for all hits about as quick as that for the nearest, and are they those that searches for the
    /// nearest would find one after another?
    #[inline]
    pub(crate) fn finds_all_at_once(&self) -> bool {
        use ShapeKind::{Blob, Julia, Lathe, Ovus, Poly, Sor, SphereSweep, Superellipsoid};
        matches!(
            self,
            Blob(_) | Julia(_) | Lathe(_) | Ovus(_) | Poly(_) | Sor(_) | SphereSweep(_) | Superellipsoid(_)
        )
    }

    /// Is the point in it, or in it turned inside out? Nothing is in what has no inside, however it is turned.
    #[inline]
    pub(crate) fn holds(&self, p: Vec3, inverted: bool) -> bool {
        let inside = self.inside(p);
        inside != inverted && (inside || self.is_solid())
    }

    /// Does it know of [`ShapeKind::plainly_misses`]?
    pub(crate) fn tells_misses(&self) -> bool {
        matches!(self, ShapeKind::Blob(_))
    }

    /// Is it plain that a ray is nowhere inside, nor meets the surface, within a range? Asked only where that is much
    /// quicker than a search.
    #[inline]
    pub(crate) fn plainly_misses(&self, ray: &Ray, range: (f64, f64)) -> bool {
        match self {
            ShapeKind::Blob(blob) => blob.plainly_misses(ray, range),
            _ => false,
        }
    }

    /// Roughly what questions cost, for their order: 0 for a plane, more for what takes iterations.
    pub(crate) fn cost(&self) -> u32 {
        match self {
            ShapeKind::Plane(_) | ShapeKind::Box(_) | ShapeKind::Disc(_) | ShapeKind::Triangle(_) => 0,
            ShapeKind::Quadric(_) | ShapeKind::Cone(_) => 1,
            ShapeKind::Torus(_) | ShapeKind::Polygon(_) | ShapeKind::Ovus(_) => 2,
            ShapeKind::Isosurface(_) | ShapeKind::Julia(_) | ShapeKind::Parametric(_) => 9,
            _ => 4,
        }
    }

    /// Is it plain that the surface does not reach into the hull of some points?
    pub(crate) fn misses(&self, hull: &[Vec3; 8]) -> bool {
        match self {
            ShapeKind::Plane(s) => s.misses(hull),
            ShapeKind::Sphere(s) => s.misses(hull),
            ShapeKind::Box(s) => s.misses(hull),
            ShapeKind::Cone(s) => s.misses(hull) || apart(&s.bounds(), hull),
            other => apart(&other.bounds(), hull),
        }
    }

    /// Is it plain that neither surface nor inside reach into the hull of some points?
    pub(crate) fn lacks(&self, hull: &[Vec3; 8]) -> bool {
        self.is_solid() && apart(&self.bounds().union(&self.inside_bounds()), hull)
    }

    /// The textures at a point of a surface whose parts have textures of their own: numbers of the scene's data and
    /// their shares. Nothing where the object's own texture counts.
    pub(crate) fn part_uses(&self, p: Vec3, hit: &LocalHit, out: &mut PartUses) {
        match self {
            ShapeKind::Mesh(mesh) => mesh.part_uses(hit, out),
            ShapeKind::Blob(blob) => blob.weights(p, out),
            _ => {}
        }
    }
}

/// Do all points lie beyond one side of a box?
fn apart(b: &Aabb, hull: &[Vec3; 8]) -> bool {
    let (b, around) = (padded(b), Aabb::around(*hull));
    around.min.cmpgt(b.max).any() || around.max.cmplt(b.min).any()
}

/// Where on the way along a direction the points begin.
fn start_along(hull: &[Vec3; 8], direction: Vec3) -> f64 {
    hull.iter().fold(f64::INFINITY, |least, p| least.min(p.dot(direction)))
}

/// Is `a` greater than `b` by more than rounding?
fn clearly_beyond(a: f64, b: f64) -> bool {
    a - b > 1e-9 * (1.0 + a.abs() + b.abs())
}

/// The part of `range` that a shape may report: beyond its own least distance.
#[inline]
pub(crate) fn beyond(range: (f64, f64), least: f64) -> (f64, f64) {
    (range.0.max(least), range.1)
}

/// The turn about y of a point, as a share of a full turn in 0..1; 0 on the axis (shapes spec, section 1.5).
pub(crate) fn turn(x: f64, z: f64) -> f64 {
    if x * x + z * z <= raggio_math::EPS {
        return 0.0;
    }
    (z.atan2(x) / std::f64::consts::TAU).rem_euclid(1.0)
}
