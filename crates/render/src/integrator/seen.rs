//! What a ray sees.
use glam::Vec4;
use raggio_image::Rgb;

/// What a ray sees: light, premultiplied, and what is seen through. Kept as one vector of four: written as a colour and
/// a number, it would have to be waited for by whoever hands it on as a whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen(Vec4);

impl Seen {
    /// Opaque black.
    pub const BLACK: Seen = Seen(Vec4::ZERO);

    /// Light and what is seen through.
    #[inline]
    pub fn new(rgb: Rgb, transmit: f32) -> Seen {
        Seen(rgb.extend(transmit))
    }

    /// Light alone: nothing is seen through.
    #[inline]
    pub fn opaque(rgb: Rgb) -> Seen {
        Seen::new(rgb, 0.0)
    }

    /// Light, premultiplied.
    #[inline]
    pub fn rgb(&self) -> Rgb {
        self.0.truncate()
    }

    /// What is seen through.
    #[inline]
    pub fn transmit(&self) -> f32 {
        self.0.w
    }

    /// Adds a share of what another ray sees, which colours its light otherwise than what shows behind it.
    #[inline]
    pub fn add_share(&mut self, other: &Seen, rgb: Rgb, transmit: f32) {
        self.0 += other.0 * rgb.extend(transmit);
    }

    /// All four numbers, with 0 for what is none.
    #[inline]
    pub fn to_pixel(self) -> [f32; 4] {
        Vec4::select(self.0.is_nan_mask(), Vec4::ZERO, self.0).to_array()
    }
}
