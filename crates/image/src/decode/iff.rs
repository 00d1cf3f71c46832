//! IFF pictures of the Amiga: ILBM, rows of bit planes, and its chunky sister PBM (EA IFF 85, "ILBM" and its additions of
//! 1988 and 1992: hold-and-modify, extra half-brite, true colour). Animations, patches of palettes for single rows and
//! sprites are not read.
use super::{DecodeError, checked_size, damaged};
use crate::{Bitmap, FileCurve, Format, Pixels};

/// How a number of the planes becomes a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// An entry of the palette.
    Index,
    /// The same, with a second half of the palette at half the brightness.
    HalfBrite,
    /// An entry of the palette, or the colour at the left with one channel replaced.
    Hold,
    /// Eight planes for each channel.
    True,
    /// A level of grey: there is no palette.
    Grey,
}

/// `BMHD`.
struct Header {
    width: usize,
    height: usize,
    planes: u8,
    /// Does a plane more say which pixels count?
    masked: bool,
    /// The index that shows nothing.
    clear: Option<u8>,
    packed: bool,
    /// One byte for each pixel in place of planes.
    chunky: bool,
}

/// `CAMG`: what the Amiga's screen was set to.
const HAM: u32 = 0x800;
const EHB: u32 = 0x80;

pub(super) fn decode(bytes: &[u8]) -> Result<Bitmap, DecodeError> {
    let error = damaged(Format::Iff);
    let chunky = match bytes.get(8..12) {
        Some(b"ILBM") => false,
        Some(b"PBM ") => true,
        _ => return Err(error("it holds no picture, only ILBM and PBM do")),
    };
    let (mut header, mut colors, mut screen, mut body) = (None, Vec::new(), 0, None);
    for (name, data) in chunks(&bytes[12..]) {
        match name {
            b"BMHD" => header = self::header(data, chunky),
            b"CMAP" => colors = data.as_chunks::<3>().0.to_vec(),
            b"CAMG" => screen = data.first_chunk().map_or(0, |&v| u32::from_be_bytes(v)),
            b"BODY" => {
                body = Some(data);
                break;
            }
            _ => {}
        }
    }
    let header = header.ok_or_else(|| error("there is no header"))?;
    let body = body.ok_or_else(|| error("there are no pixels"))?;
    checked_size(header.width, header.height)?;
    let mode = mode(&header, colors.len(), screen).ok_or_else(|| error("unusual number of planes"))?;
    let pixels = pixels(&header, mode, &colors, body).ok_or_else(|| error("the pixels are cut short"))?;
    let curve = if mode == Mode::True { FileCurve::None } else { FileCurve::CustomSrgb };
    Ok(Bitmap { width: header.width, height: header.height, pixels, curve, premultiplied: false })
}

/// Names and contents; the last may be shorter than it says, and odd ones are followed by a byte that means nothing.
fn chunks(mut data: &[u8]) -> impl Iterator<Item = (&[u8; 4], &[u8])> {
    std::iter::from_fn(move || {
        let (name, rest) = data.split_first_chunk::<4>()?;
        let (&size, rest) = rest.split_first_chunk::<4>()?;
        let size = (u32::from_be_bytes(size) as usize).min(rest.len());
        let (content, rest) = rest.split_at(size);
        data = rest.get(size % 2..).unwrap_or(&[]);
        Some((name, content))
    })
}

fn header(data: &[u8], chunky: bool) -> Option<Header> {
    let data = data.first_chunk::<20>()?;
    let word = |i: usize| usize::from(u16::from_be_bytes([data[i], data[i + 1]]));
    Some(Header {
        width: word(0),
        height: word(2),
        planes: data[8],
        masked: data[9] == 1,
        clear: (data[9] == 2).then_some(data[13]),
        packed: data[10] == 1,
        chunky,
    })
}

fn mode(header: &Header, colors: usize, screen: u32) -> Option<Mode> {
    let hold = screen & HAM != 0;
    Some(match header.planes {
        24 if !header.chunky => Mode::True,
        6 | 8 if hold => Mode::Hold,
        1..=8 if colors == 0 => Mode::Grey,
        // Many programs left out what the screen was set to.
        6 if screen & EHB != 0 || colors == 32 => Mode::HalfBrite,
        1..=8 => Mode::Index,
        _ => return None,
    })
}

