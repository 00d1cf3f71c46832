//! How long a primary ray takes for each of the advanced shapes: `cargo run --release --example shape_speed [name]`.
use std::sync::Arc;
use std::time::Instant;

use raggio_function::{BinaryOp, Builtin, Expr, Function};
use raggio_geometry::{Geometry, RayClass};
use raggio_math::{Affine, Ray, Vec2, Vec3};
use raggio_scene::*;

const WIDTH: u32 = 96;
const HEIGHT: u32 = 72;

fn main() {
    let only = std::env::args().nth(1);
    for (name, shape) in shapes().into_iter().filter(|s| only.as_ref().is_none_or(|only| only == s.0)) {
        let object = Object::new(ObjectKind::Shape(Arc::new(shape)));
        let Ok(geometry) = Geometry::of_object(&Arc::new(object)) else {
            println!("{name}: not supported");
            continue;
        };
        let passes = (0..60).map(|_| pass(&geometry));
        let best = passes.min_by(|a, b| a.0.total_cmp(&b.0));
        let (seconds, hits) = best.unwrap_or_default();
        let rays = f64::from(WIDTH * HEIGHT);
        println!(
            "{name:16} {:8.0} ns per ray, {:3.0} % hit",
            seconds * 1e9 / rays,
            100.0 * f64::from(hits) / rays
        );
    }
}

/// Seconds that a picture's rays take, and how many of them hit.
fn pass(geometry: &Geometry) -> (f64, u32) {
    let start = Instant::now();
    let mut hits = 0;
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let at = Vec2::new(f64::from(x) / f64::from(WIDTH) - 0.5, 0.5 - f64::from(y) / f64::from(HEIGHT));
            let dir = Vec3::new(1.33 * at.x, at.y - 0.4, 1.5).normalize();
            let ray = Ray::new(Vec3::new(0.0, 1.3, -4.0), dir);
            if let Some(hit) = geometry.closest(&ray, (0.0, f64::INFINITY), RayClass::Camera) {
                hits += u32::from(geometry.interaction(&ray, &hit).n.x > -2.0);
            }
        }
    }
    (start.elapsed().as_secs_f64(), hits)
}

fn shapes() -> Vec<(&'static str, Shape)> {
    let mut list = smooth_shapes();
    list.extend(curved_shapes());
    list
}

fn smooth_shapes() -> Vec<(&'static str, Shape)> {
    let mut quartic = vec![0.0; 35];
    for (k, x) in [
        (0, 1.),
        (4, 2.),
        (7, 2.),
        (9, -2.245),
        (20, 1.),
        (23, 2.),
        (25, 1.755),
        (30, 1.),
        (32, -2.245),
        (34, 0.76),
    ] {
        quartic[k] = x;
    }
    let ball = |x: f64, y: f64, z: f64| BlobComponent {
        shape: BlobShape::Sphere { center: Vec3::new(x, y, z), radius: 0.9 },
        strength: 1.0,
        blob_from_component: Affine::IDENTITY,
        texture: None,
    };
    let few = vec![ball(0.6, 0., 0.), ball(-0.5, 0.2, 0.), ball(0., 0.9, 0.1)];
    let many = (0..200)
        .map(|k| {
            let a = f64::from(k) * 0.7;
            let mut b = ball(1.2 * a.cos() * (a * 0.13).sin(), 1.2 * (a * 0.37).sin(), 1.2 * a.sin());
            if let BlobShape::Sphere { radius, .. } = &mut b.shape {
                *radius = 0.3;
            }
            b
        })
        .collect();
    let blob = |components| Shape::Blob(Arc::new(Blob { threshold: 0.6, components }));
    let julia = Julia {
        parameter: [-0.083, 0.0, -0.83, -0.025],
        algebra: JuliaAlgebra::Quaternion,
        function: JuliaFunction::Sqr,
        max_iteration: 8,
        precision: 50.0,
        slice: [0.0, 0.0, 0.0, 1.0],
        slice_distance: 0.0,
    };
    vec![
        ("sphere", Shape::Sphere { center: Vec3::ZERO, radius: 1.0 }),
        ("small sphere", Shape::Sphere { center: Vec3::ZERO, radius: 0.05 }),
        ("torus", Shape::Torus { major: 1.0, minor: 0.35 }),
        ("quartic", Shape::Poly { degree: 4, coefficients: quartic.into() }),
        ("superellipsoid", Shape::Superellipsoid { e: 0.25, n: 0.4 }),
        ("ovus", Shape::Ovus { bottom: 1.0, top: 0.65 }),
        ("blob of 3", blob(few)),
        ("blob of 200", blob(many)),
        ("julia", Shape::Julia(Box::new(julia))),
        ("isosurface", Shape::Isosurface(Box::new(wavy()))),
        ("height_field", hills()),
    ]
}

