//! Packets against their rays one by one, by every kernel.
use super::*;

/// Asks every kernel for a packet and for its rays one by one. Says how many rays hit something.
fn compare(bvh: &mut MeshBvh, rays: &[MeshRay; 16], what: &str) -> usize {
    let packet = Packet::new(rays);
    let mut found = 0;
    for isa in wide::Isa::all() {
        bvh.isa = isa;
        let (hits, any) = (bvh.closest_packet(&packet), bvh.any_packet(&packet));
        for (i, ray) in rays.iter().enumerate() {
            let single = bvh.closest(ray);
            assert_eq!(hits.triangle[i] == u32::MAX, single.is_none(), "{what} {isa:?} {i} {ray:?}");
            assert_eq!(any >> i & 1 == 1, single.is_some(), "{what} {isa:?} {i} {ray:?}");
            let t = single.map_or(f32::INFINITY, |hit| hit.t);
            let close = hits.t[i] == t || (hits.t[i] - t).abs() <= 1e-5 * t;
            assert!(close, "{what} {isa:?} {i} {} {t} {ray:?}", hits.t[i]);
            found += usize::from(single.is_some());
        }
    }
    found
}

/// Makes one ray of a packet odd: parts that are 0, infinite or not numbers, ranges without a start, an end or a middle.
fn spoil(ray: &mut MeshRay, how: usize) {
    match how {
        0 => ray.dir[0] = 0.0,
        1 => ray.t_max = 0.5,
        2 => ray.t_min = 1.5,
        3 => ray.dir[0] = f32::NAN,
        4 => ray.origin[2] = f32::NAN,
        5 => ray.t_max = f32::NAN,
        6 => ray.t_min = f32::NAN,
        7 => ray.dir[1] = f32::INFINITY,
        8 => ray.origin[1] = f32::NEG_INFINITY,
        9 => ray.t_min = f32::INFINITY,
        10 => ray.dir = [0.0; 3],
        11 => ray.dir = ray.dir.map(|c| 1e-30 * c),
        12 => ray.dir = ray.dir.map(|c| 1e30 * c),
        13 => ray.t_max = -1.0,
        _ => {}
    }
}

/// Nothing, one, many in one place, flat ones, very large and far ones.
#[test]
fn packets_agree_with_single_rays_on_odd_meshes() {
    let p =
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1e18, 1e18, 0.0], [1e30, -1e30, 1e30], [2.0, 0.0, 0.0]];
    let meshes: [&[[u32; 3]]; 7] = [
        &[],
        &[[0, 1, 2]],
        &[[0, 1, 2]; 100],
        &[[0, 0, 1], [1, 1, 1], [0, 1, 5]],
        &[[0, 1, 3], [0, 1, 2]],
        &[[0, 1, 4], [0, 4, 2], [0, 1, 2]],
        &[[0, 0, 1], [0, 1, 2], [3, 4, 4], [0, 1, 2], [1, 5, 2], [0, 1, 4]],
    ];
    let mut random = Random(17);
    for triangles in meshes {
        let mut bvh = MeshBvh::build(&p, triangles);
        for n in 0..times(300) {
            let origin = [0.2 + 0.1 * random.float(), 0.3, if n % 2 == 0 { 3.0 } else { -3.0 }];
            // Some packets lie in one octant, so that they are traced as packets but for the odd ray.
            let aside = if n % 4 < 2 { 0.0 } else { 0.1 };
            let mut rays: [MeshRay; 16] = std::array::from_fn(|_| {
                ray(origin, [aside + 0.05 * random.float(), aside + 0.05 * random.float(), -origin[2]])
            });
            // The last lane is the one that bounds over all lanes are most likely to keep a NaN of.
            let lane = if n % 2 == 0 { 15 } else { n / 4 % 16 };
            spoil(&mut rays[lane], n / 4 % 15);
            compare(&mut bvh, &rays, &format!("{triangles:?} {n}"));
        }
    }
}

/// Narrow bundles, wide ones, some along an axis, which go into several octants, and some without any coherence, at
/// triangles that hang together and at loose ones.
#[test]
fn packets_agree_with_single_rays() {
    let mut random = Random(11);
    for (vertices, triangles) in [soup(300, 0.2, &mut random), band(300, &mut random)] {
        let mut bvh = MeshBvh::build(&vertices, &triangles);
        let mut found = 0;
        for n in 0..times(400) {
            let spread = [0.01, 0.05, 0.3, 4.0][n % 4];
            let (origin, mut dir) = (random.point().map(|c| 2.0 * c), random.point());
            if n % 7 == 0 {
                dir[n % 3] = 0.0;
            }
            let apart = if n % 5 == 0 { 0.1 } else { 0.0 };
            let rays: [MeshRay; 16] = std::array::from_fn(|_| {
                let (d, p) = (random.point(), random.point());
                let from = [0, 1, 2].map(|k| origin[k] + apart * p[k]);
                ray(from, [0, 1, 2].map(|k| dir[k] + spread * d[k]))
            });
            found += compare(&mut bvh, &rays, &n.to_string());
        }
        assert!(found > 0);
    }
}

/// Rays whose range ends before 0 hit nothing, and take nothing from the others.
#[test]
fn rays_without_a_range_stand_aside() {
    let (vertices, triangles) = band(200, &mut Random(19));
    let mut bvh = MeshBvh::build(&vertices, &triangles);
    let mut random = Random(37);
    let mut found = 0;
    for n in 0..times(300) {
        let (origin, target) = (random.point().map(|c| 2.0 + c), vertices[n % vertices.len()]);
        let full: [MeshRay; 16] = std::array::from_fn(|_| {
            let d = random.point();
            ray(origin, [0, 1, 2].map(|k| target[k] + 0.02 * d[k] - origin[k]))
        });
        let mut rays = full;
        let active = if n % 16 == 0 { 0 } else { random.0 >> 40 };
        for (i, ray) in rays.iter_mut().enumerate() {
            ray.t_max = if active >> i & 1 == 1 { ray.t_max } else { -1.0 };
        }
        found += compare(&mut bvh, &rays, &n.to_string());
        let (some, all) = (bvh.closest_packet(&Packet::new(&rays)), bvh.closest_packet(&Packet::new(&full)));
        for i in 0..16 {
            let expected = if active >> i & 1 == 1 { all.triangle[i] } else { u32::MAX };
            assert_eq!(some.triangle[i], expected, "{n} {i}");
        }
    }
    assert!(found > 0);
}
