//! Targa files, raw or run-length encoded; rows from the top (Truevision TGA file format, version 2.0).
use std::io::Write;

use super::EncodeError;
use crate::{Bitmap, Format, Pixels};

/// The longest packet.
const PACKET: usize = 128;

pub(super) fn write(bitmap: &Bitmap, run_length: bool, out: &mut impl Write) -> Result<(), EncodeError> {
    let size =
        |n: usize| u16::try_from(n).map_err(|_| EncodeError::Size(bitmap.width, bitmap.height, Format::Tga));
    let (width, height) = (size(bitmap.width)?.to_le_bytes(), size(bitmap.height)?.to_le_bytes());
    let has_alpha = matches!(bitmap.pixels, Pixels::Rgba8(_));
    let samples = if has_alpha { 4 } else { 3 };
    let kind = if run_length { 10 } else { 2 };
    let mut header = [0; 18];
    header[2] = kind;
    header[12..14].copy_from_slice(&width);
    header[14..16].copy_from_slice(&height);
    header[16] = 8 * samples as u8;
    header[17] = if has_alpha { 0x28 } else { 0x20 };
    out.write_all(&header)?;

    let pixels: Vec<[u8; 4]> = bitmap.pixels.rgba8().into_iter().map(|[r, g, b, a]| [b, g, r, a]).collect();
    for row in pixels.chunks(bitmap.width) {
        if run_length {
            write_packets(row, samples, out)?;
        } else {
            row.iter().try_for_each(|p| out.write_all(&p[..samples]))?;
        }
    }
    Ok(())
}

/// A row as packets: equal neighbours once with their number, others as they are.
fn write_packets(mut row: &[[u8; 4]], samples: usize, out: &mut impl Write) -> std::io::Result<()> {
    while let Some(first) = row.first() {
        let run = row.iter().take(PACKET).take_while(|p| *p == first).count();
        let count = if run > 1 {
            out.write_all(&[0x80 | (run - 1) as u8])?;
            out.write_all(&first[..samples])?;
            run
        } else {
            let differing = row.windows(2).take(PACKET - 1).take_while(|w| w[0] != w[1]).count();
            let count = if differing + 1 == row.len() { row.len() } else { differing.max(1) };
            let count = count.min(PACKET);
            out.write_all(&[(count - 1) as u8])?;
            row[..count].iter().try_for_each(|p| out.write_all(&p[..samples]))?;
            count
        };
        row = &row[count..];
    }
    Ok(())
}
