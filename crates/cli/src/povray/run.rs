//! Renders what the settings say, frame by frame, and tells about it as POV-Ray does.
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use raggio::diag::{Diagnostic, Severity, Sources};
use raggio::image::EncodeOptions;
use raggio::{Antialias, AntialiasMethod, Declared, ParseOptions, Region, RenderOptions, SceneOptions};

use super::animation::{Frame, Frames, frames, output_path};
use super::{Console, Settings, StreamKind};
use crate::{Outcome, cancel, pipeline};

/// Renders all frames. The first that fails ends the run.
pub(super) fn render(settings: &Settings) -> Outcome {
    let console = Console::open(settings);
    let frames = frames(settings);
    let cancel = cancel::on_interrupt();
    let run = Run { settings, console: &console, frames: &frames, cancel };
    run.banner();
    if let Err(message) = run.write_ini() {
        console.line(StreamKind::Fatal, message);
    }
    for (i, frame) in frames.list.iter().enumerate() {
        if frames.animated {
            let text = format!("Rendering frame {} of {} (#{})", i + 1, frames.list.len(), frame.number);
            console.line(StreamKind::Render, text);
        }
        match run.frame(frame) {
            Ok(Outcome::Done) => {}
            Ok(other) => return other,
            Err(message) => {
                message.iter().for_each(|m| console.line(StreamKind::Fatal, m));
                console.line(StreamKind::Fatal, "Render failed");
                return Outcome::Failed;
            }
        }
    }
    console.line(StreamKind::Statistic, "POV-Ray finished");
    Outcome::Done
}

struct Run<'a> {
    settings: &'a Settings,
    console: &'a Console,
    frames: &'a Frames,
    cancel: Arc<AtomicBool>,
}

