//! Images with their options: `image_map`, `bump_map`, `image_pattern`, `material_map`, height fields
//! (textures spec, section 7; language spec, section 5.4).
use std::sync::Arc;

use raggio_image::{FileCurve, Pixels};
use raggio_scene::{Bitmap, Curve, Function, GammaMode, ImageMap, Interpolation, MapType};

use super::function;
use super::util::{color, comma_float, float, set_flag, vec2, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};

/// What an image is for; only colours are converted by custom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Usage {
    /// `image_map`
    Colors,
    /// `image_pattern`
    Pattern,
    /// `bump_map`
    Bump,
    /// `material_map`
    Material,
}

/// A picture with what was said about its encoding.
pub struct Source {
    /// The samples.
    pub bitmap: Bitmap,
    /// `gamma`, the curve that the scene says the file has.
    pub gamma: Option<Curve>,
    /// `premultiplied`, or what the file says.
    pub premultiplied: bool,
    /// Was it sampled from a function? Then nothing converts it.
    pub sampled: bool,
}

/// `{ image options }`; the word has been read.
pub fn block(p: &mut Parser, usage: Usage) -> Result<Arc<ImageMap>> {
    block_with(p, usage, &mut |_| Ok(false))
}

/// The same with further items.
pub fn block_with(
    p: &mut Parser,
    usage: Usage,
    extra: &mut dyn FnMut(&mut Parser) -> Result<bool>,
) -> Result<Arc<ImageMap>> {
    let mut image = None;
    p.block("image_map", |p| match &mut image {
        None => {
            let source = source(p)?;
            image = Some(image_map(p, source, usage));
            Ok(true)
        }
        Some(image) => Ok(p.accept_punct(',')? || option(p, usage, image)? || extra(p)?),
    })?;
    match image {
        Some(image) => Ok(Arc::new(image)),
        None => p.expected("an image file"),
    }
}

/// An image without options yet.
fn image_map(p: &Parser, source: Source, usage: Usage) -> ImageMap {
    ImageMap {
        conversion: conversion(p, &source, usage),
        premultiplied: source.premultiplied,
        use_index: usage == Usage::Material,
        ..ImageMap::new(source.bitmap.into())
    }
}

/// A file with its encoding, or a function that is sampled.
pub fn source(p: &mut Parser) -> Result<Source> {
    if p.accept(Kw::Function)? {
        let bitmap = sampled(p)?;
        return Ok(Source { bitmap, gamma: None, premultiplied: false, sampled: true });
    }
    old_orientation(p)?;
    let format = word(p)?.filter(|&word| is_format(word));
    if format.is_some() {
        p.next()?;
    }
    let name = p.path()?;
    let bitmap = p.image(&name, format)?;
    let mut source = Source { premultiplied: bitmap.premultiplied, bitmap, gamma: None, sampled: false };
    loop {
        match word(p)? {
            Some(Kw::Gamma) => source.gamma = Some(gamma(p)?),
            Some(Kw::Premultiplied) => {
                set_flag(p, &mut source.premultiplied)?;
            }
            _ => return Ok(source),
        }
    }
}

/// Very old scenes put a map type, a vector or both before the file's type; they have no meaning any more.
fn old_orientation(p: &mut Parser) -> Result<()> {
    while matches!(p.peek()?, Tok::Punct('<') | Tok::Number(_)) {
        let span = p.span();
        p.tuple()?;
        p.comma()?;
        p.warn("old-orientation", "an orientation before the file has no meaning any more", span);
    }
    Ok(())
}

fn is_format(word: Kw) -> bool {
    matches!(
        word,
        Kw::Bmp
            | Kw::Exr
            | Kw::Gif
            | Kw::Hdr
            | Kw::Iff
            | Kw::Jpeg
            | Kw::Pgm
            | Kw::Png
            | Kw::Pot
            | Kw::Ppm
            | Kw::Sys
            | Kw::Tga
            | Kw::Tiff
    )
}

/// `gamma g` or `gamma srgb`
fn gamma(p: &mut Parser) -> Result<Curve> {
    p.next()?;
    if p.accept(Kw::Srgb)? {
        return Ok(Curve::Srgb);
    }
    let span = p.span();
    let g = float(p)?;
    if g <= 0.0 {
        return p.error("bad-gamma", "a gamma must be greater than 0", span);
    }
    Ok(Curve::power(g as f32))
}

/// From what curve to what curve the colours go (table in section 5.4 of the language spec).
fn conversion(p: &Parser, source: &Source, usage: Usage) -> Option<(Curve, Curve)> {
    let GammaMode::Working(working) = p.settings.gamma else {
        let curve = source.gamma.filter(|_| !source.sampled)?;
        return (curve != Curve::Linear).then_some((curve, Curve::Linear));
    };
    let modern = p.settings.version.effective >= 370;
    let (from, to) = match (source.gamma, usage) {
        _ if source.sampled => return None,
        (Some(curve), Usage::Colors) => (curve, working),
        (Some(curve), _) => (curve, Curve::Linear),
        (None, Usage::Colors) => match source.bitmap.curve {
            FileCurve::Stated(curve) => (curve, working),
            FileCurve::CustomSrgb if modern => (Curve::Srgb, working),
            FileCurve::Linear => (Curve::Linear, working),
            FileCurve::CustomSrgb | FileCurve::None => return None,
        },
        (None, _) => return None,
    };
    (from != to).then_some((from, to))
}

