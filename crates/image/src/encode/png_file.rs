//! PNG files, filtered and compressed in strips by as many threads as are given; the bytes do not depend on how many.
use std::borrow::Cow;
use std::io::Write;

use flate2::{Compress, Compression, FlushCompress};
use simd_adler32::Adler32;

use super::EncodeError;
use super::files::{refused, size};
use super::parallel::in_parallel;
use crate::{Bitmap, Curve, FileCurve, Format, Pixels};

/// What files say about their maker.
pub(super) const SOFTWARE: &str = "Raggio";

/// A fifth of the usual level's time, for files a tenth larger.
const LEVEL: u32 = 2;

/// About so many bytes make a strip.
const STRIP: usize = 1 << 18;

/// How the samples of a bitmap lie in the file.
struct Layout<'a> {
    color: png::ColorType,
    wide: bool,
    data: Cow<'a, [u8]>,
    pixel_bytes: usize,
}

/// Writes a bitmap of whole numbers as PNG, with the chunks that its curve asks for. Palettes become colours. At most
/// so many `threads` work on it; 0 stands for one for each processor.
pub fn write_png(bitmap: &Bitmap, threads: usize, out: &mut impl Write) -> Result<(), EncodeError> {
    let (width, height) = size(bitmap, Format::Png)?;
    let layout = layout(&bitmap.pixels);
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(layout.color);
    encoder.set_depth(if layout.wide { png::BitDepth::Sixteen } else { png::BitDepth::Eight });
    match bitmap.curve {
        FileCurve::Stated(Curve::Power(g)) => encoder.set_source_gamma(png::ScaledFloat::new(1.0 / g)),
        FileCurve::Stated(Curve::Linear) | FileCurve::Linear => {
            encoder.set_source_gamma(png::ScaledFloat::new(1.0));
        }
        _ => encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual),
    }
    let error = |e: png::EncodingError| match e {
        png::EncodingError::IoError(e) => EncodeError::Io(e),
        other => refused(Format::Png)(other),
    };
    encoder.add_text_chunk("Software".to_owned(), SOFTWARE.to_owned()).map_err(error)?;
    let mut writer = encoder.write_header().map_err(error)?;
    let row_bytes = bitmap.width * layout.pixel_bytes;
    let strips = compressed(&layout.data, row_bytes, layout.pixel_bytes, threads)
        .map_err(|e| refused(Format::Png)(e.to_string()))?;
    for strip in strips {
        writer.write_chunk(png::chunk::IDAT, &strip).map_err(error)?;
    }
    writer.finish().map_err(error)
}

fn layout(pixels: &Pixels) -> Layout<'_> {
    use png::ColorType::{Grayscale, GrayscaleAlpha, Rgb, Rgba};
    let wide = |v: &[u16]| v.iter().flat_map(|v| v.to_be_bytes()).collect::<Vec<u8>>();
    let (color, wide, data): (_, _, Cow<'_, [u8]>) = match pixels {
        Pixels::Grey8(v) => (Grayscale, false, v.into()),
        Pixels::Grey16(v) => (Grayscale, true, wide(v).into()),
        Pixels::GreyAlpha8(v) => (GrayscaleAlpha, false, v.as_flattened().into()),
        Pixels::GreyAlpha16(v) => (GrayscaleAlpha, true, wide(v.as_flattened()).into()),
        Pixels::Rgb8(v) => (Rgb, false, v.as_flattened().into()),
        Pixels::Rgb16(v) => (Rgb, true, wide(v.as_flattened()).into()),
        Pixels::Rgba16(v) => (Rgba, true, wide(v.as_flattened()).into()),
        other => (Rgba, false, other.rgba8().into_iter().flatten().collect::<Vec<u8>>().into()),
    };
    Layout { color, wide, data, pixel_bytes: color.samples() << u32::from(wide) }
}

/// The rows as one zlib stream (RFC 1950) in pieces.
fn compressed(
    data: &[u8],
    row_bytes: usize,
    pixel_bytes: usize,
    threads: usize,
) -> Result<Vec<Vec<u8>>, flate2::CompressError> {
    let strip_bytes = (STRIP / row_bytes).max(1) * row_bytes;
    let starts: Vec<usize> = (0..data.len()).step_by(strip_bytes).collect();
    let strip = |i: usize| {
        let end = (starts[i] + strip_bytes).min(data.len());
        let above = starts[i].checked_sub(row_bytes).map(|above| &data[above..starts[i]]);
        let filtered = filtered(&data[starts[i]..end], above, row_bytes, pixel_bytes);
        let flush = if end == data.len() { FlushCompress::Finish } else { FlushCompress::Sync };
        deflated(&filtered, flush).map(|pressed| (filtered, pressed))
    };
    let mut sum = Adler32::new();
    let mut pieces = vec![vec![0x78, 0x01]];
    for strip in in_parallel(starts.len(), threads, strip) {
        let (filtered, pressed) = strip?;
        sum.write(&filtered);
        pieces.push(pressed);
    }
    pieces.push(sum.finish().to_be_bytes().to_vec());
    Ok(pieces)
}

fn deflated(data: &[u8], flush: FlushCompress) -> Result<Vec<u8>, flate2::CompressError> {
    let mut compress = Compress::new(Compression::new(LEVEL), false);
    let mut out = Vec::with_capacity(data.len() / 2 + 64);
    loop {
        let read = compress.total_in() as usize;
        compress.compress_vec(&data[read..], &mut out, flush)?;
        // Room left over says that everything has been put out.
        if out.len() < out.capacity() {
            return Ok(out);
        }
        out.reserve(data.len() / 4 + 64);
    }
}

