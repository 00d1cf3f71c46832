//! What holds for all of them, and for shapes at stretched places.
use super::fields::*;
use super::functions::*;
use super::swept::*;
use super::*;
use crate::shapes::moved;

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
    let shape = moved(&Shape::Isosurface(Box::new(iso)), &place).expect("moved");
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
    let shape = moved(&shape, &transform::scale(Vec3::splat(20.0))).expect("moved");
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
pub(super) fn text() -> Subject {
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

#[test]
fn ends_belong_to_open_cones_only() {
    let at = |height: f64| Vec3::new(0.3, height, 0.2);
    for cap_radius in [1.0, 1.5] {
        let cone = |open| {
            let (base, cap) = (Vec3::ZERO, Vec3::Y);
            crate::shapes::build(&Shape::Cone { base, base_radius: 1.0, cap, cap_radius, open }, 0)
                .expect("a cone")
        };
        let (open, closed) = (cone(true), cone(false));
        // As POV-Ray's inside() says.
        for end in [0.0, 1.0] {
            assert!(open.inside(at(end)) && !closed.inside(at(end)));
        }
        assert!(closed.inside(at(1e-9)) && closed.inside(at(1.0 - 1e-9)));
        assert!(!open.inside(at(-1e-9)) && !open.inside(at(1.0 + 1e-9)));
    }
}
