//! The advanced shapes against rays, points and texture coordinates recorded from POV-Ray 3.7, and laws that every one
//! of them must keep.
use std::sync::Arc;

use raggio_function::Function;
use raggio_math::{Affine, MIN_HIT, Ray, Vec2, Vec3, transform};
use raggio_scene::{
    BlobComponent, BlobShape, Container, Curve2, CurveKind, Prism, Shape, SplineKind, SweepSphere,
};

use super::{ShapeKind, build};
use crate::Surface;

const HITS: &str = include_str!("../../tests/data/shape_hits.csv");
const INSIDE: &str = include_str!("../../tests/data/inside.csv");
const UV: &str = include_str!("../../tests/data/uv.csv");

/// A shape at its place, asked in the world.
struct Subject {
    name: &'static str,
    surface: ShapeKind,
    world_from_object: Affine,
    object_from_world: Affine,
}

struct WorldHit {
    p: Vec3,
    n: Vec3,
    uv: Vec2,
}

impl Subject {
    fn new(name: &'static str, shape: &Shape, world_from_object: Affine) -> Self {
        let surface = build(shape).expect("the shape is there");
        Subject { name, surface, world_from_object, object_from_world: world_from_object.inverse() }
    }

    /// The ray in the object's space, and how many of its units one world unit is.
    fn local(&self, origin: Vec3, dir: Vec3) -> (Ray, f64) {
        let ray = Ray::new(origin, dir.normalize()).transformed(&self.object_from_world);
        let length = ray.dir.length();
        (Ray::new(ray.origin, ray.dir / length), length)
    }

    fn trace(&self, origin: Vec3, dir: Vec3) -> Option<WorldHit> {
        let (ray, length) = self.local(origin, dir);
        let hit = self.surface.closest(&ray, (MIN_HIT * length, f64::INFINITY))?;
        let local = ray.at(hit.t);
        let p = self.world_from_object.transform_point3(local);
        let n = self.surface.normal(local, &hit);
        assert!((n.length() - 1.0).abs() < 1e-9, "{}: normal {n} is not of unit length", self.name);
        let n = transform::normal_by_inverse(&self.object_from_world, n).normalize();
        let uv = self.surface.uv(local, &hit).unwrap_or(Vec2::new(p.x, p.y));
        Some(WorldHit { p, n, uv })
    }

    fn inside(&self, p: Vec3) -> bool {
        self.surface.inside(self.object_from_world.transform_point3(p))
    }

    /// Every recorded row: how many differ by more than the tolerances, and which.
    fn differing_hits(&self, point: f64, normal: f64) -> Vec<String> {
        let mut wrong = Vec::new();
        for row in rows(HITS, self.name) {
            let v = numbers(&row[1..]);
            let found = self.trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5]));
            let expected =
                (v[6] == 1.0).then(|| (Vec3::new(v[7], v[8], v[9]), Vec3::new(v[10], v[11], v[12])));
            let same = match (&found, &expected) {
                (None, None) => true,
                (Some(f), Some((p, n))) => (f.p - *p).length() <= point && (f.n - *n).length() <= normal,
                _ => false,
            };
            if !same {
                let found = found.map(|f| (f.p, f.n));
                wrong.push(format!("{row:?}\n  found {found:?}"));
            }
        }
        wrong
    }

    fn differing_insides(&self) -> Vec<String> {
        let differs = |row: &Vec<&str>| {
            let v = numbers(&row[1..]);
            self.inside(Vec3::new(v[0], v[1], v[2])) != (v[3] == 1.0)
        };
        rows(INSIDE, self.name).filter(differs).map(|row| format!("{row:?}")).collect()
    }

    fn agrees_with_the_record(&self, point: f64, normal: f64) {
        let wrong = self.differing_hits(point, normal);
        assert!(wrong.is_empty(), "{} hits of {} differ:\n{}", wrong.len(), self.name, wrong.join("\n"));
        let wrong = self.differing_insides();
        assert!(wrong.is_empty(), "{} points of {} differ:\n{}", wrong.len(), self.name, wrong.join("\n"));
    }

    fn uv_agrees_with_the_record(&self, tolerance: f64) {
        for row in rows(UV, self.name).filter(|row| row[1].is_empty()) {
            let v = numbers(&row[2..]);
            let hit = self.trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5])).expect("a hit");
            let wrapped = |a: f64| (a - a.round()).abs();
            let off = Vec2::new(hit.uv.x - v[6], hit.uv.y - v[7]);
            assert!(wrapped(off.x).max(wrapped(off.y)) < tolerance, "{row:?}: {}", hit.uv);
        }
    }

    /// Hits alternate between entry and exit, `inside` says so between them, and `closest` is the first of them.
    fn is_a_consistent_solid(&self) {
        let mut tested = 0;
        for k in 0..400 {
            let h = |m: u32| f64::from((k * m + 977) % 1009) / 1009.0 * 2.0 - 1.0;
            let origin = Vec3::new(h(37), h(101), h(59)).normalize() * 4.0;
            let target = Vec3::new(h(211), h(17), h(83));
            let (ray, _) = self.local(origin, target - origin);
            let mut hits = Vec::new();
            self.surface.hits(&ray, (0.0, f64::INFINITY), &mut hits);
            hits.sort_by(|a, b| a.t.total_cmp(&b.t));
            let first = self.surface.closest(&ray, (0.0, f64::INFINITY)).map(|h| h.t);
            assert_eq!(first, hits.first().map(|h| h.t), "{}: ray {k}", self.name);
            assert!(hits.len() % 2 == 0, "{}: ray {k} has {} hits", self.name, hits.len());
            for (i, pair) in hits.windows(2).enumerate() {
                if pair[1].t - pair[0].t < 1e-3 {
                    continue;
                }
                tested += 1;
                let middle = ray.at(0.5 * (pair[0].t + pair[1].t));
                assert_eq!(self.surface.inside(middle), i % 2 == 0, "{}: ray {k} after hit {i}", self.name);
            }
        }
        assert!(tested > 20, "{}: only {tested} intervals", self.name);
    }
}

