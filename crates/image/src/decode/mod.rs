//! From a file's bytes to a [`Bitmap`].
//!
//! Sizes are checked before anything is allocated for them, and a damaged file is an error, never a panic.
mod common;
mod exr;
mod gif;
mod iff;
mod png;
mod tga;

use crate::{Bitmap, FileCurve, Format};

/// Pictures with more pixels than this are refused.
pub(crate) const MOST_PIXELS: usize = 1 << 28;

/// Why a picture cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum DecodeError {
    /// Nothing at the start of the file says what it is.
    #[error("this is no picture in a known format")]
    Unknown,
    /// Too many pixels, or none.
    #[error("a picture of {0} x {1} pixels cannot be read")]
    Size(usize, usize),
    /// The file is damaged or uses a rare feature.
    #[error("the {0} picture cannot be decoded: {1}")]
    Damaged(Format, String),
}

/// Decodes a picture. Where the bytes carry a mark they decide on the format; `format` is for those that do not,
/// and for [`Format::Pot`], which looks like GIF.
pub fn decode(bytes: &[u8], format: Option<Format>) -> Result<Bitmap, DecodeError> {
    let format = match (Format::from_bytes(bytes), format) {
        (Some(Format::Gif), Some(Format::Pot)) => Format::Pot,
        (found, named) => found.or(named).ok_or(DecodeError::Unknown)?,
    };
    let bitmap = match format {
        Format::Png => png::decode(bytes),
        Format::Gif => gif::decode(bytes),
        Format::Pot => gif::decode_potential(bytes),
        Format::Tga => tga::decode(bytes),
        Format::Exr => exr::decode(bytes),
        Format::Iff => iff::decode(bytes),
        Format::Jpeg => common::decode(bytes, format, FileCurve::CustomSrgb),
        Format::Bmp => common::decode_bmp(bytes),
        Format::Pnm | Format::Tiff => common::decode(bytes, format, FileCurve::None),
        Format::Hdr => common::decode(bytes, format, FileCurve::Linear),
    }?;
    match bitmap.pixels.len() == bitmap.width * bitmap.height {
        true => Ok(bitmap),
        false => Err(damaged(format)("there are fewer pixels than the header says")),
    }
}

/// Makes an error of what a decoder says.
fn damaged<E: std::fmt::Display>(format: Format) -> impl Fn(E) -> DecodeError {
    move |e| DecodeError::Damaged(format, e.to_string())
}

/// Refuses sizes that no picture has.
fn checked_size(width: usize, height: usize) -> Result<(usize, usize), DecodeError> {
    match width.checked_mul(height) {
        Some(n) if n > 0 && n <= MOST_PIXELS => Ok((width, height)),
        _ => Err(DecodeError::Size(width, height)),
    }
}

/// Bytes as pixels of `N` samples.
fn grouped<const N: usize>(bytes: &[u8]) -> Vec<[u8; N]> {
    bytes.as_chunks::<N>().0.to_vec()
}

/// Whole numbers of two bytes each as pixels of `N` samples.
fn grouped16<const N: usize>(samples: &[u16]) -> Vec<[u16; N]> {
    samples.as_chunks::<N>().0.to_vec()
}
