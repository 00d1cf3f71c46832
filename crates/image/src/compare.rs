//! How different two pictures look, and a picture that shows it.
use nv_flip::{DEFAULT_PIXELS_PER_DEGREE, FlipImageRgb8, FlipPool, flip};

use crate::{Bitmap, Curve, FileCurve, Pixels};

/// Two pictures compared, after rounding to 8 bits and without alpha.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Mean of NVIDIA's FLIP over the picture, 0 to 1, at its default viewing distance (67 pixels per degree).
    pub mean_flip: f32,
    /// The greatest difference of a channel, in steps of 255.
    pub greatest: u8,
    /// The mean difference of a channel, in steps of 255.
    pub mean: f32,
    /// Side by side: expected, difference (FLIP in the magma scale), actual.
    pub panel: Bitmap,
}

/// The pictures have different sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected {expected:?} pixels, got {actual:?}")]
pub struct SizeMismatch {
    /// Width and height of the expected picture.
    pub expected: (usize, usize),
    /// Width and height of the actual picture.
    pub actual: (usize, usize),
}

/// Compares two pictures. Both are taken as sRGB.
pub fn compare(expected: &Bitmap, actual: &Bitmap) -> Result<Comparison, SizeMismatch> {
    let (width, height) = (expected.width, expected.height);
    let mismatch = SizeMismatch { expected: (width, height), actual: (actual.width, actual.height) };
    if mismatch.expected != mismatch.actual || expected.pixels.is_empty() {
        return Err(mismatch);
    }
    let (a, b) = (expected.pixels.rgb8(), actual.pixels.rgb8());
    let image = |v: &[[u8; 3]]| FlipImageRgb8::with_data(width as u32, height as u32, v.as_flattened());
    let errors = flip(image(&a), image(&b), DEFAULT_PIXELS_PER_DEGREE);
    let mean_flip = FlipPool::from_image(&errors).mean();
    let shown = errors.apply_color_lut(&nv_flip::magma_lut()).to_vec();

    let differences = || a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a.abs_diff(*b));
    let sum: u64 = differences().map(u64::from).sum();
    Ok(Comparison {
        mean_flip,
        greatest: differences().max().unwrap_or(0),
        mean: sum as f32 / (3 * a.len()) as f32,
        panel: side_by_side(width, &[&a, shown.as_chunks::<3>().0, &b]),
    })
}

/// Pictures of one size in a row, with a line of grey between them.
fn side_by_side(width: usize, pictures: &[&[[u8; 3]]]) -> Bitmap {
    const GAP: [u8; 3] = [128; 3];
    let height = pictures.first().map_or(0, |p| p.len() / width.max(1));
    let mut pixels = Vec::new();
    for y in 0..height {
        for (i, picture) in pictures.iter().enumerate() {
            if i > 0 {
                pixels.push(GAP);
            }
            pixels.extend_from_slice(&picture[y * width..(y + 1) * width]);
        }
    }
    Bitmap {
        width: pictures.len() * (width + 1) - 1,
        height,
        pixels: Pixels::Rgb8(pixels),
        curve: FileCurve::Stated(Curve::Srgb),
        premultiplied: false,
    }
}
