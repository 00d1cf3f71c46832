//! The colours of pixels, converted on the way out, so that big pictures keep the size they have in the file.
use std::sync::Arc;

use raggio_image::{Bitmap, Color, Curve, Pixels, Rgb};
use raggio_scene::ImageMap;

/// Colours of a palette: as many as a byte can name.
const PALETTE: usize = 256;

#[derive(Debug)]
pub(super) struct Texels {
    bitmap: Arc<Bitmap>,
    values: Values,
    transparent: bool,
}

/// How stored samples become numbers.
#[derive(Debug)]
enum Values {
    Palette(Box<[Color]>),
    /// One number for each value of a byte or of 16 bits.
    Table(Box<[f32]>),
    /// Sixteen bits without conversion.
    Sixteen,
    Float(Option<(Curve, Curve)>),
}

impl Texels {
    pub fn new(map: &ImageMap) -> Self {
        let bitmap = map.source.bitmap.clone();
        let convert = |c: f32| map.conversion.map_or(c, |(from, to)| from.convert(to, c));
        let table = |max: u32| (0..=max).map(|i| convert(i as f32 / max as f32)).collect();
        let values = match &bitmap.pixels {
            Pixels::Palette { colors, .. } => Values::Palette(palette(map, colors, convert)),
            Pixels::Grey8(_) | Pixels::GreyAlpha8(_) | Pixels::Rgb8(_) | Pixels::Rgba8(_) => {
                Values::Table(table(255))
            }
            Pixels::Grey16(_) | Pixels::GreyAlpha16(_) | Pixels::Rgb16(_) | Pixels::Rgba16(_) => {
                if map.conversion.is_some() { Values::Table(table(65535)) } else { Values::Sixteen }
            }
            Pixels::RgbF32(_) | Pixels::RgbaF32(_) => Values::Float(map.conversion),
        };
        let transparent = match &values {
            Values::Palette(colors) => colors.iter().any(|c| c.filter != 0.0 || c.transmit != 0.0),
            _ => map.filter_all != 0.0 || map.transmit_all != 0.0 || has_alpha(&bitmap.pixels),
        };
        Texels { bitmap, values, transparent }
    }

    /// Does any pixel let light through?
    pub fn is_transparent(&self) -> bool {
        self.transparent
    }

    /// The palette's indices, if there is a palette.
    pub fn indices(&self) -> Option<&[u8]> {
        match &self.bitmap.pixels {
            Pixels::Palette { indices, .. } => Some(indices),
            _ => None,
        }
    }

    /// The colour of pixel `i`, still multiplied by alpha if the file's colours are.
    #[inline]
    pub fn get(&self, i: usize) -> Color {
        let v8 = |c: u8| self.value(usize::from(c));
        let v16 = |c: u16| self.value(usize::from(c));
        let (a8, a16) = (|a: u8| f32::from(a) / 255.0, |a: u16| f32::from(a) / 65535.0);
        let (rgb, alpha) = match &self.bitmap.pixels {
            Pixels::Palette { indices, .. } => return self.palette_color(indices[i]),
            Pixels::Grey8(v) => (Rgb::splat(v8(v[i])), 1.0),
            Pixels::Grey16(v) => (Rgb::splat(v16(v[i])), 1.0),
            Pixels::GreyAlpha8(v) => (Rgb::splat(v8(v[i][0])), a8(v[i][1])),
            Pixels::GreyAlpha16(v) => (Rgb::splat(v16(v[i][0])), a16(v[i][1])),
            Pixels::Rgb8(v) => (Rgb::from(v[i].map(v8)), 1.0),
            Pixels::Rgb16(v) => (Rgb::from(v[i].map(v16)), 1.0),
            Pixels::Rgba8(v) => {
                let [r, g, b, a] = v[i];
                (Rgb::from([r, g, b].map(v8)), a8(a))
            }
            Pixels::Rgba16(v) => {
                let [r, g, b, a] = v[i];
                (Rgb::from([r, g, b].map(v16)), a16(a))
            }
            Pixels::RgbF32(v) => (Rgb::from(v[i].map(|c| self.float(c))), 1.0),
            Pixels::RgbaF32(v) => {
                let [r, g, b, a] = v[i];
                (Rgb::from([r, g, b].map(|c| self.float(c))), a)
            }
        };
        Color { rgb, filter: 0.0, transmit: 1.0 - alpha }
    }

    #[inline]
    fn value(&self, sample: usize) -> f32 {
        match &self.values {
            Values::Table(table) => table[sample],
            _ => sample as f32 / 65535.0,
        }
    }

    fn float(&self, c: f32) -> f32 {
        match self.values {
            Values::Float(Some((from, to))) => from.convert(to, c),
            _ => c,
        }
    }

    fn palette_color(&self, index: u8) -> Color {
        match &self.values {
            Values::Palette(colors) => colors[usize::from(index)],
            _ => Color::BLACK,
        }
    }
}

/// The palette's colours with the scene's `filter` and `transmit` set; missing ones are black.
fn palette(map: &ImageMap, colors: &[[u8; 4]], convert: impl Fn(f32) -> f32) -> Box<[Color]> {
    let unit = |c: u8| f32::from(c) / 255.0;
    let mut palette: Vec<Color> = colors
        .iter()
        .map(|&[r, g, b, a]| Color {
            rgb: Rgb::from([r, g, b].map(|c| convert(unit(c)))),
            filter: map.filter_all,
            transmit: if map.transmit_all == 0.0 { 1.0 - unit(a) } else { map.transmit_all },
        })
        .collect();
    for &(index, filter) in &map.filter_index {
        if let Some(color) = palette.get_mut(index as usize) {
            color.filter = filter;
        }
    }
    for &(index, transmit) in &map.transmit_index {
        if let Some(color) = palette.get_mut(index as usize) {
            color.transmit = transmit;
        }
    }
    palette.resize(PALETTE, Color::BLACK);
    palette.into()
}

fn has_alpha(pixels: &Pixels) -> bool {
    match pixels {
        Pixels::GreyAlpha8(v) => v.iter().any(|p| p[1] != u8::MAX),
        Pixels::GreyAlpha16(v) => v.iter().any(|p| p[1] != u16::MAX),
        Pixels::Rgba8(v) => v.iter().any(|p| p[3] != u8::MAX),
        Pixels::Rgba16(v) => v.iter().any(|p| p[3] != u16::MAX),
        Pixels::RgbaF32(v) => v.iter().any(|p| p[3] != 1.0),
        Pixels::Palette { .. } | Pixels::Grey8(_) | Pixels::Grey16(_) => false,
        Pixels::Rgb8(_) | Pixels::Rgb16(_) | Pixels::RgbF32(_) => false,
    }
}
