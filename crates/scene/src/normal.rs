//! Normals: what bends a surface's normal (textures spec, section 8).
use std::sync::Arc;

use crate::{ImageMap, Map, Pattern, Warp};

/// `normal { ... }`
#[derive(Clone, Debug)]
pub struct Normal {
    /// What it is.
    pub kind: NormalKind,
    /// The number after the pattern, or `bump_size`.
    pub amount: f32,
    /// `accuracy`
    pub accuracy: f32,
    /// `no_bump_scale`
    pub no_bump_scale: bool,
}

/// What a normal is.
#[derive(Clone, Debug)]
pub enum NormalKind {
    /// One of the patterns with a rule of its own.
    Special {
        /// Which.
        pattern: NormalPattern,
        /// Warps, frequency and phase, turbulence.
        settings: Arc<Pattern>,
    },
    /// The slope of any pattern, optionally through a `slope_map` of (position, height, slope).
    Slope {
        /// The pattern.
        pattern: Arc<Pattern>,
        /// `slope_map`
        map: Option<Vec<(f32, f32, f32)>>,
    },
    /// A pattern that chooses or mixes normals. `PatternKind::Average` mixes by the map's weights.
    Map {
        /// The pattern.
        pattern: Arc<Pattern>,
        /// Among what.
        map: Map<Normal>,
    },
    /// `bump_map`
    Bump {
        /// What acts on the point first.
        warps: Vec<Warp>,
        /// The image.
        image: Arc<ImageMap>,
    },
    /// `uv_mapping` on the normal: the inner normal at the point (u, v, 0).
    Uv(Arc<Normal>),
}

/// Patterns that bend normals by a rule of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum NormalPattern {
    Bumps,
    Dents,
    Wrinkles,
    Quilted { control0: f32, control1: f32 },
    Ripples,
    Waves,
    Facets { size: f64, coords: f64, metric: f64 },
}
