//! The box that the language tells of an object (`min_extent`, `max_extent`), and at which photons are aimed. It is not
//! the tightest one: it follows rules of its own (shapes spec, sections 1.4 and 8), and is unbounded as soon as one part
//! of it is.
use std::sync::Arc;

use raggio_math::{Aabb, Affine, EPS, Vec3, poly};
use raggio_scene::{Csg, Curve2, Object, ObjectKind, Shape, SplineKind, SweepSphere};

use crate::Geometry;
use crate::index::transformed;
use crate::shape_pool::uniform_scale;
use crate::shapes::{acting, julia_radius};

/// Flat shapes are as thick as this, each way.
const FLAT: f64 = 1e-3;

/// Superellipsoids reach so far beyond their cube.
const ROUND: f64 = 1.0001;

/// A box in coordinates of its own: turned later, it grows less than if it were turned twice.
struct Boxed {
    bounds: Aabb,
    /// Into the coordinates of the object's kind.
    place: Affine,
}

/// The box of an object, in its parent's coordinates.
pub fn extent(object: &Object) -> Aabb {
    let inner = match &object.kind {
        ObjectKind::Shape(shape) => boxed(shape),
        ObjectKind::Light(_) => Boxed::straight(Aabb::INFINITE),
        ObjectKind::LightGroup { children, .. } => Boxed::straight(united(children)),
        ObjectKind::Csg { op: Csg::Union | Csg::Merge, children } => Boxed::straight(united(children)),
        ObjectKind::Csg { op, children } => Boxed::straight(common(object, *op, children)),
    };
    let mut whole = match inner.bounds.is_finite() {
        true => transformed(&inner.bounds, &(object.parent_from_object * inner.place)),
        false => Aabb::INFINITE,
    };
    if let ObjectKind::Shape(shape) = &object.kind {
        match **shape {
            // They keep theirs.
            Shape::HeightField(_) => return whole,
            Shape::Sphere { center, radius } => {
                // One that is still round is as wide as before.
                if let Some(scale) = uniform_scale(&object.parent_from_object) {
                    let center = object.parent_from_object.transform_point3(center);
                    whole = Aabb::around([center]).grown(scale * radius.abs());
                }
            }
            // Its part between the clips.
            Shape::Quadric(_) if !object.clips.is_empty() => whole = bounded(tight(object)),
            _ => {}
        }
    }
    [&object.clips, &object.bounds].into_iter().fold(whole, |whole, fences| fenced(whole, fences))
}

/// A box that clips or bounds replace if theirs is smaller.
fn fenced(whole: Aabb, fences: &[Arc<Object>]) -> Aabb {
    let volume = |b: &Aabb| b.size().element_product();
    let held = fences.iter().fold(Aabb::INFINITE, |held, fence| held.intersection(&extent(fence)));
    if held.is_finite() && (!whole.is_finite() || volume(&held) < volume(&whole)) { held } else { whole }
}

fn united(children: &[Arc<Object>]) -> Aabb {
    bounded(children.iter().fold(Aabb::EMPTY, |all, child| all.union(&extent(child))))
}

/// A box that ends in all directions, or none.
fn bounded(b: Aabb) -> Aabb {
    if b.is_finite() && !b.is_empty() { b } else { Aabb::INFINITE }
}

/// What the members of an intersection or difference have in common, as far as they are not turned inside out. Planes
/// count, if they are at a right angle to an axis; height fields do not.
fn common(object: &Object, op: Csg, children: &[Arc<Object>]) -> Aabb {
    let cut = children.iter().enumerate().fold(Aabb::INFINITE, |held, (i, child)| {
        let turned = child.inverse != (i > 0 && matches!(op, Csg::Difference { .. }));
        let member = match &child.kind {
            ObjectKind::Shape(shape) => match **shape {
                Shape::Plane { normal, distance } => half(normal, distance, child, turned),
                Shape::HeightField(_) => Aabb::INFINITE,
                // Its part between the others.
                Shape::Quadric(_) if !turned => tight(&unplaced(object)),
                _ if turned => Aabb::INFINITE,
                _ => extent(child),
            },
            _ if turned => Aabb::INFINITE,
            _ => extent(child),
        };
        held.intersection(&member)
    });
    bounded(cut)
}

/// A combination in its own coordinates, without its fences.
fn unplaced(object: &Object) -> Object {
    Object { parent_from_object: Affine::IDENTITY, clips: Vec::new(), bounds: Vec::new(), ..object.clone() }
}

/// The half of space behind a plane that is at a right angle to an axis.
fn half(normal: Vec3, distance: f64, plane: &Object, turned: bool) -> Aabb {
    let to = &plane.parent_from_object;
    let n = raggio_math::transform::normal_by_inverse(&to.inverse(), normal).normalize_or_zero();
    let d = n.dot(to.transform_point3(normal * distance));
    let (n, d) = if turned { (-n, -d) } else { (n, d) };
    let mut side = Aabb::INFINITE;
    for k in 0..3 {
        if n[k] >= 1.0 - EPS {
            side.max[k] = d;
        } else if n[k] <= EPS - 1.0 {
            side.min[k] = -d;
        }
    }
    side
}

impl Boxed {
    fn straight(bounds: Aabb) -> Self {
        Boxed { bounds, place: Affine::IDENTITY }
    }

