//! Bounding volume hierarchies: build and traverse. Knows boxes and triangles, nothing of shapes.
//!
//! A [`Bvh`] is built once over boxes and then only read, from any thread. Nodes have eight children whose boxes are
//! kept in single precision, rounded outwards, in structure-of-arrays form, so that one test handles eight boxes. The
//! scalar path and the SIMD path compute the same numbers in the same order, and so visit the same leaves.
//!
//! Invariant: a traversal never misses a box that the exact ray touches (conservative rounding throughout); it may
//! visit a few more. Deliberately absent: what is in the boxes.
#![warn(missing_docs)]

mod build;
mod cover;
mod kernel;
pub mod mesh;
mod node;
mod region;
mod round;
mod row;
mod traverse;

pub use build::Built;
pub use kernel::Slab;
pub use region::Region;
pub use row::{BoxRow, Touched};
pub use traverse::Bvh;
