//! Splines that are spheres, tori and cylinders, against those shapes.
use std::f64::consts::FRAC_1_SQRT_2;

use raggio_scene::{Knots, Shape, Trim};

use super::*;

/// A row of points in the plane with weights, and its knots.
struct Profile {
    points: Vec<(Vec2, f64)>,
    knots: Knots,
}

/// A circle of nine points, or the right half of it, of five.
fn arc(centre: Vec2, radius: f64, half: bool) -> Profile {
    let around = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let right = [(0, -1), (1, -1), (1, 0), (1, 1), (0, 1)];
    let corners: &[(i32, i32)] = if half { &right } else { &around };
    let point = |(k, &(x, y)): (usize, &(i32, i32))| {
        let weight = if k % 2 == 1 { FRAC_1_SQRT_2 } else { 1.0 };
        (centre + radius * Vec2::new(f64::from(x), f64::from(y)), weight)
    };
    let knots = if half {
        vec![0., 0., 0., 0.5, 0.5, 1., 1., 1.]
    } else {
        vec![0., 0., 0., 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1., 1., 1.]
    };
    Profile { points: corners.iter().enumerate().map(point).collect(), knots: Knots { degree: 2, knots } }
}

/// The surface of a profile (radius, height) turned about y.
fn turned(profile: &Profile) -> Nurbs {
    let circle = arc(Vec2::ZERO, 1.0, false);
    let point = |(p, w): &(Vec2, f64)| {
        let around = circle.points.iter().map(|(c, v)| (Vec3::new(p.x * c.x, p.y, p.x * c.y), w * v));
        around.collect::<Vec<_>>()
    };
    Nurbs {
        u: profile.knots.clone(),
        v: circle.knots.clone(),
        points: profile.points.iter().flat_map(point).collect(),
        trims: Vec::new(),
    }
}

/// Rays towards places near the origin, from all around.
fn rays() -> impl Iterator<Item = Ray> {
    (0..1500).map(|i| {
        let k = f64::from(i);
        let origin = Vec3::new((k * 1.3).sin(), (k * 0.71).cos(), (k * 2.17).sin()) * 4.0 + Vec3::X * 0.1;
        let aim = Vec3::new((k * 0.37).cos(), (k * 0.53).sin(), (k * 0.91).cos()) * 1.4;
        Ray::new(origin, (aim - origin).normalize())
    })
}

/// Every hit of the one is a hit of the other, with the same normal but for its sign.
fn agrees(nurbs: &Nurbs, shape: &Shape, distance: f64) {
    let (patch, other) = (NurbsPatch::new(nurbs), super::super::build(shape, 0).expect("a shape"));
    let all = |surface: &dyn Surface, ray: &Ray| {
        let mut hits = Vec::new();
        surface.hits(ray, (0.0, f64::INFINITY), &mut hits);
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        hits
    };
    let mut count = 0;
    for ray in rays() {
        let (found, expected) = (all(&patch, &ray), all(&other, &ray));
        // Roots that nearly touch are beyond the shapes' own solvers.
        if expected.windows(2).any(|w| w[1].t - w[0].t < 1e-3) {
            continue;
        }
        assert_eq!(found.len(), expected.len(), "{ray:?}\n{found:?}\n{expected:?}");
        for (f, e) in found.iter().zip(&expected) {
            assert!((f.t - e.t).abs() < distance, "{f:?} instead of {e:?}");
            let p = ray.at(f.t);
            let cross = patch.normal(p, f).cross(other.normal(p, e)).length();
            assert!(cross < 1e-6, "normals differ by {cross} at {p}");
        }
        let nearest = patch.closest(&ray, (0.0, f64::INFINITY)).map(|h| h.t);
        assert_eq!(nearest.is_some(), !found.is_empty());
        assert!(nearest.is_none_or(|t| (t - found[0].t).abs() < 1e-9));
        count += found.len();
    }
    assert!(count > 500, "only {count} hits");
}

/// A ring of major radius 1 and minor radius 0.4.
pub(in crate::shapes) fn ring() -> Nurbs {
    turned(&arc(Vec2::X, 0.4, false))
}

#[test]
fn a_sphere_is_a_sphere() {
    let sphere = Shape::Sphere { center: Vec3::ZERO, radius: 1.0 };
    agrees(&turned(&arc(Vec2::ZERO, 1.0, true)), &sphere, 1e-9);
}

#[test]
fn a_torus_is_a_torus() {
    let torus = Shape::Torus { major: 1.0, minor: 0.4 };
    agrees(&ring(), &torus, 1e-7);
}

#[test]
fn a_cylinder_is_a_cylinder() {
    let knots = Knots { degree: 1, knots: vec![0., 0., 1., 1.] };
    let line = Profile { points: vec![(Vec2::new(0.8, -1.0), 1.0), (Vec2::new(0.8, 1.0), 1.0)], knots };
    let cylinder = Shape::Cylinder { base: -Vec3::Y, cap: Vec3::Y, radius: 0.8, open: true };
    agrees(&turned(&line), &cylinder, 1e-9);
}

