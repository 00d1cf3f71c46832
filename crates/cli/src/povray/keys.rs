//! The INI keys and what they set. Switches set the same things under other names.
use raggio::image::{Curve, Dither, Format};

/// An option that makes no sense.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OptionError {
    /// The option as it was written.
    pub option: String,
    /// What is wrong with it.
    pub reason: String,
}

impl OptionError {
    pub(super) fn new(option: impl Into<String>, reason: impl Into<String>) -> Self {
        OptionError { option: option.into(), reason: reason.into() }
    }
}

/// A row or column: a number of pixels or a part of the picture.
pub(crate) type Edge = Option<f64>;

/// A text stream: where it is shown, and the file that it goes to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stream {
    pub console: bool,
    pub file: Option<String>,
}

/// The streams by their place in [`Settings::streams`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StreamKind {
    Debug,
    Fatal,
    Render,
    Statistic,
    Warning,
    /// All of them together.
    All,
}

/// Everything that switches and INI files can set, with the values that it has when they do not.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Settings {
    pub input: Option<String>,
    pub output: Option<String>,
    pub output_to_file: bool,
    pub format: Format,
    pub run_length: bool,
    pub bits: u8,
    pub alpha: bool,
    pub grey: bool,
    pub compression: u8,
    pub file_curve: Curve,
    pub dither: bool,
    pub dither_method: Dither,
    pub width: usize,
    pub height: usize,
    pub columns: (Edge, Edge),
    pub rows: (Edge, Edge),
    pub quality: u8,
    pub antialias: bool,
    pub threshold: f32,
    pub sampling_method: u8,
    pub depth: Option<u32>,
    pub jitter: bool,
    pub jitter_amount: f64,
    pub antialias_gamma: f32,
    pub libraries: Vec<String>,
    pub include_header: Option<String>,
    pub version: Option<f64>,
    pub declares: Vec<(String, f64)>,
    pub clock: Option<f64>,
    pub initial_clock: f64,
    pub final_clock: f64,
    pub initial_frame: i64,
    pub final_frame: Option<i64>,
    pub subset_start: Option<f64>,
    pub subset_end: Option<f64>,
    pub frame_step: i64,
    pub cyclic: bool,
    pub threads: usize,
    pub verbose: bool,
    pub create_ini: Option<String>,
    pub streams: [Stream; 6],
    /// Options that were understood but change nothing here, by name.
    pub without_effect: Vec<&'static str>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            input: None,
            output: None,
            output_to_file: true,
            format: Format::Png,
            run_length: false,
            bits: 8,
            alpha: false,
            grey: false,
            compression: 0,
            file_curve: Curve::Srgb,
            dither: false,
            dither_method: Dither::FloydSteinberg,
            width: 800,
            height: 600,
            columns: (None, None),
            rows: (None, None),
            quality: 9,
            antialias: false,
            threshold: 0.3,
            sampling_method: 1,
            depth: None,
            jitter: true,
            jitter_amount: 1.0,
            antialias_gamma: 2.5,
            libraries: Vec::new(),
            include_header: None,
            version: None,
            declares: Vec::new(),
            clock: None,
            initial_clock: 0.0,
            final_clock: 1.0,
            initial_frame: 1,
            final_frame: None,
            subset_start: None,
            subset_end: None,
            frame_step: 1,
            cyclic: false,
            threads: 0,
            verbose: true,
            create_ini: None,
            streams: std::array::from_fn(|_| Stream { console: true, file: None }),
            without_effect: Vec::new(),
        }
    }
}

/// Keys that are understood and change nothing: displays, bounding methods, buffers.
const HARMLESS: &[&str] = &[
    "Bounding",
    "Bounding_Method",
    "Bounding_Threshold",
    "BSP_BaseAccessCost",
    "BSP_ChildAccessCost",
    "BSP_IsectCost",
    "BSP_MaxDepth",
    "BSP_MissChance",
    "Buffer_Output",
    "Buffer_Size",
    "Display",
    "Display_Gamma",
    "Draw_Vistas",
    "High_Reproducibility",
    "Light_Buffer",
    "Max_Image_Buffer_Memory",
    "Palette",
    "Pause_When_Done",
    "Preview_End_Size",
    "Preview_Start_Size",
    "Radiosity_Vain_Pretrace",
    "Remove_Bounds",
    "Render_Block_Size",
    "Render_Block_Step",
    "Render_Pattern",
    "Split_Unions",
    "Test_Abort",
    "Test_Abort_Count",
    "Video_Mode",
    "Vista_Buffer",
    "Warning_Level",
];

