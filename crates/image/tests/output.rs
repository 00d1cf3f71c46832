//! What is written: rounding, gamma, alpha and dithering as POV-Ray 3.7 does them, and every format read back.
use raggio_image::{
    Bitmap, Curve, Dither, EncodeOptions, FileCurve, Format, Picture, Pixels, compare, decode, develop,
    encode, write_png,
};

/// A ramp of 16 columns from black to (1, 0.9, 0.8), sampled at the centres of pixels.
fn ramp(height: usize) -> Picture {
    let row = (0..16).map(|i| (i as f32 + 0.5) / 16.0).map(|t| [t, 0.9 * t, 0.8 * t, 0.0]);
    let pixels = std::iter::repeat_n(row, height).flatten().collect();
    Picture { width: 16, height, pixels }
}

fn pixel(color: [f32; 4]) -> Picture {
    Picture { width: 1, height: 1, pixels: vec![color] }
}

fn bytes(picture: &Picture, options: &EncodeOptions) -> Vec<u8> {
    let mut out = Vec::new();
    encode(picture, options, &mut out).expect("an encoded picture");
    out
}

fn read(bytes: &[u8]) -> Bitmap {
    decode(bytes, Some(Format::Tga)).expect("a picture")
}

fn options(format: Format) -> EncodeOptions {
    EncodeOptions { format, ..EncodeOptions::default() }
}

#[test]
fn every_dithering_method_gives_the_recorded_numbers() {
    let mut rows = std::collections::BTreeMap::<&str, Vec<u16>>::new();
    for line in include_str!("data/dither.csv").lines() {
        let (method, numbers) = line.split_once(';').expect("method; numbers");
        rows.entry(method)
            .or_default()
            .extend(numbers.split(',').map(|n| n.parse::<u16>().expect("a number")));
    }
    assert_eq!(rows.len(), 6);
    for (method, expected) in rows {
        let dither = Dither::from_name(method);
        assert!(dither.is_some(), "{method}");
        let bitmap = develop(&ramp(8), &EncodeOptions { bits: 5, dither, ..EncodeOptions::default() });
        let Pixels::Rgb8(got) = bitmap.pixels else { panic!("not 8 bits") };
        let got: Vec<u16> = got.as_flattened().iter().map(|v| u16::from(v >> 3)).collect();
        let wrong = got.iter().zip(&expected).filter(|(a, b)| a != b).count();
        assert_eq!(wrong, 0, "{method}:\n{got:?}\n{expected:?}");
    }
}

#[test]
fn numbers_round_and_widen_as_recorded() {
    let red = |bits: u8| match develop(&ramp(1), &EncodeOptions { bits, ..EncodeOptions::default() }).pixels {
        Pixels::Rgb8(v) => v.iter().take(5).map(|p| u16::from(p[0])).collect::<Vec<_>>(),
        Pixels::Rgb16(v) => v.iter().take(5).map(|p| p[0]).collect(),
        other => panic!("{other:?}"),
    };
    assert_eq!(red(8), [49, 86, 110, 129, 145]);
    assert_eq!(red(5), [49, 82, 107, 132, 148]);
    assert_eq!(red(12), [12707, 22181, 28294, 33096, 37145]);
    assert_eq!(red(16), [12710, 22181, 28298, 33099, 37151]);
}

#[test]
fn gamma_follows_working_space_and_file() {
    let half = pixel([0.5, 0.5, 0.5, 0.0]);
    let written = |working, file| {
        let o = EncodeOptions { working, file, ..EncodeOptions::default() };
        develop(&half, &o).pixels.rgb8()[0][0]
    };
    assert_eq!(written(Some(Curve::Linear), Curve::Srgb), 188);
    assert_eq!(written(None, Curve::Srgb), 128);
    assert_eq!(written(Some(Curve::Srgb), Curve::Srgb), 128);
    assert_eq!(written(Some(Curve::Linear), Curve::power(1.0)), 128);
    let grey = develop(&ramp(1), &EncodeOptions { bits: 16, grey: true, ..EncodeOptions::default() });
    let Pixels::Grey16(grey) = grey.pixels else { panic!("not grey") };
    assert_eq!(grey[..3], [12141, 21282, 27184]);
}

#[test]
fn alpha_is_straight_and_large_enough() {
    let stored = |c| {
        let o = EncodeOptions { alpha: true, format: Format::Tga, ..EncodeOptions::default() };
        develop(&pixel(c), &o).pixels.rgba8()[0]
    };
    assert_eq!(stored([0.5, 0.0, 0.0, 0.5]), [255, 0, 0, 128]);
    assert_eq!(stored([0.0, 0.0, 0.0, 1.0]), [0, 0, 0, 0]);
    assert_eq!(stored([0.375, 0.375, 0.375, 0.25]), [188, 188, 188, 191]);
    // Brighter than its alpha allows: alpha is raised.
    assert_eq!(stored([0.5, 0.5, 0.5, 1.0]), [255, 255, 255, 128]);
    let opaque = develop(&pixel([0.5, 0.0, 0.0, 0.5]), &EncodeOptions::default());
    assert_eq!(opaque.pixels.rgba8()[0], [188, 0, 0, 255]);
}

#[test]
fn bad_numbers_are_black_or_clipped() {
    let o = EncodeOptions::default();
    let stored = |v: f32| develop(&pixel([v, v, v, 0.0]), &o).pixels.rgb8()[0][0];
    assert_eq!((stored(f32::NAN), stored(f32::INFINITY), stored(-3.0), stored(7.0)), (0, 255, 0, 255));
}

