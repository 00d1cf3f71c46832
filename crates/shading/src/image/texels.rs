//! The colours of pixels, converted on the way out, so that big pictures keep the size they have in the file.
use std::sync::Arc;

use raggio_image::{Color, Curve, Mosaic, Pixels, Rgb};
use raggio_scene::ImageMap;

use super::kernel::Mix;

/// Colours of a palette: as many as a byte can name.
const PALETTE: usize = 256;

#[derive(Debug)]
pub(super) struct Texels {
    mosaic: Arc<Mosaic>,
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
        let mosaic = map.source.mosaic.clone();
        let convert = |c: f32| map.conversion.map_or(c, |(from, to)| from.convert(to, c));
        let table = |max: u32| (0..=max).map(|i| convert(i as f32 / max as f32)).collect();
        let values = match mosaic.pixels() {
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
            _ => map.filter_all != 0.0 || map.transmit_all != 0.0 || has_alpha(mosaic.pixels()),
        };
        Texels { mosaic, values, transparent }
    }

    /// Does any pixel let light through?
    pub fn is_transparent(&self) -> bool {
        self.transparent
    }

    /// The palette's indices, if there is a palette.
    pub fn indices(&self) -> Option<&[u8]> {
        match self.mosaic.pixels() {
            Pixels::Palette { indices, .. } => Some(indices),
            _ => None,
        }
    }

    /// The colour of sample `i`, still multiplied by alpha if the file's colours are.
    pub fn get(&self, i: usize) -> Color {
        self.mix([i], [1.0])
    }

    fn float(&self, c: f32) -> f32 {
        match self.values {
            Values::Float(Some((from, to))) => from.convert(to, c),
            _ => c,
        }
    }
}

impl Mix for Texels {
    type Mixture = Color;

    /// The kind of the samples is asked once, and where they have no alpha three channels are summed.
    #[inline]
    fn mix<const N: usize>(&self, at: [usize; N], weights: [f64; N]) -> Color {
        let table: &[f32] = if let Values::Table(table) = &self.values { table } else { &[] };
        let v8 = |c: u8| table[usize::from(c)];
        let v16 = |c: u16| table.get(usize::from(c)).copied().unwrap_or(f32::from(c) / 65535.0);
        let (a8, a16) = (|a: u8| f32::from(a) / 255.0, |a: u16| f32::from(a) / 65535.0);
        match (self.mosaic.pixels(), &self.values) {
            (Pixels::Palette { indices, .. }, Values::Palette(colors)) => {
                let channels = sum(at, weights, |i| {
                    let c = colors[usize::from(indices[i])];
                    [c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit]
                });
                let [r, g, b, filter, transmit] = channels;
                Color { rgb: Rgb::new(r, g, b), filter, transmit }
            }
            (Pixels::Palette { .. }, _) => Color::BLACK,
            (Pixels::Grey8(v), _) => grey(sum(at, weights, |i| [v8(v[i])])),
            (Pixels::Grey16(v), _) => grey(sum(at, weights, |i| [v16(v[i])])),
            (Pixels::GreyAlpha8(v), _) => clear_grey(sum(at, weights, |i| [v8(v[i][0]), 1.0 - a8(v[i][1])])),
            (Pixels::GreyAlpha16(v), _) => {
                clear_grey(sum(at, weights, |i| [v16(v[i][0]), 1.0 - a16(v[i][1])]))
            }
            (Pixels::Rgb8(v), _) => solid(sum(at, weights, |i| v[i].map(v8))),
            (Pixels::Rgb16(v), _) => solid(sum(at, weights, |i| v[i].map(v16))),
            (Pixels::RgbF32(v), _) => solid(sum(at, weights, |i| v[i].map(|c| self.float(c)))),
            (Pixels::Rgba8(v), _) => clear(sum(at, weights, |i| {
                let [r, g, b, a] = v[i];
                [v8(r), v8(g), v8(b), 1.0 - a8(a)]
            })),
            (Pixels::Rgba16(v), _) => clear(sum(at, weights, |i| {
                let [r, g, b, a] = v[i];
                [v16(r), v16(g), v16(b), 1.0 - a16(a)]
            })),
            (Pixels::RgbaF32(v), _) => clear(sum(at, weights, |i| {
                let [r, g, b, a] = v[i];
                [self.float(r), self.float(g), self.float(b), 1.0 - a]
            })),
        }
    }
}

/// Indices into a palette or a list of materials.
pub(super) struct Indices<'a>(pub &'a [u8]);

impl Mix for Indices<'_> {
    type Mixture = f64;

    fn mix<const N: usize>(&self, at: [usize; N], weights: [f64; N]) -> f64 {
        at.into_iter().zip(weights).map(|(i, weight)| weight * f64::from(self.0[i])).sum()
    }
}

/// The channels of several samples, each times its weight, summed in double precision.
#[inline]
fn sum<const N: usize, const C: usize>(
    at: [usize; N],
    weights: [f64; N],
    channels: impl Fn(usize) -> [f32; C],
) -> [f32; C] {
    let mut sum = [0.0; C];
    for k in 0..N {
        let sample = channels(at[k]);
        for c in 0..C {
            sum[c] += weights[k] * f64::from(sample[c]);
        }
    }
    let mut out = [0.0; C];
    for c in 0..C {
        out[c] = sum[c] as f32;
    }
    out
}

fn grey([v]: [f32; 1]) -> Color {
    solid([v; 3])
}

fn clear_grey([v, transmit]: [f32; 2]) -> Color {
    clear([v, v, v, transmit])
}

fn solid([r, g, b]: [f32; 3]) -> Color {
    clear([r, g, b, 0.0])
}

fn clear([r, g, b, transmit]: [f32; 4]) -> Color {
    Color { rgb: Rgb::new(r, g, b), filter: 0.0, transmit }
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
