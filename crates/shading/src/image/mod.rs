//! Images as pigments, patterns, bumps and choosers of materials (textures spec, section 7).
mod kernel;
mod place;
mod smooth;
#[cfg(test)]
mod tests;
mod texels;

use std::sync::Arc;

use raggio_image::{Color, grey};
use raggio_math::Vec3;
use raggio_scene as scene;

use kernel::mix_at;
use smooth::Pyramid;
use texels::{Indices, Texels};

pub use smooth::FOOTPRINT_STEP;

/// A picture with the way from a point to its colour. The samples are the scene's own.
#[derive(Debug)]
pub(crate) struct Image {
    map: Arc<scene::ImageMap>,
    texels: Texels,
    /// Smaller copies, where the picture is `smooth`.
    pyramid: Option<Box<Pyramid>>,
}

/// A place on the picture: columns from the left and rows from the top, in pixels, within the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    x: f64,
    y: f64,
}

impl Image {
    pub fn compile(map: &Arc<scene::ImageMap>) -> Self {
        let texels = Texels::new(map);
        let pyramid = map.smooth.then(|| Box::new(Pyramid::new(&texels, &map.source.mosaic)));
        Image { map: map.clone(), texels, pyramid }
    }

    /// Does it look at the camera's pixels?
    pub fn is_smooth(&self) -> bool {
        self.pyramid.is_some()
    }

    /// The colour that a point sees; `None` beside a picture used `once`.
    pub fn color(&self, p: Vec3) -> Option<Color> {
        self.place(p).map(|place| self.color_at(place))
    }

    /// Does it cover everything and let nothing through?
    pub fn is_opaque(&self) -> bool {
        !self.map.once && !self.texels.is_transparent()
    }

    /// The value of `image_pattern`; 0 beside the picture.
    pub fn pattern_value(&self, p: Vec3) -> f64 {
        let Some(place) = self.place(p) else { return 0.0 };
        let color = self.color_at(place);
        let value = match (self.map.use_alpha, self.texels.is_transparent()) {
            (true, true) => color.transmit,
            (true, false) => color.rgb.x,
            (false, _) => grey(color.rgb),
        };
        f64::from(value).clamp(0.0, 1.0)
    }

    /// Which material a point has: the palette's index, or 255 times red; 0 beside the picture.
    pub fn material_index(&self, p: Vec3) -> usize {
        let Some(place) = self.place(p) else { return 0 };
        match self.texels.indices() {
            Some(indices) => self.index_at(indices, place) as usize,
            None => (255.0 * self.color_at(place).rgb.x).max(0.0) as usize,
        }
    }

    /// The heights that `bump_map` compares: here, below to the left, and below to the right, all times `size`.
    pub fn heights(&self, p: Vec3, size: f64) -> Option<[f64; 3]> {
        let here = self.place(p)?;
        let mosaic = &self.map.source.mosaic;
        let (width, height) = (mosaic.width() as f64, mosaic.height() as f64);
        let beside =
            |dx: f64| Place { x: (here.x + dx).rem_euclid(width), y: (here.y + 1.0).rem_euclid(height) };
        Some([here, beside(-1.0), beside(1.0)].map(|place| size * self.height_at(place)))
    }

    fn height_at(&self, place: Place) -> f64 {
        match self.texels.indices() {
            Some(indices) if self.map.use_index => self.index_at(indices, place),
            _ => f64::from(grey(self.color_at(place).rgb)),
        }
    }

    fn index_at(&self, indices: &[u8], place: Place) -> f64 {
        mix_at(&self.map, place, &Indices(indices)).trunc()
    }

    fn color_at(&self, place: Place) -> Color {
        self.finish(mix_at(&self.map, place, &self.texels))
    }

    /// What is done to a colour after interpolation.
    fn finish(&self, mut color: Color) -> Color {
        let alpha = 1.0 - color.transmit;
        if self.map.premultiplied && f64::from(alpha) > raggio_math::EPS {
            color.rgb /= alpha;
        }
        if self.texels.indices().is_none() {
            color.filter += self.map.filter_all;
            color.transmit += self.map.transmit_all;
        }
        color
    }
}
