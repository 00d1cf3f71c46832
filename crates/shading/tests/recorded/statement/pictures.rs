//! The small pictures and density files that the recorded statements name.

use raggio_image::{FileCurve, Pixels};
use raggio_scene::{Bitmap, DensityFile, ImageMap};

const RGBA: [[u8; 4]; 20] = [
    [74, 165, 0, 91],
    [148, 239, 74, 165],
    [222, 57, 148, 239],
    [40, 131, 222, 57],
    [114, 205, 40, 131],
    [111, 202, 37, 128],
    [222, 57, 148, 239],
    [77, 168, 3, 94],
    [188, 23, 114, 205],
    [43, 134, 225, 60],
    [148, 239, 74, 165],
    [40, 131, 222, 57],
    [188, 23, 114, 205],
    [80, 171, 6, 97],
    [228, 63, 154, 245],
    [185, 20, 111, 202],
    [114, 205, 40, 131],
    [43, 134, 225, 60],
    [228, 63, 154, 245],
    [157, 248, 83, 174],
];

const PALETTE: [[u8; 4]; 7] = [
    [0, 40, 80, 255],
    [53, 93, 133, 255],
    [106, 146, 186, 255],
    [159, 199, 239, 255],
    [212, 252, 36, 255],
    [9, 49, 89, 255],
    [62, 102, 142, 255],
];

/// A picture of 5 by 4 pixels by its file name.
pub fn bitmap(name: &str) -> Bitmap {
    let pixels = match name {
        "tex_rgb.png" => Pixels::Rgb8(RGBA.iter().map(|&[r, g, b, _]| [r, g, b]).collect()),
        "tex_rgba.png" => Pixels::Rgba8(RGBA.to_vec()),
        "tex_pal.png" => {
            Pixels::Palette { indices: (0..20).map(|i| i % 7).collect(), colors: PALETTE.to_vec() }
        }
        other => panic!("no picture {other}"),
    };
    Bitmap { width: 5, height: 4, pixels, curve: FileCurve::CustomSrgb, premultiplied: false }
}

/// An image map with the language's defaults and no conversion.
pub fn image_map(name: &str) -> ImageMap {
    ImageMap::new(bitmap(name).into())
}

/// A density file by its name.
pub fn density(name: &str) -> DensityFile {
    let bytes: &[u8] = match name {
        "tex_8.df3" => include_bytes!("../../data/tex_8.df3"),
        "tex_16.df3" => include_bytes!("../../data/tex_16.df3"),
        other => panic!("no density file {other}"),
    };
    let number = |b: &[u8]| b.iter().fold(0_u32, |n, &b| n << 8 | u32::from(b));
    let size = [0, 2, 4].map(|i| number(&bytes[i..i + 2]) as usize);
    let width = (bytes.len() - 6) / size.iter().product::<usize>();
    let most = (1_u64 << (8 * width)) as f32 - 1.0;
    let samples = bytes[6..].chunks(width).map(|b| number(b) as f32 / most).collect();
    DensityFile { size, samples, interpolation: 0 }
}
