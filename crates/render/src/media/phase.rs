//! Phase functions: how much is scattered by how much the direction turns (media spec, section 1.5).
use raggio_scene::Scattering;

/// The strength for the cosine between the ray and the direction to the light; no factor of 1/4 pi, as the language
/// has it.
pub fn phase(scattering: &Scattering, cosine: f64) -> f64 {
    let half = (1.0 + cosine) / 2.0;
    match scattering.kind {
        2 => 0.576_655_375 * (1.0 + 9.0 * half.powi(8)),
        3 => 0.495_714_547 * (1.0 + 50.0 * half.powi(32)),
        4 => 0.799_372_013 * (1.0 + cosine * cosine),
        5 => {
            let g = f64::from(scattering.eccentricity);
            let square = 1.0 + g * g - 2.0 * g * cosine;
            (1.0 - g * g) / (square * square.sqrt())
        }
        _ => 1.0,
    }
}

/// Is that the same for all directions?
pub fn is_isotropic(scattering: &Scattering) -> bool {
    !(2..=5).contains(&scattering.kind)
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_image::Rgb;

    fn mean(kind: u8, eccentricity: f32) -> f64 {
        let s = Scattering { kind, color: Rgb::ONE, eccentricity, extinction: 1.0 };
        let n = 20_000;
        let at = |i: i32| phase(&s, 2.0 * (f64::from(i) + 0.5) / f64::from(n) - 1.0);
        (0..n).map(at).sum::<f64>() / f64::from(n)
    }

    #[test]
    fn henyey_greenstein_and_isotropic_scatter_all_light() {
        assert!((mean(1, 0.0) - 1.0).abs() < 1e-12);
        assert!((mean(5, 0.4) - 1.0).abs() < 1e-6);
        assert!((mean(5, -0.7) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_other_kinds_have_their_own_sums() {
        // The integrals of the formulas over the sphere, by hand.
        assert!((mean(2, 0.0) - 0.576_655_375 * 2.0).abs() < 1e-6);
        assert!((mean(3, 0.0) - 0.495_714_547 * (1.0 + 50.0 / 33.0)).abs() < 1e-6);
        assert!((mean(4, 0.0) - 0.799_372_013 * 4.0 / 3.0).abs() < 1e-6);
    }
}
