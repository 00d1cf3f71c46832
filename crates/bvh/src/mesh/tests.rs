//! Every kernel against every triangle alone, and against meshes that must not leak.
use raggio_math::Vec3;

use super::*;

mod packets;

/// How often to repeat: under Miri, which is a thousand times slower, far less often.
fn times(count: usize) -> usize {
    if cfg!(miri) { count.div_ceil(100) } else { count }
}

/// A small deterministic generator: the tests need variety, not quality.
struct Random(u64);

impl Random {
    fn float(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 40) as f32 / (1u64 << 24) as f32 * 2.0 - 1.0
    }
    fn point(&mut self) -> [f32; 3] {
        [self.float(), self.float(), self.float()]
    }
}

fn ray(origin: [f32; 3], dir: [f32; 3]) -> MeshRay {
    MeshRay { origin, t_min: 0.0, dir, t_max: f32::INFINITY }
}

fn soup(count: u32, size: f32, random: &mut Random) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let mut vertices = Vec::new();
    for _ in 0..count {
        let centre = random.point();
        for _ in 0..3 {
            let d = random.point();
            vertices.push([0, 1, 2].map(|k| centre[k] + size * d[k]));
        }
    }
    (vertices, (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
}

/// A band of triangles that hang together.
fn band(count: u32, random: &mut Random) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let vertices = (0..count + 2).map(|i| random.point().map(|c| 0.5 * c + 0.5 * (i as f32 * 0.01).sin()));
    (vertices.collect(), (0..count).map(|i| [i, i + 1, i + 2]).collect())
}

/// Every triangle tested on its own, through a structure that holds just that one.
fn brute_force(vertices: &[[f32; 3]], triangles: &[[u32; 3]], ray: &MeshRay) -> Option<f32> {
    let one = |t: &[u32; 3]| scalar_closest(&MeshBvh::build(vertices, &[*t]), ray).map(|h| h.t);
    triangles.iter().filter_map(one).min_by(f32::total_cmp)
}

fn scalar_closest(bvh: &MeshBvh, ray: &MeshRay) -> Option<MeshHit> {
    with_blocks!(&bvh.blocks, list => scalar::closest(bvh, list, ray))
}

#[test]
fn every_kernel_agrees_with_brute_force() {
    let mut random = Random(7);
    let soups = [(1, 0.5), (3, 0.5), (40, 0.3), (200, 0.05), (200, 2.0)];
    let mut meshes = soups.map(|(count, size)| soup(count, size, &mut random)).to_vec();
    meshes.extend([1, 5, 6, 9, 250].map(|count| band(count, &mut random)));
    for (vertices, triangles) in meshes {
        let mut bvh = MeshBvh::build(&vertices, &triangles);
        for _ in 0..times(200) {
            let ray = ray(random.point().map(|c| 2.0 * c), random.point());
            let expected = brute_force(&vertices, &triangles, &ray);
            for isa in wide::Isa::all() {
                bvh.isa = isa;
                let found = bvh.closest(&ray).map(|h| h.t);
                assert_eq!(found.is_some(), expected.is_some(), "{isa:?} {ray:?}");
                if let (Some(a), Some(b)) = (found, expected) {
                    assert!((a - b).abs() <= 1e-5 * b.abs().max(1.0), "{isa:?} {a} {b}");
                }
                // Large trees are asked in another order.
                for far_off in [true, false] {
                    bvh.far_off = far_off;
                    assert_eq!(bvh.any(&ray), expected.is_some(), "{isa:?} {far_off}");
                }
            }
        }
    }
}

#[test]
fn nothing_coincident_flat_and_huge_are_harmless() {
    let p = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1e18, 1e18, 0.0]];
    let down = ray([0.2, 0.3, 1.0], [0.0, 0.0, -1.0]);
    assert_eq!(MeshBvh::build(&p, &[]).closest(&down), None);
    let same = MeshBvh::build(&p, &[[0, 1, 2]; 1000]);
    assert_eq!(same.closest(&down).map(|h| h.t), Some(1.0));
    let degenerate = MeshBvh::build(&p, &[[0, 0, 1], [1, 1, 1]]);
    assert!(!degenerate.any(&down));
    let huge = MeshBvh::build(&p, &[[0, 1, 3], [0, 1, 2]]);
    assert_eq!(huge.closest(&down).map(|h| h.triangle), Some(1));
}

