//! Warps that lay a flat pattern around a cylinder, sphere, torus, plane or cube (textures spec, section 5.2).
use std::f64::consts::{PI, TAU};

use raggio_math::Vec3;

use crate::pattern::{CubeFace, cube_face};

#[derive(Debug)]
pub(super) struct Mapping {
    projection: Projection,
    /// Unit; `None` is the z axis, which turns nothing.
    orientation: Option<Vec3>,
}

/// What the pattern is laid around. Angles grow with the distance to the power of `dist_exp`; 0 leaves them alone.
#[derive(Debug)]
pub(super) enum Projection {
    Cylindrical { dist_exp: f64 },
    Spherical { dist_exp: f64 },
    Toroidal { dist_exp: f64, major_radius: f64 },
    Planar { distance: f64 },
    Cubic,
}

impl Mapping {
    pub fn new(projection: Projection, orientation: Vec3) -> Self {
        let o = orientation.normalize_or(Vec3::Z);
        Mapping { projection, orientation: (o != Vec3::Z).then_some(o) }
    }

    pub fn apply(&self, p: Vec3) -> Vec3 {
        let Some(q) = self.projection.apply(p) else { return p };
        match self.orientation {
            None => q,
            Some(o) => Vec3::new(
                o.x * q.z + o.y * q.x + o.z * q.x,
                o.x * q.y - o.y * q.z + o.z * q.y,
                -o.x * q.x + o.y * q.y + o.z * q.z,
            ),
        }
    }
}

impl Projection {
    /// `None` where the mapping has no answer: such points stay where they are.
    fn apply(&self, p: Vec3) -> Option<Vec3> {
        match *self {
            Projection::Cylindrical { dist_exp } => {
                let r = p.x.hypot(p.z);
                (r != 0.0).then(|| Vec3::new(longitude(p) * growth(r, dist_exp), p.y, r))
            }
            Projection::Spherical { dist_exp } => {
                let d = p.length();
                let angles = (d != 0.0).then(|| (longitude(p), 0.5 + (p.y / d).asin() / PI));
                angles.map(|(theta, phi)| {
                    let g = growth(d, dist_exp);
                    Vec3::new(theta * g, phi * g, d)
                })
            }
            Projection::Toroidal { dist_exp, major_radius } => {
                let (theta, phi, l) = torus_angles(p, major_radius)?;
                let g = growth(l, dist_exp);
                Some(Vec3::new(theta * g, phi * g, l))
            }
            Projection::Planar { distance } => Some(Vec3::new(p.x, p.y, distance)),
            Projection::Cubic => cubic(p),
        }
    }
}

fn growth(distance: f64, exponent: f64) -> f64 {
    if exponent == 0.0 { 1.0 } else { distance.powf(exponent) }
}

/// The angle about the y axis in turns, 0..1 from +x toward +z; 0 on the axis.
pub(crate) fn longitude(p: Vec3) -> f64 {
    if p.x == 0.0 && p.z == 0.0 {
        return 0.0;
    }
    let turns = p.z.atan2(p.x) / TAU;
    if turns < 0.0 { turns + 1.0 } else { turns }
}

/// Both angles in turns, and the distance from the circle of radius `major` in the plane y = 0. `None` on the y axis.
pub(crate) fn torus_angles(p: Vec3, major: f64) -> Option<(f64, f64, f64)> {
    let r = p.x.hypot(p.z);
    if r == 0.0 {
        return None;
    }
    let outward = r - major;
    let l = outward.hypot(p.y);
    let phi = if l == 0.0 { 0.0 } else { (-outward / l).acos() };
    let phi = if p.y > 0.0 { TAU - phi } else { phi };
    Some((longitude(p), phi / TAU, l))
}

/// A cube unfolded to a lying cross of 4 by 3 squares.
fn cubic(p: Vec3) -> Option<Vec3> {
    let m = p.abs().max_element();
    let (x, y, z) = (p.x / m + 1.0, p.y / m + 1.0, p.z / m + 1.0);
    let third = 1.0 / 3.0;
    (m != 0.0).then(|| match cube_face(p) {
        CubeFace::PosX => Vec3::new(0.75 - z / 8.0, third + y / 6.0, m),
        CubeFace::PosY => Vec3::new(0.25 + x / 8.0, 1.0 - z / 6.0, m),
        CubeFace::PosZ => Vec3::new(0.25 + x / 8.0, third + y / 6.0, m),
        CubeFace::NegX => Vec3::new(z / 8.0, third + y / 6.0, m),
        CubeFace::NegY => Vec3::new(0.25 + x / 8.0, z / 6.0, m),
        CubeFace::NegZ => Vec3::new(1.0 - x / 8.0, third + y / 6.0, m),
    })
}