/// Rows with the filters that leave the smallest differences, each after its filter's number (PNG specification,
/// section 9). `above` is the row before the first.
fn filtered(rows: &[u8], above: Option<&[u8]>, row_bytes: usize, pixel_bytes: usize) -> Vec<u8> {
    let mut out = Vec::with_capacity(rows.len() + rows.len() / row_bytes);
    let nothing = vec![0; row_bytes];
    let mut above = above.unwrap_or(&nothing);
    let mut tries = [vec![0; row_bytes], vec![0; row_bytes], vec![0; row_bytes]];
    for row in rows.chunks_exact(row_bytes) {
        sub(row, pixel_bytes, &mut tries[0]);
        up(row, above, &mut tries[1]);
        paeth(row, above, pixel_bytes, &mut tries[2]);
        let best = (0..3).min_by_key(|&i| weight(&tries[i])).unwrap_or(0);
        out.push([1, 2, 4][best]);
        out.extend_from_slice(&tries[best]);
        above = row;
    }
    out
}

/// The sum of the bytes as distances from 0.
fn weight(row: &[u8]) -> u32 {
    row.iter().map(|&v| u32::from(v.min(v.wrapping_neg()))).sum()
}

fn sub(row: &[u8], pixel_bytes: usize, out: &mut [u8]) {
    let (first, rest) = out.split_at_mut(pixel_bytes);
    first.copy_from_slice(&row[..pixel_bytes]);
    for ((out, &v), &left) in rest.iter_mut().zip(&row[pixel_bytes..]).zip(row) {
        *out = v.wrapping_sub(left);
    }
}

fn up(row: &[u8], above: &[u8], out: &mut [u8]) {
    for ((out, &v), &above) in out.iter_mut().zip(row).zip(above) {
        *out = v.wrapping_sub(above);
    }
}

fn paeth(row: &[u8], above: &[u8], pixel_bytes: usize, out: &mut [u8]) {
    let (first, rest) = out.split_at_mut(pixel_bytes);
    up(&row[..pixel_bytes], &above[..pixel_bytes], first);
    let before = row.iter().zip(above);
    let here = row[pixel_bytes..].iter().zip(&above[pixel_bytes..]);
    for ((out, (&v, &b)), (&a, &c)) in rest.iter_mut().zip(here).zip(before) {
        *out = v.wrapping_sub(predicted(a, b, c));
    }
}

/// Of left, above and above left that which is nearest to left + above - above left.
#[inline]
fn predicted(a: u8, b: u8, c: u8) -> u8 {
    let (x, y, z) = (i16::from(a), i16::from(b), i16::from(c));
    let (to_a, to_b, to_c) = ((y - z).abs(), (x - z).abs(), (x + y - 2 * z).abs());
    let other = if to_b <= to_c { b } else { c };
    if to_a <= to_b && to_a <= to_c { a } else { other }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(i: usize) -> u8 {
        ((i * i + 7 * i) ^ (i >> 3)) as u8
    }

    /// Smooth in parts, noisy in others.
    fn picture(width: usize, height: usize) -> Bitmap {
        let pixel = |i: usize| {
            let (x, y) = (i % width, i / width);
            if (x / 50 + y / 30).is_multiple_of(2) {
                [x as u8, y as u8, 9]
            } else {
                [noise(i), 3, noise(i / 2)]
            }
        };
        let pixels = Pixels::Rgb8((0..width * height).map(pixel).collect());
        Bitmap { width, height, pixels, curve: FileCurve::Stated(Curve::Srgb), premultiplied: false }
    }

    #[test]
    fn pictures_of_many_strips_come_back_and_threads_change_no_byte() {
        for (width, height) in [(1, 1), (3, 2), (640, 480), (100_000, 7)] {
            let bitmap = picture(width, height);
            let mut files = [1, 2, 5].map(|threads| {
                let mut file = Vec::new();
                write_png(&bitmap, threads, &mut file).expect("written");
                file
            });
            assert!(files[1..].iter().all(|file| *file == files[0]));
            let mut reader = png::Decoder::new(std::io::Cursor::new(&mut files[0])).read_info().expect("PNG");
            let mut back = vec![0; reader.output_buffer_size().expect("a size")];
            reader.next_frame(&mut back).expect("a picture");
            let Pixels::Rgb8(pixels) = &bitmap.pixels else { unreachable!("made so") };
            assert_eq!(back, pixels.as_flattened());
        }
    }

    #[test]
    fn filters_obey_their_definitions() {
        let row: Vec<u8> = (0..90).map(|i| noise(i * 3)).collect();
        let above: Vec<u8> = (0..90).map(|i| noise(i * 5 + 1)).collect();
        let at = |row: &[u8], i: usize| i.checked_sub(3).map_or(0, |i| row[i]);
        let mut out = vec![0; 90];
        sub(&row, 3, &mut out);
        assert!((0..90).all(|i| out[i].wrapping_add(at(&row, i)) == row[i]));
        up(&row, &above, &mut out);
        assert!((0..90).all(|i| out[i].wrapping_add(above[i]) == row[i]));
        paeth(&row, &above, 3, &mut out);
        for i in 0..90 {
            let (a, b, c) = (at(&row, i), above[i], at(&above, i));
            let p = i32::from(a) + i32::from(b) - i32::from(c);
            let nearest = [a, b, c].into_iter().min_by_key(|&v| (p - i32::from(v)).abs()).expect("three");
            assert_eq!(out[i].wrapping_add(nearest), row[i], "{i}");
        }
    }
}
