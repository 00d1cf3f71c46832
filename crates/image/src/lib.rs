//! Colours, pixel buffers, gamma, and the way in and out of picture files.
//!
//! Invariants: decoding gives the numbers that stand in the file, with what the file says about their encoding; who
//! uses them decides on a curve. Deliberately absent: sampling of image maps (that is `shading`), tone mapping.
#![warn(missing_docs)]

mod bitmap;
mod color;

pub use bitmap::{Bitmap, FileCurve, Pixels};
pub use color::{Color, Curve, Rgb, grey};
