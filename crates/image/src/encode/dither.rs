//! Rounding of encoded values to whole numbers, with or without dithering (language spec, section 5.6).

/// How rounding errors are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dither {
    /// Ordered, 2 x 2.
    B2,
    /// Ordered, 3 x 3.
    B3,
    /// Ordered, 4 x 4.
    B4,
    /// Error diffusion to the next pixel.
    D1,
    /// Error diffusion to the right and below.
    D2,
    /// Floyd and Steinberg's error diffusion.
    FloydSteinberg,
}

const B2: [[u8; 2]; 2] = [[1, 3], [4, 2]];
const B3: [[u8; 3]; 3] = [[3, 7, 4], [6, 1, 9], [2, 8, 5]];
const B4: [[u8; 4]; 4] = [[1, 9, 3, 11], [13, 5, 15, 7], [4, 12, 2, 10], [16, 8, 14, 6]];

impl Dither {
    /// By the name that the language's switches use.
    pub fn from_name(name: &str) -> Option<Dither> {
        Some(match name.to_ascii_uppercase().as_str() {
            "B2" => Dither::B2,
            "B3" => Dither::B3,
            "B4" => Dither::B4,
            "D1" => Dither::D1,
            "D2" => Dither::D2,
            "FS" => Dither::FloydSteinberg,
            _ => return None,
        })
    }

    /// What an ordered method adds to the encoded value at column x and row y, in steps of the file's numbers.
    fn offset(self, x: usize, y: usize) -> f32 {
        let centred = |k: u8, n: u8| f32::from(k) / f32::from(n) - 0.5;
        match self {
            Dither::B2 => centred(B2[x % 2][y % 2], 4),
            Dither::B3 => centred(B3[x % 3][y % 3], 9),
            Dither::B4 => centred(B4[x % 4][y % 4], 16),
            _ => 0.0,
        }
    }

    /// Where diffused error goes: to the right, then below left, below and below right.
    fn weights(self) -> [f32; 4] {
        match self {
            Dither::D1 => [1.0, 0.0, 0.0, 0.0],
            Dither::D2 => [0.5, 0.0, 0.25, 0.25],
            Dither::FloydSteinberg => [7.0 / 16.0, 3.0 / 16.0, 5.0 / 16.0, 1.0 / 16.0],
            _ => [0.0; 4],
        }
    }
}

/// A value in 0..=1 as one of the whole numbers 0..=max.
pub(super) fn rounded(v: f32, max: f32) -> u16 {
    (v.clamp(0.0, 1.0) * max + 0.5) as u16
}

/// Rounds the values of one channel, pixel after pixel, rows from the top.
pub(super) struct Rounder<'a> {
    pub dither: Option<Dither>,
    pub max: f32,
    /// From the working space to the file's curve.
    pub encode: &'a dyn Fn(f32) -> f32,
    /// And back.
    pub decode: &'a dyn Fn(f32) -> f32,
}

impl Rounder<'_> {
    /// The whole numbers for `values`, which are in the working space.
    pub(super) fn channel(&self, width: usize, values: impl Iterator<Item = f32>) -> Vec<u16> {
        match self.dither {
            None => values.map(|v| rounded((self.encode)(v), self.max)).collect(),
            Some(d @ (Dither::B2 | Dither::B3 | Dither::B4)) => values
                .enumerate()
                .map(|(i, v)| {
                    let offset = d.offset(i % width, i / width) / self.max;
                    rounded((self.encode)(v) + offset, self.max)
                })
                .collect(),
            Some(d) => self.diffused(width, values, d),
        }
    }

    /// Error diffusion; the error lives in the working space. As in the program, the simplest method runs on over the
    /// ends of rows, and the others use the sum for the first pixel of a row one row late.
    fn diffused(&self, width: usize, values: impl Iterator<Item = f32>, dither: Dither) -> Vec<u16> {
        let [right, below_left, below, below_right] = dither.weights();
        let (mut here, mut next) = (vec![0.0; width], vec![0.0; width]);
        let mut carried = 0.0;
        let mut late = 0.0;
        let mut out = Vec::new();
        for (i, v) in values.enumerate() {
            let x = i % width;
            if x == 0 {
                std::mem::swap(&mut here, &mut next);
                next.fill(0.0);
                late = std::mem::replace(&mut here[0], late);
                carried = if dither == Dither::D1 { carried } else { 0.0 };
            }
            let wanted = v + here[x] + carried;
            let written = rounded((self.encode)(wanted), self.max);
            let error = wanted.clamp(0.0, 1.0) - (self.decode)(f32::from(written) / self.max);
            let error = if error.is_finite() { error } else { 0.0 };
            carried = right * error;
            if x > 0 {
                next[x - 1] += below_left * error;
            }
            next[x] += below * error;
            if x + 1 < width {
                next[x + 1] += below_right * error;
            }
            out.push(written);
        }
        out
    }
}
