//! How diffuse light falls off with the angle, for finishes whose `brilliance` asks for powers of cosines.

/// So many powers are remembered.
const KNOWN: usize = 512;

/// Powers of cosines worked out before. Photons come from few directions.
pub(crate) struct Lobes {
    brilliance: f32,
    /// Cosines with their powers, each where its bits lead.
    known: Box<[(f32, f32); KNOWN]>,
}

/// No cosine.
const NOTHING: (f32, f32) = (f32::NAN, 0.0);

impl Default for Lobes {
    fn default() -> Lobes {
        Lobes { brilliance: 1.0, known: Box::new([NOTHING; KNOWN]) }
    }
}

impl Lobes {
    /// Makes ready for a finish.
    #[inline]
    pub fn begin(&mut self, brilliance: f32) {
        if brilliance != 1.0 && brilliance != self.brilliance {
            self.brilliance = brilliance;
            self.known.fill(NOTHING);
        }
    }

    /// The cosine to the power of the `brilliance` that was made ready.
    #[inline]
    pub fn power(&mut self, cosine: f32) -> f32 {
        let place = (cosine.to_bits().wrapping_mul(0x9e37_79b1) >> 23) as usize;
        let known = &mut self.known[place % KNOWN];
        if known.0 != cosine {
            *known = (cosine, cosine.powf(self.brilliance));
        }
        known.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_those_of_the_finish_made_ready_last() {
        let mut lobes = Lobes::default();
        for brilliance in [0.6, 3.0, 1.0, 3.0, 0.6] {
            lobes.begin(brilliance);
            for i in (0..3000).chain(0..3000) {
                let cosine = i as f32 / 3000.0;
                assert!(brilliance == 1.0 || lobes.power(cosine) == cosine.powf(brilliance), "{cosine}");
            }
        }
    }
}
