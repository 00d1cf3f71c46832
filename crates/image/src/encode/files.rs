//! The file formats, each from the numbers that it stores.
use std::borrow::Cow;
use std::io::{Cursor, Write};

use exr::prelude::WritableImage;
use image::ExtendedColorType;

use super::{EncodeError, EncodeOptions, Picture};
use crate::{Bitmap, Curve, Format, Pixels, Rgb};

/// What files say about their maker.
pub(super) const SOFTWARE: &str = "Raggio";

pub(super) fn refused<E: std::fmt::Display>(format: Format) -> impl Fn(E) -> EncodeError {
    move |e| EncodeError::Refused(format, e.to_string())
}

pub(super) fn size(bitmap: &Bitmap, format: Format) -> Result<(u32, u32), EncodeError> {
    match (u32::try_from(bitmap.width), u32::try_from(bitmap.height)) {
        (Ok(width), Ok(height)) => Ok((width, height)),
        _ => Err(EncodeError::Size(bitmap.width, bitmap.height, format)),
    }
}

/// Raw PPM or PGM with `bits` bits per sample.
pub(super) fn write_pnm(bitmap: &Bitmap, bits: u8, out: &mut impl Write) -> Result<(), EncodeError> {
    let wide = |v: &[u16]| v.iter().flat_map(|v| v.to_be_bytes()).collect::<Vec<u8>>();
    let (mark, data): (_, Cow<[u8]>) = match &bitmap.pixels {
        Pixels::Grey8(v) => ("P5", v.into()),
        Pixels::Grey16(v) => ("P5", wide(v).into()),
        Pixels::Rgb16(v) => ("P6", wide(v.as_flattened()).into()),
        other => ("P6", other.rgb8().into_iter().flatten().collect::<Vec<u8>>().into()),
    };
    let max = u16::MAX >> (16 - bits.clamp(1, 16));
    write!(out, "{mark}\n# Software: {SOFTWARE}\n{} {}\n{max}\n", bitmap.width, bitmap.height)?;
    Ok(out.write_all(&data)?)
}

pub(super) fn write_jpeg(bitmap: &Bitmap, quality: u8, out: &mut impl Write) -> Result<(), EncodeError> {
    let (width, height) = size(bitmap, Format::Jpeg)?;
    if width > 65_535 || height > 65_535 {
        return Err(EncodeError::Size(bitmap.width, bitmap.height, Format::Jpeg));
    }
    let mut encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(out, quality.clamp(1, 100));
    encoder
        .encode(bitmap.pixels.rgb8().as_flattened(), width, height, ExtendedColorType::Rgb8)
        .map_err(from_image(Format::Jpeg))
}

pub(super) fn write_bmp(bitmap: &Bitmap, out: &mut impl Write) -> Result<(), EncodeError> {
    let (width, height) = size(bitmap, Format::Bmp)?;
    let mut encoder = image::codecs::bmp::BmpEncoder::new(out);
    let written = match &bitmap.pixels {
        Pixels::Rgba8(v) => encoder.encode(v.as_flattened(), width, height, ExtendedColorType::Rgba8),
        other => encoder.encode(other.rgb8().as_flattened(), width, height, ExtendedColorType::Rgb8),
    };
    written.map_err(from_image(Format::Bmp))
}

fn from_image(format: Format) -> impl Fn(image::ImageError) -> EncodeError {
    move |e| match e {
        image::ImageError::IoError(e) => EncodeError::Io(e),
        other => refused(format)(other),
    }
}

/// Radiance RGBE: linear light, unclamped above, without alpha.
pub(super) fn write_hdr(
    picture: &Picture,
    working: Option<Curve>,
    out: &mut impl Write,
) -> Result<(), EncodeError> {
    let pixels: Vec<image::Rgb<f32>> =
        picture.pixels.iter().map(|&p| image::Rgb(linear(p, working).max(Rgb::ZERO).to_array())).collect();
    image::codecs::hdr::HdrEncoder::new(out)
        .encode(&pixels, picture.width, picture.height)
        .map_err(from_image(Format::Hdr))
}

/// OpenEXR: linear light as it is, premultiplied, in single precision.
pub(super) fn write_exr(
    picture: &Picture,
    options: &EncodeOptions,
    out: &mut impl Write,
) -> Result<(), EncodeError> {
    let pixel = |at: exr::math::Vec2<usize>| picture.pixels[at.y() * picture.width + at.x()];
    let color = |at| {
        let c = linear(pixel(at), options.working);
        (c.x, c.y, c.z)
    };
    // The encoder wants to seek, which standard output cannot.
    let mut file = Cursor::new(Vec::new());
    let size = (picture.width, picture.height);
    let written = if options.alpha {
        let channels = exr::prelude::SpecificChannels::rgba(|at| {
            let (r, g, b) = color(at);
            (r, g, b, 1.0 - pixel(at)[3])
        });
        exr::prelude::Image::from_channels(size, channels).write().to_buffered(&mut file)
    } else {
        let channels = exr::prelude::SpecificChannels::rgb(color);
        exr::prelude::Image::from_channels(size, channels).write().to_buffered(&mut file)
    };
    written.map_err(refused(Format::Exr))?;
    Ok(out.write_all(file.get_ref())?)
}

fn linear([r, g, b, _]: [f32; 4], working: Option<Curve>) -> Rgb {
    let curve = working.unwrap_or(Curve::Linear);
    Rgb::new(curve.decode(r), curve.decode(g), curve.decode(b))
}
