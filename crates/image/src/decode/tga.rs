//! Targa: palettes, grey and colour, raw or run-length encoded (Truevision TGA file format, version 2.0).
use super::{DecodeError, checked_size, damaged};
use crate::{Bitmap, FileCurve, Format, Pixels};

/// The header's fields that matter.
struct Header {
    kind: u8,
    run_length: bool,
    first_color: usize,
    colors: usize,
    color_bits: u8,
    width: usize,
    height: usize,
    bits: u8,
    top_down: bool,
    right_to_left: bool,
}

/// The header's length.
const HEADER: usize = 18;

pub(super) fn decode(bytes: &[u8]) -> Result<Bitmap, DecodeError> {
    let error = damaged(Format::Tga);
    let header = header(bytes).ok_or_else(|| error("the header is cut short"))?;
    checked_size(header.width, header.height)?;
    let palette_bytes = header.colors * usize::from(header.color_bits.div_ceil(8));
    let start = HEADER + usize::from(bytes[0]);
    let palette = bytes.get(start..start + palette_bytes).ok_or_else(|| error("the palette is cut short"))?;
    let size = usize::from(header.bits.div_ceil(8));
    if !matches!((header.kind, header.bits), (1 | 3, 8) | (2, 15 | 16 | 24 | 32)) {
        return Err(error("unusual depth or kind of picture"));
    }
    let data = samples(&bytes[start + palette_bytes..], &header, size)
        .ok_or_else(|| error("the pixels are cut short"))?;
    let pixels = match header.kind {
        1 => {
            let unused = vec![[0, 0, 0, 255]; header.first_color.min(256)];
            let size = usize::from(header.color_bits.div_ceil(8)).max(1);
            let used = palette.chunks_exact(size).map(|c| color(c, header.color_bits));
            Pixels::Palette { indices: data, colors: unused.into_iter().chain(used).take(256).collect() }
        }
        3 => Pixels::Grey8(data),
        _ if header.bits == 32 => Pixels::Rgba8(data.chunks_exact(4).map(|c| color(c, 32)).collect()),
        _ => Pixels::Rgb8(
            data.chunks_exact(size).map(|c| color(c, header.bits)).map(|[r, g, b, _]| [r, g, b]).collect(),
        ),
    };
    Ok(Bitmap {
        width: header.width,
        height: header.height,
        pixels,
        curve: FileCurve::CustomSrgb,
        premultiplied: false,
    })
}

fn header(b: &[u8]) -> Option<Header> {
    let b = b.get(..HEADER)?;
    let word = |i: usize| usize::from(u16::from_le_bytes([b[i], b[i + 1]]));
    let has_palette = b[1] == 1;
    Some(Header {
        kind: b[2] & 7,
        run_length: b[2] & 8 != 0,
        first_color: if has_palette { word(3) } else { 0 },
        colors: if has_palette { word(5) } else { 0 },
        color_bits: b[7],
        width: word(12),
        height: word(14),
        bits: b[16],
        top_down: b[17] & 0x20 != 0,
        right_to_left: b[17] & 0x10 != 0,
    })
}

/// The samples of `size` bytes each in picture order: rows from the top, columns from the left.
fn samples(data: &[u8], header: &Header, size: usize) -> Option<Vec<u8>> {
    let wanted = header.width * header.height * size;
    let mut out =
        if header.run_length { unpacked(data, wanted, size)? } else { data.get(..wanted)?.to_vec() };
    let line = header.width * size;
    if header.right_to_left {
        for row in out.chunks_exact_mut(line) {
            row.reverse();
            row.chunks_exact_mut(size).for_each(<[u8]>::reverse);
        }
    }
    if !header.top_down {
        out = out.chunks_exact(line).rev().flatten().copied().collect();
    }
    Some(out)
}

/// Opens packets: a head, then either one sample to repeat or several to take as they are.
fn unpacked(mut data: &[u8], wanted: usize, size: usize) -> Option<Vec<u8>> {
    let mut out = Vec::new();
    while out.len() < wanted {
        let (&head, rest) = data.split_first()?;
        let count = usize::from(head & 0x7f) + 1;
        let repeated = head & 0x80 != 0;
        let (sample, rest) = rest.split_at_checked(if repeated { size } else { size * count })?;
        for _ in 0..if repeated { count } else { 1 } {
            out.extend_from_slice(sample);
        }
        data = rest;
    }
    out.truncate(wanted);
    Some(out)
}

/// A colour as red, green, blue, alpha.
fn color(c: &[u8], bits: u8) -> [u8; 4] {
    match (bits, c) {
        (15 | 16, &[low, high]) => {
            let v = u16::from_le_bytes([low, high]);
            let channel = |shift: u16| {
                let five = (v >> shift & 31) as u8;
                five << 3 | five >> 2
            };
            [channel(10), channel(5), channel(0), 255]
        }
        (_, &[b, g, r, a]) => [r, g, b, a],
        (_, &[b, g, r]) => [r, g, b, 255],
        _ => [0, 0, 0, 255],
    }
}