/// Keys that are understood but not obeyed, which a user should know.
const WITHOUT_EFFECT: &[&str] = &[
    "Continue_Trace",
    "Fatal_Error_Command",
    "Fatal_Error_Return",
    "Field_Render",
    "Odd_Field",
    "Post_Frame_Command",
    "Post_Frame_Return",
    "Post_Scene_Command",
    "Post_Scene_Return",
    "Pre_Frame_Command",
    "Pre_Frame_Return",
    "Pre_Scene_Command",
    "Pre_Scene_Return",
    "Radiosity_File_Name",
    "Radiosity_From_File",
    "Radiosity_To_File",
    "User_Abort_Command",
    "User_Abort_Return",
];

/// A truth value: anything but these words is false.
fn truth(value: &str) -> bool {
    ["on", "true", "yes", "1"].iter().any(|word| value.eq_ignore_ascii_case(word))
}

/// A word that is no file name but switches something.
fn is_truth(value: &str) -> bool {
    truth(value) || ["off", "false", "no", "0"].iter().any(|word| value.eq_ignore_ascii_case(word))
}

/// The first word of the value, as a number.
fn number(value: &str) -> Result<f64, String> {
    let word = value.split_whitespace().next().unwrap_or("");
    match word.parse::<f64>() {
        Ok(v) if v.is_finite() => Ok(v),
        _ => Err(format!("a number is expected, not {value:?}")),
    }
}

/// A whole number of `range`; fractions are cut off.
fn whole(value: &str, range: std::ops::RangeInclusive<i64>) -> Result<i64, String> {
    let v = number(value)?.trunc();
    let (low, high) = (*range.start(), *range.end());
    if v >= low as f64 && v <= high as f64 {
        Ok(v as i64)
    } else {
        Err(format!("a number between {low} and {high} is expected, not {value}"))
    }
}

/// Most pixels along a side.
const MOST_PIXELS: i64 = 1 << 20;

