//! OpenEXR: the first layer with colours; premultiplied, as the format has it.
use std::io::Cursor;

use exr::prelude::*;

use super::{DecodeError, checked_size, damaged};
use crate::{Bitmap, FileCurve, Format, Pixels};

/// What is gathered while reading: the width, the pixels, and whether any is transparent.
struct Canvas {
    width: usize,
    pixels: Vec<[f32; 4]>,
}

pub(super) fn decode(bytes: &[u8]) -> std::result::Result<Bitmap, DecodeError> {
    let error = |e: exr::error::Error| damaged(Format::Exr)(e);
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(error)?;
    for header in &meta.headers {
        checked_size(header.layer_size.width(), header.layer_size.height())?;
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, _| Canvas {
                width: size.width(),
                pixels: vec![[0.0, 0.0, 0.0, 1.0]; size.width() * size.height()],
            },
            |canvas: &mut Canvas, at: Vec2<usize>, (r, g, b, a): (f32, f32, f32, f32)| {
                if let Some(pixel) = canvas.pixels.get_mut(at.y() * canvas.width + at.x()) {
                    *pixel = [r, g, b, a];
                }
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(error)?;
    let size = image.layer_data.size;
    let pixels = image.layer_data.channel_data.pixels.pixels;
    let opaque = pixels.iter().all(|p| p[3] == 1.0);
    let pixels = if opaque {
        Pixels::RgbF32(pixels.into_iter().map(|[r, g, b, _]| [r, g, b]).collect())
    } else {
        Pixels::RgbaF32(pixels)
    };
    Ok(Bitmap {
        width: size.width(),
        height: size.height(),
        pixels,
        curve: FileCurve::Linear,
        premultiplied: true,
    })
}