/// A wavy surface of degrees 3 and 2 with uneven weights and knots that are not clamped.
pub(in crate::shapes) fn wavy() -> Nurbs {
    let point = |k: usize| {
        let (i, j) = (k / 5, k % 5);
        let height = ((k * 7) % 5) as f64 * 0.25 - 0.5;
        (Vec3::new(i as f64 - 2.5, height, j as f64 - 2.0), 0.5 + ((k * 3) % 4) as f64 * 0.4)
    };
    Nurbs {
        u: Knots { degree: 3, knots: vec![0., 1., 2., 3., 4., 4., 5.5, 6., 7., 8.] },
        v: Knots { degree: 2, knots: vec![-1., 0., 0., 1., 3., 3., 3., 4.] },
        points: (0..30).map(point).collect(),
        trims: Vec::new(),
    }
}

#[test]
fn derivatives_are_those_of_the_points() {
    let patch = NurbsPatch::new(&wavy());
    assert_eq!(patch.patches.len(), 4);
    for (k, tree) in patch.patches.iter().enumerate() {
        let sheet = &tree.sheet;
        let uv = sheet.lo.lerp(sheet.hi, 0.2 + 0.15 * k as f64);
        let (du, dv) = sheet.slopes(uv);
        let slope = |step: Vec2| (sheet.point(uv + step) - sheet.point(uv - step)) / (2.0 * step.length());
        assert!((slope(Vec2::X * 1e-5) - du).length() < 1e-8, "{du}");
        assert!((slope(Vec2::Y * 1e-5) - dv).length() < 1e-8, "{dv}");
        let all = sheet.enclose(sheet.lo, sheet.hi);
        let ranges = |r: [Range; 3], d: Vec3| (0..3).all(|a| r[a].contains(d[a]));
        assert!(all.bounds.contains(sheet.point(uv)) && ranges(all.du, du) && ranges(all.dv, dv));
    }
}

#[test]
fn pieces_meet() {
    let patch = NurbsPatch::new(&wavy());
    for a in &patch.patches {
        for b in &patch.patches {
            if a.sheet.hi.x == b.sheet.lo.x && a.sheet.lo.y == b.sheet.lo.y {
                let uv = Vec2::new(a.sheet.hi.x, 0.3 * a.sheet.lo.y + 0.7 * a.sheet.hi.y);
                assert!((a.sheet.point(uv) - b.sheet.point(uv)).length() < 1e-12);
            }
        }
    }
}

#[test]
fn every_ray_down_on_a_height_hits_it() {
    let patch = NurbsPatch::new(&wavy());
    for tree in &patch.patches {
        for k in 0..400 {
            let share = Vec2::new(f64::from(k % 20) + 0.5, f64::from(k / 20) + 0.5) / 20.0;
            let p = tree.sheet.point(tree.sheet.lo + (tree.sheet.hi - tree.sheet.lo) * share);
            let hit = patch.closest(&Ray::new(p + Vec3::Y * 3.0, -Vec3::Y), (0.0, 10.0));
            assert!(hit.is_some_and(|h| (h.t - 3.0).abs() < 1e-9), "{p}: {hit:?}");
        }
    }
}

#[test]
fn trims_keep_what_lies_within_an_odd_number_of_loops() {
    let corner = |x: f64, y: f64| (Vec3::new(x, y, 0.0), 1.0);
    let line = || Knots { degree: 1, knots: vec![-2., -2., 2., 2.] };
    let square = |r: f64| Trim {
        knots: Knots { degree: 1, knots: vec![0., 0., 1., 2., 3., 3.] },
        points: [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(x, y)| (Vec2::new(x, y), 1.0)).to_vec(),
    };
    let circle = arc(Vec2::ZERO, 1.0, false);
    let nurbs = Nurbs {
        u: line(),
        v: line(),
        points: vec![corner(-2., -2.), corner(-2., 2.), corner(2., -2.), corner(2., 2.)],
        trims: vec![Trim { knots: circle.knots, points: circle.points }, square(0.25)],
    };
    let patch = NurbsPatch::new(&nurbs);
    for k in 0..2000 {
        let p = Vec2::new((f64::from(k) * 0.737).sin(), (f64::from(k) * 1.391).cos()) * 1.5;
        let hit = patch.closest(&Ray::new(p.extend(-1.0), Vec3::Z), (0.0, 10.0));
        let expected = p.length() < 1.0 && p.abs().max_element() > 0.25;
        if (p.length() - 1.0).abs() > 1e-9 && (p.abs().max_element() - 0.25).abs() > 1e-9 {
            assert_eq!(hit.is_some(), expected, "{p}");
        }
    }
    // The loop's edge is the circle itself, however near one looks.
    for (radius, there) in [(1.0 - 1e-10, true), (1.0 + 1e-10, false)] {
        let p = Vec2::from_angle(0.3) * radius;
        let hit = patch.closest(&Ray::new(p.extend(-1.0), Vec3::Z), (0.0, 10.0));
        assert_eq!(hit.is_some(), there, "{radius}");
    }
}
