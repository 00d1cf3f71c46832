//! The optics of scattering stuff: coefficients from a colour, the dipole's answer, Fresnel's transmission.
use std::f64::consts::PI;

use raggio_image::Rgb;

use crate::integrator::reflection::fresnel;

/// What part of light leaves an interface again by diffuse reflection inside (Egan and Hilgeman's fit, as the language
/// has it), as the factor A of the dipole.
fn internal_reflection(eta: f64) -> f64 {
    let f = if eta < 1.0 {
        eta * eta - eta.powf(2.25)
    } else {
        let x = 1.0 - 1.0 / eta;
        (x + 3.0 * x.powf(4.5)) / 4.0
    };
    (1.0 + f) / (1.0 - f)
}

/// From the colour that is seen to the reduced albedo that makes it, for one refractive index.
pub struct Albedo {
    table: [f32; 101],
}

impl Albedo {
    /// Inverts the diffuse reflectance of a half space by bisection.
    pub fn new(ior: f64) -> Albedo {
        let a = internal_reflection(ior);
        let reflectance = |albedo: f64| {
            let root = (3.0 * (1.0 - albedo)).max(0.0).sqrt();
            albedo / 2.0 * (1.0 + (-4.0 / 3.0 * a * root).exp()) * (-root).exp()
        };
        let invert = |wanted: f64| {
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if reflectance(middle) < wanted { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        };
        let mut table = std::array::from_fn(|i| invert(i as f64 / 100.0) as f32);
        (table[0], table[100]) = (0.0, 1.0);
        Albedo { table }
    }

    fn of(&self, reflectance: f64) -> f64 {
        let place = (reflectance * 100.0).clamp(0.0, 100.0);
        let i = (place as usize).min(99);
        let (a, b) = (f64::from(self.table[i]), f64::from(self.table[i + 1]));
        a + (b - a) * (place - i as f64)
    }
}

/// One channel of a medium; all per millimetre.
#[derive(Clone, Copy, Default)]
pub struct Channel {
    albedo: f64,
    /// Scattering, and all that dims.
    pub scattering: f64,
    pub extinction: f64,
    effective: f64,
}

/// A medium's optics.
pub struct Coefficients {
    pub channels: [Channel; 3],
    internal: f64,
}

impl Coefficients {
    /// From the colour seen and the mean free path in millimetres.
    pub fn new(albedo: &Albedo, seen: Rgb, free_path: Rgb, eta: f64) -> Coefficients {
        let channel = |seen: f32, path: f32| {
            let reduced = albedo.of(seen.into());
            if reduced <= 0.0 || path <= 0.0 {
                return Channel::default();
            }
            let scattering = 1.0 / f64::from(path);
            let extinction = scattering / reduced;
            let absorption = extinction - scattering;
            let effective = (3.0 * absorption * extinction).max(0.0).sqrt();
            Channel { albedo: reduced, scattering, extinction, effective }
        };
        Coefficients {
            channels: [
                channel(seen.x, free_path.x),
                channel(seen.y, free_path.y),
                channel(seen.z, free_path.z),
            ],
            internal: internal_reflection(eta),
        }
    }

    /// The extinction of all channels as the language weighs brightness.
    pub fn mean_extinction(&self) -> f64 {
        let [r, g, b] = self.channels.map(|c| c.extinction);
        0.297 * r + 0.589 * g + 0.114 * b
    }

    /// What leaves of light that entered at a distance (in millimetres), per area.
    pub fn dipole(&self, distance: f64) -> Rgb {
        Rgb::from_array(self.channels.map(|c| c.dipole(distance, self.internal) as f32))
    }

    /// What passes unscattered over a way in millimetres.
    pub fn unscattered(&self, way: f64) -> Rgb {
        Rgb::from_array(self.channels.map(|c| (-c.extinction * way).exp() as f32))
    }
}

impl Channel {
    fn dipole(&self, distance: f64, internal: f64) -> f64 {
        if self.extinction <= 0.0 {
            return 0.0;
        }
        let real = 1.0 / self.extinction;
        let mirrored = real * (1.0 + 4.0 / 3.0 * internal);
        let term = |z: f64| {
            let d = (z * z + distance * distance).sqrt();
            z * (self.effective + 1.0 / d) * (-self.effective * d).exp() / (d * d)
        };
        self.albedo / (4.0 * PI) * (term(real) + term(mirrored))
    }
}

/// What part of light passes the surface at an angle.
pub fn fresnel_transmission(eta: f64, cosine: f64) -> f64 {
    1.0 - fresnel(eta, cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_dipole_sends_back_the_colour_it_was_made_for() {
        let albedo = Albedo::new(1.3);
        let seen = Rgb::new(0.8, 0.64, 0.4);
        let medium = Coefficients::new(&albedo, seen, Rgb::new(1.0, 2.0, 0.5), 1.3);
        // The integral over the plane of light that enters everywhere.
        let (n, step) = (200_000, 1e-3);
        let ring = |i: i32| {
            let r = (f64::from(i) + 0.5) * step;
            medium.dipole(r) * (2.0 * PI * r * step) as f32
        };
        let sum = (0..n).map(ring).fold(raggio_math::Vec3::ZERO, |a, b| a + b.as_dvec3());
        assert!((sum.as_vec3() - seen).abs().max_element() < 5e-3, "{sum}");
    }

    #[test]
    fn the_table_runs_from_nothing_to_all() {
        let albedo = Albedo::new(1.5);
        assert_eq!((albedo.of(0.0), albedo.of(1.0)), (0.0, 1.0));
        assert!(albedo.of(0.3) > albedo.of(0.2) && albedo.of(0.3) < 1.0);
    }
}
