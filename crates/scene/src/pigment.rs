//! Pigments and the maps that patterns look up.
use std::sync::Arc;

use crate::{Color, ImageMap, Pattern, Warp};

/// Entries by ascending position; a value between two is a mix of both (textures spec, section 9.1).
/// Lists of block patterns are maps at 0, 1, 2 ...; in an average the positions are weights.
pub type Map<T> = Vec<(f32, Arc<T>)>;

/// Colours by position.
pub type ColorMap = Vec<(f32, Color)>;

/// `pigment { ... }`
#[derive(Clone, Debug)]
pub struct Pigment {
    /// What it is.
    pub kind: PigmentKind,
    /// Used at low quality instead.
    pub quick_color: Option<Color>,
}

/// What a pigment is.
#[derive(Clone, Debug)]
pub enum PigmentKind {
    /// One colour.
    Solid {
        /// The colour.
        color: Color,
        /// Without effect on it. A pattern that a later `pigment { }` puts in its place goes through them.
        warps: Vec<Warp>,
    },
    /// A pattern that looks up colours.
    ColorMap {
        /// The pattern.
        pattern: Arc<Pattern>,
        /// The colours.
        map: Arc<ColorMap>,
    },
    /// A pattern that chooses or mixes pigments. `PatternKind::Average` mixes by the map's weights.
    PigmentMap {
        /// The pattern.
        pattern: Arc<Pattern>,
        /// The pigments, each at the point that the pattern's warps give.
        map: Map<Pigment>,
    },
    /// `image_map`
    Image {
        /// What acts on the point first.
        warps: Vec<Warp>,
        /// The image.
        image: Arc<ImageMap>,
    },
    /// `uv_mapping` on the pigment: the inner pigment at the point (u, v, 0).
    Uv(Arc<Pigment>),
}

impl Pigment {
    /// A pigment of one colour.
    pub fn solid(color: Color) -> Self {
        Pigment { kind: PigmentKind::solid(color), quick_color: None }
    }
}

impl PigmentKind {
    /// One colour that nothing has moved.
    pub fn solid(color: Color) -> Self {
        PigmentKind::Solid { color, warps: Vec::new() }
    }
}
