//! The photon map: how coarsely photons are kept, the tree (photon spec, section 2.5).
//!
//! The tree is built as in POV-Ray, with the photons that its search cannot find, so that pictures agree.
use std::f64::consts::PI;
use std::sync::LazyLock;

use raggio_image::Rgb;
use raggio_math::{Vec2, Vec3};

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

/// Where a photon is, and which it is; less to move about than all of it.
#[derive(Clone, Copy)]
struct Place {
    p: [f32; 3],
    number: u32,
}

/// A photon that searches on one side of a plane do not find: its number, the axis, and where the plane is.
type Shy = (u32, u8, f32);

/// Parts of the tree with so many photons are worth a thread's while.
const PART: usize = 1 << 14;

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
    let step = |angle: f64| DIRECTIONS[((angle * 127.0 / PI).trunc() + 127.0) as usize];
    let phi = if flat > 0.0 { (w.x / flat).clamp(-1.0, 1.0).acos().copysign(w.z) } else { 0.0 };
    let theta = flat.min(1.0).acos().copysign(w.y);
    let (phi, theta) = (step(phi), step(theta));
    Vec3::new(theta.x * phi.x, theta.y, theta.x * phi.y)
}

/// Cosines and sines of the angles that a signed byte holds, from minus half a turn to half a turn.
static DIRECTIONS: LazyLock<[Vec2; 255]> =
    LazyLock::new(|| std::array::from_fn(|i| Vec2::from_angle((i as f64 - 127.0) * PI / 127.0)));

impl PhotonMap {
    /// A map of photons in the order in which they were stored.
    pub fn new(photons: Vec<Photon>) -> PhotonMap {
        let place = |(number, photon): (u32, &Photon)| Place { p: photon.p, number };
        let mut places: Vec<Place> = (0..).zip(&photons).map(place).collect();
        let shy = arrange(&mut places, 0);
        let photons = places.iter().map(|place| photons[place.number as usize]).collect();
        let places: Vec<[f32; 3]> = places.iter().map(|place| place.p).collect();
        PhotonMap { photons, index: Index::new(&places, shy), radius: 0.0 }
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

/// Puts photons, the first of which has the number `start`, in the order of the tree. Gives the shy ones by number.
fn arrange(places: &mut [Place], start: u32) -> Vec<Shy> {
    if places.len() < 2 {
        return Vec::new();
    }
    let axis = widest(places);
    // Two are left as they are, which is why some photons are never found.
    if let [first, second] = places {
        let plane = first.p[axis];
        return if second.p[axis] < plane { vec![(start + 1, axis as u8, plane)] } else { Vec::new() };
    }
    let middle = (places.len() - 1) / 2;
    select(places, middle, axis);
    let is_large = places.len() > PART;
    let (left, right) = places.split_at_mut(middle);
    let left = || arrange(left, start);
    let right = || arrange(&mut right[1..], start + middle as u32 + 1);
    let (mut shy, more) = if is_large { rayon::join(left, right) } else { both(left, right) };
    shy.extend(more);
    shy
}

/// One after the other.
fn both<T>(first: impl FnOnce() -> T, second: impl FnOnce() -> T) -> (T, T) {
    (first(), second())
}

/// The axis along which photons are spread most.
fn widest(places: &[Place]) -> usize {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for place in places {
        for k in 0..3 {
            low[k] = low[k].min(place.p[k]);
            high[k] = high[k].max(place.p[k]);
        }
    }
    let size = |k: usize| high[k] - low[k];
    (1..3).fold(0, |best, k| if size(k) > size(best) { k } else { best })
}

/// Moves the photon that belongs in the middle there, lesser ones before it (Hoare's selection with the pivot of three).
fn select(p: &mut [Place], middle: usize, axis: usize) {
    let (mut l, mut r) = (0, p.len() - 1);
    while l < r {
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
        if k > l && middle < k {
            r = k - 1;
        } else if k < r && k < middle {
            l = k + 1;
        } else {
            return;
        }
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