/// A closed, finely divided sphere seen from inside: every ray must hit, those through edges and corners too.
#[test]
fn a_closed_mesh_leaks_nowhere() {
    let (rows, columns) = (24u32, 31u32);
    let mut vertices = vec![[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
    for i in 1..rows {
        for j in 0..columns {
            let (a, b) = (
                i as f32 / rows as f32 * std::f32::consts::PI,
                j as f32 / columns as f32 * std::f32::consts::TAU,
            );
            vertices.push([a.sin() * b.cos(), a.cos(), a.sin() * b.sin()]);
        }
    }
    let at = |i: u32, j: u32| match i {
        0 => 0,
        i if i == rows => 1,
        i => 2 + (i - 1) * columns + j % columns,
    };
    let mut triangles = Vec::new();
    for i in 0..rows {
        for j in 0..columns {
            triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    let mut bvh = MeshBvh::build(&vertices, &triangles);
    let mut random = Random(3);
    for n in 0..times(200_000) / if cfg!(miri) { 40 } else { 1 } {
        let origin = random.point().map(|c| 0.3 * c);
        let t = triangles[n % triangles.len()];
        let (a, b) = (vertices[t[n % 3] as usize], vertices[t[(n + 1) % 3] as usize]);
        let w = if n % 7 == 0 { 0.0 } else { 0.5 + 0.5 * random.float() };
        let target = [0, 1, 2].map(|k| a[k] + w * (b[k] - a[k]));
        let through_edge = ray(origin, [0, 1, 2].map(|k| target[k] - origin[k]));
        for isa in wide::Isa::all() {
            bvh.isa = isa;
            assert!(bvh.any(&through_edge), "{isa:?} {through_edge:?}");
        }
    }
}

/// The hit of a ray in double precision with one triangle, by Cramer's rule.
fn alone(corners: [Vec3; 3], ray: &Ray) -> Option<f64> {
    let [a, b, c] = corners;
    let (e1, e2, from) = (b - a, c - a, ray.origin - a);
    let p = ray.dir.cross(e2);
    let (u, q) = (from.dot(p) / e1.dot(p), from.cross(e1));
    let v = ray.dir.dot(q) / e1.dot(p);
    let t = e2.dot(q) / e1.dot(p);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
}

/// Meshes of all sizes, near the origin and far from it, hit from near and from far away.
#[test]
fn rays_in_double_precision_are_exact_at_any_scale() {
    let mut random = Random(5);
    for (scale, offset, away) in [
        (1.0, 0.0, 2.0),
        (1e-20, 0.0, 3.0),
        (1e20, 0.0, 2.0),
        (1.0, 1e4, 2.0),
        (1e-3, 10.0, 1e6),
        (1e3, -1e7, 1e4),
    ] {
        let (mut vertices, triangles) = soup(300, 0.3, &mut random);
        vertices.iter_mut().flatten().for_each(|c| *c = *c * scale + offset);
        let mut bvh = MeshBvh::build(&vertices, &triangles);
        let vector = |p: [f32; 3]| Vec3::from_array(p.map(f64::from));
        for _ in 0..times(200) {
            let target =
                bvh.bounds().min + (bvh.bounds().max - bvh.bounds().min) * (vector(random.point()) + 0.5);
            let origin = vector(random.point()).normalize() * f64::from(scale) * away + f64::from(offset);
            let ray = Ray::new(origin, (target - origin).normalize());
            let mut expected: Vec<f64> = triangles
                .iter()
                .filter_map(|t| alone(t.map(|i| vector(vertices[i as usize])), &ray))
                .collect();
            expected.sort_by(f64::total_cmp);
            for isa in wide::Isa::all() {
                bvh.isa = isa;
                let mut all = Vec::new();
                bvh.all(&ray, (0.0, f64::INFINITY), |hit| all.push(hit.t));
                all.sort_by(f64::total_cmp);
                assert_eq!(all.len(), expected.len(), "{isa:?} {scale} {ray:?}");
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
                assert!(all.iter().zip(&expected).all(|(&a, &b)| near(a, b)), "{isa:?} {all:?} {expected:?}");
                let first = |stop: bool| bvh.nearest(&ray, (0.0, f64::INFINITY), |_| stop).map(|h| h.t);
                assert_eq!(first(false), all.first().copied(), "{isa:?}");
                assert!(
                    first(true).is_none_or(|t| all.contains(&t)) && first(true).is_some() != all.is_empty()
                );
            }
        }
    }
}

/// Large meshes are built in parts, by all threads.
/// The triangles of all blocks, one block after the other.
fn listed_triangles<B: Block>(blocks: &[B]) -> Vec<u32> {
    let lanes = |block: &B| (0..B::LANES).map(|lane| block.triangle(lane)).collect::<Vec<_>>();
    blocks.iter().flat_map(lanes).collect()
}

#[test]
#[cfg_attr(miri, ignore = "takes hours there")]
fn large_meshes_are_the_same_for_any_number_of_threads() {
    let (vertices, triangles) = soup(150_000, 0.01, &mut Random(9));
    let built = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| MeshBvh::build(&vertices, &triangles))
    };
    let (one, three) = (built(1), built(3));
    let blocks = |bvh: &MeshBvh| with_blocks!(&bvh.blocks, list => listed_triangles(list));
    let nodes = |bvh: &MeshBvh| bvh.nodes.iter().map(|node| (node.bounds, node.child)).collect::<Vec<_>>();
    assert!(nodes(&one) == nodes(&three) && blocks(&one) == blocks(&three));
    let mut listed: Vec<u32> = blocks(&one).into_iter().filter(|&t| t != u32::MAX).collect();
    listed.sort_unstable();
    assert!(listed.into_iter().eq(0..150_000));
    for i in (0..150_000).step_by(997) {
        let corners = triangles[i].map(|v| Vec3::from_array(vertices[v as usize].map(f64::from)));
        let target = (corners[0] + corners[1] + corners[2]) / 3.0;
        let ray = Ray::new(target - Vec3::Z, Vec3::Z);
        let mut found = false;
        one.all(&ray, (0.0, 2.0), |hit| found |= hit.face as usize == i);
        assert!(found, "{i}");
    }
}

#[test]
fn broken_rays_end_and_hit_nothing() {
    let (vertices, triangles) = soup(100, 0.5, &mut Random(13));
    let mut bvh = MeshBvh::build(&vertices, &triangles);
    for isa in wide::Isa::all() {
        bvh.isa = isa;
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            for k in 0..3 {
                let mut broken = [0.1, 0.2, 0.3];
                broken[k] = bad;
                for single in [ray(broken, [0.0, 0.0, 1.0]), ray([0.0; 3], broken)] {
                    // What is infinite may seem to hit in single precision; it must end.
                    let hits = bvh.closest(&single).is_some() | bvh.any(&single);
                    assert!(!hits || bad.is_infinite(), "{isa:?} {single:?}");
                    let vector = |p: [f32; 3]| Vec3::from_array(p.map(f64::from));
                    let double = Ray::new(vector(single.origin), vector(single.dir));
                    assert!(bvh.nearest(&double, (0.0, 10.0), |_| false).is_none());
                    bvh.all(&double, (0.0, 10.0), |hit| panic!("{isa:?} {double:?} {hit:?}"));
                }
            }
        }
        let good = Ray::new(Vec3::new(0.0, 0.0, -3.0), Vec3::Z);
        for range in [(f64::NAN, 1.0), (0.0, f64::NAN), (5.0, 1.0), (f64::INFINITY, f64::INFINITY)] {
            assert!(bvh.nearest(&good, range, |_| false).is_none(), "{isa:?} {range:?}");
        }
    }
}

/// Parts of the mesh, turned, hold all of it, and more tightly than the turned box of the whole.
#[test]
fn parts_hold_all_triangles() {
    let (vertices, triangles) = soup(500, 0.1, &mut Random(21));
    let bvh = MeshBvh::build(&vertices, &triangles);
    let parts = bvh.parts();
    assert!(parts.len() > 8 && parts.len() <= 64);
    for corner in triangles.iter().flatten() {
        let p = Vec3::from_array(vertices[*corner as usize].map(f64::from));
        assert!(parts.iter().any(|part| part.contains(p)), "{p}");
    }
    assert_eq!(parts.iter().fold(Aabb::EMPTY, |all, part| all.union(part)), bvh.bounds());
    assert!(MeshBvh::build(&vertices, &[]).parts().is_empty());
    assert_eq!(MeshBvh::build(&vertices, &triangles[..1]).parts().len(), 1);
}

/// A tree whose vertices have moved answers like one that was built where they are now, in small and in large meshes.
#[test]
fn a_tree_follows_its_vertices() {
    let mut random = Random(23);
    for count in [0, 3, 300, times(40_000)] {
        let (mut vertices, triangles) = soup(count as u32, 0.05, &mut random);
        let mut followed = MeshBvh::build(&vertices, &triangles);
        for p in &mut vertices {
            *p = [p[0] + 0.3 * p[1] * p[1], p[1] - p[2] + 1.0, 2.0 * p[2]];
        }
        followed.refit(&vertices, &triangles);
        let built = MeshBvh::build(&vertices, &triangles);
        assert_eq!(followed.bounds(), built.bounds());
        let mut hits = 0;
        for _ in 0..times(500) {
            let ray = ray(random.point().map(|c| 3.0 * c), random.point());
            assert_eq!(followed.closest(&ray).map(|h| h.t), built.closest(&ray).map(|h| h.t), "{ray:?}");
            assert_eq!(followed.any(&ray), built.any(&ray), "{ray:?}");
            hits += u32::from(built.any(&ray));
        }
        assert!(hits > 0 || count < 300 || cfg!(miri));
    }
}

/// Corners that lie in one place are one point of a block, whether they are one vertex or not, until they part.
#[test]
fn corners_in_one_place_may_part() {
    let (shared, corners) = band(300, &mut Random(29));
    let mut vertices: Vec<[f32; 3]> = corners.iter().flatten().map(|&v| shared[v as usize]).collect();
    let triangles: Vec<[u32; 3]> = (0..300).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mut bvh = MeshBvh::build(&vertices, &triangles);
    assert!(matches!(bvh.blocks, Blocks::Shared(_)));
    for triangle in vertices.chunks_mut(3) {
        let centre = [0, 1, 2].map(|k| (triangle[0][k] + triangle[1][k] + triangle[2][k]) / 3.0);
        triangle.iter_mut().for_each(|p| *p = [0, 1, 2].map(|k| 0.5 * (p[k] + centre[k])));
    }
    bvh.refit(&vertices, &triangles);
    let (built, mut random) = (MeshBvh::build(&vertices, &triangles), Random(31));
    for _ in 0..times(500) {
        let ray = ray(random.point(), random.point());
        assert_eq!(bvh.closest(&ray).map(|h| h.t), built.closest(&ray).map(|h| h.t), "{ray:?}");
    }
}
