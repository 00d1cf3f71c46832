//! The photon map: how coarsely photons are kept, the tree (photon spec, section 2.5).
//!
//! The tree is built as in POV-Ray, with the photons that its search cannot find, so that pictures agree.
use std::f64::consts::PI;

use raggio_image::Rgb;
use raggio_math::Vec3;

use super::Photon;
use super::search::Index;
pub use super::search::Nearest;

/// Photons in the order of a balanced tree.
#[derive(Default)]
pub struct PhotonMap {
    photons: Vec<Photon>,
    index: Index,
    /// The radius of a gather.
    pub radius: f64,
}

/// A box around photons.
struct Bounds {
    low: [f32; 3],
    high: [f32; 3],
}

impl Photon {
    /// A photon of that power, rounded as it will be kept.
    pub fn new(p: Vec3, power: Rgb, toward: Vec3) -> Photon {
        Photon { p: p.as_vec3().to_array(), power: coarse(power), toward: coarse_direction(toward) }
    }
}

/// A colour as three bytes with a common exponent. The exponent's byte overflows from 2^32 on.
fn coarse(power: Rgb) -> Rgb {
    let brightest = power.max_element();
    if brightest.is_nan() || brightest < 1e-32 || brightest.is_infinite() {
        return Rgb::ZERO;
    }
    let mut exponent = brightest.log2().floor() as i32 + 1;
    if brightest >= 2f32.powi(exponent) {
        exponent += 1;
    }
    let scale = 2f32.powi(exponent);
    let byte = |v: f32| (256.0 * v / scale).floor().clamp(0.0, 255.0);
    let kept = (exponent + 250).rem_euclid(256) - 250;
    let back = 2f32.powi(kept.max(-126) - 8);
    Rgb::new(byte(power.x), byte(power.y), byte(power.z)) * back
}

/// A direction as two angles of a signed byte each.
fn coarse_direction(w: Vec3) -> Vec3 {
    let flat = w.x.hypot(w.z);
    let byte = |angle: f64| (angle * 127.0 / PI).trunc() * PI / 127.0;
    let phi = if flat > 0.0 { (w.x / flat).clamp(-1.0, 1.0).acos().copysign(w.z) } else { 0.0 };
    let theta = flat.min(1.0).acos().copysign(w.y);
    let (phi, theta) = (byte(phi), byte(theta));
    Vec3::new(theta.cos() * phi.cos(), theta.sin(), theta.cos() * phi.sin())
}

impl PhotonMap {
    /// A map of photons in the order in which they were stored.
    pub fn new(photons: Vec<Photon>) -> PhotonMap {
        let mut map = PhotonMap { photons, ..PhotonMap::default() };
        let mut shy = Vec::new();
        let mut ranges = Vec::new();
        if !map.photons.is_empty() {
            ranges.push((0, map.photons.len() - 1));
        }
        while let Some((s, e)) = ranges.pop() {
            let bounds = map.bounds(s, e);
            let size = |k: usize| bounds.high[k] - bounds.low[k];
            let axis = (1..3).fold(0, |best, k| if size(k) > size(best) { k } else { best });
            let mid = (s + e) / 2;
            match e - s {
                0 => {}
                // Two are left as they are, which is why some photons are never found.
                1 => {
                    let plane = map.photons[s].p[axis];
                    if map.photons[e].p[axis] < plane {
                        shy.push((e as u32, axis as u8, plane));
                    }
                }
                _ => map.select(s, e, mid, axis),
            }
            if mid > s {
                ranges.push((s, mid - 1));
            }
            if e > mid {
                ranges.push((mid + 1, e));
            }
        }
        shy.sort_unstable_by_key(|s| s.0);
        let places: Vec<[f32; 3]> = map.photons.iter().map(|photon| photon.p).collect();
        map.index = Index::new(&places, shy);
        map
    }

    /// Is there nothing?
    pub fn is_empty(&self) -> bool {
        self.photons.is_empty()
    }

    /// How many photons there are.
    pub fn len(&self) -> usize {
        self.photons.len()
    }

    /// A photon by number.
    pub fn photon(&self, number: u32) -> &Photon {
        &self.photons[number as usize]
    }

    fn bounds(&self, s: usize, e: usize) -> Bounds {
        let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for photon in &self.photons[s..=e] {
            for k in 0..3 {
                min[k] = min[k].min(photon.p[k]);
                max[k] = max[k].max(photon.p[k]);
            }
        }
        Bounds { low: min, high: max }
    }

