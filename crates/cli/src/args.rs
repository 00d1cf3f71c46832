//! The modern command line.
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::sweep::Sweep;

/// A ray tracer for POV-Ray scenes.
#[derive(Parser)]
#[command(name = "raggio", version, about, args_conflicts_with_subcommands = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub command: Option<Command>,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Render a scene to a picture.
    Render(RenderArgs),
    /// Read a scene and report its faults without rendering.
    Check(CheckArgs),
    /// Render a scene with several values of one setting, side by side.
    Sweep(SweepArgs),
    /// Show every pattern, finish or shape on one sheet.
    Gallery(GalleryArgs),
    /// Take POV-Ray's own switches and INI files.
    #[command(disable_help_flag = true)]
    Povray {
        /// `+Iscene.pov +W320 ...`
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
}

impl Default for Command {
    fn default() -> Self {
        Command::Render(RenderArgs::default())
    }
}

/// How messages are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum MessageFormat {
    /// For people.
    #[default]
    Human,
    /// One JSON object a line.
    Json,
}

/// Which scene, and where its files are.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct SceneArgs {
    /// The scene, or a model (.obj, .ply, .stl); `-` reads standard input; without one a scene that is built in.
    pub scene: Option<PathBuf>,
    /// Another folder to look for include files, pictures and fonts in.
    #[arg(long, value_name = "FOLDER")]
    pub library: Vec<PathBuf>,
    /// Prefer the include files of an installed POV-Ray to those that are built in.
    #[arg(long, conflicts_with = "no_installed_library")]
    pub installed_library: bool,
    /// Leave an installed POV-Ray alone even for fonts and pictures that are not built in.
    #[arg(long)]
    pub no_installed_library: bool,
    /// Declare a name before the scene begins.
    #[arg(long, value_name = "NAME=VALUE", value_parser = declaration)]
    pub declare: Vec<(String, raggio::Declared)>,
    /// The value of `clock`.
    #[arg(long)]
    pub clock: Option<f64>,
    /// The picture's size in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<(usize, usize)>,
    /// Say how long each step took.
    #[arg(long)]
    pub timing: bool,
    /// How messages are written.
    #[arg(long, value_enum, default_value_t)]
    pub message_format: MessageFormat,
}

/// How it is rendered.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct TraceArgs {
    /// Threads; 0 takes one for each core.
    #[arg(long, default_value_t)]
    pub threads: usize,
    /// 0 (quick colours) to 9 (everything).
    #[arg(long, value_parser = clap::value_parser!(u8).range(0..=9))]
    pub quality: Option<u8>,
    /// Smooth edges; the threshold says from which difference on (0.3).
    #[arg(long, value_name = "THRESHOLD", num_args = 0..=1, require_equals = true, default_missing_value = "0.3")]
    pub antialias: Option<f32>,
    /// Most reflections and refractions in a row, in place of the scene's `max_trace_level`.
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=256))]
    pub max_depth: Option<u16>,
    /// Another choice of random numbers.
    #[arg(long, default_value_t)]
    pub seed: u64,
}

#[derive(Args, Clone, Debug, Default)]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub trace: TraceArgs,
    /// The picture's file; its ending says the format; `-` is standard output, as PNG.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Render a part only; the rest stays black.
    #[arg(long, value_name = "LEFT,TOP,RIGHT,BOTTOM", value_parser = region)]
    pub region: Option<raggio::Region>,
    /// Keep transparency.
    #[arg(long)]
    pub alpha: bool,
    /// Bits per channel of PNG and PPM, 5 to 16.
    #[arg(long, value_parser = clap::value_parser!(u8).range(5..=16))]
    pub bits: Option<u8>,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct SweepArgs {
    /// The scene; without one a scene that is built in.
    pub scene: Option<PathBuf>,
    /// Another folder to look for include files, pictures and fonts in.
    #[arg(long, value_name = "FOLDER")]
    pub library: Vec<PathBuf>,
    /// The size of each picture.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<(usize, usize)>,
    /// Threads; 0 takes one for each core.
    #[arg(long, default_value_t)]
    pub threads: usize,
    /// Smooth edges.
    #[arg(long, value_name = "THRESHOLD", num_args = 0..=1, require_equals = true, default_missing_value = "0.3")]
    pub antialias: Option<f32>,
    /// How messages are written.
    #[arg(long, value_enum, default_value_t)]
    pub message_format: MessageFormat,
    #[command(flatten)]
    pub sweep: SweepChoice,
    /// The file of the contact sheet, a PNG.
    #[arg(short, long, value_name = "FILE", default_value = "sweep.png")]
    pub output: PathBuf,
}

