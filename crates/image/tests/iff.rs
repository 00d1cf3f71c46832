//! IFF pictures made by hand: every kind has the pixels that were put in, and broken files bring errors.
use raggio_image::{DecodeError, FileCurve, Format, Pixels, decode};

/// What a file is made of.
#[derive(Clone, Copy)]
struct Recipe<'a> {
    size: (u16, u16),
    planes: u8,
    masking: u8,
    packed: bool,
    screen: Option<u32>,
    colors: &'a [[u8; 3]],
}

const PLAIN: Recipe =
    Recipe { size: (0, 0), planes: 4, masking: 0, packed: true, screen: None, colors: &COLORS };

/// Sixteen colours that are easily told apart.
const COLORS: [[u8; 3]; 16] = {
    let mut colors = [[0; 3]; 16];
    let mut i = 0;
    while i < 16 {
        colors[i] = [(i * 16) as u8, (i * 37) as u8, (255 - i * 11) as u8];
        i += 1;
    }
    colors
};

fn chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut out = name.to_vec();
    out.extend((data.len() as u32).to_be_bytes());
    out.extend(data);
    out.extend(std::iter::repeat_n(0, data.len() % 2));
    out
}

/// Runs where two equal bytes follow each other, single bytes elsewhere.
fn packed(row: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    for run in row.chunk_by(|a, b| a == b) {
        for part in run.chunks(128) {
            match part.len() {
                1 => out.extend([0, part[0]]),
                n => out.extend([(257 - n) as u8, part[0]]),
            }
        }
    }
    out.push(128);
    out
}

/// A file whose bit planes hold these numbers, row by row.
fn ilbm(recipe: Recipe, values: &[u32]) -> Vec<u8> {
    let (width, height) = (usize::from(recipe.size.0), usize::from(recipe.size.1));
    assert_eq!(values.len(), width * height);
    let mut body = Vec::new();
    for row in values.chunks(width) {
        for plane in 0..recipe.planes + u8::from(recipe.masking == 1) {
            let mut line = vec![0u8; width.div_ceil(16) * 2];
            for (x, value) in row.iter().enumerate() {
                let bit = if plane < recipe.planes { value >> plane & 1 } else { 1 };
                line[x / 8] |= (bit as u8) << (7 - x % 8);
            }
            body.extend(if recipe.packed { packed(&line) } else { line });
        }
    }
    let mut header = Vec::new();
    header.extend(recipe.size.0.to_be_bytes());
    header.extend(recipe.size.1.to_be_bytes());
    header.extend([
        0,
        0,
        0,
        0,
        recipe.planes,
        recipe.masking,
        u8::from(recipe.packed),
        0,
        0,
        3,
        1,
        1,
        0,
        0,
        0,
        0,
    ]);
    let mut form = b"ILBM".to_vec();
    form.extend(chunk(b"ANNO", b"odd"));
    form.extend(chunk(b"BMHD", &header));
    if !recipe.colors.is_empty() {
        form.extend(chunk(b"CMAP", recipe.colors.as_flattened()));
    }
    if let Some(screen) = recipe.screen {
        form.extend(chunk(b"CAMG", &screen.to_be_bytes()));
    }
    form.extend(chunk(b"BODY", &body));
    chunk(b"FORM", &form)
}

fn pixels(file: &[u8]) -> Pixels {
    decode(file, None).expect("a picture").pixels
}

fn colors(file: &[u8]) -> Vec<[u8; 3]> {
    pixels(file).rgb8()
}

#[test]
fn palettes_of_every_depth_keep_their_indices() {
    for planes in 1..=8 {
        for (packed, masking) in [(true, 0), (false, 0), (true, 1), (false, 1)] {
            let (width, height) = (19 + u16::from(planes), 5);
            let count = u32::from(width) * 5;
            let values: Vec<u32> = (0..count).map(|i| (i * i / 3) % (1 << planes)).collect();
            let colors: Vec<[u8; 3]> = (0..1 << planes).map(|i: u32| [i as u8, 7, (255 - i) as u8]).collect();
            let recipe =
                Recipe { size: (width, height), planes, masking, packed, screen: None, colors: &colors };
            let bitmap = decode(&ilbm(recipe, &values), Some(Format::Iff)).expect("a picture");
            assert_eq!((bitmap.width, bitmap.height), (usize::from(width), 5));
            let Pixels::Palette { indices, colors: found } = bitmap.pixels else { panic!("no palette") };
            assert_eq!(indices, values.iter().map(|&v| v as u8).collect::<Vec<_>>(), "{planes} planes");
            assert_eq!(found[1], [1, 7, 254, 255]);
        }
    }
}

