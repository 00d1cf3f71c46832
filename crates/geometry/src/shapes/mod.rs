//! Every kind of shape, one file each; registered here once.
mod bicubic;
mod blob;
mod collect;
mod container;
mod height_field;
mod hypercomplex;
mod isosurface;
mod julia;
mod lathe;
mod outline;
mod ovus;
mod parametric;
mod plane;
mod poly;
mod prism;
mod quaternion;
#[cfg(test)]
mod recorded_tests;
mod revolve;
mod sor;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
mod text;
mod torus;
mod tree;

use raggio_math::{Aabb, Ray, Vec2, Vec3};
use raggio_scene::Shape;

use crate::{BuildError, LocalHit, Surface};

pub(crate) use plane::Plane;
pub(crate) use sphere::Sphere;

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
            fn inside_bounds(&self) -> Aabb {
                match self { $(ShapeKind::$kind(s) => s.inside_bounds(),)* }
            }
            fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
                match self { $(ShapeKind::$kind(s) => s.hits(ray, range, out),)* }
            }
            fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
                match self { $(ShapeKind::$kind(s) => s.closest(ray, range),)* }
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
    HeightField(Box<height_field::HeightField>),
    Isosurface(Box<isosurface::Isosurface>),
    Julia(Box<julia::Julia>),
    Lathe(lathe::Lathe),
    Ovus(ovus::Ovus),
    Parametric(Box<parametric::Parametric>),
    Plane(Plane),
    Poly(poly::Poly),
    Prism(Box<prism::Prism>),
    Sor(sor::Sor),
    Sphere(Sphere),
    SphereSweep(sphere_sweep::SphereSweep),
    Superellipsoid(superellipsoid::Superellipsoid),
    Text(text::Text),
    Torus(torus::Torus),
}

/// Makes a shape ready. Shapes that cannot be hit at all (no radius, no area) are valid and simply never hit.
pub(crate) fn build(shape: &Shape) -> Result<ShapeKind, BuildError> {
    Ok(match shape {
        Shape::Sphere { center, radius } => ShapeKind::Sphere(Sphere::new(*center, *radius)),
        Shape::Plane { normal, distance } => ShapeKind::Plane(Plane::new(*normal, *distance)),
        Shape::Box { .. } => return Err(BuildError::Unsupported("box")),
        Shape::Cylinder { .. } => return Err(BuildError::Unsupported("cylinder")),
        Shape::Cone { .. } => return Err(BuildError::Unsupported("cone")),
        Shape::Disc { .. } => return Err(BuildError::Unsupported("disc")),
        Shape::Quadric(_) => return Err(BuildError::Unsupported("quadric")),
        Shape::Triangle { .. } => return Err(BuildError::Unsupported("triangle")),
        Shape::SmoothTriangle { .. } => return Err(BuildError::Unsupported("smooth_triangle")),
        Shape::Polygon { .. } => return Err(BuildError::Unsupported("polygon")),
        Shape::Mesh(_) => return Err(BuildError::Unsupported("mesh")),
        Shape::Torus { major, minor } => ShapeKind::Torus(torus::Torus::new(*major, *minor)),
        Shape::Poly { degree, coefficients } => {
            ShapeKind::Poly(poly::Poly::new(*degree, coefficients.clone()))
        }
        Shape::Superellipsoid { e, n } => {
            ShapeKind::Superellipsoid(superellipsoid::Superellipsoid::new(*e, *n))
        }
        Shape::Ovus { bottom, top } => ShapeKind::Ovus(ovus::Ovus::new(*bottom, *top)),
        Shape::BicubicPatch { flatness, u_steps, v_steps, points, uv, .. } => {
            ShapeKind::Bicubic(Box::new(bicubic::Bicubic::new(points, *flatness, *u_steps, *v_steps, *uv)))
        }
        Shape::HeightField(field) => {
            ShapeKind::HeightField(Box::new(height_field::HeightField::new(field.clone())))
        }
        Shape::Blob(blob) => ShapeKind::Blob(blob::Blob::new(blob)),
        Shape::Julia(julia) => ShapeKind::Julia(Box::new(julia::Julia::new(julia))),
        Shape::Lathe { curves, .. } => ShapeKind::Lathe(lathe::Lathe::new(curves)),
        Shape::Sor { points, open } => ShapeKind::Sor(sor::Sor::new(points, *open)),
        Shape::Prism(prism) => ShapeKind::Prism(Box::new(prism::Prism::new(prism))),
        Shape::SphereSweep { kind, spheres, tolerance } => {
            ShapeKind::SphereSweep(sphere_sweep::SphereSweep::new(*kind, spheres, *tolerance))
        }
        Shape::Text { glyphs, depth } => ShapeKind::Text(text::Text::new(glyphs, *depth)),
        Shape::Isosurface(iso) => ShapeKind::Isosurface(Box::new(isosurface::Isosurface::new(iso))),
        Shape::Parametric(p) => ShapeKind::Parametric(Box::new(parametric::Parametric::new(p))),
    })
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
