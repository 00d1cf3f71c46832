//! Pictures for look-ups anywhere: big ones lie in square tiles, so that pixels below each other share lines and pages of
//! memory as pixels beside each other do.
use crate::{Bitmap, Pixels};

/// Pixels along a tile's side.
const SIDE: usize = 1 << SIDE_BITS;
const SIDE_BITS: usize = 2;

/// Pictures of fewer bytes stay in rows: the processor's caches hold them either way.
const TILED_FROM: usize = 32 << 20;

/// Where a pixel stands among the samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Samples of one row, or of one row of tiles.
    pitch: usize,
    tiled: bool,
}

impl Layout {
    /// Row by row.
    pub fn rows(width: usize) -> Self {
        Layout { pitch: width, tiled: false }
    }

    /// Tile by tile, row by row within each; tiles at the right end and at the bottom are whole.
    pub fn tiles(width: usize) -> Self {
        Layout { pitch: width.div_ceil(SIDE) * SIDE * SIDE, tiled: true }
    }

    /// Is it tile by tile?
    pub fn is_tiled(self) -> bool {
        self.tiled
    }

    /// Where the pixel in column `x` and row `y` stands.
    #[inline]
    pub fn index(self, x: usize, y: usize) -> usize {
        if self.tiled { self.in_tiles(x, y) } else { self.in_rows(x, y) }
    }

    /// The same for who has asked already that the layout is not tiled.
    #[inline]
    pub fn in_rows(self, x: usize, y: usize) -> usize {
        y * self.pitch + x
    }

    /// The same for who has asked already that the layout is tiled.
    #[inline]
    pub fn in_tiles(self, x: usize, y: usize) -> usize {
        y / SIDE * self.pitch + y % SIDE * SIDE + x / SIDE * (SIDE * SIDE) + x % SIDE
    }

    /// Samples of a picture of `height` rows, those beside and below it that fill its tiles included.
    pub fn samples(self, height: usize) -> usize {
        if self.tiled { height.div_ceil(SIDE) * self.pitch } else { height * self.pitch }
    }
}

/// A picture whose samples lie by a [`Layout`].
#[derive(Clone, Debug)]
pub struct Mosaic {
    width: usize,
    height: usize,
    layout: Layout,
    pixels: Pixels,
}

impl From<Bitmap> for Mosaic {
    /// In tiles where that makes look-ups faster.
    fn from(bitmap: Bitmap) -> Self {
        if bitmap.pixels.bytes() < TILED_FROM { Mosaic::in_rows(bitmap) } else { Mosaic::in_tiles(bitmap) }
    }
}

impl Mosaic {
    /// The picture as it is.
    pub fn in_rows(bitmap: Bitmap) -> Self {
        let Bitmap { width, height, pixels, .. } = bitmap;
        Mosaic { width, height, layout: Layout::rows(width), pixels }
    }

    /// The picture in tiles, whatever its size. Its samples are moved in place.
    pub fn in_tiles(bitmap: Bitmap) -> Self {
        let Bitmap { width, height, mut pixels, .. } = bitmap;
        match &mut pixels {
            Pixels::Palette { indices, .. } => tile(indices, width, height),
            Pixels::Grey8(v) => tile(v, width, height),
            Pixels::Grey16(v) => tile(v, width, height),
            Pixels::GreyAlpha8(v) => tile(v, width, height),
            Pixels::GreyAlpha16(v) => tile(v, width, height),
            Pixels::Rgb8(v) => tile(v, width, height),
            Pixels::Rgb16(v) => tile(v, width, height),
            Pixels::Rgba8(v) => tile(v, width, height),
            Pixels::Rgba16(v) => tile(v, width, height),
            Pixels::RgbF32(v) => tile(v, width, height),
            Pixels::RgbaF32(v) => tile(v, width, height),
        }
        Mosaic { width, height, layout: Layout::tiles(width), pixels }
    }

    /// Columns, at least 1.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows, at least 1.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Where the pixels stand.
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// The samples by [`Mosaic::layout`]. Those that only fill tiles repeat pixels of the picture.
    pub fn pixels(&self) -> &Pixels {
        &self.pixels
    }
}

/// Moves rows into tiles, from the last band of rows on: a band's tiles never reach into the rows of the bands above it.
fn tile<T: Copy>(pixels: &mut Vec<T>, width: usize, height: usize) {
    let layout = Layout::tiles(width);
    let Some(&filler) = pixels.first() else { return };
    let samples = layout.samples(height);
    pixels.reserve_exact(samples.saturating_sub(pixels.len()));
    pixels.resize(samples, filler);
    let mut band = Vec::with_capacity(SIDE * width);
    for top in (0..height).step_by(SIDE).rev() {
        let rows = SIDE.min(height - top);
        band.clear();
        band.extend_from_slice(&pixels[top * width..(top + rows) * width]);
        let tiles = &mut pixels[layout.index(0, top)..][..layout.pitch];
        for y in 0..SIDE {
            for x in 0..width.next_multiple_of(SIDE) {
                tiles[layout.in_tiles(x, y)] = band[y.min(rows - 1) * width + x.min(width - 1)];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FileCurve;

    fn numbered(width: usize, height: usize) -> Bitmap {
        let pixels = Pixels::Grey16((0..width * height).map(|i| i as u16).collect());
        Bitmap { width, height, pixels, curve: FileCurve::None, premultiplied: false }
    }

    #[test]
    fn every_pixel_is_found_in_its_tile() {
        for (width, height) in
            [(1, 1), (1, 9), (9, 1), (3, 3), (4, 4), (5, 4), (4, 5), (8, 8), (13, 7), (31, 66)]
        {
            let rows = numbered(width, height);
            let mosaic = Mosaic::in_tiles(rows.clone());
            let (Pixels::Grey16(rows), Pixels::Grey16(tiles)) = (&rows.pixels, mosaic.pixels()) else {
                panic!("another kind of pixels");
            };
            let layout = mosaic.layout();
            assert_eq!(tiles.len(), layout.samples(height), "{width} x {height}");
            assert_eq!(tiles.len() % (SIDE * SIDE), 0, "{width} x {height}");
            let mut seen = vec![false; tiles.len()];
            for y in 0..height {
                for x in 0..width {
                    let i = layout.index(x, y);
                    assert_eq!(tiles[i], rows[y * width + x], "{width} x {height} at {x}, {y}");
                    assert!(!std::mem::replace(&mut seen[i], true), "{width} x {height}: {i} twice");
                }
            }
            assert!(tiles.iter().all(|t| rows.contains(t)), "fillers repeat pixels");
        }
    }

    #[test]
    fn neighbours_lie_close_together() {
        let layout = Layout::tiles(4096);
        assert_eq!(layout.index(SIDE - 1, SIDE - 1), SIDE * SIDE - 1);
        assert_eq!(layout.index(SIDE, 0), SIDE * SIDE);
        assert_eq!(layout.index(0, SIDE), 4096 * SIDE);
    }

    #[test]
    fn small_pictures_stay_in_rows() {
        let mosaic = Mosaic::from(numbered(20, 10));
        assert!(!mosaic.layout().is_tiled());
        assert_eq!(mosaic.pixels(), &numbered(20, 10).pixels);
    }
}
