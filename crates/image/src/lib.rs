//! Colours, pixel buffers, gamma, and the way in and out of picture files.
//!
//! Invariants: decoding gives the numbers that stand in the file, with what the file says about their encoding; who
//! uses them decides on a curve. Writing goes through two doors: [`develop`] makes whole numbers of a finished
//! [`Picture`], [`encode`] puts them into a file. Deliberately absent: sampling of image maps (that is `shading`), tone
//! mapping.
#![warn(missing_docs)]

mod bitmap;
mod color;
mod compare;
mod decode;
mod encode;
mod format;
mod mosaic;

pub use bitmap::{Bitmap, FileCurve, Pixels};
pub use color::{Color, Curve, Rgb, grey};
pub use compare::{Comparison, SizeMismatch, compare};
pub use decode::{DecodeError, decode};
pub use encode::{Dither, EncodeError, EncodeOptions, Picture, develop, encode, write_png};
pub use format::Format;
pub use mosaic::{Layout, Mosaic};
