//! Patterns, pigments, normals, textures: from a point on a surface to colours and bent normals.
//!
//! Invariants: everything is compiled once ([`Texture::compile`] and its kin); evaluation allocates nothing and cannot
//! fail. Deliberately absent: rays, lights, recursion (that is `render`).

mod api;

pub use api::{Context, Layer, Noise, Normal, Pattern, Pigment, Texture, TextureMap};
