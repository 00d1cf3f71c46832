//! Tori, polynomials, blobs and prisms.
use super::*;
use crate::LocalHit;

pub(super) fn torus(name: &'static str) -> Subject {
    let ring = Shape::Torus { major: 1.0, minor: 0.35 };
    match name {
        "torus_spindle" => plain(name, Shape::Torus { major: 0.5, minor: 0.8 }),
        _ => Subject::new(name, &ring, rotate(35.0, 0.0, 20.0)),
    }
}

#[test]
fn tori() {
    for name in ["torus", "torus_sturm", "torus_spindle"] {
        torus(name).agrees_with_the_record(1e-6, 1e-5);
    }
    torus("torus").uv_agrees_with_the_record(3e-4);
    torus("torus").is_a_consistent_solid();
}

pub(super) fn polynomial(name: &'static str) -> Subject {
    let (degree, coefficients): (u8, Vec<f64>) = match name {
        "cubic" => {
            let c =
                [1., 0.3, 0., 0.1, 0., 0.2, 0., -1., 0., 0., 0.5, 0., 0.1, 0., 0.2, 0., 1., 0., -0.5, 0.1];
            (3, c.to_vec())
        }
        "quartic" => {
            let mut c = vec![0.0; 35];
            for (k, x) in [(0, 1.), (4, 2.), (7, 2.), (9, -2.245), (20, 1.), (23, 2.), (25, 1.755), (30, 1.)]
            {
                c[k] = x;
            }
            c[32] = -2.245;
            c[34] = 0.76;
            (4, c)
        }
        _ => {
            let mut c = Vec::new();
            for i in (0..=6).rev() {
                for j in (0..=6 - i).rev() {
                    for k in (0..=6 - i - j).rev() {
                        c.push(match (i, j, k) {
                            (6, 0, 0) | (0, 6, 0) | (0, 0, 6) => 1.0,
                            (2, 2, 0) => 0.5,
                            (0, 0, 1) => 0.2,
                            (0, 0, 0) => -0.7,
                            _ => 0.0,
                        });
                    }
                }
            }
            (6, c)
        }
    };
    plain(name, Shape::Poly { degree, coefficients: coefficients.into() })
}

#[test]
fn polynomials() {
    for name in ["cubic", "quartic"] {
        polynomial(name).agrees_with_the_record(1e-6, 1e-5);
    }
    // POV-Ray's solver misses one ray that runs exactly along an axis.
    let wrong = polynomial("poly6").differing_hits(1e-6, 1e-5);
    assert!(matches!(&wrong[..], [row] if row.contains("\"-5.2\", \"0\", \"0\", \"1\", \"0\"")), "{wrong:?}");
    assert!(polynomial("poly6").differing_insides().is_empty());
    polynomial("poly6").is_a_consistent_solid();
}

pub(super) fn ball(center: Vec3, radius: f64, strength: f64, scale: Vec3) -> BlobComponent {
    let shape = BlobShape::Sphere { center, radius };
    BlobComponent { shape, strength, blob_from_component: transform::scale(scale), texture: None }
}

pub(super) fn blob(name: &'static str) -> Subject {
    let v = Vec3::new;
    let one = Vec3::ONE;
    let (threshold, components, place) = match name {
        "blob" => {
            let c = vec![
                ball(v(0.6, 0., 0.), 1.0, 1.0, one),
                ball(v(-0.5, 0.2, 0.), 0.9, 1.2, one),
                ball(v(0., 0.9, 0.1), 0.8, 0.9, one),
            ];
            (0.6, c, Affine::IDENTITY)
        }
        "blob_neg" => {
            let c =
                vec![ball(v(0., 0., 0.), 1.4, 2.0, one), ball(v(0.4, 0.4, -0.9), 0.8, -3.0, v(1., 1.2, 0.9))];
            (0.5, c, Affine::IDENTITY)
        }
        _ => {
            let rod = BlobShape::Cylinder { base: v(-0.8, -0.3, 0.), cap: v(0.7, 0.5, 0.2), radius: 0.6 };
            let rod = BlobComponent {
                shape: rod,
                strength: 1.0,
                blob_from_component: Affine::IDENTITY,
                texture: None,
            };
            let c = vec![rod, ball(v(0., -0.4, 0.), 0.9, 1.0, one)];
            (0.4, c, transform::scale(v(1., 1.2, 1.)) * rotate(0., 20., 0.))
        }
    };
    Subject::new(name, &Shape::Blob(Arc::new(raggio_scene::Blob { threshold, components })), place)
}

#[test]
fn blobs() {
    for name in ["blob", "blob_neg", "blob_cyl"] {
        blob(name).agrees_with_the_record(5e-6, 1e-5);
        blob(name).is_a_consistent_solid();
    }
    blob("blob").uv_agrees_with_the_record(3e-4);
}

