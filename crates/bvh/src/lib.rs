//! Bounding volume hierarchies: build, refit, traverse. Knows boxes and triangles, nothing of shapes.
#![warn(missing_docs)]

pub mod mesh;