    /// Moves the photon that belongs at `mid` there, lesser ones before it (Hoare's selection with the pivot of three).
    fn select(&mut self, mut l: usize, mut r: usize, mid: usize, axis: usize) {
        while l < r {
            let p = &mut self.photons;
            p.swap((l + r) / 2, l + 1);
            if p[l + 1].p[axis] > p[r].p[axis] {
                p.swap(l + 1, r);
            }
            if p[l].p[axis] > p[r].p[axis] {
                p.swap(l, r);
            }
            if p[l + 1].p[axis] > p[l].p[axis] {
                p.swap(l + 1, l);
            }
            let pivot = p[l].p[axis];
            let (mut j, mut k) = (l + 1, r);
            while j <= k {
                j += 1;
                while j <= r && p[j].p[axis] < pivot {
                    j += 1;
                }
                k -= 1;
                while k >= l && p[k].p[axis] > pivot {
                    k -= 1;
                }
                if j < k {
                    p.swap(j, k);
                }
            }
            p.swap(l, k);
            if k > l && mid < k {
                r = k - 1;
            } else if k < r && k < mid {
                l = k + 1;
            } else {
                return;
            }
        }
    }

    /// Finds the nearest photons within a radius of a point; see [`Nearest::search`].
    pub fn search(
        &self,
        place: (Vec3, Option<Vec3>),
        radius: f64,
        max: usize,
        likely: &mut f64,
        nearest: &mut Nearest,
    ) {
        nearest.search(&self.index, place, radius, max, likely);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scattered(n: usize) -> Vec<Photon> {
        let mut state = 7u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as f64 / f64::from(1u32 << 31)
        };
        let place = |r: &mut dyn FnMut() -> f64| Vec3::new(r(), r() * 0.1, r());
        (0..n).map(|_| Photon::new(place(&mut random), Rgb::ONE, Vec3::Y)).collect()
    }

    #[test]
    fn searches_find_nearly_all_of_the_nearest() {
        let photons = scattered(2000);
        let map = PhotonMap::new(photons.clone());
        let mut nearest = Nearest::default();
        let p = Vec3::new(0.5, 0.05, 0.4);
        let mut likely = f64::INFINITY;
        map.search((p, None), 0.2, 50, &mut likely, &mut nearest);
        assert_eq!(nearest.len(), 50);
        let mut exact: Vec<f64> =
            photons.iter().map(|q| (Vec3::from(q.p.map(f64::from)) - p).length()).collect();
        exact.sort_by(f64::total_cmp);
        let got = nearest.radius(0.2);
        assert!(got > exact[49] * 0.999_999 && got < exact[49] * 1.1, "{got} {}", exact[49]);
        map.search((p, None), 0.02, 50, &mut likely, &mut nearest);
        let within = exact.iter().filter(|d| **d < 0.02).count();
        assert!(nearest.len() <= within && nearest.len() + 3 >= within);
        assert_eq!(nearest.radius(0.02), 0.02);
    }

    #[test]
    fn what_is_found_does_not_depend_on_the_guess() {
        let map = PhotonMap::new(scattered(3000));
        let mut nearest = Nearest::default();
        for normal in [None, Some(Vec3::Y)] {
            let place = (Vec3::new(0.3, 0.02, 0.8), normal);
            let mut found = |mut likely: f64| {
                map.search(place, 0.3, 60, &mut likely, &mut nearest);
                let mut numbers: Vec<u32> = nearest.numbers().collect();
                numbers.sort_unstable();
                assert_eq!(likely, nearest.radius(f64::INFINITY));
                numbers
            };
            let all = found(f64::INFINITY);
            assert_eq!(all.len(), 60);
            assert_eq!(found(0.01), all);
            assert_eq!(found(0.1), all);
        }
    }

    #[test]
    fn powers_keep_eight_bits_and_directions_seven() {
        let kept = coarse(Rgb::new(0.0913, 0.05, 0.001));
        assert!((kept - Rgb::new(0.0913, 0.05, 0.001)).abs().max_element() < 0.125 / 256.0);
        assert_eq!(coarse(Rgb::ZERO), Rgb::ZERO);
        for w in [Vec3::Y, Vec3::new(0.6, 0.64, -0.48), -Vec3::X] {
            assert!(coarse_direction(w).dot(w) > 0.999, "{w} {}", coarse_direction(w));
        }
    }
}
