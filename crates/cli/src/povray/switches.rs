//! The switches: `+W320`, `-D`, `+A0.3`. Each says what a pair of INI keys says.
use super::keys::{OptionError, Settings};

/// What may follow a switch, and the INI key that it stands for.
enum Form {
    /// On with plus, off with minus.
    Toggle(&'static str),
    /// The same, and a number may follow for another key.
    ToggleNumber(&'static str, &'static str),
    /// The same, and a text may follow for another key.
    ToggleText(&'static str, &'static str),
    /// A number must follow.
    Number(&'static str),
    /// A text must follow.
    Text(&'static str),
    /// A file type: a letter, then `G` for grey or a number of bits.
    FileType,
    /// Anything may follow, nothing happens.
    Ignored,
}

use Form::*;

/// All switches in capitals.
const SWITCHES: &[(&str, Form)] = &[
    ("A", ToggleNumber("Antialias", "Antialias_Threshold")),
    ("AG", Number("Antialias_Gamma")),
    ("AM", Number("Sampling_Method")),
    ("BM", Number("Bounding_Method")),
    ("BS", Number("Render_Block_Size")),
    ("C", Toggle("Continue_Trace")),
    ("D", Ignored),
    ("EC", Number("End_Column")),
    ("EF", Number("Subset_End_Frame")),
    ("EP", Number("Preview_End_Size")),
    ("ER", Number("End_Row")),
    ("F", FileType),
    ("GA", ToggleText("All_Console", "All_File")),
    ("GD", ToggleText("Debug_Console", "Debug_File")),
    ("GF", ToggleText("Fatal_Console", "Fatal_File")),
    ("GI", Text("Create_Ini")),
    ("GP", Ignored),
    ("GR", ToggleText("Render_Console", "Render_File")),
    ("GS", ToggleText("Statistic_Console", "Statistic_File")),
    ("GW", ToggleText("Warning_Console", "Warning_File")),
    ("H", Number("Height")),
    ("HI", Text("Include_Header")),
    ("HR", Toggle("High_Reproducibility")),
    ("I", Text("Input_File_Name")),
    ("J", ToggleNumber("Jitter", "Jitter_Amount")),
    ("K", Number("Clock")),
    ("KC", Toggle("Cyclic_Animation")),
    ("KF", Number("Final_Clock")),
    ("KFF", Number("Final_Frame")),
    ("KFI", Number("Initial_Frame")),
    ("KI", Number("Initial_Clock")),
    ("L", Text("Library_Path")),
    ("MB", ToggleNumber("Bounding", "Bounding_Threshold")),
    ("MI", Number("Max_Image_Buffer_Memory")),
    ("MV", Number("Version")),
    ("O", Text("Output_File_Name")),
    ("P", Toggle("Pause_When_Done")),
    ("Q", Number("Quality")),
    ("R", Number("Antialias_Depth")),
    ("RF", Text("Radiosity_File_Name")),
    ("RFI", Toggle("Radiosity_From_File")),
    ("RFO", Toggle("Radiosity_To_File")),
    ("RP", Number("Render_Pattern")),
    ("RTR", Toggle("Real_Time_Raytracing")),
    ("RVP", Toggle("Radiosity_Vain_Pretrace")),
    ("SC", Number("Start_Column")),
    ("SF", Number("Subset_Start_Frame")),
    ("SP", Number("Preview_Start_Size")),
    ("SR", Number("Start_Row")),
    ("STP", Number("Frame_Step")),
    ("SU", Toggle("Split_Unions")),
    ("TH", ToggleText("Dither", "Dither_Method")),
    ("UA", Toggle("Output_Alpha")),
    ("UD", Toggle("Draw_Vistas")),
    ("UF", Toggle("Field_Render")),
    ("UL", Toggle("Light_Buffer")),
    ("UO", Toggle("Odd_Field")),
    ("UR", Toggle("Remove_Bounds")),
    ("UV", Toggle("Vista_Buffer")),
    ("V", Toggle("Verbose")),
    ("W", Number("Width")),
    ("WL", Number("Warning_Level")),
    ("WT", Number("Work_Threads")),
    ("X", ToggleNumber("Test_Abort", "Test_Abort_Count")),
];

/// Applies a switch, sign and all. The longest name that makes sense of the text wins: `+RFI` is no file name.
pub(super) fn apply(switch: &str, settings: &mut Settings) -> Result<(), OptionError> {
    let unknown = || OptionError::new(switch, "there is no such switch");
    let (on, text) = match switch.split_at_checked(1) {
        Some(("+", text)) => (true, text),
        Some(("-", text)) => (false, text),
        _ => return Err(unknown()),
    };
    let mut candidates: Vec<_> = SWITCHES
        .iter()
        .filter(|(name, _)| text.get(..name.len()).is_some_and(|t| t.eq_ignore_ascii_case(name)))
        .collect();
    candidates.sort_by_key(|(name, _)| std::cmp::Reverse(name.len()));
    let (name, form) =
        candidates.into_iter().find(|(name, form)| form.fits(&text[name.len()..])).ok_or_else(unknown)?;
    let rest = &text[name.len()..];
    let state = if on { "on" } else { "off" };
    let mut set =
        |key: &str, value: &str| settings.set(key, value).map_err(|e| OptionError::new(switch, e.reason));
    match form {
        Toggle(key) => set(key, state),
        ToggleNumber(key, other) | ToggleText(key, other) => {
            set(key, state)?;
            if rest.is_empty() { Ok(()) } else { set(other, rest) }
        }
        Number(key) | Text(key) => set(key, rest),
        FileType => file_type(on, rest, &mut set),
        Ignored => Ok(()),
    }
}

impl Form {
    /// Can this text follow?
    fn fits(&self, rest: &str) -> bool {
        let number = || rest.parse::<f64>().is_ok();
        match self {
            Toggle(_) => rest.is_empty(),
            ToggleNumber(..) => rest.is_empty() || number(),
            ToggleText(..) | Ignored => true,
            Number(_) => number(),
            Text(_) => !rest.is_empty(),
            FileType => {
                let mut letters = rest.chars();
                let known = letters.next().is_none_or(|c| "BCEHJNPT".contains(c.to_ascii_uppercase()));
                let depth = letters.as_str();
                known && (depth.is_empty() || depth.eq_ignore_ascii_case("g") || depth.parse::<u8>().is_ok())
            }
        }
    }
}

fn file_type(
    on: bool,
    rest: &str,
    set: &mut impl FnMut(&str, &str) -> Result<(), OptionError>,
) -> Result<(), OptionError> {
    set("Output_to_File", if on { "on" } else { "off" })?;
    let Some(kind) = rest.get(..1) else { return Ok(()) };
    set("Output_File_Type", kind)?;
    match &rest[1..] {
        "" => Ok(()),
        grey if grey.eq_ignore_ascii_case("g") => set("Grayscale_Output", "on"),
        bits => set("Bits_Per_Color", bits),
    }
}