/// One option after the file.
fn option(p: &mut Parser, usage: Usage, image: &mut ImageMap) -> Result<bool> {
    let Some(key) = word(p)? else { return Ok(false) };
    match key {
        Kw::Once => return set_flag(p, &mut image.once),
        Kw::Map_type => image.map_type = map_type(p, usage)?,
        Kw::Interpolate => {
            p.next()?;
            image.interpolation = match float(p)? as i64 {
                2 => Interpolation::Bilinear,
                3 => Interpolation::Bicubic,
                4 => Interpolation::NormalizedDistance,
                _ => Interpolation::None,
            };
        }
        Kw::Repeat => {
            p.next()?;
            let span = p.span();
            image.repeat = vec2(p)?;
            if image.repeat.min_element() <= 0.0 {
                return p.error("bad-repeat", "repeat must be greater than 0", span);
            }
        }
        Kw::Offset => {
            p.next()?;
            image.offset = vec2(p)?;
        }
        Kw::Use_index => {
            p.next()?;
            image.use_index = true;
        }
        Kw::Use_color | Kw::Use_colour => {
            p.next()?;
            image.use_index = false;
        }
        Kw::Use_alpha => return set_flag(p, &mut image.use_alpha),
        Kw::Smooth if usage == Usage::Colors => return set_flag(p, &mut image.smooth),
        Kw::Filter => transparency(p, &mut image.filter_all, &mut image.filter_index)?,
        Kw::Transmit => transparency(p, &mut image.transmit_all, &mut image.transmit_index)?,
        Kw::Alpha => {
            let span = p.span();
            p.next()?;
            color(p)?;
            p.warn("old-alpha", "`alpha` in an image has no meaning any more", span);
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// What is no type of map is refused in an `image_map` only; elsewhere the image lies flat.
fn map_type(p: &mut Parser, usage: Usage) -> Result<MapType> {
    p.next()?;
    let span = p.span();
    Ok(match float(p)? as i64 {
        0 => MapType::Planar,
        1 => MapType::Spherical,
        2 => MapType::Cylindrical,
        5 => MapType::Torus,
        _ if usage == Usage::Colors => {
            return p.error("bad-map-type", "map_type must be 0, 1, 2 or 5", span);
        }
        _ => {
            p.warn("bad-map-type", "map_type must be 0, 1, 2 or 5; 0 is taken", span);
            MapType::Planar
        }
    })
}

/// `filter all f` or `filter index, f`; likewise `transmit`.
fn transparency(p: &mut Parser, all: &mut f32, by_index: &mut Vec<(u32, f32)>) -> Result<()> {
    p.next()?;
    if p.accept(Kw::All)? {
        *all = float(p)? as f32;
        return Ok(());
    }
    let index = float(p)?.max(0.0) as u32;
    let amount = comma_float(p)? as f32;
    by_index.push((index, amount));
    Ok(())
}

/// Most samples of a function image.
const MOST_SAMPLES: usize = 1 << 28;

/// `function width, height { body }`, the word having been read: sampled over the unit square, first row on top.
pub fn sampled(p: &mut Parser) -> Result<Bitmap> {
    let span = p.span();
    let [width, height] = sampled_size(p)?;
    if width * height > MOST_SAMPLES {
        return p.error("too-large", format!("a function image of {width} x {height} is too large"), span);
    }
    let function = function::body(p, &[], true)?;
    let pixels = match function.components() {
        1 => Pixels::Grey16(samples(&function, width, height, |f, at| to_16_bits(f.eval(at)))),
        5 => Pixels::Rgba16(samples(&function, width, height, |f, at| {
            let c = f.eval5(at);
            [c[0], c[1], c[2], 1.0 - c[4]].map(to_16_bits)
        })),
        _ => {
            return p.error(
                "bad-function",
                "an image is made of a float function or a pigment function",
                span,
            );
        }
    };
    Ok(Bitmap { width, height, pixels, curve: FileCurve::None, premultiplied: false })
}

fn sampled_size(p: &mut Parser) -> Result<[usize; 2]> {
    let size = |n: f64| (n + 0.5).clamp(1.0, 65_536.0) as usize;
    let width = size(float(p)?);
    let height = size(comma_float(p)?);
    Ok([width, height])
}

fn samples<T>(
    function: &Function,
    width: usize,
    height: usize,
    sample: impl Fn(&Function, &[f64]) -> T,
) -> Vec<T> {
    let place = |i: usize, n: usize| if n > 1 { i as f64 / (n - 1) as f64 } else { 0.0 };
    let at = |i: usize| [place(i % width, width), place(i / width, height), 0.0];
    (0..width * height).map(|i| sample(function, &at(i))).collect()
}

/// Values are cut off, not rounded.
fn to_16_bits(value: f64) -> u16 {
    (value.clamp(0.0, 1.0) * 65_535.0) as u16
}