impl Settings {
    /// Sets a key; its case does not matter.
    pub(super) fn set(&mut self, key: &str, value: &str) -> Result<(), OptionError> {
        let value = value.trim();
        let known = |names: &[&'static str]| names.iter().copied().find(|n| n.eq_ignore_ascii_case(key));
        if known(HARMLESS).is_some() {
            return Ok(());
        }
        if let Some(name) = known(WITHOUT_EFFECT) {
            if !value.is_empty() && (truth(value) || !is_truth(value)) {
                self.without_effect.push(name);
            }
            return Ok(());
        }
        let lower = key.to_ascii_lowercase();
        let found = match self.set_output(&lower, value) {
            Ok(false) => self.set_tracing(&lower, value),
            other => other,
        };
        let found = match found {
            Ok(false) => self.set_scene(&lower, value),
            other => other,
        };
        match found {
            Ok(true) => Ok(()),
            Ok(false) => Err(OptionError::new(format!("{key}={value}"), "there is no such option")),
            Err(reason) => Err(OptionError::new(format!("{key}={value}"), reason)),
        }
    }

    /// The picture's file and the text streams. `false`: the key is none of these.
    fn set_output(&mut self, key: &str, value: &str) -> Result<bool, String> {
        match key {
            "output_file_name" => self.output = Some(value.to_owned()),
            "output_to_file" => self.output_to_file = truth(value),
            "output_file_type" => self.set_file_type(value)?,
            "output_alpha" => self.alpha = truth(value),
            "bits_per_color" => self.bits = whole(value, 0..=100)?.clamp(5, 16) as u8,
            "grayscale_output" => self.grey = truth(value),
            "compression" => self.compression = whole(value, 0..=100)? as u8,
            "file_gamma" if value.eq_ignore_ascii_case("srgb") => self.file_curve = Curve::Srgb,
            "file_gamma" => match number(value)? {
                g if g > 0.0 => self.file_curve = Curve::power(g as f32),
                _ => return Err("a gamma above 0 is expected".to_owned()),
            },
            "dither" => self.dither = truth(value),
            "dither_method" => {
                self.dither_method =
                    Dither::from_name(value).ok_or("B2, B3, B4, D1, D2 or FS is expected")?;
            }
            "real_time_raytracing" => self.output_to_file &= !truth(value),
            "create_ini" => self.create_ini = (!is_truth(value) || truth(value)).then(|| value.to_owned()),
            "verbose" => self.verbose = truth(value),
            _ => return self.set_stream(key, value),
        }
        Ok(true)
    }

    fn set_file_type(&mut self, value: &str) -> Result<(), String> {
        let (format, run_length) = match value.to_ascii_uppercase().as_str() {
            "B" => (Format::Bmp, false),
            "C" => (Format::Tga, true),
            "E" => (Format::Exr, false),
            "H" => (Format::Hdr, false),
            "J" => (Format::Jpeg, false),
            "N" => (Format::Png, false),
            "P" => (Format::Pnm, false),
            "T" => (Format::Tga, false),
            _ => return Err("B, C, E, H, J, N, P or T is expected".to_owned()),
        };
        (self.format, self.run_length) = (format, run_length);
        Ok(())
    }

    /// `Debug_Console`, `All_File` and the like.
    fn set_stream(&mut self, key: &str, value: &str) -> Result<bool, String> {
        let Some((name, what)) = key.split_once('_') else { return Ok(false) };
        let kind = match name {
            "debug" => StreamKind::Debug,
            "fatal" => StreamKind::Fatal,
            "render" => StreamKind::Render,
            "statistic" => StreamKind::Statistic,
            "warning" => StreamKind::Warning,
            "all" => StreamKind::All,
            _ => return Ok(false),
        };
        match what {
            "console" if kind == StreamKind::All => {
                self.streams.iter_mut().for_each(|s| s.console = truth(value));
            }
            "console" => self.streams[kind as usize].console = truth(value),
            "file" if truth(value) => self.streams[kind as usize].file = Some(format!("{name}text.out")),
            "file" => self.streams[kind as usize].file = (!is_truth(value)).then(|| value.to_owned()),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// How the picture is computed.
    fn set_tracing(&mut self, key: &str, value: &str) -> Result<bool, String> {
        match key {
            "width" => self.width = whole(value, 0..=MOST_PIXELS)? as usize,
            "height" => self.height = whole(value, 0..=MOST_PIXELS)? as usize,
            "start_column" => self.columns.0 = Some(number(value)?),
            "end_column" => self.columns.1 = Some(number(value)?),
            "start_row" => self.rows.0 = Some(number(value)?),
            "end_row" => self.rows.1 = Some(number(value)?),
            "quality" => self.quality = whole(value, 0..=i64::from(i32::MAX))?.min(9) as u8,
            "antialias" => self.antialias = truth(value),
            "antialias_threshold" => self.threshold = number(value)? as f32,
            "antialias_depth" => self.depth = Some(whole(value, 1..=9)? as u32),
            "antialias_gamma" => self.antialias_gamma = number(value)? as f32,
            "sampling_method" => self.sampling_method = whole(value, 1..=3)? as u8,
            "jitter" => self.jitter = truth(value),
            "jitter_amount" => self.jitter_amount = number(value)?,
            "work_threads" => self.threads = whole(value, 0..=512)? as usize,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The scene, its surroundings, and animation.
    fn set_scene(&mut self, key: &str, value: &str) -> Result<bool, String> {
        const FRAMES: std::ops::RangeInclusive<i64> = -1_000_000_000..=1_000_000_000;
        match key {
            "input_file_name" => self.input = Some(value.to_owned()),
            "include_header" => self.include_header = Some(value.to_owned()),
            "library_path" => self.libraries.push(value.to_owned()),
            "version" => self.version = Some(number(value)?),
            "declare" => self.declares.push(declaration(value)?),
            "clock" => self.clock = Some(number(value)?),
            "initial_clock" => self.initial_clock = number(value)?,
            "final_clock" => self.final_clock = number(value)?,
            "initial_frame" => self.initial_frame = whole(value, FRAMES)?,
            "final_frame" => self.final_frame = Some(whole(value, FRAMES)?).filter(|&n| n != -1),
            "subset_start_frame" => self.subset_start = Some(number(value)?),
            "subset_end_frame" => self.subset_end = Some(number(value)?),
            "frame_step" => self.frame_step = whole(value, 1..=1_000_000_000)?,
            "cyclic_animation" => self.cyclic = truth(value),
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// `Name=number`. As in the original, what follows the number is ignored: `1/2` is 1.
fn declaration(value: &str) -> Result<(String, f64), String> {
    let (name, value) = value.split_once('=').ok_or("Declare=NAME=NUMBER is expected")?;
    let name = name.trim();
    let starts_well = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if !starts_well || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return Err(format!("{name:?} is no name"));
    }
    let value = value.trim();
    let end = (1..=value.len())
        .rev()
        .find(|&end| value.get(..end).is_some_and(|v| v.trim_end().parse::<f64>().is_ok_and(f64::is_finite)));
    match end.and_then(|end| value[..end].trim_end().parse().ok()) {
        Some(number) => Ok((name.to_owned(), number)),
        None => Err("only numbers can be declared here".to_owned()),
    }
}
