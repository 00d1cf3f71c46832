//! PNG pictures as the comparisons need them: 8-bit RGB in, the mean FLIP error, and a difference map out.

use std::path::Path;

/// An 8-bit RGB picture, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue of each pixel.
    pub rgb: Vec<u8>,
}

/// How far two pictures are apart.
pub struct Difference {
    /// Mean FLIP error, 0 to 1.
    pub mean: f32,
    /// The error of each pixel in false colours.
    pub map: Picture,
}

/// Reads a PNG of any kind; alpha is dropped, as the measure does not look at it.
pub fn read_png(path: &Path) -> Result<Picture, String> {
    let said = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
    let file = std::fs::File::open(path).map_err(|e| said(&e))?;
    let mut decoder = png::Decoder::new(std::io::BufReader::new(file));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(|e| said(&e))?;
    let size = reader.output_buffer_size().ok_or_else(|| said(&"too large"))?;
    let mut buffer = vec![0; size];
    let info = reader.next_frame(&mut buffer).map_err(|e| said(&e))?;
    let samples = info.color_type.samples();
    let rgb = buffer[..info.buffer_size()]
        .chunks_exact(samples)
        .flat_map(|p| if samples < 3 { [p[0]; 3] } else { [p[0], p[1], p[2]] })
        .collect();
    Ok(Picture { width: info.width, height: info.height, rgb })
}

/// Writes an RGB PNG, with its folder where that is missing.
pub fn write_png(path: &Path, picture: &Picture) -> Result<(), String> {
    let said = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| said(&e))?;
    }
    let file = std::fs::File::create(path).map_err(|e| said(&e))?;
    let mut encoder = png::Encoder::new(std::io::BufWriter::new(file), picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(|e| said(&e))?;
    writer.write_image_data(&picture.rgb).map_err(|e| said(&e))
}

/// FLIP for low dynamic range at the default viewing distance; `None` where the sizes differ.
pub fn compare(expected: &Picture, actual: &Picture) -> Option<Difference> {
    let (w, h) = (expected.width, expected.height);
    if (w, h) != (actual.width, actual.height) {
        return None;
    }
    let expected = nv_flip::FlipImageRgb8::with_data(w, h, &expected.rgb);
    let actual = nv_flip::FlipImageRgb8::with_data(w, h, &actual.rgb);
    let error = nv_flip::flip(expected, actual, nv_flip::DEFAULT_PIXELS_PER_DEGREE);
    let mean = nv_flip::FlipPool::from_image(&error).mean();
    let map = error.apply_color_lut(&nv_flip::magma_lut()).to_vec();
    Some(Difference { mean, map: Picture { width: w, height: h, rgb: map } })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(value: u8) -> Picture {
        Picture { width: 16, height: 8, rgb: vec![value; 16 * 8 * 3] }
    }

    #[test]
    fn equal_pictures_differ_by_nothing_and_black_from_white_by_all() {
        let same = compare(&flat(90), &flat(90)).expect("same size");
        assert_eq!(same.mean, 0.0);
        let far = compare(&flat(0), &flat(255)).expect("same size");
        assert!(far.mean > 0.9, "{}", far.mean);
        assert!(compare(&flat(0), &Picture { width: 8, height: 16, rgb: vec![0; 384] }).is_none());
    }

    #[test]
    fn a_written_picture_reads_back() {
        let path = std::env::temp_dir().join(format!("xtask-{}.png", std::process::id()));
        let mut picture = flat(7);
        picture.rgb[5] = 200;
        write_png(&path, &picture).expect("written");
        assert_eq!(read_png(&path).expect("read"), picture);
        std::fs::remove_file(&path).expect("removed");
    }
}
