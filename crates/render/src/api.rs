//! What a caller says and gets.
use std::sync::atomic::AtomicBool;

use raggio_geometry::BuildError;
use raggio_scene::Scene;

/// A scene made ready for rays.
pub struct World;

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

/// Pixels `left..right`, `top..bottom`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct Region {
    pub left: usize,
    pub top: usize,
    pub right: usize,
    pub bottom: usize,
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

#[allow(unused_variables, clippy::todo, clippy::missing_errors_doc)]
impl World {
    /// Makes a scene ready.
    pub fn build(scene: &Scene) -> Result<World, BuildError> {
        todo!()
    }

    /// Renders. `progress` is called from any thread with (pixels done, pixels in all); `cancel` stops at the next tile.
    pub fn render(
        &self,
        options: &Options,
        cancel: &AtomicBool,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Film {
        todo!()
    }
}
