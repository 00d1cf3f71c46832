//! Colours (language spec, section 5.3).
use raggio_scene::{Color, Curve, GammaMode};

use super::num::Num;
use super::{Parser, Result, Tok};
use crate::keyword::Kw;

impl Parser<'_> {
    /// A colour slot with all five channels: `rgb`, `rgbf`, `srgb`, `color`, a colour identifier, `red .. green ..`.
    pub fn color(&mut self) -> Result<Color> {
        self.channels().map(Color::from_array)
    }

    /// Does a word come next with which a colour begins?
    pub(super) fn at_color_word(&mut self) -> Result<bool> {
        let Tok::Kw(kw) = self.peek()? else { return Ok(false) };
        Ok(matches!(kw, Kw::Color | Kw::Colour) || rgb_word(kw).is_some() || channel(kw).is_some())
    }

    /// The five numbers of a colour phrase, in single precision.
    pub(super) fn channels(&mut self) -> Result<[f64; 5]> {
        let word = self.accept(Kw::Color)? || self.accept(Kw::Colour)?;
        let mut channels = match self.peek()? {
            Tok::Kw(kw) if channel(kw).is_some() => [0.0; 5],
            Tok::Kw(kw) if rgb_word(kw).is_some() => self.rgb_phrase(kw)?,
            _ if self.at_expression()? => self.full()?.padded(5).v,
            Tok::Unknown => return self.undeclared("is no colour"),
            _ if word => self.missing_color([0.0; 5]),
            _ => return self.expected("a colour"),
        };
        while let Tok::Kw(kw) = self.peek()?
            && let Some(index) = channel(kw)
        {
            self.next()?;
            channels[index] = self.float()?;
        }
        Ok(channels.map(|c| f64::from(c as f32)))
    }

    /// `black`, with a warning, for the colour of which there is only the word, or not even that.
    pub fn missing_color<T>(&mut self, black: T) -> T {
        let span = self.span();
        self.warn("missing-color", "a colour is missing here; black is taken", span);
        black
    }

    /// `rgb e` and its kin.
    fn rgb_phrase(&mut self, kw: Kw) -> Result<[f64; 5]> {
        self.next()?;
        let span = self.here();
        let (size, encoded) = rgb_word(kw).unwrap_or((3, false));
        let value = self.full()?;
        let mut c = match value.len {
            1 => Num { len: 1, ..value }.padded(size).v,
            len => {
                if len != size {
                    let message =
                        format!("suspicious expression after {}: {size} numbers belong here", kw.word());
                    self.warn("suspicious-color", message, span);
                }
                value.v
            }
        };
        if matches!(kw, Kw::Rgbt | Kw::Srgbt) && value.len <= 4 {
            c.swap(3, 4);
        }
        if encoded {
            let working = self.working_curve(span)?;
            for c in &mut c[..3] {
                *c = f64::from(Curve::Srgb.convert(working, *c as f32));
            }
        }
        Ok(c)
    }

    fn working_curve(&self, span: raggio_diag::Span) -> Result<Curve> {
        match self.settings.gamma {
            GammaMode::Working(curve) if self.gamma_explicit => Ok(curve),
            _ => {
                let message = "srgb colours need `global_settings { assumed_gamma ... }` before them";
                self.error("srgb-without-gamma", message, span)
            }
        }
    }
}

/// How many numbers follow, and whether they are encoded by the sRGB curve.
fn rgb_word(kw: Kw) -> Option<(u8, bool)> {
    Some(match kw {
        Kw::Rgb => (3, false),
        Kw::Rgbf | Kw::Rgbt => (4, false),
        Kw::Rgbft => (5, false),
        Kw::Srgb => (3, true),
        Kw::Srgbf | Kw::Srgbt => (4, true),
        Kw::Srgbft => (5, true),
        _ => return None,
    })
}

fn channel(kw: Kw) -> Option<usize> {
    Some(match kw {
        Kw::Red => 0,
        Kw::Green => 1,
        Kw::Blue => 2,
        Kw::Filter | Kw::Alpha => 3,
        Kw::Transmit => 4,
        _ => return None,
    })
}
