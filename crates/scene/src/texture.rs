//! Textures: layers, patterned textures, lists.
use std::sync::Arc;

use crate::{Finish, Map, Normal, Pattern, Pigment, Warp};

/// `texture { ... }`, or several in a row: a layered texture is one [`Texture`].
#[derive(Clone, Debug)]
pub struct Texture {
    /// What it is.
    pub kind: TextureKind,
}

/// What a texture is made of.
#[derive(Clone, Debug)]
pub enum TextureKind {
    /// Plain layers; the first lies at the bottom.
    Layers(Vec<Layer>),
    /// A pattern chooses between textures or mixes them. Also `tiles` (a checker) and block patterns.
    Patterned {
        /// What chooses. `PatternKind::Average` mixes by the map's weights.
        pattern: Arc<Pattern>,
        /// Among what.
        map: Map<Texture>,
    },
    /// `material_map`: an image's index chooses.
    MaterialMap {
        /// What acts on the point first.
        warps: Vec<Warp>,
        /// The image.
        image: Arc<crate::ImageMap>,
        /// Among what.
        textures: Vec<Arc<Texture>>,
    },
    /// `uv_mapping` on the texture: the inner texture at the point (u, v, 0).
    Uv(Arc<Texture>),
}

/// One plain layer.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Colour.
    pub pigment: Arc<Pigment>,
    /// Bumps.
    pub normal: Option<Arc<Normal>>,
    /// Answer to light.
    pub finish: Finish,
}
