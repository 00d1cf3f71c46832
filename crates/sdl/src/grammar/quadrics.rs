//! Spheres, boxes and the other simple solids (shapes spec, section 2).
use raggio_math::{EPS, Vec3};
use raggio_scene::{Object, Shape};

use super::object;
use super::util::{comma_float, comma_vec3, float, optional_second, vec2, vec3};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `sphere { center, radius }`
pub fn sphere(p: &mut Parser) -> Result<Object> {
    object::shape(p, "sphere", |p| Ok(Shape::Sphere { center: vec3(p)?, radius: comma_float(p)? }))
}

/// `box { corner, corner }`
pub fn box_(p: &mut Parser) -> Result<Object> {
    object::shape(p, "box", |p| {
        let (a, b) = (vec3(p)?, comma_vec3(p)?);
        Ok(Shape::Box { min: a.min(b), max: a.max(b) })
    })
}

/// `plane { normal, distance }`, the distance along the unit normal.
pub fn plane(p: &mut Parser) -> Result<Object> {
    object::shape(p, "plane", |p| {
        let span = p.span();
        let normal = vec3(p)?;
        let distance = comma_float(p)?;
        if normal.length() < EPS {
            return p.error(
                "degenerate-plane",
                "degenerate plane normal: the zero vector has no direction",
                span,
            );
        }
        Ok(Shape::Plane { normal: normal.normalize(), distance })
    })
}

/// `cylinder { base, cap, radius [open] }`
pub fn cylinder(p: &mut Parser) -> Result<Object> {
    object::shape(p, "cylinder", |p| {
        let span = p.span();
        let (base, cap) = (vec3(p)?, comma_vec3(p)?);
        let radius = comma_float(p)?.abs();
        let open = p.accept(Kw::Open)?;
        if (cap - base).length() < EPS {
            return p.error("degenerate-cylinder", "degenerate cylinder: both ends are the same point", span);
        }
        Ok(Shape::Cylinder { base, cap, radius, open })
    })
}

/// `cone { base, radius, cap, radius [open] }`; with equal radii it is a cylinder.
pub fn cone(p: &mut Parser) -> Result<Object> {
    object::shape(p, "cone", |p| {
        let span = p.span();
        let (base, base_radius) = (vec3(p)?, comma_float(p)?);
        let (cap, cap_radius) = (comma_vec3(p)?, comma_float(p)?);
        let open = p.accept(Kw::Open)?;
        if (cap - base).length() < EPS {
            return p.error("degenerate-cone", "degenerate cone: both ends are the same point", span);
        }
        if (base_radius - cap_radius).abs() < EPS {
            return Ok(Shape::Cylinder { base, cap, radius: base_radius.abs(), open });
        }
        Ok(Shape::Cone { base, base_radius, cap, cap_radius, open })
    })
}

/// `disc { center, normal, radius [, hole] }`. A disc without a direction is never hit: its radius is none.
pub fn disc(p: &mut Parser) -> Result<Object> {
    object::shape(p, "disc", |p| {
        let (center, normal) = (vec3(p)?, comma_vec3(p)?);
        let radius = comma_float(p)?;
        let hole = optional_second(p)?.unwrap_or(0.0);
        match normal.try_normalize() {
            Some(normal) => Ok(Shape::Disc { center, normal, radius, hole }),
            None => Ok(Shape::Disc { center, normal: Vec3::Z, radius: 0.0, hole: 1.0 }),
        }
    })
}

/// `torus { major, minor }`
pub fn torus(p: &mut Parser) -> Result<Object> {
    object::shape(p, "torus", |p| Ok(Shape::Torus { major: float(p)?, minor: comma_float(p)? }))
}

/// `superellipsoid { <e, n> }`
pub fn superellipsoid(p: &mut Parser) -> Result<Object> {
    object::shape(p, "superellipsoid", |p| {
        let exponents = vec2(p)?;
        Ok(Shape::Superellipsoid { e: exponents.x, n: exponents.y })
    })
}

/// `ovus { bottom, top }`; a top of twice the bottom or more swallows it and is a sphere.
pub fn ovus(p: &mut Parser) -> Result<Object> {
    object::shape(p, "ovus", |p| {
        let span = p.span();
        let (bottom, top) = (float(p)?, comma_float(p)?);
        if bottom < 0.0 || top < 0.0 {
            return p.error("negative-ovus", "both radii of an ovus must be positive", span);
        }
        if top < 2.0 * bottom {
            return Ok(Shape::Ovus { bottom, top });
        }
        p.warn("fat-ovus", "the second radius should be less than twice the first; this is a sphere", span);
        Ok(Shape::Sphere { center: Vec3::new(0.0, bottom, 0.0), radius: top })
    })
}
