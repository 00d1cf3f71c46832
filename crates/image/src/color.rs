//! Colours and transfer curves (language spec, section 5).

/// Light or reflectance in the working space: linear unless the scene says otherwise.
pub type Rgb = glam::Vec3;

/// Brightness as the language weighs it.
#[inline]
pub fn grey(c: Rgb) -> f32 {
    0.297 * c.x + 0.589 * c.y + 0.114 * c.z
}

/// A pigment's colour: what it reflects, and the parts of light that it lets through.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Color {
    /// The colour itself.
    pub rgb: Rgb,
    /// The part that passes tinted by `rgb`.
    pub filter: f32,
    /// The part that passes untinted.
    pub transmit: f32,
}

impl Color {
    /// Opaque black.
    pub const BLACK: Color = Color::opaque(0.0, 0.0, 0.0);
    /// Opaque white.
    pub const WHITE: Color = Color::opaque(1.0, 1.0, 1.0);

    /// A colour that lets nothing through.
    pub const fn opaque(r: f32, g: f32, b: f32) -> Self {
        Color { rgb: Rgb::new(r, g, b), filter: 0.0, transmit: 0.0 }
    }

    /// From the language's five numbers: red, green, blue, filter, transmit.
    pub fn from_array(c: [f64; 5]) -> Self {
        Color {
            rgb: Rgb::new(c[0] as f32, c[1] as f32, c[2] as f32),
            filter: c[3] as f32,
            transmit: c[4] as f32,
        }
    }

    /// The language's five numbers.
    pub fn to_array(self) -> [f64; 5] {
        [self.rgb.x, self.rgb.y, self.rgb.z, self.filter, self.transmit].map(f64::from)
    }

    /// What light becomes on its way through: `rgb * filter + transmit` per channel.
    #[inline]
    pub fn transmission(self) -> Rgb {
        self.rgb * self.filter + Rgb::splat(self.transmit)
    }

    /// What is left for the surface itself.
    #[inline]
    pub fn opacity(self) -> f32 {
        1.0 - self.filter - self.transmit
    }

    /// `self` at `t = 0`, `other` at `t = 1`, every channel linearly.
    #[inline]
    pub fn lerp(self, other: Color, t: f64) -> Color {
        Color {
            rgb: self.lerp_rgb(other, t),
            filter: mix(self.filter, other.filter, t),
            transmit: mix(self.transmit, other.transmit, t),
        }
    }

    /// The same without filter and transmit.
    #[inline]
    pub fn lerp_rgb(self, other: Color, t: f64) -> Rgb {
        let (a, b) = (self.rgb, other.rgb);
        Rgb::new(mix(a.x, b.x, t), mix(a.y, b.y, t), mix(a.z, b.z, t))
    }
}

#[inline]
fn mix(a: f32, b: f32, t: f64) -> f32 {
    (f64::from(a) * (1.0 - t) + f64::from(b) * t) as f32
}

/// A transfer curve between encoded and linear values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// No encoding.
    Linear,
    /// The sRGB curve.
    Srgb,
    /// `linear = encoded ^ g`.
    Power(f32),
}

impl Curve {
    /// A power curve; exponents within 1% of 1 are linear (language spec, section 5.1).
    pub fn power(g: f32) -> Curve {
        if (1.0 / g - 1.0).abs() <= 0.01 { Curve::Linear } else { Curve::Power(g) }
    }

    /// From encoded to linear.
    pub fn decode(self, c: f32) -> f32 {
        match self {
            Curve::Linear => c,
            Curve::Srgb if c < 0.04045 => c / 12.92,
            Curve::Srgb => ((c + 0.055) / 1.055).powf(2.4),
            Curve::Power(g) => c.max(0.0).powf(g),
        }
    }

    /// From linear to encoded.
    pub fn encode(self, v: f32) -> f32 {
        match self {
            Curve::Linear => v,
            Curve::Srgb if v <= 0.003_130_8 => 12.92 * v,
            Curve::Srgb => 1.055 * v.powf(1.0 / 2.4) - 0.055,
            Curve::Power(g) => v.max(0.0).powf(1.0 / g),
        }
    }

    /// From values encoded with `self` to values encoded with `to`; the same curve changes nothing at all.
    pub fn convert(self, to: Curve, c: f32) -> f32 {
        match (self, to) {
            (a, b) if a == b => c,
            (Curve::Power(a), Curve::Power(b)) if (a / b - 1.0).abs() <= 0.01 => c,
            (Curve::Power(a), Curve::Power(b)) => c.max(0.0).powf(a / b),
            (a, b) => b.encode(a.decode(c)),
        }
    }
}
