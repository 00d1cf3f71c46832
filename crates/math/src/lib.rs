//! The ground floor: points, transforms, boxes, polynomial roots, noise and random numbers.
//!
//! Invariants: everything is `f64`, nothing allocates per call, nothing can fail after construction.
//! Deliberately absent: colours, shapes, files.
#![warn(missing_docs)]

mod aabb;
pub mod noise;
pub mod poly;
mod ray;
pub mod transform;
pub mod turns;
mod wide;

pub use aabb::Aabb;
pub use glam::{DAffine3 as Affine, DMat3 as Mat3, DVec2 as Vec2, DVec3 as Vec3, DVec4 as Vec4};
pub use ray::Ray;
pub use wide::{Wide, wide};

/// The language's "zero": two numbers closer than this are equal (language spec, section 2).
pub const EPS: f64 = 1e-10;
/// The depth that a ray which hits nothing is said to have travelled.
pub const FAR: f64 = 2e10;
/// The farthest hit that most shapes accept.
pub const MAX_DISTANCE: f64 = 1e7;
/// The nearest hit that the closest-hit search accepts, whatever the shape says.
pub const MIN_HIT: f64 = 1e-4;
