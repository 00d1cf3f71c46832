//! Pictures as files hold them: palette, grey or colour, whole numbers or floats.

/// A decoded picture. Rows run from the top; nothing has been converted yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Bitmap {
    /// Columns, at least 1.
    pub width: usize,
    /// Rows, at least 1.
    pub height: usize,
    /// The samples.
    pub pixels: Pixels,
    /// What the file or its format says about the encoding of its colours.
    pub curve: FileCurve,
    /// Are the colours already multiplied by alpha?
    pub premultiplied: bool,
}

/// The samples of a [`Bitmap`], row by row; alpha, where there is one, comes last in each pixel.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Pixels {
    /// Indices into at most 256 colours (RGBA, 8 bits each).
    Palette {
        indices: Vec<u8>,
        colors: Vec<[u8; 4]>,
    },
    Grey8(Vec<u8>),
    Grey16(Vec<u16>),
    GreyAlpha8(Vec<[u8; 2]>),
    GreyAlpha16(Vec<[u16; 2]>),
    Rgb8(Vec<[u8; 3]>),
    Rgb16(Vec<[u16; 3]>),
    Rgba8(Vec<[u8; 4]>),
    Rgba16(Vec<[u16; 4]>),
    RgbF32(Vec<[f32; 3]>),
    RgbaF32(Vec<[f32; 4]>),
}

/// How a file's colours are encoded when the scene gives no `gamma` (table in section 5.4 of the language spec).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FileCurve {
    /// The file itself says so: a PNG chunk.
    Stated(crate::Curve),
    /// The format's custom is sRGB (PNG without chunks, JPEG, GIF, TGA, BMP).
    CustomSrgb,
    /// The format has no custom: values are taken as the working space (PPM, PGM, TIFF).
    None,
    /// The format is linear light (HDR, EXR).
    Linear,
}