impl Run<'_> {
    fn banner(&self) {
        let s = self.settings;
        let say = |text: String| self.console.line(StreamKind::Render, text);
        say(format!("Raggio {} as POV-Ray 3.7", env!("CARGO_PKG_VERSION")));
        say("Parser Options".to_owned());
        say(format!("  Input file: {}", s.input.as_deref().unwrap_or("")));
        say("Image Output Options".to_owned());
        say(format!("  Image resolution.....{} by {}", s.width, s.height));
        for name in &s.without_effect {
            self.console.line(StreamKind::Warning, format!("Warning: the option {name} has no effect here."));
        }
        let has_alpha = matches!(s.format.extension(), "png" | "tga" | "bmp" | "exr");
        if s.alpha && s.output_to_file && !has_alpha {
            self.console.line(
                StreamKind::Warning,
                "Warning: Alpha channel output currently not (or not officially) supported with selected output file type.",
            );
        }
    }

    /// `Err` without a message: all has been said.
    fn frame(&self, frame: &Frame) -> Result<Outcome, Option<String>> {
        let scene = self.scene(frame).map_err(Some)?;
        let output = self.output(frame)?;
        self.console.line(
            StreamKind::Render,
            "==== [Parsing...] ==========================================================",
        );
        let mut debug = |text: &str| self.console.say(StreamKind::Debug, text);
        let ready = match pipeline::prepare(&scene, &mut debug, &self.cancel) {
            Ok(ready) => ready,
            Err(_) if self.cancel.load(Ordering::Relaxed) => return Ok(Outcome::Interrupted),
            Err(failure) => {
                failure.diagnostics.iter().for_each(|d| self.diagnostic(d, &failure.sources));
                return Err(Some("Fatal error in parser: Cannot parse input.".to_owned()));
            }
        };
        ready.loaded.warnings.iter().for_each(|d| self.diagnostic(d, &ready.loaded.sources));
        if let Some(missing) = pipeline::left_out(&ready.loaded) {
            self.console.line(StreamKind::Warning, format!("Warning: {missing}"));
        }
        self.console.line(StreamKind::Statistic, format!("  Parse Time:  {}", time(ready.parse_time)));
        self.console.line(StreamKind::Statistic, format!("  Bounding Time:  {}", time(ready.build_time)));
        let options = self.options()?;
        self.console.line(
            StreamKind::Render,
            "==== [Rendering...] ========================================================",
        );
        let start = Instant::now();
        let percent = AtomicUsize::new(usize::MAX);
        let film =
            ready.world.render(&options, &self.cancel, &|done, all| self.progress(&percent, done, all));
        if self.settings.verbose {
            self.console.say(StreamKind::Render, "\n");
        }
        for warning in ready.world.warnings() {
            self.console.line(StreamKind::Warning, format!("Warning: {warning}"));
        }
        let cancelled = film.cancelled;
        if let Some(path) = &output {
            let encode = pipeline::encode_options(&ready.loaded, self.encode());
            raggio::write_picture(&pipeline::picture(film), &encode, path)
                .map_err(|e| Some(e.to_string()))?;
        }
        self.console.line(StreamKind::Statistic, format!("  Trace Time:  {}", time(start.elapsed())));
        if cancelled {
            self.console.line(StreamKind::Fatal, "Render cancelled by user");
            return Ok(Outcome::Interrupted);
        }
        Ok(Outcome::Done)
    }

    /// Says how far the picture is, whenever another percent is done.
    fn progress(&self, last: &AtomicUsize, done: usize, all: usize) {
        let percent = done * 100 / all.max(1);
        if self.settings.verbose && last.swap(percent, Ordering::Relaxed) != percent {
            let text = format!("Rendered {done} of {all} pixels ({percent}%)\r");
            self.console.say(StreamKind::Render, &text);
        }
    }

    /// A message in POV-Ray's form, then the place and the advice in ours.
    fn diagnostic(&self, d: &Diagnostic, sources: &Sources) {
        let (stream, kind) = match d.severity {
            Severity::Error => (StreamKind::Fatal, "Parse Error"),
            Severity::Warning => (StreamKind::Warning, "Parse Warning"),
            Severity::Note => (StreamKind::Debug, "Note"),
        };
        let place = d.span.map(|span| {
            let (line, _) = sources.line_column(span);
            format!("File '{}' line {line}: ", sources.get(span.file).name)
        });
        self.console.line(stream, format!("{}{kind}: {}", place.unwrap_or_default(), d.message));
        if d.severity == Severity::Error {
            self.console.say(stream, &d.render(sources, false));
        }
    }

    fn scene(&self, frame: &Frame) -> Result<SceneOptions, String> {
        let s = self.settings;
        let clock_on = s.clock.is_some() || self.frames.animated;
        // The clock passes through single precision there.
        let single = |v: f64| f64::from(v as f32);
        let parse = ParseOptions {
            declares: s.declares.iter().map(|(name, v)| (name.clone(), Declared::Number(*v))).collect(),
            clock: single(frame.clock),
            clock_on,
            image_width: s.width as u32,
            image_height: s.height as u32,
            frame_number: frame.number as f64,
            initial_frame: self.frames.initial_frame as f64,
            final_frame: self.frames.final_frame as f64,
            initial_clock: self.frames.initial_clock,
            final_clock: self.frames.final_clock,
            clock_delta: self.frames.clock_delta,
            version: s.version.map(|v| (v * 100.0).round() as u16),
        };
        let name = s.input.clone().unwrap_or_default();
        let path = scene_path(&name);
        let failed = |e: std::io::Error| format!("Parse Error: Cannot open input file {name}: {e}");
        let mut text =
            if name == "-" { pipeline::standard_input() } else { std::fs::read(&path) }.map_err(failed)?;
        if let Some(header) = &s.include_header {
            // On the first line, so that the numbers of lines stay.
            text.splice(0..0, format!("#include \"{header}\" ").into_bytes());
        }
        Ok(SceneOptions {
            text: Some((if name == "-" { name } else { path.display().to_string() }, text)),
            path: Some(path),
            libraries: s.libraries.iter().map(PathBuf::from).collect(),
            installed_library: raggio::InstalledLibrary::First,
            parse,
        })
    }

    /// The picture's file; `None` without file output. Its folder must exist before the work begins.
    fn output(&self, frame: &Frame) -> Result<Option<PathBuf>, Option<String>> {
        if !self.settings.output_to_file {
            return Ok(None);
        }
        let path = output_path(self.settings, self.frames, frame.number);
        match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
                Err(Some(format!("Cannot create output file {}: there is no such folder", path.display())))
            }
            _ => Ok(Some(path)),
        }
    }

    fn options(&self) -> Result<RenderOptions, Option<String>> {
        let s = self.settings;
        let region = region(s).map_err(Some)?;
        let antialias = Antialias {
            method: if s.sampling_method == 2 {
                AntialiasMethod::Recursive
            } else {
                AntialiasMethod::NonRecursive
            },
            threshold: s.threshold,
            depth: s.depth.unwrap_or(3),
            jitter: if s.jitter { s.jitter_amount } else { 0.0 },
            gamma: s.antialias_gamma,
        };
        Ok(RenderOptions {
            region,
            quality: s.quality,
            antialias: s.antialias.then_some(antialias),
            threads: s.threads,
            alpha: s.alpha,
            ..pipeline::render_options((s.width, s.height))
        })
    }

    fn encode(&self) -> EncodeOptions {
        let s = self.settings;
        EncodeOptions {
            format: s.format,
            // Grey PNG is made for height fields and always holds 16 bits.
            bits: if s.grey && s.format == raggio::image::Format::Png { 16 } else { s.bits },
            alpha: s.alpha,
            grey: s.grey,
            file: s.file_curve,
            dither: s.dither.then_some(s.dither_method),
            quality: if s.compression < 2 { 85 } else { s.compression },
            run_length: s.run_length,
            threads: s.threads,
            ..EncodeOptions::default()
        }
    }

    /// `Create_Ini`: the options that matter, in a file that can be rendered again.
    fn write_ini(&self) -> Result<(), String> {
        let s = self.settings;
        let Some(name) = &s.create_ini else { return Ok(()) };
        let input = s.input.as_deref().unwrap_or("");
        let switched = ["on", "true", "yes", "1"].iter().any(|word| name.eq_ignore_ascii_case(word));
        let path = if switched { Path::new(input).with_extension("ini") } else { PathBuf::from(name) };
        let onoff = |on: bool| if on { "on" } else { "off" };
        let mut text = format!(
            "Input_File_Name=\"{input}\"\nWidth={}\nHeight={}\nQuality={}\nBits_Per_Color={}\nOutput_Alpha={}\n\
             Antialias={}\nAntialias_Threshold={}\nSampling_Method={}\n",
            s.width,
            s.height,
            s.quality,
            s.bits,
            onoff(s.alpha),
            onoff(s.antialias),
            s.threshold,
            s.sampling_method,
        );
        s.output.iter().for_each(|o| text.push_str(&format!("Output_File_Name=\"{o}\"\n")));
        s.clock.iter().for_each(|c| text.push_str(&format!("Clock={c}\n")));
        s.final_frame.iter().for_each(|f| text.push_str(&format!("Final_Frame={f}\n")));
        s.libraries.iter().for_each(|l| text.push_str(&format!("Library_Path=\"{l}\"\n")));
        s.declares.iter().for_each(|(name, v)| text.push_str(&format!("Declare={name}={v}\n")));
        std::fs::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
    }
}

