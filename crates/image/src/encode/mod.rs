//! From a finished picture to a file's bytes.
mod develop;
mod dither;
mod files;
mod parallel;
mod png;
mod steps;
mod tga;

use std::io::Write;

pub use develop::develop;
pub use dither::Dither;
pub use png::write_png;

use crate::{Curve, Format};

/// A finished picture as a renderer leaves it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green and blue in the working space, multiplied by alpha, and transmit (one less alpha); rows from the top.
    pub pixels: Vec<[f32; 4]>,
}

/// How a picture is to be stored.
#[derive(Clone, Debug, PartialEq)]
pub struct EncodeOptions {
    /// The file's format.
    pub format: Format,
    /// Bits per channel, 5 to 16. Formats of 8 bits ignore it; PNG stores 5 to 8 bits in bytes and more in words.
    pub bits: u8,
    /// Store alpha, where the format can.
    pub alpha: bool,
    /// Store brightness alone, where the format can.
    pub grey: bool,
    /// The curve of the working space; `None` switches all gamma handling off, values are stored as they are.
    pub working: Option<Curve>,
    /// The curve of the file (`File_Gamma`); HDR and EXR are always linear.
    pub file: Curve,
    /// Spread the rounding errors.
    pub dither: Option<Dither>,
    /// Of JPEG, 1 to 100.
    pub quality: u8,
    /// Run-length encode TGA.
    pub run_length: bool,
    /// Threads that may work at a PNG file, which does not depend on them; 0 means all that the machine has.
    pub threads: usize,
}

impl Default for EncodeOptions {
    fn default() -> Self {
        EncodeOptions {
            format: Format::Png,
            bits: 8,
            alpha: false,
            grey: false,
            working: Some(Curve::Linear),
            file: Curve::Srgb,
            dither: None,
            quality: 95,
            run_length: false,
            threads: 1,
        }
    }
}

/// Why a picture cannot be stored.
#[derive(Debug, thiserror::Error)]
pub enum EncodeError {
    /// A format without an encoder.
    #[error("{0} pictures cannot be written; choose PNG, PPM, BMP, TGA, JPEG, HDR or EXR")]
    Unsupported(Format),
    /// The format cannot hold so large a picture, or this one has no pixels.
    #[error("a picture of {0} x {1} pixels cannot be stored as {2}")]
    Size(usize, usize, Format),
    /// The encoder refuses.
    #[error("the {0} picture cannot be encoded: {1}")]
    Refused(Format, String),
    /// The file refuses.
    #[error(transparent)]
    Io(#[from] std::io::Error),
}

/// Encodes a picture in the format that `options` names.
pub fn encode(picture: &Picture, options: &EncodeOptions, out: &mut impl Write) -> Result<(), EncodeError> {
    let size = EncodeError::Size(picture.width, picture.height, options.format);
    let pixels = picture.width.checked_mul(picture.height);
    if pixels.is_none_or(|n| n == 0 || n != picture.pixels.len()) {
        return Err(size);
    }
    match options.format {
        Format::Hdr => files::write_hdr(picture, options.working, out),
        Format::Exr => files::write_exr(picture, options, out),
        Format::Gif | Format::Pot | Format::Tiff | Format::Iff => {
            Err(EncodeError::Unsupported(options.format))
        }
        Format::Png => write_png(&develop(picture, options), options.threads, out),
        Format::Pnm => files::write_pnm(&develop(picture, options), options.bits, out),
        Format::Jpeg => files::write_jpeg(&develop(picture, options), options.quality, out),
        Format::Bmp => files::write_bmp(&develop(picture, options), out),
        Format::Tga => tga::write(&develop(picture, options), options.run_length, out),
    }
}