/// What is varied: exactly one of these. `a..b` counts by 1, `a..b:step` by `step`.
#[derive(Args, Clone, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct SweepChoice {
    /// Most reflections in a row, as in `0..7`.
    #[arg(long, value_name = "RANGE", value_parser = crate::sweep::range)]
    pub max_depth: Option<Sweep>,
    /// Quality.
    #[arg(long, value_name = "RANGE", value_parser = crate::sweep::range)]
    pub quality: Option<Sweep>,
    /// Clock, as in `0..1:0.25`.
    #[arg(long, value_name = "RANGE", value_parser = crate::sweep::range)]
    pub clock: Option<Sweep>,
    /// A declared name, as in `Height=1..3:0.5`.
    #[arg(long, value_name = "NAME=RANGE", value_parser = crate::sweep::named_range)]
    pub declare: Option<(String, Sweep)>,
}

/// What a gallery shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum GalleryKind {
    Patterns,
    Finishes,
    Shapes,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct GalleryArgs {
    /// What to show.
    #[arg(value_enum)]
    pub kind: GalleryKind,
    /// The size of each picture.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<(usize, usize)>,
    /// Threads; 0 takes one for each core.
    #[arg(long, default_value_t)]
    pub threads: usize,
    /// How much difference between pixels is smoothed.
    #[arg(long, value_name = "THRESHOLD", default_value_t = 0.1)]
    pub antialias: f32,
    /// How messages are written.
    #[arg(long, value_enum, default_value_t)]
    pub message_format: MessageFormat,
    /// The file of the sheet, a PNG.
    #[arg(short, long, value_name = "FILE", default_value = "gallery.png")]
    pub output: PathBuf,
}

fn size(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match parts {
        Some((w, h)) if (1..=1 << 20).contains(&w) && (1..=1 << 20).contains(&h) => Ok((w, h)),
        _ => Err("a size like 800x600 is expected".to_owned()),
    }
}

fn region(text: &str) -> Result<raggio::Region, String> {
    let parts: Vec<usize> = text.split(',').filter_map(|v| v.trim().parse().ok()).collect();
    match parts[..] {
        [left, top, right, bottom] if left < right && top < bottom => {
            Ok(raggio::Region { left, top, right, bottom })
        }
        _ => Err("left,top,right,bottom in pixels is expected, the last two beyond the first two".to_owned()),
    }
}

/// `NAME=number`, or else `NAME=text`.
fn declaration(text: &str) -> Result<(String, raggio::Declared), String> {
    let (name, value) = text.split_once('=').ok_or("NAME=VALUE is expected")?;
    let well_formed = name
        .chars()
        .enumerate()
        .all(|(i, c)| c == '_' || c.is_ascii_alphabetic() || (i > 0 && c.is_ascii_digit()));
    if name.is_empty() || !well_formed {
        return Err(format!("{name:?} is no name"));
    }
    let value = match value.parse::<f64>() {
        Ok(v) if v.is_finite() => raggio::Declared::Number(v),
        _ => raggio::Declared::String(value.to_owned()),
    };
    Ok((name.to_owned(), value))
}
