//! First hits on a mesh, timed: `mesh_rays MESH.tri A.ray [B.ray ...]` prints one line of JSON per ray file.
//!
//! `.tri` is "TRI1", then u32 vertices, triangles, 0, then f32 xyz a vertex, u32 abc a triangle; `.ray` is "RAY1", then
//! u32 count, 0, 0, then eight f32 a ray: origin, t_min, direction, t_max. All little-endian. Times are CPU time of the
//! one thread, the median of five; results are written out as they are found.

use std::time::Duration;

use raggio_bvh::mesh::{MeshBvh, MeshRay, Packet, PacketHit};

type Error = Box<dyn std::error::Error + Send + Sync>;
/// Points and the triangles between them.
type Mesh = (Vec<[f32; 3]>, Vec<[u32; 3]>);

fn main() -> Result<(), Error> {
    // One thread does it all, so that its time is all the time.
    rayon::ThreadPoolBuilder::new().num_threads(1).build()?.install(measure)
}

fn measure() -> Result<(), Error> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [mesh, rays @ ..] = &args[..] else {
        return Err("usage: mesh_rays MESH.tri A.ray [B.ray ...]".into());
    };
    let (vertices, triangles) = read_mesh(&std::fs::read(mesh)?)?;
    let (build, bvh) = timed(3, || MeshBvh::build(&vertices, &triangles));
    for file in rays {
        let rays = read_rays(&std::fs::read(file)?)?;
        let mut hits = vec![(0.0f32, 0u32); rays.len()];
        let mut shadows = vec![0u8; rays.len()];
        let (closest, ()) = timed(5, || {
            for (ray, hit) in rays.iter().zip(&mut hits) {
                *hit = bvh.closest(ray).map_or((f32::INFINITY, u32::MAX), |h| (h.t, h.triangle));
            }
        });
        let (any, ()) = timed(5, || {
            for (ray, shadow) in rays.iter().zip(&mut shadows) {
                *shadow = u8::from(bvh.any(ray));
            }
        });
        let packets: Vec<Packet> = rays.chunks(16).map(packet).collect();
        let none = PacketHit { t: [f32::INFINITY; 16], triangle: [u32::MAX; 16] };
        let mut packet_hits = vec![none; packets.len()];
        let mut packet_shadows = vec![0u16; packets.len()];
        let (closest_packet, ()) = timed(5, || {
            for (packet, hit) in packets.iter().zip(&mut packet_hits) {
                *hit = bvh.closest_packet(packet);
            }
        });
        let (any_packet, ()) = timed(5, || {
            for (packet, shadow) in packets.iter().zip(&mut packet_shadows) {
                *shadow = bvh.any_packet(packet);
            }
        });
        let packet_sum: f64 = (0..rays.len())
            .map(|i| packet_hits[i / 16].t[i % 16])
            .filter(|t| t.is_finite())
            .map(f64::from)
            .sum();
        let mrays = |time: f64| rays.len() as f64 / time * 1e-6;
        let found = hits.iter().filter(|h| h.0 < f32::INFINITY);
        let sum: f64 = found.clone().map(|h| f64::from(h.0)).sum();
        let blocked = shadows.iter().filter(|&&s| s != 0).count();
        println!(
            "{{\"rays\":\"{file}\",\"build_s\":{build:.4},\"bytes\":{},\"closest_mrays\":{:.3},\"any_mrays\":{:.3},\
             \"closest_packet_mrays\":{:.3},\"any_packet_mrays\":{:.3},\"hits\":{},\"any_hits\":{blocked},\
             \"sum_t\":{sum:.6},\"packet_sum_t\":{packet_sum:.6}}}",
            bvh.bytes(),
            mrays(closest),
            mrays(any),
            mrays(closest_packet),
            mrays(any_packet),
            found.count(),
        );
    }
    Ok(())
}

/// Sixteen rays; a last handful is filled up with copies.
fn packet(rays: &[MeshRay]) -> Packet {
    Packet::new(&std::array::from_fn(|i| rays[i.min(rays.len() - 1)]))
}

/// The median time of some runs, after one that is not counted, and the last result.
fn timed<T>(runs: usize, mut work: impl FnMut() -> T) -> (f64, T) {
    let mut result = work();
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let start = cpu_time();
            result = work();
            (cpu_time() - start).as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[runs / 2], result)
}

/// CPU time of this thread, from the kernel's accounting.
fn cpu_time() -> Duration {
    cpu_time::ThreadTime::now().as_duration()
}

fn words(bytes: &[u8]) -> impl Iterator<Item = [u8; 4]> + '_ {
    bytes.chunks_exact(4).map(|c| [c[0], c[1], c[2], c[3]])
}

fn header(bytes: &[u8], magic: &[u8; 4]) -> Result<[usize; 2], Error> {
    if bytes.len() < 16 || &bytes[..4] != magic {
        return Err(format!("not a {} file", String::from_utf8_lossy(magic)).into());
    }
    let mut counts = words(&bytes[4..12]).map(|w| u32::from_le_bytes(w) as usize);
    Ok([counts.next().unwrap_or(0), counts.next().unwrap_or(0)])
}

fn read_mesh(bytes: &[u8]) -> Result<Mesh, Error> {
    let [vertices, triangles] = header(bytes, b"TRI1")?;
    let body = bytes.get(16..16 + 12 * (vertices + triangles)).ok_or("the mesh is cut short")?;
    let (points, indices) = body.split_at(12 * vertices);
    let points: Vec<f32> = words(points).map(f32::from_le_bytes).collect();
    let indices: Vec<u32> = words(indices).map(u32::from_le_bytes).collect();
    let triple = |c: &[f32]| [c[0], c[1], c[2]];
    if indices.iter().any(|&i| i as usize >= vertices) {
        return Err("an index is out of range".into());
    }
    Ok((
        points.chunks_exact(3).map(triple).collect(),
        indices.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect(),
    ))
}

fn read_rays(bytes: &[u8]) -> Result<Vec<MeshRay>, Error> {
    let [count, _] = header(bytes, b"RAY1")?;
    let body = bytes.get(16..16 + 32 * count).ok_or("the rays are cut short")?;
    let numbers: Vec<f32> = words(body).map(f32::from_le_bytes).collect();
    let ray =
        |r: &[f32]| MeshRay { origin: [r[0], r[1], r[2]], t_min: r[3], dir: [r[4], r[5], r[6]], t_max: r[7] };
    Ok(numbers.chunks_exact(8).map(ray).collect())
}
