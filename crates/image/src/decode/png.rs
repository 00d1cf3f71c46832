//! PNG: all depths, palettes as palettes, and what the chunks say about gamma.
use std::io::Cursor;

use png::{BitDepth, ColorType, Info, Transformations};

use super::{DecodeError, checked_size, damaged, grouped, grouped16};
use crate::{Bitmap, Curve, FileCurve, Format, Pixels};

pub(super) fn decode(bytes: &[u8]) -> Result<Bitmap, DecodeError> {
    let error = |e: png::DecodingError| damaged(Format::Png)(e);
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    let info = decoder.read_header_info().map_err(error)?;
    let (width, height) = checked_size(info.width as usize, info.height as usize)?;
    let palette = info.color_type == ColorType::Indexed;
    decoder.set_transformations(if palette { Transformations::IDENTITY } else { Transformations::EXPAND });
    let mut reader = decoder.read_info().map_err(error)?;
    let size = reader.output_buffer_size().ok_or(DecodeError::Size(width, height))?;
    let mut buffer = vec![0; size];
    let frame = reader.next_frame(&mut buffer).map_err(error)?;
    buffer.truncate(frame.buffer_size());
    let pixels = if palette {
        indexed(&buffer, width, frame.line_size, reader.info())
    } else {
        direct(&buffer, frame.color_type, frame.bit_depth)
    };
    Ok(Bitmap { width, height, pixels, curve: curve(reader.info()), premultiplied: false })
}

/// The sRGB chunk, else the gAMA chunk, else the custom of the format.
fn curve(info: &Info) -> FileCurve {
    match (info.srgb, info.gama_chunk) {
        (Some(_), _) => FileCurve::Stated(Curve::Srgb),
        (None, Some(g)) if g.into_value() > 0.0 => FileCurve::Stated(Curve::power(1.0 / g.into_value())),
        _ => FileCurve::CustomSrgb,
    }
}

fn direct(buffer: &[u8], color: ColorType, depth: BitDepth) -> Pixels {
    if depth == BitDepth::Sixteen {
        let wide: Vec<u16> = buffer.as_chunks::<2>().0.iter().map(|&b| u16::from_be_bytes(b)).collect();
        return match color {
            ColorType::Grayscale | ColorType::Indexed => Pixels::Grey16(wide),
            ColorType::GrayscaleAlpha => Pixels::GreyAlpha16(grouped16(&wide)),
            ColorType::Rgb => Pixels::Rgb16(grouped16(&wide)),
            ColorType::Rgba => Pixels::Rgba16(grouped16(&wide)),
        };
    }
    match color {
        ColorType::Grayscale | ColorType::Indexed => Pixels::Grey8(buffer.to_vec()),
        ColorType::GrayscaleAlpha => Pixels::GreyAlpha8(grouped(buffer)),
        ColorType::Rgb => Pixels::Rgb8(grouped(buffer)),
        ColorType::Rgba => Pixels::Rgba8(grouped(buffer)),
    }
}

/// Unpacks indices of 1, 2, 4 or 8 bits and joins the palette with its transparency.
fn indexed(buffer: &[u8], width: usize, line_size: usize, info: &Info) -> Pixels {
    let bits = info.bit_depth as usize;
    let per_byte = 8 / bits.clamp(1, 8);
    let mask = ((1u16 << bits) - 1) as u8;
    let index = |line: &[u8], x: usize| {
        let shift = 8 - bits - (x % per_byte) * bits;
        (line[x / per_byte] >> shift) & mask
    };
    let indices = buffer
        .chunks_exact(line_size.max(1))
        .flat_map(|line| (0..width).map(move |x| index(line, x)))
        .collect();
    let alpha = info.trns.as_deref().unwrap_or(&[]);
    let colors = info.palette.as_deref().unwrap_or(&[]).as_chunks::<3>().0;
    let colors = colors.iter().enumerate();
    let colors = colors.map(|(i, &[r, g, b])| [r, g, b, alpha.get(i).copied().unwrap_or(255)]).collect();
    Pixels::Palette { indices, colors }
}
