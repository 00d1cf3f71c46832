//! What the caller says about a run, and what the run gives back.
use raggio_diag::Diagnostic;
use raggio_scene::Scene;

use crate::value::Value;

/// The surroundings of a scene: picture size, clock, names declared from outside.
#[derive(Clone, Debug, Default)]
pub struct ParseOptions {
    /// Names declared before the scene begins.
    pub declares: Vec<(String, Declared)>,
    /// `clock`
    pub clock: f64,
    /// Was a clock given?
    pub clock_on: bool,
    /// `image_width`
    pub image_width: u32,
    /// `image_height`
    pub image_height: u32,
    /// `frame_number`; like the five after it 0 without animation.
    pub frame_number: f64,
    /// `initial_frame`
    pub initial_frame: f64,
    /// `final_frame`
    pub final_frame: f64,
    /// `initial_clock`
    pub initial_clock: f64,
    /// `final_clock`
    pub final_clock: f64,
    /// `clock_delta`
    pub clock_delta: f64,
    /// A version given from outside, in hundredths: 370 is 3.7.
    pub version: Option<u16>,
}

/// A value declared from outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Declared {
    /// A number; six significant digits of it count, as in POV-Ray.
    Number(f64),
    /// A string.
    String(String),
}

impl Declared {
    pub(crate) fn to_value(&self) -> Value {
        match self {
            Declared::Number(x) => Value::Float(crate::parser::six_digits(*x)),
            Declared::String(text) => Value::String(text.as_str().into()),
        }
    }
}

/// A scene that has been read.
#[derive(Debug)]
pub struct Parsed {
    /// The scene.
    pub scene: Scene,
    /// What may not be as meant, in order.
    pub warnings: Vec<Diagnostic>,
}