/// A chain of curves as the front end makes it (shapes spec, section 5).
pub(super) fn curves(kind: SplineKind, p: &[Vec2]) -> Vec<Curve2> {
    let z = Vec2::ZERO;
    let piece = |a, b, c, d, kind| Curve2 { a, b, c, d, kind };
    match kind {
        SplineKind::Linear => {
            p.windows(2).map(|p| piece(z, z, p[1] - p[0], p[0], CurveKind::Linear)).collect()
        }
        SplineKind::Quadratic => p
            .windows(3)
            .map(|p| {
                piece(z, (p[0] - 2. * p[1] + p[2]) * 0.5, (p[2] - p[0]) * 0.5, p[1], CurveKind::Quadratic)
            })
            .collect(),
        SplineKind::Cubic => p
            .windows(4)
            .map(|p| {
                let a = (-p[0] + 3. * p[1] - 3. * p[2] + p[3]) * 0.5;
                let b = (2. * p[0] - 5. * p[1] + 4. * p[2] - p[3]) * 0.5;
                piece(a, b, (p[2] - p[0]) * 0.5, p[1], CurveKind::Cubic)
            })
            .collect(),
        _ => p
            .chunks(4)
            .map(|p| {
                let a = -p[0] + 3. * p[1] - 3. * p[2] + p[3];
                let b = 3. * p[0] - 6. * p[1] + 3. * p[2];
                piece(a, b, 3. * (p[1] - p[0]), p[0], CurveKind::Cubic)
            })
            .collect(),
    }
}

pub(super) fn points(list: &[(f64, f64)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

pub(super) fn prism(name: &'static str) -> Subject {
    let (curves, heights) = match name {
        "prism" => {
            let outer = points(&[(-1., -1.), (1., -1.), (1.2, 1.), (-1., 0.8), (-1., -1.)]);
            let inner = points(&[(-0.4, -0.4), (0.5, -0.4), (0.4, 0.5), (-0.4, 0.4), (-0.4, -0.4)]);
            let mut c = curves(SplineKind::Linear, &outer);
            c.extend(curves(SplineKind::Linear, &inner));
            (c, (-0.5, 0.7))
        }
        "prism_quad" => {
            let p = points(&[(-1., 0.), (0., -1.), (1., 0.), (0., 1.), (-1., 0.), (0., -1.)]);
            (curves(SplineKind::Quadratic, &p), (-0.5, 0.5))
        }
        "prism_cubic" => {
            let p = points(&[(-1., 0.2), (0., -1.), (1., 0.), (0.2, 1.), (-1., 0.2), (0., -1.), (1., 0.)]);
            (curves(SplineKind::Cubic, &p), (-0.5, 0.5))
        }
        "prism_bezier" => {
            // Prisms run each segment backwards.
            let p = points(&[(0., 1.), (1.2, 1.), (1.2, -1.), (0., -1.)]);
            let q = points(&[(0., -1.), (-1.5, -0.5), (-0.8, 0.8), (0., 1.)]);
            (curves(SplineKind::Bezier, &[p, q].concat()), (-0.4, 0.6))
        }
        _ => {
            let p = points(&[(-1., -1.), (1., -0.8), (1.1, 1.), (-0.9, 1.), (-1., -1.)]);
            (curves(SplineKind::Linear, &p), (0.3, 1.1))
        }
    };
    let open = name == "prism_bezier";
    plain(name, Shape::Prism(Arc::new(Prism { conic: name == "prism_conic", heights, curves, open })))
}

#[test]
fn prisms() {
    for name in ["prism", "prism_quad", "prism_cubic", "prism_bezier", "prism_conic"] {
        prism(name).agrees_with_the_record(1e-6, 1e-5);
        if name != "prism_bezier" {
            prism(name).is_a_consistent_solid();
        }
    }
    prism("prism").uv_agrees_with_the_record(3e-4);
}

/// Every distance must be found, and no other; a ray that passes within rounding of the surface may miss it.
#[test]
fn tori_against_roots_with_eighty_digits() {
    let mut sure = 0;
    for line in include_str!("../../../tests/data/torus_roots.csv").lines().filter(|l| !l.starts_with('#')) {
        let (kind, numbers) = line.split_once(',').expect("fields");
        let v: Vec<f64> = numbers.split(',').map(|x| x.parse().expect("a number")).collect();
        let surface = build(&Shape::Torus { major: v[0], minor: v[1] }, 0).expect("a torus");
        let ray = Ray::new(Vec3::new(v[2], v[3], v[4]), Vec3::new(v[5], v[6], v[7]));
        let mut hits = Vec::new();
        surface.hits(&ray, (0.0, f64::INFINITY), &mut hits);
        let expected = &v[8..];
        // Of the place of the origin, over how steeply the surface is met.
        let slack = |t: f64| {
            let p = ray.at(t);
            let across = surface.normal(p, &LocalHit::at(t)).dot(ray.dir).abs();
            1e-13 * (v[0] + ray.origin.length()) / across
        };
        for (i, &t) in expected.iter().enumerate() {
            let gap = expected.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, y)| (t - y).abs());
            if slack(t) < 0.1 * gap.fold(f64::INFINITY, f64::min) {
                sure += 1;
                let found = hits.iter().any(|h| (h.t - t).abs() < slack(t));
                assert!(found, "{kind}: {t} is missing in {hits:?}: {line}");
            }
        }
        let known = |h: &LocalHit| expected.iter().any(|t| (h.t - t).abs() < slack(*t).max(slack(h.t)));
        assert!(hits.iter().all(known), "{kind}: {hits:?} for {line}");
    }
    assert!(sure > 600, "{sure} roots");
}
