//! What a caller says and gets.
/// How to render.
#[derive(Clone, Debug)]
pub struct Options {
    /// Columns of the whole picture.
    pub width: usize,
    /// Rows of the whole picture.
    pub height: usize,
    /// The part to render; `None` is all of it.
    pub region: Option<Region>,
    /// 0..=9 (light spec, section 8).
    pub quality: u8,
    /// `None` takes one sample at each pixel's centre.
    pub antialias: Option<Antialias>,
    /// 0 takes as many as there are cores.
    pub threads: usize,
    /// Changes every random choice; 0 is POV-Ray's own where there is one.
    pub seed: u64,
    /// Overrides the scene's `max_trace_level`.
    pub max_trace_level: Option<u16>,
    /// Keep transparency (`+UA`).
    pub alpha: bool,
}

impl Default for Options {
    /// 800 x 600 pixels, everything on, no anti-aliasing, a thread for each core.
    fn default() -> Self {
        Options {
            width: 800,
            height: 600,
            region: None,
            quality: 9,
            antialias: None,
            threads: 0,
            seed: 0,
            max_trace_level: None,
            alpha: false,
        }
    }
}

/// Pixels `left..right`, `top..bottom`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct Region {
    pub left: usize,
    pub top: usize,
    pub right: usize,
    pub bottom: usize,
}

impl Region {
    /// How many pixels it has.
    pub fn area(&self) -> usize {
        (self.right - self.left) * (self.bottom - self.top)
    }
}

impl Options {
    /// The part to render, kept within the picture.
    pub(crate) fn area(&self) -> Region {
        let whole = Region { left: 0, top: 0, right: self.width, bottom: self.height };
        self.region.map_or(whole, |r| {
            let (right, bottom) = (r.right.min(self.width), r.bottom.min(self.height));
            Region { left: r.left.min(right), top: r.top.min(bottom), right, bottom }
        })
    }
}

/// Anti-aliasing (light spec, section 2).
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Antialias {
    pub method: AntialiasMethod,
    pub threshold: f32,
    pub depth: u32,
    /// 0 switches it off.
    pub jitter: f64,
    pub gamma: f32,
}

/// POV-Ray's two methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum AntialiasMethod {
    NonRecursive,
    Recursive,
}

/// The picture: red, green, blue in the working space, premultiplied, and transmit, per pixel, rows from the top.
#[derive(Clone, Debug)]
pub struct Film {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// `width * height` pixels.
    pub pixels: Vec<[f32; 4]>,
    /// Was it cut short by `cancel`?
    pub cancelled: bool,
}
