//! What happens to a pattern's value after its formula: frequency, phase, wave form (textures spec, section 2).
use raggio_function::Bounds;
use raggio_math::turns::{floor, fraction, remainder, sin_turns};
use raggio_scene as scene;

/// Values wrap a little above 1, so that 1 itself stays.
const PERIOD: f64 = 1.00001;

/// A sine wave of period 1, odd about 0.
#[inline]
pub(crate) fn cycle(v: f64) -> f64 {
    sin_turns(v)
}

/// A triangle wave: 0 to 1 and back over 0..1.
#[inline]
pub(crate) fn triangle(v: f64) -> f64 {
    let t = if v >= 0.0 { fraction(v) } else { v + 1.0 + floor(v.abs()) };
    if t < 0.5 { 2.0 * t } else { 2.0 * (1.0 - t) }
}

/// Frequency, phase and wave form of a pattern.
#[derive(Clone, Copy, Debug)]
pub(super) struct Waveform {
    wave: scene::Wave,
    /// 0 neither scales nor wraps.
    frequency: f64,
    phase: f64,
    plain: bool,
}

impl Waveform {
    pub fn of(pattern: &scene::Pattern) -> Self {
        Waveform::new(pattern.wave, f64::from(pattern.frequency), f64::from(pattern.phase))
    }

    fn new(wave: scene::Wave, frequency: f64, phase: f64) -> Self {
        let unscaled = frequency == 0.0 || (frequency == 1.0 && phase == 0.0);
        Waveform { wave, frequency, phase, plain: unscaled && wave == scene::Wave::Ramp }
    }

    /// Do values in 0..=1 stay as they are?
    pub fn is_plain(&self) -> bool {
        self.plain
    }

    /// The value that maps look up. A NaN becomes 0.
    #[inline(always)]
    pub fn apply(&self, v: f64) -> f64 {
        if self.plain && (0.0..PERIOD).contains(&v) { v } else { self.reshaped(v) }
    }

    fn reshaped(&self, mut v: f64) -> f64 {
        if self.frequency != 0.0 {
            v = v * self.frequency + self.phase;
            if v.abs() >= PERIOD {
                v = remainder(v, PERIOD);
            }
        }
        if v < 0.0 {
            v = fraction(v);
        }
        if v.is_nan() { 0.0 } else { self.shape(v) }
    }

    /// Bounds of the same, where values run through less than a period of an unshaped wave.
    pub fn enclose(&self, v: Bounds) -> Bounds {
        let v = if self.frequency == 0.0 { v } else { v * self.frequency + self.phase };
        let within = v.value.lo >= 0.0 && (v.value.hi < PERIOD || self.frequency == 0.0);
        if within && matches!(self.wave, scene::Wave::Ramp) { v } else { Bounds::UNKNOWN }
    }

    #[inline]
    fn shape(&self, v: f64) -> f64 {
        match self.wave {
            scene::Wave::Ramp => v,
            scene::Wave::Triangle => triangle(v),
            scene::Wave::Sine => 0.5 * (1.0 + cycle(v)),
            scene::Wave::Scallop => cycle(0.5 * v).abs(),
            scene::Wave::Cubic => v * v * (3.0 - 2.0 * v),
            scene::Wave::Poly(2.0) => v * v,
            scene::Wave::Poly(exponent) => v.powf(f64::from(exponent)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(wave: scene::Wave, frequency: f64, phase: f64) -> Waveform {
        Waveform::new(wave, frequency, phase)
    }

    #[test]
    fn values_wrap_just_above_one() {
        let w = wave(scene::Wave::Ramp, 1.0, 0.0);
        assert_eq!(w.apply(1.0), 1.0);
        assert!(w.apply(1.00002) < 1e-4);
        assert!((w.apply(-0.25) - 0.75).abs() < 1e-15);
        assert_eq!(wave(scene::Wave::Ramp, 0.0, 0.7).apply(3.0), 3.0, "frequency 0 ignores the phase");
        assert_eq!(w.apply(f64::NAN), 0.0);
    }

    #[test]
    fn wave_forms_pass_their_key_points() {
        for (form, at, value) in [
            (scene::Wave::Triangle, 0.75, 0.5),
            (scene::Wave::Sine, 0.25, 1.0),
            (scene::Wave::Sine, 0.75, 0.0),
            (scene::Wave::Scallop, 0.5, 1.0),
            (scene::Wave::Cubic, 0.5, 0.5),
            (scene::Wave::Poly(2.0), 0.5, 0.25),
        ] {
            assert!((wave(form, 1.0, 0.0).apply(at) - value).abs() < 1e-12, "{form:?} at {at}");
        }
        assert!((triangle(-0.25) - 1.5_f64.mul_add(-1.0, 2.0)).abs() < 1e-12);
    }
}