#[test]
fn formats_of_whole_numbers_come_back_exactly() {
    let picture = ramp(3);
    for (o, mark) in [
        (options(Format::Png), &b"\x89PNG"[..]),
        (EncodeOptions { bits: 16, ..options(Format::Png) }, b"\x89PNG"),
        (EncodeOptions { alpha: true, ..options(Format::Png) }, b"\x89PNG"),
        (EncodeOptions { grey: true, bits: 16, ..options(Format::Png) }, b"\x89PNG"),
        (options(Format::Pnm), b"P6"),
        (EncodeOptions { bits: 16, ..options(Format::Pnm) }, b"P6"),
        (EncodeOptions { grey: true, ..options(Format::Pnm) }, b"P5"),
        (options(Format::Bmp), b"BM"),
        (EncodeOptions { alpha: true, ..options(Format::Bmp) }, b"BM"),
        (options(Format::Tga), &[0, 0, 2]),
        (EncodeOptions { run_length: true, ..options(Format::Tga) }, &[0, 0, 10]),
        (EncodeOptions { alpha: true, ..options(Format::Tga) }, &[0, 0, 2]),
        (EncodeOptions { alpha: true, run_length: true, ..options(Format::Tga) }, &[0, 0, 10]),
    ] {
        let file = bytes(&picture, &o);
        assert!(file.starts_with(mark), "{o:?}");
        let back = read(&file);
        assert_eq!((back.width, back.height), (16, 3));
        assert_eq!(back.pixels, develop(&picture, &o).pixels, "{o:?}");
    }
}

#[test]
fn run_lengths_survive_rows_of_runs_and_noise() {
    let width = 301;
    let shade = |i: usize| match i {
        0..=140 => 0.2,
        141..=280 => (i * 7919 % 256) as f32 / 255.0,
        _ => (i / 2 % 2) as f32,
    };
    let pixels: Vec<[f32; 4]> = (0..width * 2).map(|i| shade(i % width)).map(|v| [v, v, v, 0.0]).collect();
    let picture = Picture { width, height: 2, pixels };
    let o = EncodeOptions { run_length: true, ..options(Format::Tga) };
    let file = bytes(&picture, &o);
    assert_eq!(read(&file).pixels, develop(&picture, &o).pixels);
    assert!(file.len() < bytes(&picture, &options(Format::Tga)).len());
}

#[test]
fn png_says_how_it_is_encoded() {
    let curve = |o: EncodeOptions| read(&bytes(&ramp(1), &o)).curve;
    assert_eq!(curve(options(Format::Png)), FileCurve::Stated(Curve::Srgb));
    assert_eq!(
        curve(EncodeOptions { working: None, ..options(Format::Png) }),
        FileCurve::Stated(Curve::Srgb)
    );
    assert_eq!(
        curve(EncodeOptions { file: Curve::Linear, ..options(Format::Png) }),
        FileCurve::Stated(Curve::Linear)
    );
    let FileCurve::Stated(Curve::Power(g)) =
        curve(EncodeOptions { file: Curve::power(2.2), ..options(Format::Png) })
    else {
        panic!("no power curve")
    };
    assert!((g - 2.2).abs() < 1e-3, "{g}");
}

#[test]
fn light_is_stored_as_light() {
    let picture = Picture { width: 2, height: 1, pixels: vec![[4.0, 0.5, 0.25, 0.0], [0.25, 0.5, 1.0, 0.5]] };
    let Pixels::RgbaF32(exr) =
        read(&bytes(&picture, &EncodeOptions { alpha: true, ..options(Format::Exr) })).pixels
    else {
        panic!("no floats")
    };
    assert_eq!(exr, [[4.0, 0.5, 0.25, 1.0], [0.25, 0.5, 1.0, 0.5]]);
    let Pixels::RgbF32(hdr) = read(&bytes(&picture, &options(Format::Hdr))).pixels else {
        panic!("no floats")
    };
    for (a, b) in hdr.as_flattened().iter().zip([4.0f32, 0.5, 0.25, 0.25, 0.5, 1.0]) {
        assert!((a - b).abs() <= b * 0.02 + 0.016, "{a} {b}");
    }
    let jpeg = read(&bytes(&ramp(8), &options(Format::Jpeg)));
    let exact = develop(&ramp(8), &options(Format::Jpeg));
    assert!(compare(&exact, &jpeg).expect("sizes").mean < 4.0);
}

#[test]
fn unwritable_formats_and_sizes_are_refused() {
    let mut out = Vec::new();
    let gif = encode(&ramp(1), &options(Format::Gif), &mut out).expect_err("no GIF").to_string();
    assert!(gif.contains("GIF") && gif.contains("PNG"), "{gif}");
    assert!(encode(&Picture::default(), &options(Format::Png), &mut out).is_err());
    let short = Picture { width: 3, height: 3, pixels: vec![[0.0; 4]] };
    assert!(encode(&short, &options(Format::Png), &mut out).is_err());
}

#[test]
fn comparison_sees_differences() {
    let a = develop(&ramp(16), &EncodeOptions::default());
    let same = compare(&a, &a).expect("one size");
    assert_eq!((same.mean_flip, same.greatest, same.mean), (0.0, 0, 0.0));
    let mut darker = ramp(16);
    darker.pixels[8][0] = 0.0;
    let b = develop(&darker, &EncodeOptions::default());
    let other = compare(&a, &b).expect("one size");
    assert_eq!(other.greatest, 193);
    assert!(other.mean_flip > 0.001 && other.mean_flip < 0.5, "{}", other.mean_flip);
    assert_eq!((other.panel.width, other.panel.height), (3 * 16 + 2, 16));
    let mut png = Vec::new();
    write_png(&other.panel, 1, &mut png).expect("a panel");
    assert_eq!(read(&png).pixels, other.panel.pixels);
    assert!(compare(&a, &develop(&ramp(2), &EncodeOptions::default())).is_err());
}
