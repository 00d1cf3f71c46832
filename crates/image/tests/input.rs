//! What is read: numbers as files have them, and errors for what is no picture.
use image::ImageEncoder;
use raggio_image::{
    Bitmap, Curve, DecodeError, EncodeOptions, FileCurve, Format, Picture, Pixels, decode, encode,
};

fn read(bytes: &[u8], format: Format) -> Bitmap {
    decode(bytes, Some(format)).expect("a picture")
}

/// A TGA file of 2 x 2 pixels with the given kind, depth, descriptor, palette and data.
fn tga(kind: u8, bits: u8, descriptor: u8, palette: &[[u8; 3]], data: &[u8]) -> Vec<u8> {
    let mut file = vec![0; 18];
    (file[2], file[12], file[14], file[16], file[17]) = (kind, 2, 2, bits, descriptor);
    if !palette.is_empty() {
        (file[1], file[5], file[7]) = (1, palette.len() as u8, 24);
    }
    file.extend(palette.as_flattened());
    file.extend(data);
    file
}

#[test]
fn png_keeps_depths_and_palettes() {
    let Pixels::Palette { indices, colors } = read(include_bytes!("data/hf_pal8.png"), Format::Png).pixels
    else {
        panic!("no palette")
    };
    assert_eq!((indices.len(), &indices[..3], colors[2]), (36, &[0, 37, 74][..], [2, 253, 14, 255]));
    let Pixels::Grey8(v) = read(include_bytes!("data/hf_gray8.png"), Format::Png).pixels else { panic!() };
    assert_eq!(v[..3], [0, 37, 74]);
    let Pixels::Grey16(v) = read(include_bytes!("data/hf_gray16.png"), Format::Png).pixels else { panic!() };
    assert_eq!(v[..3], [0, 9001, 18002]);
    let Pixels::Rgb16(v) = read(include_bytes!("data/hf_rgb16.png"), Format::Png).pixels else { panic!() };
    assert_eq!(v[1], [9001, 3959, 3000]);
    let Pixels::Rgba8(v) = read(include_bytes!("data/tex_rgba.png"), Format::Png).pixels else { panic!() };
    assert_eq!(v[..2], [[74, 165, 0, 91], [148, 239, 74, 165]]);
}

#[test]
fn png_unpacks_small_indices() {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 5, 2);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Two);
    encoder.set_palette(vec![0, 0, 0, 10, 20, 30, 40, 50, 60]);
    encoder.set_trns(vec![255, 7]);
    encoder.set_source_gamma(png::ScaledFloat::new(0.5));
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[0b00_01_10_01, 0b10_00_00_00, 0b10_10_10_10, 0]).expect("rows");
    writer.finish().expect("an end");
    let bitmap = read(&file, Format::Png);
    assert_eq!(bitmap.curve, FileCurve::Stated(Curve::Power(2.0)));
    let Pixels::Palette { indices, colors } = bitmap.pixels else { panic!("no palette") };
    assert_eq!(indices, [0, 1, 2, 1, 2, 2, 2, 2, 2, 0]);
    assert_eq!(colors, [[0, 0, 0, 255], [10, 20, 30, 7], [40, 50, 60, 255]]);
}

#[test]
fn tga_of_every_kind() {
    let rows = |file: &[u8]| read(file, Format::Tga).pixels;
    let palette = [[3, 2, 1], [6, 5, 4]];
    let expected =
        Pixels::Palette { indices: vec![0, 1, 1, 0], colors: vec![[1, 2, 3, 255], [4, 5, 6, 255]] };
    assert_eq!(rows(&tga(1, 8, 0x20, &palette, &[0, 1, 1, 0])), expected);
    assert_eq!(rows(&tga(9, 8, 0x20, &palette, &[0, 0, 0x81, 1, 0, 0])), expected);
    // Bottom up, and right to left.
    assert_eq!(rows(&tga(3, 8, 0, &[], &[1, 2, 3, 4])), Pixels::Grey8(vec![3, 4, 1, 2]));
    assert_eq!(rows(&tga(3, 8, 0x30, &[], &[1, 2, 3, 4])), Pixels::Grey8(vec![2, 1, 4, 3]));
    let five = [0x00, 0x7c, 0xe0, 0x03, 0x1f, 0x00, 0x10, 0x42];
    let expected = vec![[255, 0, 0], [0, 255, 0], [0, 0, 255], [132, 132, 132]];
    assert_eq!(rows(&tga(2, 16, 0x20, &[], &five)), Pixels::Rgb8(expected));
}

#[test]
fn gif_keeps_its_palette() {
    let mut file = Vec::new();
    {
        let mut encoder = gif::Encoder::new(&mut file, 3, 2, &[9, 8, 7, 6, 5, 4]).expect("a header");
        let mut frame = gif::Frame::from_indexed_pixels(3, 2, vec![0, 1, 0, 1, 1, 0], Some(1));
        frame.interlaced = false;
        encoder.write_frame(&frame).expect("a frame");
    }
    let bitmap = read(&file, Format::Gif);
    let Pixels::Palette { indices, colors } = bitmap.pixels else { panic!("no palette") };
    assert_eq!(indices, [0, 1, 0, 1, 1, 0]);
    assert_eq!(colors[..2], [[9, 8, 7, 255], [6, 5, 4, 0]]);
    assert_eq!(bitmap.curve, FileCurve::CustomSrgb);
}

