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

impl Pixels {
    /// How many pixels there are.
    pub fn len(&self) -> usize {
        match self {
            Pixels::Palette { indices, .. } => indices.len(),
            Pixels::Grey8(v) => v.len(),
            Pixels::Grey16(v) => v.len(),
            Pixels::GreyAlpha8(v) => v.len(),
            Pixels::GreyAlpha16(v) => v.len(),
            Pixels::Rgb8(v) => v.len(),
            Pixels::Rgb16(v) => v.len(),
            Pixels::Rgba8(v) => v.len(),
            Pixels::Rgba16(v) => v.len(),
            Pixels::RgbF32(v) => v.len(),
            Pixels::RgbaF32(v) => v.len(),
        }
    }

    /// The bytes that the samples take, a palette not counted.
    pub fn bytes(&self) -> usize {
        match self {
            Pixels::Palette { indices, .. } => size_of_val(&indices[..]),
            Pixels::Grey8(v) => size_of_val(&v[..]),
            Pixels::Grey16(v) => size_of_val(&v[..]),
            Pixels::GreyAlpha8(v) => size_of_val(&v[..]),
            Pixels::GreyAlpha16(v) => size_of_val(&v[..]),
            Pixels::Rgb8(v) => size_of_val(&v[..]),
            Pixels::Rgb16(v) => size_of_val(&v[..]),
            Pixels::Rgba8(v) => size_of_val(&v[..]),
            Pixels::Rgba16(v) => size_of_val(&v[..]),
            Pixels::RgbF32(v) => size_of_val(&v[..]),
            Pixels::RgbaF32(v) => size_of_val(&v[..]),
        }
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The pixels in 8 bits with alpha: 16-bit numbers lose their low bytes, floats are clamped and rounded.
    pub fn rgba8(&self) -> Vec<[u8; 4]> {
        let high = |v: u16| (v >> 8) as u8;
        let byte = |v: f32| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        match self {
            Pixels::Palette { indices, colors } => indices
                .iter()
                .map(|&i| colors.get(usize::from(i)).copied().unwrap_or([0, 0, 0, 255]))
                .collect(),
            Pixels::Grey8(v) => v.iter().map(|&g| [g, g, g, 255]).collect(),
            Pixels::Grey16(v) => v.iter().map(|&g| high(g)).map(|g| [g, g, g, 255]).collect(),
            Pixels::GreyAlpha8(v) => v.iter().map(|&[g, a]| [g, g, g, a]).collect(),
            Pixels::GreyAlpha16(v) => v.iter().map(|p| p.map(high)).map(|[g, a]| [g, g, g, a]).collect(),
            Pixels::Rgb8(v) => v.iter().map(|&[r, g, b]| [r, g, b, 255]).collect(),
            Pixels::Rgb16(v) => v.iter().map(|p| p.map(high)).map(|[r, g, b]| [r, g, b, 255]).collect(),
            Pixels::Rgba8(v) => v.clone(),
            Pixels::Rgba16(v) => v.iter().map(|p| p.map(high)).collect(),
            Pixels::RgbF32(v) => v.iter().map(|p| p.map(byte)).map(|[r, g, b]| [r, g, b, 255]).collect(),
            Pixels::RgbaF32(v) => v.iter().map(|p| p.map(byte)).collect(),
        }
    }

    /// The pixels in 8 bits; alpha is dropped.
    pub fn rgb8(&self) -> Vec<[u8; 3]> {
        self.rgba8().into_iter().map(|[r, g, b, _]| [r, g, b]).collect()
    }
}
