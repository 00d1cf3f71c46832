//! GIF: the first frame, with its palette; and Fractint's use of it for values of two bytes.
use std::io::Cursor;
use std::num::NonZeroU64;

use super::{DecodeError, MOST_PIXELS, checked_size, damaged};
use crate::{Bitmap, FileCurve, Format, Pixels};

pub(super) fn decode(bytes: &[u8]) -> Result<Bitmap, DecodeError> {
    let error = |e: gif::DecodingError| damaged(Format::Gif)(e);
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::Indexed);
    options.set_memory_limit(match NonZeroU64::new(MOST_PIXELS as u64) {
        Some(limit) => gif::MemoryLimit::Bytes(limit),
        None => gif::MemoryLimit::Unlimited,
    });
    let mut decoder = options.read_info(Cursor::new(bytes)).map_err(error)?;
    let (width, height) = checked_size(decoder.width().into(), decoder.height().into())?;
    let shared = decoder.global_palette().map(<[u8]>::to_vec);
    let background = decoder.bg_color().unwrap_or(0) as u8;
    let frame = decoder.next_frame_info().map_err(error)?.cloned();
    let frame = frame.ok_or_else(|| damaged(Format::Gif)("there is no frame"))?;
    // POV-Ray leaves the rows of interlaced pictures in the order in which they are stored, and so do we.
    let (columns, rows) = checked_size(frame.width.into(), frame.height.into())?;
    let mut stored = vec![0; columns * rows];
    decoder.fill_buffer(&mut stored).map_err(error)?;
    let palette = frame.palette.clone().or(shared).unwrap_or_default();
    let transparent = frame.transparent.map(usize::from);
    let alpha = |i: usize| if transparent == Some(i) { 0 } else { 255 };
    let colors = palette.as_chunks::<3>().0.iter().enumerate();
    let colors = colors.map(|(i, &[r, g, b])| [r, g, b, alpha(i)]).collect();

    let mut indices = vec![background; width * height];
    let left = usize::from(frame.left);
    for (row, source) in stored.chunks_exact(columns).enumerate() {
        let start = (usize::from(frame.top) + row) * width + left;
        let room = columns.min(width.saturating_sub(left));
        if let Some(target) = indices.get_mut(start..start + room) {
            target.copy_from_slice(&source[..room]);
        }
    }
    let pixels = Pixels::Palette { indices, colors };
    Ok(Bitmap { width, height, pixels, curve: FileCurve::CustomSrgb, premultiplied: false })
}

/// The high bytes stand in the left half, the low bytes in the right half.
pub(super) fn decode_potential(bytes: &[u8]) -> Result<Bitmap, DecodeError> {
    let Bitmap { width, height, pixels, .. } = decode(bytes)?;
    let Pixels::Palette { indices, .. } = pixels else { return Err(DecodeError::Unknown) };
    let (half, _) = checked_size(width / 2, height)?;
    let joined = |row: &[u8]| -> Vec<u16> {
        let low = &row[half..];
        row[..half].iter().zip(low).map(|(&high, &low)| u16::from_be_bytes([high, low])).collect()
    };
    let pixels = Pixels::Grey16(indices.chunks_exact(width).flat_map(joined).collect());
    Ok(Bitmap { width: half, height, pixels, curve: FileCurve::None, premultiplied: false })
}
