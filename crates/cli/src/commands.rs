//! `render` and `check`.
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use raggio::image::{EncodeOptions, Format};
use raggio::{Antialias, AntialiasMethod, InstalledLibrary, ParseOptions, RenderOptions, SceneOptions};

use crate::args::{CheckArgs, RenderArgs, SceneArgs, TraceArgs};
use crate::progress::Progress;
use crate::report::Report;
use crate::{Outcome, pipeline};

/// The size of pictures when none is given.
pub(crate) const DEFAULT_SIZE: (usize, usize) = (800, 600);

/// Renders a scene to a file.
pub(crate) fn render(args: &RenderArgs, cancel: &Arc<AtomicBool>) -> Outcome {
    let report = Report::new(args.scene.message_format);
    match try_render(args, &report, cancel) {
        Ok(outcome) => outcome,
        Err(message) => {
            message.iter().for_each(|m| report.say("error", m));
            Outcome::Failed
        }
    }
}

/// `Err` without a message: the diagnostics have been shown already.
fn try_render(
    args: &RenderArgs,
    report: &Report,
    cancel: &Arc<AtomicBool>,
) -> Result<Outcome, Option<String>> {
    let output = output_path(args);
    let format = format_of(&output)?;
    let scene = scene_options(&args.scene).map_err(Some)?;
    let ready = match pipeline::prepare(&scene, &mut |text| report.debug(text), cancel) {
        Ok(ready) => ready,
        Err(failure) => {
            report.failure(&failure);
            return Err(None);
        }
    };
    report.diagnostics(&ready.loaded.warnings, &ready.loaded.sources);
    if let Some(missing) = pipeline::left_out(&ready.loaded) {
        report.say("warning", &missing);
    }
    let options = RenderOptions {
        region: args.region,
        alpha: args.alpha,
        ..trace_options(&args.trace, args.scene.size.unwrap_or(DEFAULT_SIZE))
    };
    let start = Instant::now();
    let film = {
        let progress = Progress::new("rendering", report.human());
        ready.world.render(&options, cancel, &|done, all| progress.set(done, all))
    };
    let traced = start.elapsed();
    ready.world.warnings().iter().for_each(|warning| report.say("warning", warning));
    let cancelled = film.cancelled;
    let encode = EncodeOptions {
        format,
        alpha: args.alpha,
        bits: args.bits.unwrap_or(8),
        threads: args.trace.threads,
        ..EncodeOptions::default()
    };
    let encode = pipeline::encode_options(&ready.loaded, encode);
    raggio::write_picture(&pipeline::picture(film), &encode, &output).map_err(|e| Some(e.to_string()))?;
    if args.scene.timing {
        let written = start.elapsed() - traced;
        report.timing(&[
            ("read", ready.parse_time),
            ("build", ready.build_time),
            ("trace", traced),
            ("write", written),
        ]);
    }
    // The process ends here, and the system takes memory back faster than piece by piece.
    std::mem::forget(ready);
    if cancelled {
        report.say("warning", &format!("interrupted; {} holds what was there", output.display()));
        return Ok(Outcome::Interrupted);
    }
    if args.scene.scene.is_none() {
        report.say("note", &what_next(&output));
    }
    Ok(Outcome::Done)
}

/// For somebody who has just started the program for the first time.
fn what_next(output: &Path) -> String {
    let place = std::path::absolute(output).unwrap_or_else(|_| output.to_path_buf());
    format!(
        "the built-in scene is drawn: {}\nnext: `raggio render scene.pov` draws a scene of yours, `raggio help` shows the rest",
        place.display()
    )
}

/// Reads a scene and reports its faults.
pub(crate) fn check(args: &CheckArgs, cancel: &Arc<AtomicBool>) -> Outcome {
    let report = Report::new(args.scene.message_format);
    let scene = match scene_options(&args.scene) {
        Ok(scene) => scene,
        Err(message) => {
            report.say("error", &message);
            return Outcome::Failed;
        }
    };
    match pipeline::prepare(&scene, &mut |text| report.debug(text), cancel) {
        Ok(ready) => {
            report.diagnostics(&ready.loaded.warnings, &ready.loaded.sources);
            if let Some(missing) = pipeline::left_out(&ready.loaded) {
                report.say("warning", &missing);
            }
            if args.scene.timing {
                report.timing(&[("read", ready.parse_time), ("build", ready.build_time)]);
            }
            std::mem::forget(ready);
            Outcome::Done
        }
        Err(failure) => {
            report.failure(&failure);
            Outcome::Failed
        }
    }
}

/// The scene with its surroundings.
pub(crate) fn scene_options(args: &SceneArgs) -> Result<SceneOptions, String> {
    let (width, height) = args.size.unwrap_or(DEFAULT_SIZE);
    let parse = ParseOptions {
        declares: args.declare.clone(),
        clock: args.clock.unwrap_or(0.0),
        clock_on: args.clock.is_some(),
        image_width: width as u32,
        image_height: height as u32,
        ..ParseOptions::default()
    };
    let mut options = SceneOptions {
        path: args.scene.clone(),
        libraries: args.library.clone(),
        installed_library: match (args.installed_library, args.no_installed_library) {
            (true, _) => InstalledLibrary::First,
            (_, true) => InstalledLibrary::Never,
            _ => InstalledLibrary::Last,
        },
        parse,
        ..SceneOptions::default()
    };
    if args.scene.as_deref() == Some(Path::new("-")) {
        let text = pipeline::standard_input().map_err(|e| format!("cannot read standard input: {e}"))?;
        (options.path, options.text) = (None, Some(("standard input".to_owned(), text)));
    }
    Ok(options)
}

/// How to trace, for a picture of this size.
pub(crate) fn trace_options(args: &TraceArgs, size: (usize, usize)) -> RenderOptions {
    RenderOptions {
        quality: args.quality.unwrap_or(9),
        antialias: args.antialias.map(antialias),
        threads: args.threads,
        seed: args.seed,
        max_trace_level: args.max_depth,
        ..pipeline::render_options(size)
    }
}

/// The method that the program uses by itself, with POV-Ray's own numbers.
pub(crate) fn antialias(threshold: f32) -> Antialias {
    Antialias { method: AntialiasMethod::NonRecursive, threshold, depth: 3, jitter: 1.0, gamma: 2.5 }
}

/// The picture's file: as given, or the scene's name with `.png` in this folder.
fn output_path(args: &RenderArgs) -> PathBuf {
    match (&args.output, &args.scene.scene) {
        (Some(output), _) => output.clone(),
        (None, Some(scene)) if scene != Path::new("-") => {
            PathBuf::from(scene.file_name().unwrap_or_default()).with_extension("png")
        }
        _ => PathBuf::from("default.png"),
    }
}

fn format_of(output: &Path) -> Result<Format, Option<String>> {
    let name = output.to_string_lossy();
    if name == "-" {
        return Ok(Format::Png);
    }
    let unknown = "its ending is no picture format; choose .png, .jpg, .ppm, .bmp, .tga, .hdr or .exr";
    Format::from_name(&name).ok_or_else(|| Some(format!("cannot write {name}: {unknown}")))
}
