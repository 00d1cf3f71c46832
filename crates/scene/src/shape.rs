//! Every shape, in its own coordinates (shapes spec, sections 2 to 7).
use std::sync::Arc;

use raggio_math::{Affine, Vec2, Vec3};

use crate::{Function, Mesh, Nurbs, Placed, Texture};

/// A shape. Degenerate input (zero radii, zero areas, negative counts) has been refused or mended by the front end as
/// the language prescribes; what is here can be built.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum Shape {
    Sphere {
        center: Vec3,
        radius: f64,
    },
    /// Corners sorted per axis.
    Box {
        min: Vec3,
        max: Vec3,
    },
    /// `normal` is of unit length; points with `normal . p < distance` are inside.
    Plane {
        normal: Vec3,
        distance: f64,
    },
    Cylinder {
        base: Vec3,
        cap: Vec3,
        radius: f64,
        open: bool,
    },
    Cone {
        base: Vec3,
        base_radius: f64,
        cap: Vec3,
        cap_radius: f64,
        open: bool,
    },
    /// `normal` is of unit length.
    Disc {
        center: Vec3,
        normal: Vec3,
        radius: f64,
        hole: f64,
    },
    Torus {
        major: f64,
        minor: f64,
    },
    /// `a x2 + b y2 + c z2 + d xy + e xz + f yz + g x + h y + i z + j`, coefficients a..=j.
    Quadric([f64; 10]),
    /// Degree 2..=35 and its coefficients, x exponents falling first, then y, then z.
    Poly {
        degree: u8,
        coefficients: Arc<[f64]>,
    },
    Superellipsoid {
        e: f64,
        n: f64,
    },
    Ovus {
        bottom: f64,
        top: f64,
    },
    Triangle {
        points: [Vec3; 3],
    },
    /// Normals are of unit length. Boxed, as are other large parts, so that a million spheres stay small.
    SmoothTriangle {
        points: [Vec3; 3],
        normals: Box<[Vec3; 3]>,
    },
    /// Closed loops in one plane; even-odd.
    Polygon {
        loops: Vec<Vec<Vec3>>,
    },
    Mesh(Arc<Mesh>),
    /// `points[i][j]`, i along u, j along v. `uv` are the four corners' coordinates.
    BicubicPatch {
        patch_type: u8,
        flatness: f64,
        u_steps: u32,
        v_steps: u32,
        points: Box<[[Vec3; 4]; 4]>,
        uv: Box<[Vec2; 4]>,
    },
    HeightField(Arc<HeightField>),
    Blob(Arc<Blob>),
    Julia(Box<Julia>),
    Lathe {
        curves: Arc<[Curve2]>,
        kind: SplineKind,
    },
    /// Points are (radius, height); the first and the last only steer.
    Sor {
        points: Arc<[Vec2]>,
        open: bool,
    },
    Prism(Arc<Prism>),
    SphereSweep {
        kind: SplineKind,
        spheres: Arc<[SweepSphere]>,
        tolerance: f64,
    },
    /// Glyphs with their outlines, 1 em = 1 unit, depth along z.
    Text {
        glyphs: Arc<[Glyph]>,
        depth: f64,
    },
    Isosurface(Box<Isosurface>),
    Parametric(Box<Parametric>),
    Nurbs(Arc<Nurbs>),
}

/// How control points make a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum SplineKind {
    Linear,
    Quadratic,
    Cubic,
    Bezier,
    BSpline,
}

/// One cubic piece of a plane curve, `a t3 + b t2 + c t + d` for t in 0..=1. In a lathe x is the radius and y the
/// height; in a prism they are x and z.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Curve2 {
    pub a: Vec2,
    pub b: Vec2,
    pub c: Vec2,
    pub d: Vec2,
    pub kind: CurveKind,
}

/// The degree of a piece, so that straight ones cost less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum CurveKind {
    Linear,
    Quadratic,
    Cubic,
}

