//! Compiled textures against values recorded from the language's reference renderer.
mod normals;
mod patterns;
mod pigments;
mod plane;
mod statement;
mod surface;
