//! Isosurfaces, patches, sweeps, fractals and parametric surfaces.
use super::*;

/// Small formulas for functions.
pub(super) mod formula {
    use raggio_function::{BinaryOp, Builtin, Expr, Internal};

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
    pub fn noise() -> Expr {
        Expr::Internal(Internal::NOISE, (0..3).map(slot).collect())
    }
    pub fn sqr(n: usize) -> Expr {
        mul(slot(n), slot(n))
    }
}

pub(super) fn isosurface(name: &'static str) -> Subject {
    use formula::*;
    let cube = |r: f64| Container::Box { min: Vec3::splat(-r), max: Vec3::splat(r) };
    let (body, container, max_gradient, max_trace, place) = match name {
        "iso" | "iso_all" => {
            let xy = add(sqr(0), mul(num(2.0), sqr(1)));
            let z = mul(sqr(2), add(num(1.0), slot(0)));
            (add(add(xy, z), num(-0.8)), cube(1.2), 8.0, if name == "iso" { 1 } else { 10 }, Affine::IDENTITY)
        }
        "iso_noise" => {
            let ball = add(add(sqr(0), sqr(1)), add(sqr(2), num(-0.9)));
            (add(ball, mul(num(0.5), noise())), cube(1.2), 8.0, 10, Affine::IDENTITY)
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

pub(super) fn bicubic(name: &'static str) -> Subject {
    let v = Vec3::new;
    let points = Box::new([
        [v(-1.5, -1.5, 0.), v(-0.5, -1.5, 0.8), v(0.5, -1.5, -0.8), v(1.5, -1.5, 0.)],
        [v(-1.5, -0.5, 1.), v(-0.5, -0.5, -1.), v(0.5, -0.5, 1.), v(1.5, -0.5, 0.3)],
        [v(-1.5, 0.5, -1.), v(-0.5, 0.5, 1.2), v(0.5, 0.5, -0.7), v(1.5, 0.5, 0.5)],
        [v(-1.5, 1.5, 0.), v(-0.5, 1.5, -0.5), v(0.5, 1.5, 0.5), v(1.5, 1.5, 0.25)],
    ]);
    let uv = |x: f64| [Vec2::ZERO, Vec2::new(x, 0.), Vec2::new(x, 1.), Vec2::new(0., 1.)];
    let shape = if name == "bicubic0" {
        Shape::BicubicPatch {
            patch_type: 0,
            flatness: 0.05,
            u_steps: 3,
            v_steps: 2,
            points,
            uv: Box::new(uv(1.0)),
        }
    } else {
        Shape::BicubicPatch {
            patch_type: 1,
            flatness: 0.0,
            u_steps: 3,
            v_steps: 3,
            points,
            uv: Box::new(uv(2.0)),
        }
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

pub(super) fn sweep(name: &'static str) -> Subject {
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

pub(super) fn julia(name: &'static str) -> Subject {
    plain(name, Shape::Julia(Box::new(julia_data(name))))
}

pub(super) fn julia_data(name: &str) -> raggio_scene::Julia {
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
    raggio_scene::Julia { parameter, algebra, function, max_iteration, precision, slice, slice_distance }
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

pub(super) fn parametric() -> Subject {
    use formula::*;
    let tube = || add(num(1.0), mul(num(0.35), cos(slot(1))));
    let function = |body| Arc::new(Function::new(2, body));
    // As the recorded scene writes it.
    #[allow(clippy::approx_constant)]
    let turn = 6.283185307;
    let shape = raggio_scene::Parametric {
        functions: [
            function(mul(cos(slot(0)), tube())),
            function(mul(num(0.35), sin(slot(1)))),
            function(mul(sin(slot(0)), tube())),
        ],
        uv_min: Vec2::ZERO,
        uv_max: Vec2::splat(turn),
        container: Container::Box { min: Vec3::new(-1.4, -0.4, -1.4), max: Vec3::new(1.4, 0.4, 1.4) },
        max_gradient: 2.0,
        accuracy: 0.0005,
        precompute_depth: 10,
    };
    plain("parametric", Shape::Parametric(Box::new(shape)))
}

#[test]
fn parametric_surfaces() {
    let mut hits = 0;
    for row in rows(HITS, "parametric") {
        let v = numbers(&row[1..]);
        let found = parametric().trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5]));
        assert_eq!(found.is_some(), v[6] == 1.0, "{row:?}");
        let Some(found) = found else { continue };
        let tube = Vec2::new(found.p.x.hypot(found.p.z) - 1.0, found.p.y).length();
        assert!((tube - 0.35).abs() < 1e-9, "{tube} {row:?}");
        // The record is off by the accuracy, and by much more where the ray grazes.
        if Vec3::new(v[3], v[4], v[5]).normalize().dot(found.n).abs() > 0.6 {
            let (p, n) = (Vec3::new(v[7], v[8], v[9]), Vec3::new(v[10], v[11], v[12]));
            assert!((found.p - p).length() < 0.01, "{:?} {row:?}", found.p);
            assert!((found.n - n).length() < 0.02, "{:?} {row:?}", found.n);
            hits += 1;
        }
    }
    assert!(hits > 5, "{hits}");
    for row in rows(UV, "parametric") {
        let v = numbers(&row[2..]);
        let hit =
            parametric().trace(Vec3::new(v[0], v[1], v[2]), Vec3::new(v[3], v[4], v[5])).expect("a hit");
        // The record was read from a picture in which 2 is the brightest.
        assert!((hit.uv.min(Vec2::splat(2.0)) - Vec2::new(v[6], v[7])).abs().max_element() < 2e-3, "{row:?}");
    }
}
