//! Flat patches: triangles and polygons (shapes spec, section 3).
use raggio_math::{EPS, Vec3};
use raggio_scene::{Object, Shape};

use super::object::{self, nothing, of_shape};
use super::util::{comma_vec3, vec3};
use crate::parser::{Parser, Result};

/// `triangle { a, b, c }`
pub fn triangle(p: &mut Parser) -> Result<Object> {
    object::build(p, "triangle", |p| {
        let span = p.span();
        let points = [vec3(p)?, comma_vec3(p)?, comma_vec3(p)?];
        if face_normal(points) != Vec3::ZERO {
            return Ok(of_shape(Shape::Triangle { points }));
        }
        p.warn("degenerate-triangle", "degenerate triangle; please remove it", span);
        Ok(nothing())
    })
}

/// `smooth_triangle { a, normal, b, normal, c, normal }`
pub fn smooth_triangle(p: &mut Parser) -> Result<Object> {
    object::build(p, "smooth_triangle", |p| {
        let span = p.span();
        let corners =
            [vec3(p)?, comma_vec3(p)?, comma_vec3(p)?, comma_vec3(p)?, comma_vec3(p)?, comma_vec3(p)?];
        let points = [corners[0], corners[2], corners[4]];
        let normals = [corners[1], corners[3], corners[5]].map(Vec3::normalize_or_zero);
        let face = face_normal(points);
        let sides = normals.map(|n| n.dot(face));
        if sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0) {
            return Ok(of_shape(Shape::SmoothTriangle { points, normals: Box::new(normals) }));
        }
        p.warn(
            "degenerate-triangle",
            "degenerate triangle: no area, no normal, or normals on both sides; please remove it",
            span,
        );
        Ok(nothing())
    })
}

/// The normal of a triangle, not of unit length; zero without an area.
pub fn face_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (a - b).cross(c - b)
}

/// `polygon { n, points }`: loops that close where a point repeats the first of its loop.
pub fn polygon(p: &mut Parser) -> Result<Object> {
    object::build(p, "polygon", |p| {
        let span = p.span();
        let n = p.int("number of points", 0..=1 << 24)?;
        if n < 3 {
            return p.error("few-points", "a polygon needs at least three points", span);
        }
        let mut points = Vec::new();
        for _ in 0..n {
            points.push(comma_vec3(p)?);
        }
        if !is_planar(&points) {
            return Ok(nothing());
        }
        let (loops, closed) = split_loops(&points);
        if !closed {
            p.warn("open-polygon", "this polygon is not closed; closing it", span);
        }
        Ok(of_shape(Shape::Polygon { loops }))
    })
}

/// The loops without their closing points, and whether the last one was closed.
fn split_loops(points: &[Vec3]) -> (Vec<Vec<Vec3>>, bool) {
    let (mut loops, mut current) = (Vec::new(), Vec::<Vec3>::new());
    for &point in points {
        match current.first() {
            Some(first) if (point - first).abs().max_element() < EPS => {
                loops.push(std::mem::take(&mut current));
            }
            _ => current.push(point),
        }
    }
    let closed = current.is_empty();
    if !closed {
        loops.push(current);
    }
    (loops, closed)
}

/// Do all points lie in one plane, and not on one line?
fn is_planar(points: &[Vec3]) -> bool {
    let first = points[0];
    let mut differences = points.iter().map(|&point| point - first).filter(|d| d.length() > 1e-5);
    let Some(u) = differences.next().map(Vec3::normalize) else { return false };
    let across = differences.map(|d| u.cross(d)).find(|w| w.length() > 1e-5);
    let Some(w) = across.map(Vec3::normalize) else { return false };
    points.iter().all(|&point| (point - first).dot(w).abs() <= EPS * (1.0 + point.abs().max_element()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_repeated_point_closes_a_loop() {
        let (a, b, c) = (Vec3::ZERO, Vec3::X, Vec3::Y);
        let (loops, closed) = split_loops(&[a, b, c, a, b, c, Vec3::Z]);
        assert_eq!(loops, vec![vec![a, b, c], vec![b, c, Vec3::Z]]);
        assert!(!closed);
    }

    #[test]
    fn points_off_the_plane_are_seen() {
        assert!(is_planar(&[Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE - Vec3::Z]));
        assert!(!is_planar(&[Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE]));
        assert!(!is_planar(&[Vec3::ZERO, Vec3::X, Vec3::X * 2.0]));
    }
}
