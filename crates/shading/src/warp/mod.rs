//! The list of operations that move a point before a pattern looks at it (textures spec, section 5).
mod black_hole;
mod mapping;
mod repeat;

use raggio_function::Bounds;
use raggio_math::noise::dturbulence;
use raggio_math::{Affine, Mat3, Vec3};
use raggio_scene as scene;

use black_hole::BlackHole;
use mapping::{Mapping, Projection};
pub(crate) use mapping::{longitude, torus_angles};
use repeat::Repeat;

/// Points farther out than this are pulled in, and a NaN lands here.
const LIMIT: Vec3 = Vec3::splat(1e17);

/// Operations in the order in which they act on the point.
#[derive(Debug, Default)]
pub(crate) struct WarpList {
    ops: Box<[Op]>,
    /// How normals go in and out; `None` where no transform stands in the way.
    normals: Option<Box<Normals>>,
}

/// What all transforms together do to normals.
#[derive(Debug)]
struct Normals {
    inward: Mat3,
    outward: Mat3,
}

#[derive(Debug)]
enum Op {
    Transform(Box<Transform>),
    /// What a transform that only moves does to the point.
    Shift(Vec3),
    Turbulence(scene::Turbulence),
    Repeat(Repeat),
    BlackHole(Box<BlackHole>),
    Mapping(Mapping),
}

#[derive(Debug)]
struct Transform {
    forward: Affine,
    inverse: Affine,
}

impl WarpList {
    pub fn compile(warps: &[scene::Warp]) -> Self {
        let mut ops: Vec<Op> = Vec::with_capacity(warps.len());
        for warp in warps {
            match (Op::compile(warp), ops.last_mut()) {
                (Op::Transform(next), Some(Op::Transform(last))) => {
                    last.inverse = next.inverse * last.inverse;
                    last.forward *= next.forward;
                }
                (op, _) => ops.push(op),
            }
        }
        let normals = Normals::of(&ops);
        WarpList { normals, ops: ops.into_iter().map(Op::simplified).collect() }
    }

    /// Does noise move the point?
    pub fn are_turbulent(&self) -> bool {
        self.ops.iter().any(|op| matches!(op, Op::Turbulence(_)))
    }

    /// The point that the pattern sees.
    #[inline(always)]
    pub fn apply(&self, p: Vec3) -> Vec3 {
        if self.ops.is_empty() { clip(p) } else { self.apply_at(p.x, p.y, p.z) }
    }

    /// Coordinates come in registers, where they need not be waited for.
    fn apply_at(&self, x: f64, y: f64, z: f64) -> Vec3 {
        let p = clip(Vec3::new(x, y, z));
        match &*self.ops {
            [] => p,
            [only] => clip(only.apply(p)),
            ops => {
                let mut q = p;
                for op in ops {
                    q = op.apply(q);
                }
                clip(q)
            }
        }
    }

    /// Bounds of the point that the pattern sees, if only transforms act.
    pub fn enclose(&self, p: [Bounds; 3]) -> Option<[Bounds; 3]> {
        match &*self.ops {
            [] => Some(p),
            [Op::Transform(t)] => {
                let Affine { matrix3: m, translation } = t.inverse;
                let row =
                    |k: usize| m.x_axis[k] * p[0] + m.y_axis[k] * p[1] + m.z_axis[k] * p[2] + translation[k];
                Some([row(0), row(1), row(2)])
            }
            [Op::Shift(way)] => Some([p[0] + way.x, p[1] + way.y, p[2] + way.z]),
            _ => None,
        }
    }

    /// A normal, of unit length unless `scaled`, carried into the pattern's space. Only transforms act. `scaled` keeps
    /// lengths, for `no_bump_scale`.
    #[inline]
    pub fn normal_in(&self, n: Vec3, scaled: bool) -> Vec3 {
        self.normals.as_ref().map_or(n, |normals| unit(normals.inward * n, scaled))
    }

    /// And back, from any length.
    #[inline]
    pub fn normal_out(&self, n: Vec3, scaled: bool) -> Vec3 {
        unit(self.normals.as_ref().map_or(n, |normals| normals.outward * n), scaled)
    }
}

impl Normals {
    fn of(ops: &[Op]) -> Option<Box<Normals>> {
        let mut transforms = ops.iter().filter_map(|op| match op {
            Op::Transform(t) => Some(&**t),
            _ => None,
        });
        let first = transforms.next()?;
        let start =
            Normals { inward: first.forward.matrix3.transpose(), outward: first.inverse.matrix3.transpose() };
        Some(Box::new(transforms.fold(start, |all, t| Normals {
            inward: t.forward.matrix3.transpose() * all.inward,
            outward: all.outward * t.inverse.matrix3.transpose(),
        })))
    }
}

#[inline]
fn unit(n: Vec3, leave: bool) -> Vec3 {
    if leave { n } else { n.normalize_or(n) }
}

#[inline]
fn clip(p: Vec3) -> Vec3 {
    let near = p.x.abs() < LIMIT.x && p.y.abs() < LIMIT.y && p.z.abs() < LIMIT.z;
    if near { p } else { p.max(-LIMIT).min(LIMIT) }
}

impl Op {
    fn compile(warp: &scene::Warp) -> Op {
        use scene::Warp;
        match *warp {
            Warp::Transform { forward, inverse } => Op::Transform(Box::new(Transform { forward, inverse })),
            Warp::ClassicTurbulence(t) | Warp::Turbulence(t) => Op::Turbulence(t),
            Warp::Repeat { axis, width, flip, offset } => {
                Op::Repeat(Repeat::new(usize::from(axis), width, flip, offset))
            }
            Warp::BlackHole { center, radius, strength, falloff, inverse, repeat, turbulence } => {
                let hole = BlackHole::new(center, radius, strength, falloff, inverse, repeat, turbulence);
                Op::BlackHole(Box::new(hole))
            }
            Warp::Cylindrical { orientation, dist_exp } => {
                Op::Mapping(Mapping::new(Projection::Cylindrical { dist_exp }, orientation))
            }
            Warp::Spherical { orientation, dist_exp } => {
                Op::Mapping(Mapping::new(Projection::Spherical { dist_exp }, orientation))
            }
            Warp::Toroidal { orientation, dist_exp, major_radius } => {
                Op::Mapping(Mapping::new(Projection::Toroidal { dist_exp, major_radius }, orientation))
            }
            Warp::Planar { orientation, distance } => {
                Op::Mapping(Mapping::new(Projection::Planar { distance }, orientation))
            }
            Warp::Cubic => Op::Mapping(Mapping::new(Projection::Cubic, Vec3::Z)),
        }
    }

    /// The same with less to do, where there is such.
    fn simplified(self) -> Op {
        match self {
            Op::Transform(t) if t.inverse.matrix3 == Mat3::IDENTITY => Op::Shift(t.inverse.translation),
            op => op,
        }
    }

    #[inline]
    fn apply(&self, p: Vec3) -> Vec3 {
        match self {
            Op::Transform(t) => t.inverse.transform_point3(p),
            Op::Shift(way) => p + *way,
            Op::Turbulence(t) => displace(p, t),
            Op::Repeat(repeat) => repeat.apply(p),
            Op::BlackHole(hole) => hole.apply(p),
            Op::Mapping(mapping) => mapping.apply(p),
        }
    }
}

#[inline]
fn displace(p: Vec3, t: &scene::Turbulence) -> Vec3 {
    if t.amount == Vec3::ZERO { p } else { p + dturbulence(p, t.octaves, t.omega, t.lambda) * t.amount }
}
