//! JPEG, TIFF, PBM/PGM/PPM, HDR and BMP, through the `image` crate.
use std::io::Cursor;

use image::codecs::bmp::BmpDecoder;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};

use super::{DecodeError, MOST_PIXELS, checked_size, damaged, grouped, grouped16};
use crate::{Bitmap, FileCurve, Format, Pixels};

pub(super) fn decode(bytes: &[u8], format: Format, curve: FileCurve) -> Result<Bitmap, DecodeError> {
    let error = |e: image::ImageError| damaged(format)(e);
    let coder = match format {
        Format::Jpeg => ImageFormat::Jpeg,
        Format::Tiff => ImageFormat::Tiff,
        Format::Hdr => ImageFormat::Hdr,
        _ => ImageFormat::Pnm,
    };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), coder);
    let mut limits = Limits::default();
    limits.max_alloc = Some(16 * MOST_PIXELS as u64);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(error)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = checked_size(width as usize, height as usize)?;
    let image = DynamicImage::from_decoder(decoder).map_err(error)?;
    // The language's TIFF reader keeps the high byte of grey samples, and takes alpha as multiplied in already.
    let pixels = match pixels(image) {
        Pixels::Grey16(v) if format == Format::Tiff => {
            Pixels::Grey8(v.into_iter().map(|v| (v >> 8) as u8).collect())
        }
        other => other,
    };
    Ok(Bitmap { width, height, pixels, curve, premultiplied: format == Format::Tiff })
}

pub(super) fn decode_bmp(bytes: &[u8]) -> Result<Bitmap, DecodeError> {
    let error = |e: image::ImageError| damaged(Format::Bmp)(e);
    let mut decoder = BmpDecoder::new(Cursor::new(bytes)).map_err(error)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = checked_size(width as usize, height as usize)?;
    let palette = decoder.get_palette().map(|p| p.iter().map(|&[r, g, b]| [r, g, b, 255]).collect());
    let pixels = match palette {
        Some(colors) => {
            decoder.set_indexed_color(true);
            let mut indices = vec![0; width * height];
            decoder.read_image(&mut indices).map_err(error)?;
            Pixels::Palette { indices, colors }
        }
        None => pixels(DynamicImage::from_decoder(decoder).map_err(error)?),
    };
    Ok(Bitmap { width, height, pixels, curve: FileCurve::CustomSrgb, premultiplied: false })
}

fn pixels(image: DynamicImage) -> Pixels {
    match image {
        DynamicImage::ImageLuma8(v) => Pixels::Grey8(v.into_raw()),
        DynamicImage::ImageLumaA8(v) => Pixels::GreyAlpha8(grouped(&v)),
        DynamicImage::ImageRgb8(v) => Pixels::Rgb8(grouped(&v)),
        DynamicImage::ImageRgba8(v) => Pixels::Rgba8(grouped(&v)),
        DynamicImage::ImageLuma16(v) => Pixels::Grey16(v.into_raw()),
        DynamicImage::ImageLumaA16(v) => Pixels::GreyAlpha16(grouped16(&v)),
        DynamicImage::ImageRgb16(v) => Pixels::Rgb16(grouped16(&v)),
        DynamicImage::ImageRgba16(v) => Pixels::Rgba16(grouped16(&v)),
        DynamicImage::ImageRgba32F(v) => Pixels::RgbaF32(v.as_chunks::<4>().0.to_vec()),
        other => Pixels::RgbF32(other.into_rgb32f().as_chunks::<3>().0.to_vec()),
    }
}