    /// A box that stands on the origin along z, moved to a place with z turned to an axis.
    fn on_axis(bounds: Aabb, axis: Vec3, origin: Vec3) -> Self {
        let turn = match Vec3::Z.cross(axis).try_normalize() {
            Some(around) => Affine::from_axis_angle(around, axis.z.clamp(-1.0, 1.0).acos()),
            None if axis.z < 0.0 => Affine::from_axis_angle(Vec3::X, std::f64::consts::PI),
            None => Affine::IDENTITY,
        };
        Boxed { bounds, place: Affine::from_translation(origin) * turn }
    }

    /// Around a part of a cone, which is told by its wider end.
    fn round(wide: Vec3, narrow: Vec3, radius: f64) -> Self {
        let length = (wide - narrow).length();
        let bounds = Aabb { min: Vec3::new(-radius, -radius, 0.0), max: Vec3::new(radius, radius, length) };
        Boxed::on_axis(bounds, (wide - narrow).normalize_or(Vec3::Z), narrow)
    }
}

fn boxed(shape: &Arc<Shape>) -> Boxed {
    match &**shape {
        Shape::Sphere { center, radius } => Boxed::straight(Aabb::around([*center]).grown(radius.abs())),
        Shape::Box { min, max } => Boxed::straight(Aabb { min: *min, max: *max }),
        &Shape::Cylinder { base, cap, radius, .. } => Boxed::round(base, cap, radius),
        &Shape::Cone { base, base_radius, cap, cap_radius, .. } => match base_radius >= cap_radius {
            true => Boxed::round(base, cap, base_radius),
            false => Boxed::round(cap, base, cap_radius),
        },
        &Shape::Disc { center, normal, radius, .. } => {
            let size = Vec3::new(radius, radius, FLAT);
            Boxed::on_axis(Aabb { min: -size, max: size }, normal, center)
        }
        Shape::Mesh(mesh) => {
            Boxed::straight(Aabb::around(mesh.vertices.iter().map(|v| v.map(f64::from).into())))
        }
        Shape::BicubicPatch { points, .. } => Boxed::straight(Aabb::around(points.iter().flatten().copied())),
        Shape::Blob(blob) => Boxed::straight(acting(blob)),
        Shape::Julia(julia) => Boxed::straight(Aabb::around([Vec3::ZERO]).grown(julia_radius(julia))),
        Shape::Superellipsoid { .. } => Boxed::straight(Aabb::around([Vec3::ZERO]).grown(ROUND)),
        Shape::SphereSweep { kind, spheres, .. } => Boxed::straight(sweep(*kind, spheres)),
        Shape::Polygon { loops } => {
            let normal = match loops.first().map(Vec::as_slice) {
                Some([a, b, c, ..]) => (*b - *a).cross(*c - *a).normalize_or_zero(),
                _ => Vec3::ZERO,
            };
            let flat = Aabb::around(loops.iter().flatten().copied());
            Boxed::straight(Aabb { min: flat.min - FLAT * normal.abs(), max: flat.max + FLAT * normal.abs() })
        }
        Shape::Lathe { curves, kind } => {
            let [x, y] = match kind {
                SplineKind::Bezier => control_extent(curves),
                _ => plane_extent(curves),
            };
            let radius = x.0.abs().max(x.1.abs());
            Boxed::straight(Aabb {
                min: Vec3::new(-radius, y.0, -radius),
                max: Vec3::new(radius, y.1, radius),
            })
        }
        Shape::Prism(prism) if !prism.conic => {
            let [x, z] = plane_extent(&prism.curves);
            let (low, high) = prism.heights;
            Boxed::straight(Aabb { min: Vec3::new(x.0, low, z.0), max: Vec3::new(x.1, high, z.1) })
        }
        _ => Boxed::straight(tight(&Object::new(ObjectKind::Shape(shape.clone())))),
    }
}

/// The box that rays need.
fn tight(object: &Object) -> Aabb {
    Geometry::of_object(&Arc::new(object.clone())).map_or(Aabb::INFINITE, |geometry| geometry.bounds())
}

fn sweep(kind: SplineKind, spheres: &[SweepSphere]) -> Aabb {
    let room = if kind == SplineKind::Cubic { 2.0 } else { 1.0 };
    let balls = spheres.iter().map(|s| Aabb::around([s.center]).grown(room * s.radius));
    balls.fold(Aabb::EMPTY, |all, ball| all.union(&ball))
}

/// Between what the control points of curves lie, along both axes of their plane.
fn control_extent(curves: &[Curve2]) -> [(f64, f64); 2] {
    let points = curves
        .iter()
        .flat_map(|&Curve2 { a, b, c, d, .. }| [d, d + c / 3.0, d + (2.0 * c + b) / 3.0, a + b + c + d]);
    [0, 1].map(|k| {
        points
            .clone()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p[k]), high.max(p[k])))
    })
}

/// Between what curves lie, along both axes of their plane.
fn plane_extent(curves: &[Curve2]) -> [(f64, f64); 2] {
    [0, 1].map(|k| {
        curves.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), curve| {
            let [a, b, c, d] = [curve.a, curve.b, curve.c, curve.d].map(|v| v[k]);
            let at = |t: f64| ((a * t + b) * t + c) * t + d;
            let turns = poly::quadratic([c, 2.0 * b, 3.0 * a]);
            let inner = turns.iter().copied().filter(|t| (0.0..=1.0).contains(t));
            inner.chain([0.0, 1.0]).map(at).fold((low, high), |(low, high), x| (low.min(x), high.max(x)))
        })
    })
}
