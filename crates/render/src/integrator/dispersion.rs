//! Dispersion: wavelengths, their indices and their hues (light spec, section 3.3 and appendix B).
use raggio_image::Rgb;

use super::interiors::Crossing;

/// The part of each colour (in ten-thousandths) that lies below a wavelength: from 375 nm in steps of 5 nm.
#[rustfmt::skip]
const CUMULATIVE: [[u16; 74]; 3] = [
    [
        0, 9, 29, 58, 94, 135, 178, 223, 267, 308, 344, 374, 394, 404, 404, 404,
        404, 404, 404, 404, 404, 404, 404, 404, 404, 404, 404, 404, 404, 404, 404, 404,
        404, 404, 404, 404, 404, 404, 404, 404, 429, 502, 620, 780, 979, 1215, 1483, 1781,
        2105, 2454, 2823, 3210, 3611, 4024, 4446, 4873, 5302, 5731, 6155, 6573, 6982, 7377, 7756, 8116,
        8454, 8767, 9052, 9306, 9525, 9707, 9849, 9947, 9998, 10000,
    ],
    [
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 45, 131, 256, 417, 612, 839, 1095,
        1378, 1684, 2013, 2360, 2724, 3102, 3492, 3891, 4297, 4707, 5119, 5530, 5937, 6340, 6733, 7117,
        7487, 7841, 8178, 8494, 8786, 9054, 9293, 9501, 9677, 9817, 9919, 9981, 10000, 10000, 10000, 10000,
        10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000,
    ],
    [
        0, 38, 113, 222, 363, 534, 734, 960, 1210, 1482, 1775, 2085, 2412, 2753, 3106, 3470,
        3841, 4219, 4600, 4984, 5368, 5750, 6128, 6500, 6864, 7218, 7560, 7888, 8200, 8494, 8768, 9020,
        9248, 9449, 9623, 9767, 9878, 9956, 9997, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000,
        10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000,
        10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000,
    ],
];

/// The spectrum that is sampled, in nanometres.
const START: f64 = 380.0;
const WIDTH: f64 = 350.0;
/// The wavelength at which the refractive index is what the scene says.
const CENTRE: f64 = 555.0;

/// Wavelength and hue of sample `i` of `n`. Hues of all samples add up to `n` times white.
pub(super) fn sample(i: u32, n: u32) -> (f64, Rgb) {
    let step = WIDTH / f64::from(n);
    let wavelength = START + step * (f64::from(i) + 0.5);
    let channel = |k: usize| {
        let part = below(k, wavelength + step / 2.0) - below(k, wavelength - step / 2.0);
        (part * WIDTH / step) as f32
    };
    (wavelength, Rgb::new(channel(0), channel(1), channel(2)))
}

/// The relative index of a crossing for one wavelength.
pub(super) fn eta(crossing: &Crossing, wavelength: f64) -> f64 {
    crossing.eta * crossing.dispersion.powf(-(wavelength - CENTRE) / WIDTH)
}

fn below(channel: usize, wavelength: f64) -> f64 {
    let row = &CUMULATIVE[channel];
    let place = ((wavelength - 375.0) / 5.0).clamp(0.0, (row.len() - 1) as f64);
    let i = (place as usize).min(row.len() - 2);
    let (a, b) = (f64::from(row[i]), f64::from(row[i + 1]));
    (a + (b - a) * (place - i as f64)) / 10_000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seven_hues_as_recorded() {
        let recorded = [
            [0.2555, 0.0, 1.4329],
            [0.0210, 0.0, 2.5655],
            [0.0, 0.7665, 2.2890],
            [0.0686, 2.5284, 0.6860],
            [1.8956, 2.6509, 0.0],
            [2.9169, 1.0542, 0.0],
            [1.7990, 0.0, 0.0],
        ];
        for (i, hue) in recorded.into_iter().enumerate() {
            let got = sample(i as u32, 7).1;
            assert!((got - Rgb::from_array(hue)).length() < 1e-3, "{i} {got}");
        }
    }

    #[test]
    fn hues_add_up_to_white() {
        for n in [2, 7, 20, 100] {
            let sum: Rgb = (0..n).map(|i| sample(i, n).1).sum();
            assert!((sum / n as f32 - Rgb::ONE).abs().max_element() < 0.06, "{n} {sum}");
        }
    }
}
