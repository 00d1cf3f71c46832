//! `density_file`: a grid of samples over the unit cube (textures spec, section 6).
use raggio_math::Vec3;
use raggio_scene::DensityFile;

/// The density at a point; 0 outside the unit cube.
pub(super) fn value(file: &DensityFile, p: Vec3) -> f64 {
    let inside = p.cmpge(Vec3::ZERO).all() && p.cmplt(Vec3::ONE).all();
    if !inside || file.samples.is_empty() {
        return 0.0;
    }
    let position = p * Vec3::from(file.size.map(|s| s as f64));
    match file.interpolation % 10 {
        0 => f64::from(sample(file, [position.x as usize, position.y as usize, position.z as usize])),
        1 => trilinear(file, position),
        _ => tricubic(file, position),
    }
}

fn sample(file: &DensityFile, [x, y, z]: [usize; 3]) -> f32 {
    let index = (z * file.size[1] + y) * file.size[0] + x;
    file.samples.get(index).copied().unwrap_or(0.0)
}

/// Samples stand on whole coordinates and wrap around.
fn trilinear(file: &DensityFile, position: Vec3) -> f64 {
    let low = position.to_array().map(|c| c as usize);
    let high: [usize; 3] = std::array::from_fn(|k| (low[k] + 1) % file.size[k]);
    let f = position - Vec3::from(low.map(|c| c as f64));
    let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
    let at = |x, y, z| f64::from(sample(file, [x, y, z]));
    let along_x = |y, z| mix(at(low[0], y, z), at(high[0], y, z), f.x);
    let along_y = |z| mix(along_x(low[1], z), along_x(high[1], z), f.y);
    mix(along_y(low[2]), along_y(high[2]), f.z)
}

fn tricubic(file: &DensityFile, position: Vec3) -> f64 {
    let low = position.to_array().map(|c| c as usize);
    let taps: [[usize; 4]; 3] = std::array::from_fn(|k| neighbours(low[k], file.size[k]));
    let f = (position - Vec3::from(low.map(|c| c as f64))).to_array().map(|f| f as f32);
    let along_z = |x, y| catmull_rom(taps[2].map(|z| sample(file, [x, y, z])), f[2]);
    let along_y = |x| catmull_rom(taps[1].map(|y| along_z(x, y)), f[1]);
    f64::from(catmull_rom(taps[0].map(along_y), f[0]).max(0.0))
}

/// The samples before, at and after a place. What lies before the first is found by the language's unsigned
/// arithmetic, which is the last one only for sizes that are powers of two.
fn neighbours(i: usize, size: usize) -> [usize; 4] {
    let before = ((i as u64).wrapping_sub(1) % size as u64) as usize;
    [before, i, (i + 1) % size, (i + 2) % size]
}

fn catmull_rom([a, b, c, d]: [f32; 4], t: f32) -> f32 {
    let (slope_b, slope_c) = ((c - a) / 2.0, (d - b) / 2.0);
    let e = 2.0 * (b - c) + slope_b + slope_c;
    let g = -3.0 * (b - c) - 2.0 * slope_b - slope_c;
    ((e * t + g) * t + slope_b) * t + b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_place_before_the_first_follows_unsigned_arithmetic() {
        assert_eq!(neighbours(0, 4)[0], 3);
        assert_eq!(neighbours(0, 3)[0], 0);
        assert_eq!(neighbours(0, 5)[0], 0);
        assert_eq!(neighbours(4, 5), [3, 4, 0, 1]);
    }
}