#[test]
fn rows_of_interlaced_gifs_keep_their_stored_order() {
    let mut file = Vec::new();
    let mut encoder = gif::Encoder::new(&mut file, 1, 9, &[0; 48]).expect("a header");
    let mut frame = gif::Frame::from_indexed_pixels(1, 9, vec![0, 8, 4, 2, 6, 1, 3, 5, 7], None);
    frame.interlaced = true;
    encoder.write_frame(&frame).expect("a frame");
    drop(encoder);
    let Pixels::Palette { indices, .. } = read(&file, Format::Gif).pixels else { panic!("no palette") };
    assert_eq!(indices, [0, 8, 4, 2, 6, 1, 3, 5, 7]);
}

#[test]
fn potential_joins_the_halves() {
    let mut file = Vec::new();
    let mut encoder = gif::Encoder::new(&mut file, 4, 2, &[0; 768]).expect("a header");
    let frame = gif::Frame::from_indexed_pixels(4, 2, vec![1, 2, 0x80, 0xff, 3, 4, 5, 6], None);
    encoder.write_frame(&frame).expect("a frame");
    drop(encoder);
    let bitmap = read(&file, Format::Pot);
    assert_eq!((bitmap.width, bitmap.height), (2, 2));
    assert_eq!(bitmap.pixels, Pixels::Grey16(vec![0x180, 0x2ff, 0x305, 0x406]));
}

#[test]
fn bmp_keeps_its_palette() {
    let mut file = Vec::new();
    let mut encoder = image::codecs::bmp::BmpEncoder::new(&mut file);
    encoder.encode(&[0, 100, 200, 255], 2, 2, image::ExtendedColorType::L8).expect("a file");
    let Pixels::Palette { indices, colors } = read(&file, Format::Bmp).pixels else { panic!("no palette") };
    assert_eq!(indices, [0, 100, 200, 255]);
    assert_eq!((colors.len(), colors[100]), (256, [100, 100, 100, 255]));
}

#[test]
fn grey_tiff_keeps_high_bytes() {
    let mut file = std::io::Cursor::new(Vec::new());
    let samples: Vec<u8> = [0x1234u16, 0xabcd].iter().flat_map(|v| v.to_ne_bytes()).collect();
    let encoder = image::codecs::tiff::TiffEncoder::new(&mut file);
    encoder.write_image(&samples, 2, 1, image::ExtendedColorType::L16).expect("a file");
    let bitmap = read(file.get_ref(), Format::Tiff);
    assert_eq!(bitmap.pixels, Pixels::Grey8(vec![0x12, 0xab]));
    assert_eq!(bitmap.curve, FileCurve::None);
}

#[test]
fn plain_and_raw_maps() {
    let pixels = |file: &[u8]| read(file, Format::Pnm).pixels;
    assert_eq!(pixels(b"P2\n# note\n3 1\n255\n0 128 255\n"), Pixels::Grey8(vec![0, 128, 255]));
    assert_eq!(pixels(b"P3 1 1 255 1 2 3"), Pixels::Rgb8(vec![[1, 2, 3]]));
    assert_eq!(pixels(b"P1 3 1 1 0 1"), Pixels::Grey8(vec![0, 255, 0]));
    assert_eq!(pixels(b"P5 1 1 65535 \x12\x34"), Pixels::Grey16(vec![0x1234]));
    assert_eq!(pixels(b"P6 1 1 255 \x07\x08\x09"), Pixels::Rgb8(vec![[7, 8, 9]]));
}

#[test]
fn formats_are_told_by_content_before_name() {
    let png = include_bytes!("data/tex_rgba.png");
    assert_eq!(read(png, Format::Jpeg).curve, read(png, Format::Png).curve);
    assert_eq!(Format::from_name("a.b/PIC.JPEG"), Some(Format::Jpeg));
    assert_eq!(Format::from_name("picture"), None);
    assert!(matches!(decode(b"nonsense", None), Err(DecodeError::Unknown)));
}

#[test]
fn giants_and_nothings_are_refused() {
    for size in ["100000 100000", "0 5", "99999999999999999999 1"] {
        let file = format!("P6 {size} 255 ");
        assert!(decode(file.as_bytes(), None).is_err(), "{size}");
    }
    let mut file = tga(2, 24, 0, &[], &[]);
    (file[12], file[13], file[14], file[15]) = (255, 255, 255, 255);
    assert!(matches!(decode(&file, Some(Format::Tga)), Err(DecodeError::Size(65_535, 65_535))));
}

/// Every format's file, cut short anywhere and with any byte changed, is read or refused but never panics.
#[test]
fn damaged_files_do_not_panic() {
    let pixels = (0..35).map(|i| i as f32 / 35.0).map(|v| [v, 1.0 - v, 0.5, v]).collect();
    let picture = Picture { width: 7, height: 5, pixels };
    let formats =
        [Format::Png, Format::Pnm, Format::Bmp, Format::Tga, Format::Jpeg, Format::Hdr, Format::Exr];
    let mut files: Vec<(Format, Vec<u8>)> = formats
        .into_iter()
        .map(|format| {
            let mut file = Vec::new();
            let options = EncodeOptions { format, alpha: true, run_length: true, ..EncodeOptions::default() };
            encode(&picture, &options, &mut file).expect("a file");
            (format, file)
        })
        .collect();
    files.push((Format::Png, include_bytes!("data/tex_pal.png").to_vec()));
    let mut refused = 0;
    for (format, file) in &files {
        for i in 0..file.len() {
            refused += usize::from(decode(&file[..i], Some(*format)).is_err());
            for change in [0xff, 0x01, 0x80] {
                let mut changed = file.clone();
                changed[i] ^= change;
                refused += usize::from(decode(&changed, Some(*format)).is_err());
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}
