//! `height_field { image ... }` (shapes spec, section 4).
use std::sync::Arc;

use raggio_image::{Curve, Pixels, grey};
use raggio_scene::{HeightField, Object, Rgb, Shape};

use super::image;
use super::object::{self, nothing, of_shape};
use super::util::{set, set_flag, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `height_field { image [smooth] [water_level w] }`
pub fn height_field(p: &mut Parser) -> Result<Object> {
    object::build(p, "height_field", |p| {
        let source = image::source(p)?;
        let (mut smooth, mut water_level) = (false, 0.0);
        loop {
            match word(p)? {
                Some(Kw::Smooth) => set_flag(p, &mut smooth)?,
                Some(Kw::Water_level) => set(p, &mut water_level)?,
                _ if p.accept_punct(',')? => true,
                _ => break,
            };
        }
        if p.settings.version.language < 200 {
            water_level /= 256.0;
        }
        let (width, depth) = (source.bitmap.width, source.bitmap.height);
        if width < 2 || depth < 2 {
            return Ok(nothing());
        }
        let from_top = heights(&source.bitmap.pixels, source.gamma);
        let heights = from_top.chunks(width).rev().flatten().copied().collect();
        let field = HeightField { width, depth, heights, smooth, water_level };
        Ok(of_shape(Shape::HeightField(Arc::new(field))))
    })
}

/// Heights of all pixels, the image's first row first; `gamma` decodes what can be decoded.
fn heights(pixels: &Pixels, gamma: Option<Curve>) -> Vec<u16> {
    let decode = |v: f32| gamma.map_or(v, |curve| curve.decode(v));
    let level = |v: f32| (65_535.0 * decode(v).clamp(0.0, 1.0)) as u16;
    let byte = |v: u8| f32::from(v) / 255.0;
    let word = |v: u16| f32::from(v) / 65_535.0;
    let fine = |[r, g, b]: [u16; 3]| level(grey(Rgb::new(word(r), word(g), word(b))));
    let coarse = |r: f32, g: f32| (256.0 * (255.0 * r).round() + (255.0 * g).round()) as u16;
    match pixels {
        Pixels::Palette { indices, .. } => indices.iter().map(|&i| u16::from(i) * 256).collect(),
        Pixels::Grey8(v) => v.iter().map(|&v| 257 * grey_byte(decode(byte(v)))).collect(),
        Pixels::Grey16(v) if gamma.is_none() => v.clone(),
        Pixels::Grey16(v) => v.iter().map(|&v| level(word(v))).collect(),
        Pixels::GreyAlpha8(v) => v.iter().map(|&[v, _]| level(byte(v))).collect(),
        Pixels::GreyAlpha16(v) => v.iter().map(|&[v, _]| level(word(v))).collect(),
        Pixels::Rgb8(v) => v.iter().map(|&[r, g, _]| coarse(decode(byte(r)), decode(byte(g)))).collect(),
        Pixels::Rgba8(v) => v.iter().map(|&[r, g, ..]| coarse(decode(byte(r)), decode(byte(g)))).collect(),
        Pixels::Rgb16(v) => v.iter().map(|&c| fine(c)).collect(),
        Pixels::Rgba16(v) => v.iter().map(|&[r, g, b, _]| fine([r, g, b])).collect(),
        Pixels::RgbF32(v) => v.iter().map(|&[r, g, _]| (65_280.0 * r + 255.0 * g) as u16).collect(),
        Pixels::RgbaF32(v) => v.iter().map(|&[r, g, ..]| (65_280.0 * r + 255.0 * g) as u16).collect(),
    }
}

/// A grey of 8 bits goes through the weights of red, green and blue, and may lose one step there.
fn grey_byte(g: f32) -> u16 {
    (255.0 * grey(Rgb::splat(g))) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_follow_the_kind_of_pixels() {
        let palette = Pixels::Palette { indices: vec![3, 255], colors: vec![[0; 4]; 256] };
        assert_eq!(heights(&palette, None), [768, 65_280]);
        assert_eq!(heights(&Pixels::Rgb8(vec![[7, 9, 200]]), None), [7 * 256 + 9]);
        assert_eq!(heights(&Pixels::Grey16(vec![12_345]), None), [12_345]);
        assert_eq!(heights(&Pixels::RgbF32(vec![[0.5, 0.25, 0.0]]), None), [32_703]);
        let grey = heights(&Pixels::Grey8((0..=255).collect()), None);
        assert!(grey.iter().enumerate().all(|(v, &h)| h as usize == 257 * v || h as usize + 257 == 257 * v));
    }
}
