//! The tree against asking every box and every triangle in turn.
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raggio_bvh::Bvh;
use raggio_bvh::mesh::MeshBvh;
use raggio_math::{Aabb, Ray, Vec3};

/// Miri is a thousand times slower.
const CASES: u32 = if cfg!(miri) { 4 } else { 256 };

fn point(reach: f64) -> impl Strategy<Value = Vec3> {
    (-reach..reach, -reach..reach, -reach..reach).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn direction() -> impl Strategy<Value = Vec3> {
    let axis = prop_oneof![Just(Vec3::X), Just(Vec3::NEG_Y), Just(Vec3::Z), Just(Vec3::new(1., 1., 0.))];
    prop_oneof![3 => point(1.0), 1 => axis].prop_filter_map("zero", |v| v.try_normalize())
}

/// Boxes of all sizes, some flat, some coincident, some on a lattice so that rays run along their faces.
fn boxes() -> impl Strategy<Value = Vec<Aabb>> {
    let free = (point(10.0), point(1.0)).prop_map(|(c, s)| Aabb::new(c - s, c + s));
    let lattice = (point(4.0), 0.0..1.5f64).prop_map(|(c, s)| {
        let c = c.round();
        Aabb::new(c, c + Vec3::splat(s.round()))
    });
    let huge = point(1e6).prop_map(|c| Aabb::new(c, -c * 0.3));
    let one = prop_oneof![6 => free, 3 => lattice, 1 => huge];
    (prop::collection::vec(one, 0..120), 0..20usize).prop_map(|(mut all, copies)| {
        for i in 0..copies.min(all.len()) {
            all.push(all[i]);
        }
        all
    })
}

fn entry(b: &Aabb, ray: &Ray) -> Option<f64> {
    b.hit(ray).filter(|h| h.1 >= 0.0).map(|h| h.0.max(0.0))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, rng_seed: RngSeed::Fixed(1), cases: CASES, ..ProptestConfig::default() })]

    #[test]
    fn every_box_on_the_ray_is_visited(all in boxes(), o in point(12.0), d in direction(), leaf in 1..9usize) {
        let ray = Ray::new(o, d);
        let bvh = Bvh::build(&all, leaf).bvh;
        let mut seen = vec![0; all.len()];
        bvh.all(&ray, (0.0, f64::INFINITY), |i| seen[i as usize] += 1);
        for (i, b) in all.iter().enumerate() {
            prop_assert!(seen[i] <= 1);
            prop_assert!(seen[i] == 1 || entry(b, &ray).is_none(), "box {i} {b:?} was missed");
            // Conservative, but not by more than the rounding of single precision; those in one leaf come together.
            let slack = 1e-5 * (1.0 + o.abs().max_element() + b.min.abs().max(b.max.abs()).max_element());
            prop_assert!(leaf > 1 || seen[i] == 0 || entry(&b.grown(slack), &ray).is_some());
        }
    }

    #[test]
    fn the_nearest_is_found(all in boxes(), o in point(12.0), d in direction(), far in 0.0..40.0f64) {
        let ray = Ray::new(o, d);
        let bvh = Bvh::build(&all, 2).bvh;
        let expected =
            all.iter().filter_map(|b| entry(b, &ray)).filter(|&t| t < far).min_by(f64::total_cmp);
        let mut best = None;
        bvh.closest(&ray, (0.0, far), |i, t_max| {
            let t = entry(&all[i as usize], &ray).filter(|&t| t < t_max)?;
            best = Some(t);
            Some(t)
        });
        prop_assert_eq!(best, expected);
        let any = bvh.any(&ray, (0.0, far), |i| entry(&all[i as usize], &ray).is_some_and(|t| t < far));
        prop_assert_eq!(any, expected.is_some());
    }

    #[test]
    fn points_find_their_boxes(all in boxes(), p in point(5.0), snap in any::<bool>()) {
        let p = if snap { p.round() } else { p };
        let bvh = Bvh::build(&all, 1).bvh;
        let mut found = Vec::new();
        bvh.containing(p, |i| {
            if all[i as usize].contains(p) {
                found.push(i as usize);
            }
            false
        });
        found.sort_unstable();
        let expected: Vec<usize> = (0..all.len()).filter(|&i| all[i].contains(p)).collect();
        prop_assert_eq!(found, expected);
    }

    #[test]
    fn meshes_agree_with_each_triangle_alone(
        vertices in prop::collection::vec(point(3.0), 3..40),
        picks in prop::collection::vec((0..1000usize, 0..1000usize, 0..1000usize), 0..60),
        o in point(6.0),
        d in direction(),
    ) {
        let n = vertices.len();
        let faces: Vec<[u32; 3]> =
            picks.iter().map(|&(a, b, c)| [(a % n) as u32, (b % n) as u32, (c % n) as u32]).collect();
        let vertices: Vec<[f32; 3]> = vertices.iter().map(|v| v.as_vec3().to_array()).collect();
        let ray = Ray::new(o, d);
        let mesh = MeshBvh::build(&vertices, &faces);
        let corners = |f: u32| {
            faces[f as usize].map(|i| Vec3::from_array(vertices[i as usize].map(f64::from)))
        };
        let mut all = Vec::new();
        mesh.all(&ray, (0.0, 100.0), |h| all.push(h));
        for hit in &all {
            let [a, b, c] = corners(hit.face);
            let p = a + (b - a) * hit.u + (c - a) * hit.v;
            prop_assert!((p - ray.at(hit.t)).length() < 1e-6, "the weights belong to the point");
        }
        let nearest = all.iter().map(|h| h.t).min_by(f64::total_cmp);
        prop_assert_eq!(mesh.nearest(&ray, (0.0, 100.0), |_| false).map(|h| h.t), nearest);
        let expected = (0..faces.len() as u32).filter(|&f| plane_test(corners(f), &ray)).count();
        prop_assert_eq!(mesh.nearest(&ray, (0.0, 100.0), |_| true).is_some(), nearest.is_some());
        // A ray within rounding of an edge may be judged either way.
        let sure = (0..faces.len() as u32).all(|f| edge_distance(corners(f), &ray) > 1e-9);
        prop_assert!(!sure || all.len() == expected);
    }
}

