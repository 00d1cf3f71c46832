//! Contact sheets: pictures in rows, each with its label below, in a small lettering of our own.
use raggio::image::{Bitmap, Curve, FileCurve, Pixels};

/// Rows of a letter, and the columns that it takes with the gap after it.
const LETTER: (usize, usize) = (7, 6);
/// Room around pictures.
const MARGIN: usize = 6;
/// Height of a label's line.
const LINE: usize = LETTER.0 + 2 * MARGIN;
const PAPER: [u8; 3] = [32, 32, 32];
const INK: [u8; 3] = [230, 230, 230];

/// Each letter in seven rows of five bits, the leftmost bit first.
const FONT: &[(char, [u8; 7])] = &[
    ('0', [14, 17, 19, 21, 25, 17, 14]),
    ('1', [4, 12, 4, 4, 4, 4, 14]),
    ('2', [14, 17, 1, 6, 8, 16, 31]),
    ('3', [14, 17, 1, 6, 1, 17, 14]),
    ('4', [2, 6, 10, 18, 31, 2, 2]),
    ('5', [31, 16, 30, 1, 1, 17, 14]),
    ('6', [6, 8, 16, 30, 17, 17, 14]),
    ('7', [31, 1, 2, 4, 8, 8, 8]),
    ('8', [14, 17, 17, 14, 17, 17, 14]),
    ('9', [14, 17, 17, 15, 1, 2, 12]),
    ('A', [14, 17, 17, 31, 17, 17, 17]),
    ('B', [30, 17, 17, 30, 17, 17, 30]),
    ('C', [14, 17, 16, 16, 16, 17, 14]),
    ('D', [30, 17, 17, 17, 17, 17, 30]),
    ('E', [31, 16, 16, 30, 16, 16, 31]),
    ('F', [31, 16, 16, 30, 16, 16, 16]),
    ('G', [14, 17, 16, 23, 17, 17, 15]),
    ('H', [17, 17, 17, 31, 17, 17, 17]),
    ('I', [14, 4, 4, 4, 4, 4, 14]),
    ('J', [7, 2, 2, 2, 2, 18, 12]),
    ('K', [17, 18, 20, 24, 20, 18, 17]),
    ('L', [16, 16, 16, 16, 16, 16, 31]),
    ('M', [17, 27, 21, 21, 17, 17, 17]),
    ('N', [17, 25, 21, 19, 17, 17, 17]),
    ('O', [14, 17, 17, 17, 17, 17, 14]),
    ('P', [30, 17, 17, 30, 16, 16, 16]),
    ('Q', [14, 17, 17, 17, 21, 18, 13]),
    ('R', [30, 17, 17, 30, 20, 18, 17]),
    ('S', [15, 16, 16, 14, 1, 1, 30]),
    ('T', [31, 4, 4, 4, 4, 4, 4]),
    ('U', [17, 17, 17, 17, 17, 17, 14]),
    ('V', [17, 17, 17, 17, 17, 10, 4]),
    ('W', [17, 17, 17, 21, 21, 27, 17]),
    ('X', [17, 17, 10, 4, 10, 17, 17]),
    ('Y', [17, 17, 10, 4, 4, 4, 4]),
    ('Z', [31, 1, 2, 4, 8, 16, 31]),
    ('=', [0, 0, 31, 0, 31, 0, 0]),
    ('-', [0, 0, 0, 31, 0, 0, 0]),
    ('.', [0, 0, 0, 0, 0, 12, 12]),
    ('_', [0, 0, 0, 0, 0, 0, 31]),
    ('+', [0, 4, 4, 31, 4, 4, 0]),
    (' ', [0; 7]),
];

/// What letters without a drawing look like.
const BOX: [u8; 7] = [31, 17, 17, 17, 17, 17, 31];

