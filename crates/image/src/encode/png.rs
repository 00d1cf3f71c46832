//! PNG: rows are filtered and packed in strips, by as many threads as are allowed. The file does not depend on how many.
use std::borrow::Cow;
use std::io::Write;

use flate2::{Compress, Compression, FlushCompress};

use super::EncodeError;
use super::files::{SOFTWARE, refused, size};
use super::parallel::in_order;
use crate::{Bitmap, Curve, FileCurve, Format, Pixels};

/// Bytes of pixels in a strip, about: enough that its beginning, which knows nothing of what came before, does not matter.
const STRIP: usize = 256 << 10;
/// A fifth of the usual level's time, for files a tenth larger.
const LEVEL: u32 = 2;
/// Two bytes that say: packed by deflate with a window of 32 KiB, quickly.
const ZLIB: [u8; 2] = [0x78, 0x01];

/// Writes a bitmap of whole numbers as PNG, with the chunks that its curve asks for. Palettes become colours. At most so
/// many `threads` work at it; 0 means all that the machine has.
pub fn write_png(bitmap: &Bitmap, threads: usize, out: &mut impl Write) -> Result<(), EncodeError> {
    let (width, height) = size(bitmap, Format::Png)?;
    let wide = |v: &[u16]| v.iter().flat_map(|v| v.to_be_bytes()).collect::<Vec<u8>>();
    let (color, depth, data): (_, _, Cow<[u8]>) = match &bitmap.pixels {
        Pixels::Grey8(v) => (png::ColorType::Grayscale, 8, v.into()),
        Pixels::Grey16(v) => (png::ColorType::Grayscale, 16, wide(v).into()),
        Pixels::GreyAlpha8(v) => (png::ColorType::GrayscaleAlpha, 8, v.as_flattened().into()),
        Pixels::GreyAlpha16(v) => (png::ColorType::GrayscaleAlpha, 16, wide(v.as_flattened()).into()),
        Pixels::Rgb8(v) => (png::ColorType::Rgb, 8, v.as_flattened().into()),
        Pixels::Rgb16(v) => (png::ColorType::Rgb, 16, wide(v.as_flattened()).into()),
        Pixels::Rgba16(v) => (png::ColorType::Rgba, 16, wide(v.as_flattened()).into()),
        other => (png::ColorType::Rgba, 8, other.rgba8().into_iter().flatten().collect::<Vec<u8>>().into()),
    };
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(color);
    encoder.set_depth(if depth == 16 { png::BitDepth::Sixteen } else { png::BitDepth::Eight });
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
    let pixel = color.samples() * depth / 8;
    for part in packed(&data, pixel * bitmap.width, pixel, threads).map_err(refused(Format::Png))? {
        writer.write_chunk(png::chunk::IDAT, &part).map_err(error)?;
    }
    writer.finish().map_err(error)
}

/// A strip, packed, with the length and the check sum of what was packed.
struct Strip {
    bytes: Vec<u8>,
    length: usize,
    sum: Adler,
}

/// Rows of `line` bytes as a packed stream, in parts.
fn packed(
    data: &[u8],
    line: usize,
    pixel: usize,
    threads: usize,
) -> Result<Vec<Vec<u8>>, flate2::CompressError> {
    let rows = (STRIP / line.max(1)).max(1);
    let count = data.len().div_ceil(line * rows);
    let strips = in_order(threads, count, |i| {
        let start = i * rows * line;
        let end = data.len().min(start + rows * line);
        strip(data, start..end, line, pixel, i + 1 == count)
    });
    let (mut sum, mut parts) = (Adler::default(), vec![ZLIB.to_vec()]);
    for strip in strips {
        let strip = strip?;
        sum = sum.followed_by(strip.sum, strip.length);
        parts.push(strip.bytes);
    }
    parts.push(sum.to_bytes().to_vec());
    Ok(parts)
}

fn strip(
    data: &[u8],
    range: std::ops::Range<usize>,
    line: usize,
    pixel: usize,
    last: bool,
) -> Result<Strip, flate2::CompressError> {
    let mut filter = Filter::new(line, pixel);
    let mut filtered = Vec::with_capacity(range.len() + range.len() / line);
    let nothing = vec![0; line];
    for start in range.step_by(line) {
        let above = start.checked_sub(line).map_or(&nothing[..], |above| &data[above..start]);
        filter.add(&data[start..start + line], above, &mut filtered);
    }
    let mut packer = Compress::new(Compression::new(LEVEL), false);
    let flush = if last { FlushCompress::Finish } else { FlushCompress::Sync };
    let mut bytes = Vec::new();
    // What is full has to grow; a flush is done where room is left.
    while bytes.len() == bytes.capacity() || packer.total_in() < filtered.len() as u64 || bytes.is_empty() {
        bytes.reserve(filtered.len() / 2 + 1024);
        let done = packer.total_in() as usize;
        packer.compress_vec(&filtered[done..], &mut bytes, flush)?;
    }
    Ok(Strip { bytes, length: filtered.len(), sum: Adler::of(&filtered) })
}

/// Chooses for each row between three of PNG's filters.
struct Filter {
    pixel: usize,
    left: Vec<u8>,
    above: Vec<u8>,
    paeth: Vec<u8>,
}