/// `None` if the body is too short.
fn pixels(header: &Header, mode: Mode, colors: &[[u8; 3]], body: &[u8]) -> Option<Pixels> {
    let mut rows = Rows { header, bytes: Bytes::new(body, header.packed), row: vec![0; header.width] };
    let height = 0..header.height;
    Some(match mode {
        Mode::Index | Mode::HalfBrite => {
            let mut indices = Vec::new();
            for _ in height {
                indices.extend(rows.next()?.iter().map(|&v| v as u8));
            }
            Pixels::Palette { indices, colors: palette(header, mode, colors) }
        }
        Mode::Grey => {
            let most = (1 << header.planes) - 1;
            let mut levels = Vec::new();
            for _ in height {
                levels.extend(rows.next()?.iter().map(|&v| (v * 255 / most) as u8));
            }
            Pixels::Grey8(levels)
        }
        Mode::True => {
            let mut out = Vec::new();
            for _ in height {
                out.extend(rows.next()?.iter().map(|v| v.to_le_bytes()).map(|[r, g, b, _]| [r, g, b]));
            }
            Pixels::Rgb8(out)
        }
        Mode::Hold => {
            let mut out = Vec::new();
            for _ in height {
                held(rows.next()?, header.planes - 2, colors, &mut out);
            }
            Pixels::Rgb8(out)
        }
    })
}

/// The palette with its second half where it has one.
fn palette(header: &Header, mode: Mode, colors: &[[u8; 3]]) -> Vec<[u8; 4]> {
    let mut colors = colors.to_vec();
    if mode == Mode::HalfBrite {
        colors.resize(32, [0; 3]);
        colors.extend_from_within(..);
        colors[32..].iter_mut().flatten().for_each(|c| *c /= 2);
    }
    colors.truncate(256);
    let alpha = |i: usize| if header.clear.map(usize::from) == Some(i) { 0 } else { 255 };
    colors.iter().enumerate().map(|(i, &[r, g, b])| [r, g, b, alpha(i)]).collect()
}

/// Adds a row of hold-and-modify: two bits say what the other `bits` mean.
fn held(row: &[u32], bits: u8, colors: &[[u8; 3]], out: &mut Vec<[u8; 3]>) {
    let entry = |i: u32| colors.get(i as usize).copied().unwrap_or([0; 3]);
    let mut color = entry(0);
    for &v in row {
        let low = v & ((1 << bits) - 1);
        let level = if bits == 4 { low * 17 } else { low << 2 | low >> 4 } as u8;
        match v >> bits {
            0 => color = entry(low),
            1 => color[2] = level,
            2 => color[0] = level,
            _ => color[1] = level,
        }
        out.push(color);
    }
}

/// The numbers of the pixels, row by row.
struct Rows<'a> {
    header: &'a Header,
    bytes: Bytes<'a>,
    row: Vec<u32>,
}

impl Rows<'_> {
    fn next(&mut self) -> Option<&[u32]> {
        if self.header.chunky {
            for pixel in &mut self.row {
                *pixel = self.bytes.next()?.into();
            }
            if self.header.width % 2 == 1 {
                self.bytes.next()?;
            }
            return Some(&self.row);
        }
        self.row.fill(0);
        let line = self.header.width.div_ceil(16) * 2;
        for plane in 0..self.header.planes {
            for place in 0..line {
                let byte = self.bytes.next()?;
                for (i, pixel) in self.row.iter_mut().skip(8 * place).take(8).enumerate() {
                    *pixel |= u32::from(byte >> (7 - i) & 1) << plane;
                }
            }
        }
        if self.header.masked {
            self.bytes.by_ref().take(line).for_each(drop);
        }
        Some(&self.row)
    }
}

/// The body's bytes, opened if they are packed (ByteRun1): a head, then bytes to take as they are, or one to repeat.
struct Bytes<'a> {
    data: &'a [u8],
    packed: bool,
    /// How many are still to be taken, or to be repeated.
    taken: usize,
    repeated: usize,
    last: u8,
}

impl<'a> Bytes<'a> {
    fn new(data: &'a [u8], packed: bool) -> Self {
        Bytes { data, packed, taken: 0, repeated: 0, last: 0 }
    }

    fn take_one(&mut self) -> Option<u8> {
        let (&first, rest) = self.data.split_first()?;
        self.data = rest;
        Some(first)
    }
}

impl Iterator for Bytes<'_> {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        while self.packed && self.taken == 0 && self.repeated == 0 {
            match self.take_one()? {
                // Means nothing.
                128 => {}
                head if head < 128 => self.taken = usize::from(head) + 1,
                head => {
                    self.repeated = 257 - usize::from(head);
                    self.last = self.take_one()?;
                }
            }
        }
        if self.repeated > 0 {
            self.repeated -= 1;
            return Some(self.last);
        }
        self.taken = self.taken.saturating_sub(1);
        self.take_one()
    }
}
