//! Patterns, pigments, normals, textures: from a point on a surface to colours and bent normals.
//!
//! Invariants: everything is compiled once ([`Texture::compile`] and its kin); evaluation allocates nothing and cannot
//! fail. Deliberately absent: rays, lights, recursion (that is `render`).
#![warn(missing_docs)]

mod compiler;
mod context;
mod external;
mod image;
mod map;
mod memory;
mod normal;
mod pattern;
mod pigment;
mod texture;
mod warp;

pub use context::{Context, Noise};
pub use external::{PatternFunction, PigmentFunction};
pub use image::FOOTPRINT_STEP;
pub use normal::Normal;
pub use pattern::Pattern;
pub use pigment::Pigment;
pub use texture::{Layer, Texture, TextureMap};