/// A swept outline.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Prism {
    pub conic: bool,
    /// Sorted.
    pub heights: (f64, f64),
    /// Pieces of all loops together; even-odd.
    pub curves: Vec<Curve2>,
    pub open: bool,
}

/// A control sphere of a `sphere_sweep`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct SweepSphere {
    pub center: Vec3,
    pub radius: f64,
}

/// One glyph of a text at its place.
#[derive(Clone, Debug)]
pub struct Glyph {
    /// Where its origin lies.
    pub offset: Vec2,
    /// Its outline; all contours together by even-odd.
    pub contours: Arc<[Contour]>,
}

/// A closed contour of straight and quadratic pieces.
#[derive(Clone, Debug)]
pub struct Contour {
    /// Pieces in order; each starts where the one before ends.
    pub curves: Vec<Curve2>,
}

/// A `height_field`: heights in 0..=65535 on a grid over the unit square.
#[derive(Clone, Debug)]
pub struct HeightField {
    /// Columns along x.
    pub width: usize,
    /// Rows along z.
    pub depth: usize,
    /// `heights[row * width + column]`; row 0 lies at z = 0. Height 65536 would be y = 1.
    pub heights: Vec<u16>,
    /// Interpolated normals.
    pub smooth: bool,
    /// The surface under this height (0..1) is cut away.
    pub water_level: f64,
}

/// `blob { ... }`
#[derive(Clone, Debug)]
pub struct Blob {
    /// The field's value on the surface.
    pub threshold: f64,
    /// What makes the field.
    pub components: Vec<BlobComponent>,
}

/// A component of a blob.
#[derive(Clone, Debug)]
pub struct BlobComponent {
    /// Its form.
    pub shape: BlobShape,
    /// Strength of the field; may be negative.
    pub strength: f64,
    /// Its own transform.
    pub blob_from_component: Affine,
    /// Its own texture, in the blob's coordinates.
    pub texture: Option<Placed<Texture>>,
}

/// The form of a blob's component.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum BlobShape {
    Sphere { center: Vec3, radius: f64 },
    Cylinder { base: Vec3, cap: Vec3, radius: f64 },
}

/// `julia_fractal { ... }`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Julia {
    pub parameter: [f64; 4],
    pub algebra: JuliaAlgebra,
    pub function: JuliaFunction,
    pub max_iteration: u32,
    pub precision: f64,
    /// Unit length, t component not 0.
    pub slice: [f64; 4],
    pub slice_distance: f64,
}

/// Numbers that a Julia fractal iterates on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum JuliaAlgebra {
    Quaternion,
    Hypercomplex,
}

/// The function that a Julia fractal iterates; all but the first two are hypercomplex only.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum JuliaFunction {
    Sqr,
    Cube,
    Exp,
    Reciprocal,
    Sin,
    Asin,
    Sinh,
    Asinh,
    Cos,
    Acos,
    Cosh,
    Acosh,
    Tan,
    Atan,
    Tanh,
    Atanh,
    Ln,
    Pwr(f64, f64),
}

/// What an isosurface or parametric surface is contained by.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Container {
    Box { min: Vec3, max: Vec3 },
    Sphere { center: Vec3, radius: f64 },
}

/// `isosurface { ... }`
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Isosurface {
    pub function: Arc<Function>,
    pub container: Container,
    pub threshold: f64,
    pub accuracy: f64,
    pub max_gradient: f64,
    pub evaluate: Option<IsosurfaceEvaluate>,
    /// Most hits along a ray.
    pub max_trace: u32,
    pub open: bool,
}

/// `evaluate p0, p1, p2`
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct IsosurfaceEvaluate {
    pub minimum: f64,
    pub increase: f64,
    pub decrease: f64,
}

/// `parametric { ... }`
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Parametric {
    pub functions: [Arc<Function>; 3],
    pub uv_min: Vec2,
    pub uv_max: Vec2,
    pub container: Container,
    pub max_gradient: f64,
    pub accuracy: f64,
    pub precompute_depth: u32,
}