#[test]
fn one_index_may_be_clear_and_no_palette_means_grey() {
    let recipe = Recipe { size: (4, 1), masking: 2, ..PLAIN };
    let Pixels::Palette { colors, .. } = pixels(&ilbm(recipe, &[0, 3, 5, 15])) else { panic!("no palette") };
    assert_eq!(colors.iter().map(|c| c[3]).filter(|&alpha| alpha == 0).count(), 1);
    assert_eq!(colors[3], [48, 111, 222, 0]);
    let recipe = Recipe { size: (3, 1), colors: &[], ..PLAIN };
    assert_eq!(pixels(&ilbm(recipe, &[0, 5, 15])), Pixels::Grey8(vec![0, 85, 255]));
}

#[test]
fn half_brite_repeats_the_palette_darker() {
    let palette: Vec<[u8; 3]> = (0..32).map(|i| [8 * i, 255 - i, 1]).collect();
    for screen in [Some(0x80), None] {
        let recipe = Recipe { size: (3, 1), planes: 6, screen, colors: &palette, ..PLAIN };
        assert_eq!(colors(&ilbm(recipe, &[2, 34, 63])), [[16, 253, 1], [8, 126, 0], [124, 112, 0]]);
    }
}

#[test]
fn hold_and_modify_changes_one_channel_at_a_time() {
    let recipe = Recipe { size: (5, 2), planes: 6, screen: Some(0x800), ..PLAIN };
    let row = [0x02, 0x1f, 0x20, 0x38, 0x03];
    let expected = [[32, 74, 233], [32, 74, 255], [0, 74, 255], [0, 136, 255], [48, 111, 222]];
    let found = colors(&ilbm(recipe, &[row, row].concat()));
    assert_eq!((&found[..5], &found[5..]), (&expected[..], &expected[..]));
    // A row begins with the first colour.
    let first = Recipe { size: (1, 1), ..recipe };
    assert_eq!(colors(&ilbm(first, &[0x21])), [[17, 0, 255]]);
    let eight = Recipe { size: (3, 1), planes: 8, ..recipe };
    assert_eq!(colors(&ilbm(eight, &[0x04, 0xbf, 0x41])), [[64, 148, 211], [255, 148, 211], [255, 148, 4]]);
}

#[test]
fn true_colours_come_as_they_are() {
    let recipe = Recipe { size: (3, 1), planes: 24, colors: &[], ..PLAIN };
    let bitmap = decode(&ilbm(recipe, &[0x0000ff, 0x12_34_56, 0xff_00_80]), None).expect("a picture");
    assert_eq!(bitmap.pixels, Pixels::Rgb8(vec![[255, 0, 0], [0x56, 0x34, 0x12], [0x80, 0, 0xff]]));
    assert_eq!(bitmap.curve, FileCurve::None);
}

#[test]
fn chunky_rows_are_padded_to_even_lengths() {
    let mut form = b"PBM ".to_vec();
    form.extend(chunk(b"BMHD", &[0, 3, 0, 2, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0]));
    form.extend(chunk(b"CMAP", COLORS.as_flattened()));
    form.extend(chunk(b"BODY", &[1, 2, 3, 99, 4, 5, 6, 99]));
    let Pixels::Palette { indices, .. } = pixels(&chunk(b"FORM", &form)) else { panic!("no palette") };
    assert_eq!(indices, [1, 2, 3, 4, 5, 6]);
}

#[test]
fn broken_files_say_what_is_wrong() {
    let whole = ilbm(Recipe { size: (20, 3), ..PLAIN }, &[7; 60]);
    let says = |file: &[u8]| decode(file, None).expect_err("broken").to_string();
    assert!(says(b"FORM\0\0\0\x04ILBM").contains("no header"));
    assert!(says(b"FORM\0\0\0\x04ANIM").contains("ILBM"));
    assert!(says(&whole[..whole.len() - 3]).contains("cut short"));
    let planes = Recipe { size: (1, 1), planes: 9, ..PLAIN };
    assert!(says(&ilbm(planes, &[0])).contains("planes"));
    let nothing = Recipe { size: (1, 0), ..PLAIN };
    assert!(matches!(decode(&ilbm(nothing, &[]), None), Err(DecodeError::Size(1, 0))));
}

/// Every byte of a file changed in turn, and files cut at every place: a picture or an error, never a panic.
#[test]
fn damage_never_panics() {
    for (planes, screen) in [(4, None), (6, Some(0x800)), (6, Some(0x80)), (24, None)] {
        let recipe = Recipe { size: (17, 3), planes, screen, masking: planes % 3, ..PLAIN };
        let values: Vec<u32> = (0..51).map(|i| (i * 0x01_35_79) % (1 << planes)).collect();
        let whole = ilbm(recipe, &values);
        let mut pictures = 0;
        for i in 0..whole.len() {
            let _ = decode(&whole[..i], Some(Format::Iff));
            for value in [0, 1, 7, 0x7f, 0x80, 0xff] {
                let mut file = whole.clone();
                file[i] = value;
                if let Ok(bitmap) = decode(&file, Some(Format::Iff)) {
                    assert_eq!(bitmap.pixels.len(), bitmap.width * bitmap.height);
                    pictures += 1;
                }
            }
        }
        assert!(pictures > whole.len(), "{pictures}");
    }
}
