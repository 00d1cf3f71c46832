//! A picture in tiles is the picture in rows, to the bit.
use std::sync::Arc;

use raggio_image::{Bitmap, Curve, FileCurve, Mosaic, Pixels};
use raggio_math::{Vec2, Vec3};
use raggio_scene::{ImageMap, Interpolation, MapType};

use super::{FOOTPRINT_STEP, Image};

/// Whole tiles, parts of tiles, less than one, and single columns and rows.
const SIZES: [(usize, usize); 8] = [(8, 8), (1, 1), (1, 11), (11, 1), (3, 2), (5, 4), (13, 9), (4, 17)];

fn numbers() -> impl FnMut() -> u16 {
    let mut seed = 1_u32;
    move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 16) as u16
    }
}

/// A picture of every kind of pixels.
fn pictures(count: usize) -> Vec<Pixels> {
    let mut word = numbers();
    let mut words = || -> Vec<[u16; 4]> { (0..count).map(|_| [word(), word(), word(), word()]).collect() };
    let byte = |w: u16| (w >> 8) as u8;
    let float = |w: u16| f32::from(w) / 40_000.0;
    let colors = words().iter().map(|c| c.map(byte)).collect::<Vec<_>>();
    vec![
        Pixels::Palette { indices: words().iter().map(|c| byte(c[0]) % count as u8).collect(), colors },
        Pixels::Grey8(words().iter().map(|c| byte(c[0])).collect()),
        Pixels::Grey16(words().iter().map(|c| c[0]).collect()),
        Pixels::GreyAlpha8(words().iter().map(|c| [byte(c[0]), byte(c[1])]).collect()),
        Pixels::GreyAlpha16(words().iter().map(|c| [c[0], c[1]]).collect()),
        Pixels::Rgb8(words().iter().map(|c| [c[0], c[1], c[2]].map(byte)).collect()),
        Pixels::Rgb16(words().iter().map(|c| [c[0], c[1], c[2]]).collect()),
        Pixels::Rgba8(words().iter().map(|c| c.map(byte)).collect()),
        Pixels::Rgba16(words()),
        Pixels::RgbF32(words().iter().map(|c| [c[0], c[1], c[2]].map(float)).collect()),
        Pixels::RgbaF32(words().iter().map(|c| c.map(float)).collect()),
    ]
}

fn map(mosaic: Mosaic) -> ImageMap {
    ImageMap::new(mosaic)
}

/// The middles of all pixels, and points all around the picture.
fn points(width: usize, height: usize) -> Vec<Vec3> {
    let middle = |i: usize, n: usize| (i as f64 + 0.5) / n as f64;
    let mut points: Vec<Vec3> = (0..width * height)
        .map(|i| Vec3::new(middle(i % width, width), middle(i / width, height), 0.0))
        .collect();
    let mut word = numbers();
    let mut unit = || 4.0 * f64::from(word()) / 65_536.0 - 1.5;
    points.extend((0..60).map(|_| Vec3::new(unit(), unit(), unit())));
    points
}

/// All that can be asked of an image at a point, as bits.
fn answers(image: &Image, p: Vec3) -> Vec<u64> {
    let footprint =
        [p, p + FOOTPRINT_STEP * 0.3 * Vec3::new(1.0, 0.3, 0.0), p + FOOTPRINT_STEP * 0.2 * Vec3::Y];
    let colors = [image.color(p), image.color_over(&footprint)];
    let channels = colors.iter().flatten().flat_map(|c| [c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit]);
    let heights = image.heights(p, 1.7).into_iter().flatten();
    channels
        .map(f64::from)
        .chain(heights)
        .chain([image.pattern_value(p), image.material_index(p) as f64])
        .map(f64::to_bits)
        .collect()
}

fn same(rows: ImageMap, tiles: ImageMap, points: &[Vec3]) {
    let what = format!("{:?}", (rows.map_type, rows.interpolation, rows.once, rows.smooth));
    let [rows, tiles] = [rows, tiles].map(|map| Image::compile(&Arc::new(map)));
    assert_eq!(rows.is_opaque(), tiles.is_opaque());
    for &p in points {
        assert_eq!(answers(&rows, p), answers(&tiles, p), "{what} at {p}");
    }
}

#[test]
fn tiles_and_rows_give_the_same() {
    use Interpolation::{Bicubic, Bilinear, NormalizedDistance};
    for (width, height) in SIZES {
        let points = points(width, height);
        for pixels in pictures(width * height) {
            let bitmap = Bitmap { width, height, pixels, curve: FileCurve::None, premultiplied: false };
            let rows = map(Mosaic::in_rows(bitmap.clone()));
            let tiles = map(Mosaic::in_tiles(bitmap));
            assert!(tiles.source.mosaic.layout().is_tiled());
            for interpolation in [Interpolation::None, Bilinear, Bicubic, NormalizedDistance] {
                for once in [false, true] {
                    let set = |map: &ImageMap| ImageMap { interpolation, once, ..map.clone() };
                    same(set(&rows), set(&tiles), &points);
                }
            }
            for map_type in [MapType::Spherical, MapType::Cylindrical, MapType::Torus] {
                let offset = Vec2::new(0.3, 0.6);
                let set =
                    |map: &ImageMap| ImageMap { map_type, offset, interpolation: Bilinear, ..map.clone() };
                same(set(&rows), set(&tiles), &points);
            }
            let conversion = Some((Curve::Srgb, Curve::Linear));
            let set = |map: &ImageMap| ImageMap { smooth: true, use_index: true, conversion, ..map.clone() };
            same(set(&rows), set(&tiles), &points);
        }
    }
}

#[test]
fn a_pixel_is_seen_where_it_stands() {
    let (width, height) = (13, 9);
    let pixels: Vec<u8> = (0..width * height).map(|i| i as u8).collect();
    let curve = FileCurve::None;
    let bitmap = Bitmap { width, height, pixels: Pixels::Grey8(pixels), curve, premultiplied: false };
    let image = Image::compile(&Arc::new(map(Mosaic::in_tiles(bitmap))));
    for y in 0..height {
        for x in 0..width {
            let p = Vec3::new((x as f64 + 0.5) / 13.0, 1.0 - (y as f64 + 0.5) / 9.0, 0.0);
            let seen = image.color(p).map(|c| (c.rgb.x * 255.0).round() as usize);
            assert_eq!(seen, Some(y * width + x), "column {x}, row {y}");
        }
    }
}
