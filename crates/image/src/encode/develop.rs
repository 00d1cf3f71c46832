//! From light to whole numbers: alpha, gamma, dithering, rounding (language spec, sections 5.5 and 5.6).
use super::dither::{Rounder, rounded};
use super::parallel::in_order;
use super::steps::Steps;
use super::{EncodeOptions, Picture};
use crate::{Bitmap, Curve, FileCurve, Format, Pixels, Rgb, grey};

/// So many pixels are worth a thread's while.
const PIECE: usize = 1 << 16;

/// Turns a picture into the numbers of a file of 8 or 16 bits per channel.
pub fn develop(picture: &Picture, options: &EncodeOptions) -> Bitmap {
    let (bits, wide) = match options.format {
        Format::Png => (options.bits.clamp(5, 16), options.bits > 8),
        Format::Pnm => (options.bits.clamp(1, 16), options.bits > 8),
        _ => (8, false),
    };
    let has_alpha = options.alpha && matches!(options.format, Format::Png | Format::Tga | Format::Bmp);
    let is_grey = options.grey && matches!(options.format, Format::Png | Format::Pnm);
    let max = f32::from(u16::MAX >> (16 - bits));

    let curve = if options.working.is_some() { options.file } else { Curve::Srgb };
    let bitmap = |pixels: Pixels| Bitmap {
        width: picture.width,
        height: picture.height,
        pixels,
        curve: FileCurve::Stated(curve),
        premultiplied: false,
    };
    if bits == 8 && !wide && !has_alpha && !is_grey && options.dither.is_none() {
        let steps = Steps::new(|v| options.working.map_or(v, |working| working.convert(options.file, v)));
        let pieces: Vec<_> = picture.pixels.chunks(PIECE).collect();
        let bytes = in_order(options.threads, pieces.len(), |i| {
            let byte = |&[r, g, b, _]: &[f32; 4]| [steps.byte(r), steps.byte(g), steps.byte(b)];
            pieces[i].iter().map(byte).collect::<Vec<_>>()
        });
        return bitmap(Pixels::Rgb8(bytes.concat()));
    }

    let pixels: Vec<[f32; 4]> =
        picture.pixels.iter().map(|&p| if has_alpha { straight(p) } else { opaque(p) }).collect();
    // A grey map holds plain brightness, whatever the gamma.
    let curves = if is_grey && options.format == Format::Pnm { None } else { options.working };
    let encode = |v: f32| curves.map_or(v, |working| working.convert(options.file, v));
    let decode = |v: f32| curves.map_or(v, |working| options.file.convert(working, v));
    let rounder = Rounder { dither: options.dither, max, encode: &encode, decode: &decode };
    let channel = |get: &dyn Fn(&[f32; 4]) -> f32| rounder.channel(picture.width, pixels.iter().map(get));

    // PNG holds fewer bits by repeating them; a map of pixels says how many there are.
    let fill = options.format == Format::Png;
    let stored = |v: u16| if fill { filled(v, bits, if wide { 16 } else { 8 }) } else { v };
    let alpha = || pixels.iter().map(|p| stored(rounded(p[3], max))).collect::<Vec<u16>>();
    let channels: Vec<Vec<u16>> = if is_grey {
        vec![channel(&|p| grey(Rgb::new(p[0], p[1], p[2])))]
    } else {
        (0..3).map(|c| channel(&move |p| p[c])).collect()
    };
    let mut channels: Vec<Vec<u16>> =
        channels.into_iter().map(|c| c.into_iter().map(stored).collect()).collect();
    if has_alpha {
        channels.push(alpha());
    }
    bitmap(gathered(&channels, wide))
}

/// Colour divided by alpha. Where a colour is brighter than its alpha allows, alpha is raised first.
fn straight([r, g, b, transmit]: [f32; 4]) -> [f32; 4] {
    let brightness = grey(Rgb::new(r, g, b));
    let alpha = (1.0 - transmit).max(brightness.min(1.0)).clamp(0.0, 1.0);
    if alpha > 0.0 { [r / alpha, g / alpha, b / alpha, alpha] } else { [0.0; 4] }
}

fn opaque([r, g, b, _]: [f32; 4]) -> [f32; 4] {
    [r, g, b, 1.0]
}

/// A number of `bits` bits widened to `to` bits by repeating its own from the left.
fn filled(v: u16, bits: u8, to: u8) -> u16 {
    let (v, bits, to) = (u32::from(v), u32::from(bits), u32::from(to));
    let high = v << (to - bits);
    let low = if 2 * bits >= to { v >> (2 * bits - to) } else { v };
    (if bits == to { v } else { high | low }) as u16
}

/// Joins channels to pixels.
fn gathered(channels: &[Vec<u16>], wide: bool) -> Pixels {
    let byte = |v: u16| v as u8;
    match (channels, wide) {
        ([v], false) => Pixels::Grey8(v.iter().map(|&v| byte(v)).collect()),
        ([v], true) => Pixels::Grey16(v.clone()),
        ([v, a], false) => Pixels::GreyAlpha8(v.iter().zip(a).map(|(&v, &a)| [byte(v), byte(a)]).collect()),
        ([v, a], true) => Pixels::GreyAlpha16(v.iter().zip(a).map(|(&v, &a)| [v, a]).collect()),
        ([r, g, b, a], false) => {
            Pixels::Rgba8((0..r.len()).map(|i| [r[i], g[i], b[i], a[i]].map(byte)).collect())
        }
        ([r, g, b, a], true) => Pixels::Rgba16((0..r.len()).map(|i| [r[i], g[i], b[i], a[i]]).collect()),
        ([r, g, b, ..], false) => Pixels::Rgb8((0..r.len()).map(|i| [r[i], g[i], b[i]].map(byte)).collect()),
        ([r, g, b, ..], true) => Pixels::Rgb16((0..r.len()).map(|i| [r[i], g[i], b[i]]).collect()),
        ([], _) => Pixels::Grey8(Vec::new()),
    }
}