/// The scene as named, or with `.pov` or `.POV`.
fn scene_path(name: &str) -> PathBuf {
    let candidates = [name.to_owned(), format!("{name}.pov"), format!("{name}.POV")];
    let found = candidates.into_iter().map(PathBuf::from).find(|path| path.is_file());
    found.unwrap_or_else(|| PathBuf::from(name))
}

/// The part to render. Edges up to 1 are parts of the side, others count pixels from 1; both ends belong to it.
pub(super) fn region(s: &Settings) -> Result<Option<Region>, String> {
    if s.width == 0 || s.height == 0 {
        return Err("Fatal error in renderer: Invalid start column or row".to_owned());
    }
    if s.columns == (None, None) && s.rows == (None, None) {
        return Ok(None);
    }
    let start = |edge: Option<f64>, side: usize| match edge {
        Some(part) if part > 0.0 && part < 1.0 => (part * side as f64) as usize,
        Some(number) => (number.max(1.0) as usize).saturating_sub(1),
        None => 0,
    };
    let end = |edge: Option<f64>, side: usize| match edge {
        Some(part) if (0.0..=1.0).contains(&part) => (part * side as f64) as usize,
        Some(number) => number.max(0.0) as usize,
        None => side,
    };
    let (left, right) = (start(s.columns.0, s.width), end(s.columns.1, s.width));
    let (top, bottom) = (start(s.rows.0, s.height), end(s.rows.1, s.height));
    if left >= s.width || top >= s.height {
        return Err("Fatal error in renderer: Invalid start column or row".to_owned());
    }
    if right > s.width || bottom > s.height {
        return Err("Fatal error in renderer: Invalid end column or row".to_owned());
    }
    Ok(Some(Region { left, top, right: right.max(left), bottom: bottom.max(top) }))
}

fn time(t: Duration) -> String {
    let s = t.as_secs();
    format!("{} hours {} minutes {} seconds ({:.3} seconds)", s / 3600, s / 60 % 60, s % 60, t.as_secs_f64())
}