fn wavy() -> Isosurface {
    let slot = Expr::Slot;
    let op = |o, a, b| Expr::Binary(o, Box::new(a), Box::new(b));
    let wave = |k: f64, n, s| {
        op(
            BinaryOp::Mul,
            Expr::Const(s),
            Expr::Call(Builtin::Sin, vec![op(BinaryOp::Mul, Expr::Const(k), slot(n))]),
        )
    };
    let body = op(BinaryOp::Add, slot(1), op(BinaryOp::Add, wave(4.0, 0, 0.3), wave(3.0, 2, 0.2)));
    Isosurface {
        function: Arc::new(Function::new(3, body)),
        container: Container::Sphere { center: Vec3::ZERO, radius: 1.3 },
        threshold: 0.0,
        accuracy: 0.001,
        max_gradient: 1.8,
        evaluate: None,
        max_trace: 1,
        open: false,
    }
}

fn hills() -> Shape {
    let mut heights = Vec::new();
    for j in 0..256 {
        for i in 0..256 {
            let (x, z) = (f64::from(i) / 40.0, f64::from(j) / 40.0);
            heights
                .push((20000.0 * (1.2 + (x * 1.3).sin() * (z * 1.1 + 0.3 * (5.0 * x).sin()).cos())) as u16);
        }
    }
    Shape::HeightField(Arc::new(HeightField {
        width: 256,
        depth: 256,
        heights,
        smooth: true,
        water_level: 0.0,
    }))
}

fn curved_shapes() -> Vec<(&'static str, Shape)> {
    let v = |x: f64, y: f64| Vec2::new(x, y);
    let profile = [v(0., -1.3), v(0.1, -1.), v(0.9, -0.6), v(0.4, 0.1), v(0.7, 0.6), v(0.2, 1.), v(0., 1.3)];
    let outline = [v(-1., 0.2), v(0., -1.), v(1., 0.), v(0.2, 1.), v(-1., 0.2), v(0., -1.), v(1., 0.)];
    let cubic = |p: &[Vec2]| Curve2 {
        a: (-p[0] + 3. * p[1] - 3. * p[2] + p[3]) * 0.5,
        b: (2. * p[0] - 5. * p[1] + 4. * p[2] - p[3]) * 0.5,
        c: (p[2] - p[0]) * 0.5,
        d: p[1],
        kind: CurveKind::Cubic,
    };
    let curves = |p: &[Vec2]| p.windows(4).map(cubic).collect::<Vec<_>>();
    let prism = Prism { conic: false, heights: (-0.5, 0.5), curves: curves(&outline), open: false };
    let s = |x: f64, y: f64, z: f64, radius: f64| SweepSphere { center: Vec3::new(x, y, z), radius };
    let spheres = [
        s(-1.5, -1., 0., 0.3),
        s(-1., -0.6, 0., 0.3),
        s(0., 0.6, 0.2, 0.4),
        s(0.8, -0.4, -0.2, 0.2),
        s(1.1, 0.6, 0., 0.25),
        s(1.2, 1., 0., 0.2),
    ];
    let sweep = |kind| Shape::SphereSweep { kind, spheres: spheres.into(), tolerance: 1e-6 };
    let points = Box::new(std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let lift = [0.0, 0.8, -0.8, 0.3, 1.0, -1.0][(i * 3 + j) % 6];
            Vec3::new(j as f64 - 1.5, lift, i as f64 - 1.5)
        })
    }));
    let uv = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    vec![
        ("lathe", Shape::Lathe { curves: curves(&profile).into(), kind: SplineKind::Cubic }),
        (
            "sor",
            Shape::Sor {
                points: [v(0., -1.4)].iter().chain(&profile[1..6]).chain(&[v(0.1, 1.5)]).copied().collect(),
                open: false,
            },
        ),
        ("prism", Shape::Prism(Arc::new(prism))),
        ("linear sweep", sweep(SplineKind::Linear)),
        ("cubic sweep", sweep(SplineKind::Cubic)),
        (
            "bicubic_patch",
            Shape::BicubicPatch {
                patch_type: 1,
                flatness: 0.0,
                u_steps: 4,
                v_steps: 4,
                points,
                uv: Box::new(uv),
            },
        ),
    ]
}