fn rows(table: &'static str, name: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().map(|l| l.split(',').collect::<Vec<_>>()).filter(move |row| row[0] == name)
}

/// Empty fields are zero.
fn numbers(fields: &[&str]) -> Vec<f64> {
    fields.iter().map(|f| f.trim().parse().unwrap_or(0.0)).collect()
}

fn plain(name: &'static str, shape: Shape) -> Subject {
    Subject::new(name, &shape, Affine::IDENTITY)
}

fn rotate(x: f64, y: f64, z: f64) -> Affine {
    transform::rotate(Vec3::new(x, y, z))
}

fn torus(name: &'static str) -> Subject {
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

fn polynomial(name: &'static str) -> Subject {
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

fn ball(center: Vec3, radius: f64, strength: f64, scale: Vec3) -> BlobComponent {
    let shape = BlobShape::Sphere { center, radius };
    BlobComponent { shape, strength, blob_from_component: transform::scale(scale), texture: None }
}

fn blob(name: &'static str) -> Subject {
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
fn curves(kind: SplineKind, p: &[Vec2]) -> Vec<Curve2> {
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

fn points(list: &[(f64, f64)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

fn prism(name: &'static str) -> Subject {
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

fn superellipsoid(name: &'static str) -> Subject {
    let shape = |e: f64, n: f64| Shape::Superellipsoid { e, n };
    match name {
        "super" => plain(name, shape(0.25, 0.4)),
        "super_star" => plain(name, shape(2.2, 1.3)),
        _ => {
            let place = rotate(30., 20., 0.) * transform::scale(Vec3::new(1., 0.8, 1.2));
            Subject::new(name, &shape(1.0, 0.1), place)
        }
    }
}

#[test]
fn superellipsoids() {
    for name in ["super", "super_star", "super_cyl"] {
        superellipsoid(name).agrees_with_the_record(1e-6, 1e-5);
        superellipsoid(name).is_a_consistent_solid();
    }
    superellipsoid("super").uv_agrees_with_the_record(3e-4);
}

/// The heights of the recorded images, row 0 at z = 0.
fn heights(name: &str) -> Vec<u16> {
    let table: [u16; 36] = match name {
        "hf_gray8" => [
            4883, 20817, 36751, 52685, 2827, 18761, 45232, 59881, 8738, 23387, 38036, 52685, 25443, 38807,
            52171, 65535, 12850, 26471, 11308, 23387, 35466, 47545, 59367, 5654, 2827, 13364, 24158, 35209,
            46003, 56540, 0, 9509, 19018, 28270, 38036, 47545,
        ],
        "hf_gray16" => [
            39595, 54781, 4431, 19617, 34803, 49989, 31676, 45625, 59574, 7987, 21936, 35885, 23757, 36469,
            49181, 61893, 9069, 21781, 15838, 27313, 38788, 50263, 61738, 7677, 7919, 18157, 28395, 38633,
            48871, 59109, 0, 9001, 18002, 27003, 36004, 45005,
        ],
        "hf_rgb8" => [
            4907, 20887, 36677, 52533, 2919, 18907, 45244, 59673, 8888, 23449, 38076, 52513, 25421, 38811,
            52011, 65533, 13073, 26471, 11486, 23325, 35486, 47457, 59494, 6061, 2927, 13727, 24337, 35269,
            46011, 56819, 0, 9505, 19076, 28457, 37904, 47417,
        ],
        "hf_rgb16" => [
            26517, 35758, 3744, 12985, 22226, 31467, 21214, 29676, 38139, 5346, 13808, 22270, 15910, 23594,
            31277, 38961, 5389, 13073, 10607, 17511, 24417, 31321, 38226, 3876, 5303, 11429, 17555, 23681,
            29808, 35934, 0, 5347, 10694, 16042, 21389, 26737,
        ],
        _ => [
            4864, 20736, 36608, 52480, 2816, 18688, 45056, 59648, 8704, 23296, 37888, 52480, 25344, 38656,
            51968, 65280, 13056, 26368, 11264, 23296, 35328, 47360, 59392, 5888, 2816, 13568, 24320, 35072,
            45824, 56576, 0, 9472, 18944, 28416, 37888, 47360,
        ],
    };
    table.to_vec()
}

fn height_field(name: &'static str) -> Subject {
    let make = |width, depth, heights, smooth, water_level| {
        Shape::HeightField(Arc::new(raggio_scene::HeightField { width, depth, heights, smooth, water_level }))
    };
    if name.starts_with("hf_func") {
        let mut heights = Vec::new();
        for row in 0..7 {
            for column in 0..9 {
                let (x, y) = (f64::from(column) / 8.0, 1.0 - f64::from(row) / 6.0);
                heights.push((65535.0 * (0.5 + 0.4 * (7.0 * x).sin() * (5.0 * y).cos())) as u16);
            }
        }
        let smooth = name.ends_with("smooth");
        return plain(name, make(9, 7, heights, smooth, if smooth { 0.3 } else { 0.0 }));
    }
    let water = if name == "hf_pal8" { 0.25 } else { 0.0 };
    let place = match name {
        "hf_gray16" => rotate(0., 30., 0.) * transform::scale(Vec3::new(2., 0.5, 1.5)),
        _ => Affine::IDENTITY,
    };
    Subject::new(name, &make(6, 6, heights(name), false, water), place)
}

#[test]
fn height_fields() {
    for name in ["hf_func", "hf_func_smooth", "hf_gray8", "hf_gray16", "hf_rgb8", "hf_rgb16", "hf_pal8"] {
        height_field(name).agrees_with_the_record(1e-6, 1e-5);
    }
    height_field("hf_func").uv_agrees_with_the_record(3e-4);
}

fn lathe(name: &'static str) -> Subject {
    let (kind, p) = match name {
        "lathe_linear" => {
            (SplineKind::Linear, points(&[(0., -1.), (0.9, -0.8), (0.4, 0.), (0.7, 0.6), (0., 1.)]))
        }
        "lathe_quad" => {
            let p = [(0., -1.3), (0.1, -1.), (0.9, -0.6), (0.4, 0.1), (0.7, 0.6), (0.2, 1.)];
            (SplineKind::Quadratic, points(&p))
        }
        "lathe_cubic" => {
            let p = [(0., -1.3), (0.1, -1.), (0.9, -0.6), (0.4, 0.1), (0.7, 0.6), (0.2, 1.), (0., 1.3)];
            (SplineKind::Cubic, points(&p))
        }
        _ => {
            let p = [(0.1, -1.), (0.9, -1.), (1.1, -0.3), (0.5, 0.)];
            let q = [(0.5, 0.), (0.2, 0.2), (0.6, 0.8), (0.1, 1.)];
            (SplineKind::Bezier, points(&[p, q].concat()))
        }
    };
    plain(name, Shape::Lathe { curves: curves(kind, &p).into(), kind })
}

#[test]
fn lathes() {
    for name in ["lathe_linear", "lathe_cubic", "lathe_bezier"] {
        lathe(name).agrees_with_the_record(5e-6, 2e-5);
    }
    // POV-Ray misses quadratic lathes with exactly level rays.
    let wrong = lathe("lathe_quad").differing_hits(1e-6, 1e-5);
    let level_misses = wrong.iter().filter(|row| row.contains("1\", \"0\", \"0\", \"0\", \"\"")).count();
    assert_eq!((wrong.len(), level_misses), (2, 2), "{wrong:?}");
    assert!(lathe("lathe_quad").differing_insides().is_empty());
    lathe("lathe_linear").is_a_consistent_solid();
    lathe("lathe_linear").uv_agrees_with_the_record(3e-4);
    lathe("lathe_bezier").uv_agrees_with_the_record(3e-4);
}

#[test]
fn a_lathe_takes_level_and_nearly_level_rays_alike() {
    let lathe = lathe("lathe_cubic");
    for rise in [0.0, 1e-12, 1e-9, 9e-7, 1.1e-6, 1e-5] {
        let hit = lathe.trace(Vec3::new(-3.0, 0.3, 0.1), Vec3::new(1.0, rise, 0.0)).expect("a hit");
        let level = lathe.trace(Vec3::new(-3.0, hit.p.y, 0.1), Vec3::X).expect("a hit");
        assert!((hit.p - level.p).length() < 1e-9, "rise {rise}: {} and {}", hit.p, level.p);
    }
}

fn sor(name: &'static str) -> Subject {
    let p = [(0., -1.3), (0.3, -1.), (0.9, -0.4), (0.4, 0.1), (0.7, 0.6), (0.35, 1.), (0.1, 1.4)];
    plain(name, Shape::Sor { points: points(&p).into(), open: name == "sor_open" })
}

#[test]
fn surfaces_of_revolution() {
    for name in ["sor", "sor_open"] {
        sor(name).agrees_with_the_record(1e-6, 1e-5);
    }
    sor("sor").is_a_consistent_solid();
    sor("sor").uv_agrees_with_the_record(3e-4);
}

fn ovus(name: &'static str) -> Subject {
    let (bottom, top) = if name == "ovus" { (1.0, 0.65) } else { (0.6, 0.8) };
    plain(name, Shape::Ovus { bottom, top })
}

#[test]
fn eggs() {
    for name in ["ovus", "ovus_top"] {
        ovus(name).agrees_with_the_record(1e-6, 1e-5);
        ovus(name).is_a_consistent_solid();
    }
    ovus("ovus").uv_agrees_with_the_record(3e-4);
    // A top of twice the bottom or more is a sphere.
    let ball = plain("ball", Shape::Ovus { bottom: 0.5, top: 1.2 });
    ball.is_a_consistent_solid();
    let hit = ball.trace(Vec3::new(-5.0, 0.5, 0.0), Vec3::X).expect("a hit");
    assert!((hit.p.x + 1.2).abs() < 1e-12);
}

/// Small formulas for functions.
mod formula {
    use raggio_function::{BinaryOp, Builtin, Expr};

    pub fn num(x: f64) -> Expr {
        Expr::Const(x)
    }
    pub fn slot(n: usize) -> Expr {
        Expr::Slot(n)
    }
    pub fn add(a: Expr, b: Expr) -> Expr {
        Expr::Binary(BinaryOp::Add, Box::new(a), Box::new(b))
    }
    pub fn mul(a: Expr, b: Expr) -> Expr {
        Expr::Binary(BinaryOp::Mul, Box::new(a), Box::new(b))
    }
    pub fn sin(a: Expr) -> Expr {
        Expr::Call(Builtin::Sin, vec![a])
    }
    pub fn cos(a: Expr) -> Expr {
        Expr::Call(Builtin::Cos, vec![a])
    }
    pub fn sqr(n: usize) -> Expr {
        mul(slot(n), slot(n))
    }
}

fn isosurface(name: &'static str) -> Subject {
    use formula::*;
    let cube = |r: f64| Container::Box { min: Vec3::splat(-r), max: Vec3::splat(r) };
    let (body, container, max_gradient, max_trace, place) = match name {
        "iso" => {
            let xy = add(sqr(0), mul(num(2.0), sqr(1)));
            let z = mul(sqr(2), add(num(1.0), slot(0)));
            (add(add(xy, z), num(-0.8)), cube(1.2), 8.0, 1, Affine::IDENTITY)
        }
        "iso_closed" => {
            let waves =
                add(mul(num(0.3), sin(mul(num(4.0), slot(0)))), mul(num(0.2), cos(mul(num(3.0), slot(2)))));
            let ball = Container::Sphere { center: Vec3::ZERO, radius: 1.0 };
            (add(slot(1), waves), ball, 3.0, 10, Affine::IDENTITY)
        }
        _ => (add(sqr(0), sqr(2)), cube(1.0), 4.0, 10, rotate(20., 0., 30.)),
    };
    let iso = raggio_scene::Isosurface {
        function: Arc::new(Function::new(3, body)),
        container,
        threshold: if name == "iso_open" { 0.36 } else { 0.0 },
        accuracy: 0.0001,
        max_gradient,
        evaluate: None,
        max_trace,
        open: name == "iso_open",
    };
    Subject::new(name, &Shape::Isosurface(Box::new(iso)), place)
}

#[test]
fn isosurfaces() {
    for name in ["iso", "iso_closed", "iso_open"] {
        isosurface(name).agrees_with_the_record(1e-5, 1e-5);
    }
    // The very steps of the search: all but two rays from inside agree to the last digit recorded.
    assert_eq!(isosurface("iso").differing_hits(1e-9, 1e-6).len(), 2);
    assert_eq!(isosurface("iso_closed").differing_hits(1e-9, 1e-6).len(), 0);
    assert_eq!(isosurface("iso_open").differing_hits(1e-9, 1e-6).len(), 0);
    isosurface("iso").uv_agrees_with_the_record(3e-4);
    isosurface("iso_closed").is_a_consistent_solid();
}

fn bicubic(name: &'static str) -> Subject {
    let v = Vec3::new;
    let points = Box::new([
        [v(-1.5, -1.5, 0.), v(-0.5, -1.5, 0.8), v(0.5, -1.5, -0.8), v(1.5, -1.5, 0.)],
        [v(-1.5, -0.5, 1.), v(-0.5, -0.5, -1.), v(0.5, -0.5, 1.), v(1.5, -0.5, 0.3)],
        [v(-1.5, 0.5, -1.), v(-0.5, 0.5, 1.2), v(0.5, 0.5, -0.7), v(1.5, 0.5, 0.5)],
        [v(-1.5, 1.5, 0.), v(-0.5, 1.5, -0.5), v(0.5, 1.5, 0.5), v(1.5, 1.5, 0.25)],
    ]);
    let uv = |x: f64| [Vec2::ZERO, Vec2::new(x, 0.), Vec2::new(x, 1.), Vec2::new(0., 1.)];
    let shape = if name == "bicubic0" {
        Shape::BicubicPatch { patch_type: 0, flatness: 0.05, u_steps: 3, v_steps: 2, points, uv: uv(1.0) }
    } else {
        Shape::BicubicPatch { patch_type: 1, flatness: 0.0, u_steps: 3, v_steps: 3, points, uv: uv(2.0) }
    };
    plain(name, shape)
}

#[test]
fn bicubic_patches() {
    for name in ["bicubic0", "bicubic1"] {
        bicubic(name).agrees_with_the_record(1e-6, 1e-5);
        bicubic(name).uv_agrees_with_the_record(3e-4);
    }
}

fn sweep(name: &'static str) -> Subject {
    let s = |x: f64, y: f64, z: f64, radius: f64| SweepSphere { center: Vec3::new(x, y, z), radius };
    let (kind, spheres, tolerance) = match name {
        "sweep_linear" => {
            let p = vec![
                s(-1., -0.6, 0., 0.3),
                s(0., 0.6, 0.2, 0.45),
                s(0.8, -0.4, -0.2, 0.2),
                s(1.1, 0.6, 0., 0.25),
            ];
            (SplineKind::Linear, p, 1e-6)
        }
        "sweep_cubic" => {
            let p = vec![
                s(-1.5, -1., 0., 0.3),
                s(-1., -0.6, 0., 0.3),
                s(0., 0.6, 0.2, 0.4),
                s(0.8, -0.4, -0.2, 0.2),
                s(1.1, 0.6, 0., 0.25),
                s(1.2, 1., 0., 0.2),
            ];
            (SplineKind::Cubic, p, 1e-6)
        }
        _ => {
            let p = vec![
                s(-1.5, -1., 0., 0.4),
                s(-1., -0.6, 0., 0.4),
                s(0., 1., 0.2, 0.5),
                s(0.8, -0.8, -0.2, 0.3),
                s(1.1, 0.6, 0., 0.35),
                s(1.2, 1., 0., 0.3),
            ];
            (SplineKind::BSpline, p, 0.001)
        }
    };
    plain(name, Shape::SphereSweep { kind, spheres: spheres.into(), tolerance })
}

#[test]
fn sphere_sweeps() {
    for name in ["sweep_linear", "sweep_cubic", "sweep_b"] {
        sweep(name).agrees_with_the_record(5e-6, 5e-5);
    }
    sweep("sweep_linear").uv_agrees_with_the_record(3e-4);
}

fn julia(name: &'static str) -> Subject {
    use raggio_scene::{JuliaAlgebra, JuliaFunction};
    let plain_slice = ([0.0, 0.0, 0.0, 1.0], 0.0);
    let (parameter, algebra, function, max_iteration, precision, (slice, slice_distance)) = match name {
        "julia" => {
            let c = [-0.083, 0.0, -0.83, -0.025];
            (c, JuliaAlgebra::Quaternion, JuliaFunction::Sqr, 8, 50.0, plain_slice)
        }
        "julia_cube" => {
            let length = (0.01f64 + 0.04 + 0.01 + 1.0).sqrt();
            let slice = [0.1, 0.2, 0.1, 1.0].map(|x| x / length);
            let c = [0.3, 0.4, -0.2, 0.1];
            (c, JuliaAlgebra::Quaternion, JuliaFunction::Cube, 6, 50.0, (slice, 0.1))
        }
        "julia_hyper" => {
            let c = [-0.16, 0.5, 0.1, -0.2];
            (c, JuliaAlgebra::Hypercomplex, JuliaFunction::Sqr, 7, 80.0, plain_slice)
        }
        _ => {
            let c = [-1.0, 0.2, 0.1, 0.05];
            (c, JuliaAlgebra::Hypercomplex, JuliaFunction::Exp, 5, 40.0, plain_slice)
        }
    };
    let julia =
        raggio_scene::Julia { parameter, algebra, function, max_iteration, precision, slice, slice_distance };
    plain(name, Shape::Julia(Box::new(julia)))
}

#[test]
fn julia_fractals() {
    for name in ["julia", "julia_cube", "julia_hyper"] {
        julia(name).agrees_with_the_record(1e-6, 1e-4);
    }
    // Thin leaves of the exponential are met or missed by chance, as the steps of the march fall.
    let exp = julia("julia_exp");
    assert!(exp.differing_insides().is_empty());
    let wrong = exp.differing_hits(1e-6, f64::INFINITY);
    assert!(wrong.len() <= 13, "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}

fn parametric() -> Subject {
    use formula::*;
    let tube = || add(num(1.0), mul(num(0.35), cos(slot(1))));
    let function = |body| Arc::new(Function::new(2, body));
    let shape = raggio_scene::Parametric {
        functions: [
            function(mul(cos(slot(0)), tube())),
            function(mul(num(0.35), sin(slot(1)))),
            function(mul(sin(slot(0)), tube())),
        ],
        uv_min: Vec2::ZERO,
        uv_max: Vec2::splat(6.283185307),
        container: Container::Box { min: Vec3::new(-1.4, -0.4, -1.4), max: Vec3::new(1.4, 0.4, 1.4) },
        max_gradient: 2.0,
        accuracy: 0.0005,
        precompute_depth: 10,
    };
    plain("parametric", Shape::Parametric(Box::new(shape)))
}

#[test]
fn parametric_surfaces() {
    parametric().agrees_with_the_record(1e-9, 1e-8);
    for row in rows(UV, "parametric") {
        let v = numbers(&row[2..]);
        let hit =
            parametric().trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5])).expect("a hit");
        // The record was read from a picture in which 2 is the brightest.
        assert!((hit.uv.min(Vec2::splat(2.0)) - Vec2::new(v[6], v[7])).abs().max_element() < 3e-4, "{row:?}");
    }
}

/// Traces in the world with a shape that was moved there.
fn trace_moved(shape: &ShapeKind, origin: Vec3, dir: Vec3) -> (Vec3, Vec3) {
    let ray = Ray::new(origin, dir.normalize());
    let hit = shape.closest(&ray, (MIN_HIT, f64::INFINITY)).expect("a hit");
    (ray.at(hit.t), shape.normal(ray.at(hit.t), &hit))
}

fn near(found: Vec3, expected: [f64; 3], tolerance: f64) {
    let expected = Vec3::from_array(expected);
    assert!((found - expected).length() < tolerance, "{found} for {expected}");
}

#[test]
fn a_stretched_isosurface_is_searched_along_the_ray_of_the_world() {
    let body = {
        use formula::*;
        let xy = add(sqr(0), mul(num(2.0), sqr(1)));
        add(add(xy, mul(sqr(2), add(num(1.0), slot(0)))), num(-0.8))
    };
    let iso = raggio_scene::Isosurface {
        function: Arc::new(Function::new(3, body)),
        container: Container::Box { min: Vec3::splat(-1.2), max: Vec3::splat(1.2) },
        threshold: 0.0,
        accuracy: 0.001,
        max_gradient: 8.0,
        evaluate: None,
        max_trace: 10,
        open: false,
    };
    let place = transform::translate(Vec3::new(0.1, 0., 0.))
        * rotate(10., 20., 30.)
        * transform::scale(Vec3::new(3., 0.5, 2.));
    let shape = super::moved(&Shape::Isosurface(Box::new(iso)), &place).expect("moved");
    let v = Vec3::new;
    // Points and normals that POV-Ray's trace() gave.
    let (p, n) = trace_moved(&shape, v(-5., 0.1, 0.2), v(1., 0., 0.1));
    near(p, [-0.124425528, 0.1, 0.687557447], 1e-8);
    near(n, [-0.430819879, 0.876748728, 0.213789383], 1e-6);
    let (p, _) = trace_moved(&shape, v(0.3, 4., 0.2), v(0.1, -1., 0.05));
    near(p, [0.646786792, 0.532132075, 0.373393396], 1e-8);
    let (p, n) = trace_moved(&shape, v(0.5, 0.2, -6.), v(-0.05, 0., 1.));
    near(p, [0.275940479, 0.2, -1.518809577], 1e-8);
    near(n, [0.389891391, -0.773479480, -0.499714115], 1e-6);
    assert!(shape.inside(v(0.1, 0., 0.)) && !shape.inside(v(5., 0., 0.)));
}

#[test]
fn a_stretched_blob_keeps_its_least_distance_in_the_world() {
    let one = Vec3::ONE;
    let components = vec![
        ball(Vec3::new(0.6, 0., 0.), 1.0, 1.0, one),
        ball(Vec3::new(-0.5, 0.2, 0.), 0.9, 1.2, one),
        ball(Vec3::new(0., 0.9, 0.1), 0.8, 0.9, one),
    ];
    let shape = Shape::Blob(Arc::new(raggio_scene::Blob { threshold: 0.6, components }));
    let shape = super::moved(&shape, &transform::scale(Vec3::splat(20.0))).expect("moved");
    // As POV-Ray's trace() does.
    let (p, n) = trace_moved(&shape, Vec3::new(-50., 3., 2.), Vec3::X);
    near(p, [-19.481424096, 3., 2.], 1e-6);
    near(n, [-0.973299296, -0.102653281, 0.205306563], 1e-6);
    near(trace_moved(&shape, p - 0.02 * Vec3::X, Vec3::X).0, p.to_array(), 1e-9);
    near(trace_moved(&shape, p - 0.005 * Vec3::X, Vec3::X).0, [20.784152338, 3., 2.], 1e-6);
}

#[test]
fn a_blobs_components_share_a_point_by_their_fields() {
    let Subject { surface: ShapeKind::Blob(blob), .. } = blob("blob") else { panic!("a blob") };
    let mut uses = crate::texturing::PartUses::new();
    // Fields by hand: strength (1 - d^2 / r^2)^2.
    let p = Vec3::new(0.1, 0.3, 0.0);
    blob.weights(p, &mut uses);
    let u = |d2: f64, r: f64| 1.0 - d2 / (r * r);
    let fields = [u(0.34, 1.0).powi(2), 1.2 * u(0.37, 0.9).powi(2), 0.9 * u(0.38, 0.8).powi(2)];
    let total: f64 = fields.iter().sum();
    assert_eq!(uses.len(), 3);
    for (k, (index, weight)) in uses.iter().enumerate() {
        assert_eq!(*index, k as u32);
        assert!((f64::from(*weight) - fields[k] / total).abs() < 1e-6);
    }
    blob.weights(Vec3::splat(9.0), &mut uses);
    assert!(uses.is_empty());
}

/// A square ring and, beside it, a half disc bounded by a parabola.
fn text() -> Subject {
    use raggio_scene::{Contour, Glyph};
    let square = |r: f64| {
        let p = points(&[(-r, -r), (-r, r), (r, r), (r, -r), (-r, -r)]);
        Contour { curves: curves(SplineKind::Linear, &p) }
    };
    // y = 1 - x^2 over -1..=1, from right to left, then back along the base.
    let arch = Curve2 {
        a: Vec2::ZERO,
        b: Vec2::new(0.0, -4.0),
        c: Vec2::new(-2.0, 4.0),
        d: Vec2::new(1.0, 0.0),
        kind: CurveKind::Quadratic,
    };
    let base = curves(SplineKind::Linear, &points(&[(-1., 0.), (1., 0.)]));
    let bow = Contour { curves: [vec![arch], base].concat() };
    let ring = Glyph { offset: Vec2::new(-0.5, 0.0), contours: vec![square(0.4), square(0.2)].into() };
    let bow = Glyph { offset: Vec2::new(1.0, 0.0), contours: vec![bow].into() };
    plain("text of our own", Shape::Text { glyphs: vec![ring, bow].into(), depth: 0.3 })
}

#[test]
fn glyphs_are_solids_by_the_even_odd_rule() {
    let text = text();
    text.is_a_consistent_solid();
    let v = Vec3::new;
    let hit = |o: Vec3, d: Vec3| text.trace(o, d).map(|h| (h.p.to_array(), h.n.to_array()));
    assert_eq!(hit(v(-0.8, 0., -2.), Vec3::Z), Some(([-0.8, 0., 0.], [0., 0., -1.])));
    assert_eq!(hit(v(-0.8, 0., 2.), -Vec3::Z).map(|h| h.1), Some([0., 0., 1.]));
    assert!(hit(v(-0.5, 0., -2.), Vec3::Z).is_none(), "through the ring");
    // From within the hole, its right wall; walls look out of the solid.
    let (p, n) = hit(v(-0.5, 0., 0.1), Vec3::X).expect("the hole's wall");
    near(Vec3::from_array(p), [-0.3, 0., 0.1], 1e-12);
    assert_eq!(n[0].abs(), 1.0);
    // The top of the bow.
    let (p, n) = hit(v(1.0, 5., 0.15), -Vec3::Y).expect("the bow");
    near(Vec3::from_array(p), [1., 1., 0.15], 1e-12);
    near(Vec3::from_array(n), [0., 1., 0.], 1e-12);
    assert!(text.inside(v(1., 0.5, 0.1)) && !text.inside(v(1., 0.5, 0.4)) && !text.inside(v(1.9, 0.5, 0.1)));
}

#[test]
fn nothing_panics_on_strange_rays() {
    let subjects = [
        torus("torus"),
        polynomial("poly6"),
        blob("blob"),
        prism("prism_conic"),
        prism("prism_cubic"),
        superellipsoid("super_star"),
        height_field("hf_func"),
        lathe("lathe_cubic"),
        sor("sor"),
        ovus("ovus"),
        isosurface("iso"),
        bicubic("bicubic1"),
        sweep("sweep_b"),
        julia("julia_exp"),
        parametric(),
        text(),
    ];
    let numbers = [0.0, -0.0, 1.0, 1e-300, 1e300, f64::INFINITY, f64::NAN];
    for subject in &subjects {
        for (k, &a) in numbers.iter().enumerate() {
            for &b in &numbers {
                let ray = Ray::new(Vec3::new(a, b, 0.5), Vec3::AXES[k % 3]);
                let hit = subject.surface.closest(&ray, (0.0, f64::INFINITY));
                assert!(hit.is_none_or(|h| h.t > 0.0), "{}: {hit:?}", subject.name);
                subject.surface.hits(
                    &Ray::new(Vec3::ZERO, Vec3::new(a, b, 0.0)),
                    (0.0, 1e7),
                    &mut Vec::new(),
                );
                subject.surface.inside(Vec3::new(a, b, a));
            }
        }
    }
}