/// Weights of the three corners where the ray meets the triangle's plane.
fn weights(corners: [Vec3; 3], ray: &Ray) -> Option<(f64, [f64; 3])> {
    let [a, b, c] = corners;
    let n = (b - a).cross(c - a);
    let t = n.dot(a - ray.origin) / n.dot(ray.dir);
    let p = ray.at(t);
    let part = |e: Vec3, f: Vec3| (e - p).cross(f - p).dot(n) / n.length_squared();
    t.is_finite().then(|| (t, [part(b, c), part(c, a), part(a, b)]))
}

fn plane_test(corners: [Vec3; 3], ray: &Ray) -> bool {
    weights(corners, ray).is_some_and(|(t, w)| t > 0.0 && t < 100.0 && w.iter().all(|&w| w >= 0.0))
}

fn edge_distance(corners: [Vec3; 3], ray: &Ray) -> f64 {
    weights(corners, ray).map_or(0.0, |(t, w)| w.iter().fold(t.abs(), |m, w| m.min(w.abs())))
}

#[test]
fn nothing_is_in_an_empty_tree() {
    let built = Bvh::build(&[Aabb::EMPTY], 2);
    assert!(built.bvh.is_empty() && built.unbounded.is_empty());
    assert!(!built.bvh.any(&Ray::new(Vec3::ZERO, Vec3::X), (0.0, 1.0), |_| true));
    assert!(!built.bvh.containing(Vec3::ZERO, |_| true));
}

#[test]
fn unbounded_boxes_are_handed_back() {
    let half = Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, f64::INFINITY, 1.0) };
    let built = Bvh::build(&[Aabb::INFINITE, Aabb::new(Vec3::ZERO, Vec3::ONE), half], 2);
    assert_eq!((built.bvh.len(), built.unbounded), (1, vec![0, 2]));
}

#[test]
fn a_hundred_equal_boxes_do_not_stop_the_builder() {
    let b = Aabb::new(Vec3::ZERO, Vec3::ONE);
    let bvh = Bvh::build(&[b; 100], 2).bvh;
    let mut count = 0;
    bvh.all(&Ray::new(Vec3::splat(0.5), Vec3::X), (0.0, 1.0), |_| count += 1);
    assert_eq!(count, 100);
}

#[test]
fn sizes_over_many_orders_make_no_endless_tree() {
    let boxes: Vec<Aabb> = (0..400)
        .map(|i| {
            let s = 10f64.powf(f64::from(i) * 0.1 - 20.0);
            Aabb::new(Vec3::splat(s), Vec3::splat(2.0 * s))
        })
        .collect();
    let bvh = Bvh::build(&boxes, 1).bvh;
    let mut count = 0;
    bvh.all(&Ray::new(Vec3::ZERO, Vec3::ONE.normalize()), (0.0, f64::INFINITY), |_| count += 1);
    assert_eq!(count, 400);
}

#[test]
fn no_ray_slips_through_a_closed_mesh() {
    // An octahedron seen from inside; rays aimed exactly at corners, edges and faces.
    let vertices: Vec<[f32; 3]> = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z]
        .iter()
        .map(|v| v.as_vec3().to_array())
        .collect();
    let faces =
        [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]].to_vec();
    let mesh = MeshBvh::build(&vertices, &faces);
    for i in 0..=40 {
        for j in 0..=40 {
            let d = Vec3::new(f64::from(i) - 20.0, f64::from(j) - 20.0, 7.0).normalize();
            for ray in [Ray::new(Vec3::ZERO, d), Ray::new(Vec3::new(0.1, 0.2, 0.3), d)] {
                assert!(mesh.nearest(&ray, (0.0, 10.0), |_| false).is_some(), "{ray:?}");
            }
        }
    }
}
