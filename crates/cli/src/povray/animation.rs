//! Frames, clocks and the names of pictures.
use std::path::{Path, PathBuf};

use super::keys::Settings;

/// One picture to render.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frame {
    /// 0 without animation.
    pub number: i64,
    pub clock: f64,
}

/// The pictures of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frames {
    pub list: Vec<Frame>,
    pub animated: bool,
    pub initial_frame: i64,
    /// As the scene sees it: one more in a cyclic animation.
    pub final_frame: i64,
    pub initial_clock: f64,
    pub final_clock: f64,
    pub clock_delta: f64,
    /// Digits of the frame's number in file names.
    digits: usize,
}

/// Which frames there are, and their clocks.
pub(crate) fn frames(settings: &Settings) -> Frames {
    // Frame 0 alone is how some callers say that there is no animation.
    let last = settings.final_frame.filter(|&last| (settings.initial_frame, last) != (0, 0));
    let Some(last) = last else {
        let frame = Frame { number: 0, clock: settings.clock.unwrap_or(0.0) };
        return Frames {
            list: vec![frame],
            animated: false,
            initial_frame: 0,
            final_frame: 0,
            initial_clock: 0.0,
            final_clock: 0.0,
            clock_delta: 0.0,
            digits: 0,
        };
    };
    let first = settings.initial_frame;
    let final_frame = last + i64::from(settings.cyclic);
    let span = (final_frame - first) as f64;
    let clock_delta = if span > 0.0 { (settings.final_clock - settings.initial_clock) / span } else { 0.0 };
    let count = (last - first + 1) as f64;
    let subset = |edge: Option<f64>, otherwise: i64| match edge {
        Some(part) if part > 0.0 && part < 1.0 => first - 1 + (part * count) as i64,
        Some(number) => number as i64,
        None => otherwise,
    };
    let (from, to) =
        (subset(settings.subset_start, first).max(first), subset(settings.subset_end, last).min(last));
    let list = (first..=to)
        .step_by(settings.frame_step.max(1) as usize)
        .filter(|&number| number >= from)
        .map(|number| Frame { number, clock: settings.initial_clock + clock_delta * (number - first) as f64 })
        .collect();
    Frames {
        list,
        animated: true,
        initial_frame: first,
        final_frame,
        initial_clock: settings.initial_clock,
        final_clock: settings.final_clock,
        clock_delta,
        digits: last.to_string().len(),
    }
}

/// The file that a frame is written to: `-` is standard output.
///
/// A name without the format's own ending gets it; a folder gets the scene's name; without a name the picture lies
/// beside the scene.
pub(crate) fn output_path(settings: &Settings, frames: &Frames, number: i64) -> PathBuf {
    let extension = settings.format.extension();
    let scene = Path::new(settings.input.as_deref().unwrap_or("object.pov"));
    let stem = scene.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let named = settings.output.as_deref().filter(|name| !name.is_empty());
    let base = match named {
        Some("-") => return PathBuf::from("-"),
        Some(name) if name.ends_with('/') || Path::new(name).is_dir() => Path::new(name).join(stem),
        Some(name) => PathBuf::from(name.strip_suffix(&format!(".{extension}")).unwrap_or(name)),
        None if scene == Path::new("-") => PathBuf::from("stdin"),
        None => scene.with_file_name(stem),
    };
    let mut path = base.into_os_string();
    if frames.animated {
        path.push(format!("{number:0digits$}", digits = frames.digits));
    }
    path.push(format!(".{extension}"));
    PathBuf::from(path)
}
