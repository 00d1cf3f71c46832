//! Do rays slip through closed meshes? `watertight [MILLIONS]` aims that many million rays (100 if not said) from inside
//! at edges and corners and prints how many got out: singles, packets, and rays in double precision.

use raggio_bvh::mesh::{MeshBvh, MeshRay, Packet};
use raggio_math::{Ray, Vec3};

/// A closed mesh around the origin.
struct Closed {
    vertices: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

/// What got out, by kind of ray.
#[derive(Default)]
struct Leaks {
    shot: u64,
    closest: u64,
    any: u64,
    packet: u64,
    double: u64,
}

fn main() -> Result<(), std::num::ParseIntError> {
    let millions: u64 = std::env::args().nth(1).map_or(Ok(100), |text| text.parse())?;
    let meshes = [(24, 31, 0.0, 0.0), (200, 333, 0.05, 0.0), (700, 700, 0.1, 0.0), (200, 333, 0.05, 1000.0)];
    let mut random = Random(1);
    let mut leaks = Leaks::default();
    for (rows, columns, bumps, away) in meshes {
        let mesh = ball(rows, columns, bumps, away);
        let bvh = MeshBvh::build(&mesh.vertices, &mesh.triangles);
        for _ in 0..millions * 1_000_000 / meshes.len() as u64 / 16 {
            shoot(&mesh, &bvh, away, &mut random, &mut leaks);
        }
    }
    let Leaks { shot, closest, any, packet, double } = leaks;
    println!(
        "{shot} rays; got out: closest {closest}, any {any}, packets {packet}, double precision {double}"
    );
    Ok(())
}

/// Sixteen rays from one point to points on edges, every seventh to a corner.
fn shoot(mesh: &Closed, bvh: &MeshBvh, away: f32, random: &mut Random, leaks: &mut Leaks) {
    let origin = [0; 3].map(|_| away + 0.3 * random.float());
    let first = random.below(mesh.triangles.len());
    let rays: [MeshRay; 16] = std::array::from_fn(|i| {
        let triangle = mesh.triangles[(first + i) % mesh.triangles.len()];
        let corner = random.below(3);
        let [a, b] = [corner, (corner + 1) % 3].map(|k| mesh.vertices[triangle[k] as usize]);
        let w = if random.below(7) == 0 { 0.0 } else { 0.5 + 0.5 * random.float() };
        let dir = std::array::from_fn(|k| a[k] + w * (b[k] - a[k]) - origin[k]);
        MeshRay { origin, t_min: 0.0, dir, t_max: f32::INFINITY }
    });
    let packet = Packet::new(&rays);
    let (hits, blocked) = (bvh.closest_packet(&packet), bvh.any_packet(&packet));
    for (i, ray) in rays.iter().enumerate() {
        let vector = |v: [f32; 3]| Vec3::from_array(v.map(f64::from));
        let double = Ray::new(vector(ray.origin), vector(ray.dir).normalize());
        leaks.shot += 1;
        leaks.closest += u64::from(bvh.closest(ray).is_none());
        leaks.any += u64::from(!bvh.any(ray));
        leaks.packet += u64::from(hits.triangle[i] == u32::MAX || blocked >> i & 1 == 0);
        leaks.double += u64::from(bvh.nearest(&double, (0.0, f64::INFINITY), |_| true).is_none());
    }
}

/// A ball of radius 1 with bumps, moved away from the origin along the diagonal.
fn ball(rows: u32, columns: u32, bumps: f32, away: f32) -> Closed {
    let point = |theta: f32, phi: f32| {
        let d = [theta.sin() * phi.cos(), theta.cos(), theta.sin() * phi.sin()];
        let radius = 1.0 + bumps * (9.0 * d[0]).sin() * (11.0 * d[1] + 1.0).sin() * (7.0 * d[2]).cos();
        d.map(|c| c * radius + away)
    };
    let (pi, tau) = (std::f32::consts::PI, std::f32::consts::TAU);
    let mut vertices = vec![point(0.0, 0.0), point(pi, 0.0)];
    for i in 1..rows {
        for j in 0..columns {
            vertices.push(point(i as f32 / rows as f32 * pi, j as f32 / columns as f32 * tau));
        }
    }
    let at = |i: u32, j: u32| match i {
        0 => 0,
        i if i == rows => 1,
        i => 2 + (i - 1) * columns + j % columns,
    };
    let mut triangles = Vec::new();
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
        triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    Closed { vertices, triangles }
}

/// A small deterministic generator: variety, not quality.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, count: usize) -> usize {
        self.next() as usize % count
    }

    /// From -1 to 1.
    fn float(&mut self) -> f32 {
        (self.next() >> 7) as f32 / (1u64 << 23) as f32 - 1.0
    }
}