/// Puts labelled pictures of one size on a sheet that is about as wide as high.
pub(crate) fn sheet(cells: &[(String, Bitmap)]) -> Bitmap {
    let (width, height) = cells.first().map_or((1, 1), |(_, b)| (b.width, b.height));
    let (cell_width, cell_height) = (width + MARGIN, height + LINE);
    let columns = columns(cells.len(), cell_width, cell_height);
    let rows = cells.len().div_ceil(columns);
    let mut canvas = Canvas::new(columns * cell_width + MARGIN, rows * cell_height + MARGIN);
    for (i, (label, picture)) in cells.iter().enumerate() {
        let (x, y) = (MARGIN + i % columns * cell_width, MARGIN + i / columns * cell_height);
        canvas.paste(x, y, picture);
        canvas.write(x, y + height + MARGIN / 2, label, width);
    }
    canvas.finish()
}

/// All in one row while that is not too wide, else so that the sheet is roughly square.
fn columns(count: usize, width: usize, height: usize) -> usize {
    const WIDEST: usize = 3000;
    if count * width <= WIDEST {
        return count.max(1);
    }
    let square = ((count * height) as f64 / width as f64).sqrt().ceil() as usize;
    square.clamp(1, count.max(1))
}

struct Canvas {
    width: usize,
    pixels: Vec<[u8; 3]>,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Self {
        Canvas { width, pixels: vec![PAPER; width * height] }
    }

    fn paste(&mut self, x: usize, y: usize, picture: &Bitmap) {
        let pixels = picture.pixels.rgb8();
        for (row, line) in pixels.chunks(picture.width.max(1)).enumerate() {
            let start = (y + row) * self.width + x;
            if let Some(target) = self.pixels.get_mut(start..start + line.len()) {
                target.copy_from_slice(line);
            }
        }
    }

    /// Writes as many letters as fit into `room` pixels.
    fn write(&mut self, x: usize, y: usize, text: &str, room: usize) {
        for (i, c) in text.chars().take(room / LETTER.1).enumerate() {
            let c = c.to_ascii_uppercase();
            let rows = FONT.iter().find(|(letter, _)| *letter == c).map_or(BOX, |(_, rows)| *rows);
            for (row, bits) in rows.iter().enumerate() {
                for column in (0..5).filter(|column| bits >> (4 - column) & 1 == 1) {
                    self.pixels[(y + row) * self.width + x + i * LETTER.1 + column] = INK;
                }
            }
        }
    }

    fn finish(self) -> Bitmap {
        Bitmap {
            width: self.width,
            height: self.pixels.len() / self.width,
            pixels: Pixels::Rgb8(self.pixels),
            curve: FileCurve::Stated(Curve::Srgb),
            premultiplied: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(label: &str, shade: u8) -> (String, Bitmap) {
        let pixels = Pixels::Rgb8(vec![[shade; 3]; 40 * 10]);
        let curve = FileCurve::Stated(Curve::Srgb);
        (label.to_owned(), Bitmap { width: 40, height: 10, pixels, curve, premultiplied: false })
    }

    #[test]
    fn pictures_stand_in_a_row_over_their_labels() {
        let sheet = sheet(&[cell("a=1", 100), cell("a=2", 200)]);
        assert_eq!((sheet.width, sheet.height), (2 * 46 + 6, 10 + LINE + 6));
        let pixels = sheet.pixels.rgb8();
        let at = |x: usize, y: usize| pixels[y * sheet.width + x];
        assert_eq!((at(0, 0), at(6, 6), at(45, 15), at(52, 6)), (PAPER, [100; 3], [100; 3], [200; 3]));
        // The letters A of both labels are equal, the digits differ.
        let letter = |x: usize| {
            (0..7)
                .flat_map(|y| (0..5).map(move |c| (c, y)))
                .map(|(c, y)| at(x + c, 19 + y))
                .collect::<Vec<_>>()
        };
        assert!(letter(6).contains(&INK));
        assert_eq!(letter(6), letter(52));
        assert_ne!(letter(6 + 12), letter(52 + 12));
    }

    #[test]
    fn many_pictures_break_into_rows() {
        assert_eq!(columns(5, 320, 240), 5);
        assert!((3..=5).contains(&columns(16, 320, 240)));
        assert_eq!(columns(1, 5000, 5000), 1);
    }
}