impl Filter {
    fn new(line: usize, pixel: usize) -> Self {
        Filter { pixel, left: vec![0; line], above: vec![0; line], paeth: vec![0; line] }
    }

    /// Adds a row, filtered so that the sum of its bytes' sizes is least.
    fn add(&mut self, row: &[u8], above: &[u8], out: &mut Vec<u8>) {
        let pixel = self.pixel;
        for ((out, &x), &b) in self.above.iter_mut().zip(row).zip(above) {
            *out = x.wrapping_sub(b);
        }
        self.left[..pixel].copy_from_slice(&row[..pixel]);
        self.paeth[..pixel].copy_from_slice(&self.above[..pixel]);
        for ((out, &x), &a) in self.left[pixel..].iter_mut().zip(&row[pixel..]).zip(row) {
            *out = x.wrapping_sub(a);
        }
        let near = row.iter().zip(&above[pixel..]).zip(above);
        for ((out, &x), ((&a, &b), &c)) in self.paeth[pixel..].iter_mut().zip(&row[pixel..]).zip(near) {
            *out = x.wrapping_sub(paeth(a, b, c));
        }
        let size = |row: &[u8]| row.iter().map(|&b| u32::from((b as i8).unsigned_abs())).sum::<u32>();
        let (left, up, paeth) = (size(&self.left), size(&self.above), size(&self.paeth));
        let (number, best) = if left <= up && left <= paeth {
            (1, &self.left)
        } else if up <= paeth {
            (2, &self.above)
        } else {
            (4, &self.paeth)
        };
        out.push(number);
        out.extend_from_slice(best);
    }
}

/// Of the pixels at the left, above and above left that which is nearest to left + above - above left (PNG, 9.4).
#[inline]
fn paeth(a: u8, b: u8, c: u8) -> u8 {
    let (wide_a, wide_b, wide_c) = (i16::from(a), i16::from(b), i16::from(c));
    let (to_a, to_b) = ((wide_b - wide_c).abs(), (wide_a - wide_c).abs());
    let to_c = (wide_a + wide_b - 2 * wide_c).abs();
    if to_a <= to_b && to_a <= to_c {
        a
    } else if to_b <= to_c {
        b
    } else {
        c
    }
}

/// The check sum of zlib (RFC 1950): a sum of all bytes, and the sum of that sum after each byte.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Adler {
    sum: u64,
    sums: u64,
}

impl Default for Adler {
    fn default() -> Self {
        Adler { sum: 1, sums: 0 }
    }
}

impl Adler {
    const MODULUS: u64 = 65_521;

    fn of(data: &[u8]) -> Adler {
        // So many bytes cannot overflow.
        const PART: usize = 1 << 16;
        data.chunks(PART).fold(Adler::default(), |all, part| {
            let (mut sum, mut sums) = (0, 0);
            for (i, &byte) in part.iter().enumerate() {
                sum += u64::from(byte);
                sums += u64::from(byte) * (part.len() - i) as u64;
            }
            all.followed_by(Adler { sum: sum + 1, sums: sums + part.len() as u64 }, part.len())
        })
    }

    /// The sum of these bytes and of `length` more, whose own sum is `next`.
    fn followed_by(self, next: Adler, length: usize) -> Adler {
        let length = length as u64 % Self::MODULUS;
        let before = self.sum + Self::MODULUS - 1;
        Adler {
            sum: (before + next.sum) % Self::MODULUS,
            sums: (self.sums + next.sums + before % Self::MODULUS * length) % Self::MODULUS,
        }
    }

    fn to_bytes(self) -> [u8; 4] {
        ((self.sums << 16 | self.sum) as u32).to_be_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_parts_are_the_sum_of_all() {
        // RFC 1950's sum of a known text.
        assert_eq!(Adler::of(b"Wikipedia").to_bytes(), [0x11, 0xe6, 0x03, 0x98]);
        let data: Vec<u8> = (0..200_000u32).map(|i| (i.wrapping_mul(i) >> 3) as u8).collect();
        for cut in [0, 1, 65_521, 131_072, 199_999] {
            let (a, b) = data.split_at(cut);
            assert_eq!(Adler::of(a).followed_by(Adler::of(b), b.len()), Adler::of(&data), "{cut}");
        }
    }

    #[test]
    fn many_strips_read_back_and_do_not_depend_on_threads() {
        let noise = |i: usize| (i.wrapping_mul(2_654_435_761) >> 13) as u8;
        for (width, height) in [(1, 1), (3, 700), (900, 400)] {
            let count = width * height;
            let smooth: Vec<[u8; 3]> = (0..count).map(|i| [i as u8, (i / width) as u8, 7]).collect();
            let rough: Vec<[u8; 3]> = (0..count).map(|i| [noise(i), noise(i + 99), noise(i ^ 77)]).collect();
            for pixels in [Pixels::Rgb8(smooth), Pixels::Rgb8(rough)] {
                let curve = FileCurve::Stated(Curve::Srgb);
                let bitmap = Bitmap { width, height, pixels, curve, premultiplied: false };
                let file = |threads| {
                    let mut out = Vec::new();
                    write_png(&bitmap, threads, &mut out).expect("a file");
                    out
                };
                let one = file(1);
                assert_eq!(crate::decode(&one, None).expect("a picture").pixels, bitmap.pixels);
                assert_eq!(one, file(3));
            }
        }
    }
}
