//! `#version` and the gamma that follows from it (language spec, sections 1.8 and 5.1).
use raggio_scene::{Curve, GammaMode, Version};

use super::cursor::Stop;
use super::{Parser, Result, Tok};
use crate::value::Value;

/// The effective version where none was ever set.
const UNDECLARED: u16 = 362;
/// The newest version that POV-Ray 3.7 takes, and the newest that we take.
const CURRENT: u16 = 370;
const NEWEST: u16 = 380;

/// What was said about the version.
#[derive(Debug, Default)]
pub struct VersionState {
    /// Has a `#version` been executed, or one been given from outside?
    set: bool,
    noise_explicit: bool,
}

impl VersionState {
    /// `outside` is the version given by the caller, in hundredths.
    pub fn new(outside: Option<u16>) -> (Self, Version) {
        let language = outside.unwrap_or(CURRENT);
        let effective = outside.unwrap_or(UNDECLARED);
        (VersionState { set: outside.is_some(), noise_explicit: false }, Version { language, effective })
    }
}

impl Parser<'_> {
    /// `#version e;`, the word already read.
    pub(super) fn version_directive(&mut self) -> Result<()> {
        let frame = self.cursor.callers.len();
        let span = self.span();
        let patch = self.unofficial()?;
        self.cursor.stop = Stop::All;
        self.cursor.stop_frame = frame;
        let value = self.float();
        self.cursor.stop = Stop::Never;
        let hundredths = (100.0 * value? + 0.5).trunc();
        if !self.accept_raw_semicolon()? {
            self.warn("missing-semicolon", "#version should end with `;`", span);
        }
        if let Some(patch) = patch {
            let message = format!("this asks for {patch}, a changed POV-Ray; what it adds is not known here");
            self.warn("unofficial-version", message, span);
            return Ok(());
        }
        if !(0.0..=f64::from(NEWEST)).contains(&hundredths) {
            let message = format!("this scene wants version {}; we read up to 3.8", hundredths / 100.0);
            return self.error("version", message, span);
        }
        let language = hundredths as u16;
        if language > CURRENT {
            self.warn("version", "read as 3.7 with a few additions of 3.8", span);
        }
        self.set_version(language);
        Ok(())
    }

    /// `unofficial` before a version, and the name of a patch after it, whose own version the number then is.
    fn unofficial(&mut self) -> Result<Option<String>> {
        if self.peek()? != Tok::Unknown || self.source_text(self.here()) != "unofficial" {
            return Ok(None);
        }
        self.next()?;
        if self.peek()? != Tok::Unknown {
            return Ok(None);
        }
        let patch = self.source_text(self.here());
        self.next()?;
        Ok(Some(patch))
    }

    fn set_version(&mut self, language: u16) {
        self.version.set = true;
        self.settings.version = Version { language, effective: language };
        if !self.version.noise_explicit {
            self.settings.noise_generator = if language < 350 { 1 } else { 2 };
        }
        self.update_gamma();
    }

    /// `noise_generator n` in the global settings.
    pub fn set_noise_generator(&mut self, n: u8) {
        self.version.noise_explicit = true;
        self.settings.noise_generator = n;
    }

    /// `assumed_gamma` in the global settings; the first one counts. False if this is not the first.
    pub fn set_assumed_gamma(&mut self, curve: Curve) -> bool {
        if self.gamma_explicit {
            return false;
        }
        self.gamma_explicit = true;
        self.settings.gamma = GammaMode::Working(curve);
        true
    }

    fn update_gamma(&mut self) {
        if self.gamma_explicit {
            return;
        }
        let modern = self.version.set && self.settings.version.effective >= CURRENT;
        self.settings.gamma = if modern { GammaMode::Working(Curve::Linear) } else { GammaMode::None };
    }

    /// The identifiers that exist before the scene, and what the version given from outside means.
    pub(super) fn begin(&mut self) {
        self.update_gamma();
        if !self.version.noise_explicit && self.lang() < 350 {
            self.settings.noise_generator = 1;
        }
        let o = self.options;
        let numbers = [
            ("image_width", f64::from(o.image_width)),
            ("image_height", f64::from(o.image_height)),
            ("frame_number", o.frame_number),
            ("initial_frame", o.initial_frame),
            ("final_frame", o.final_frame),
            ("initial_clock", o.initial_clock),
            ("final_clock", o.final_clock),
            ("clock_delta", o.clock_delta),
        ];
        for (name, value) in numbers {
            self.predeclare(name, Value::Float(super::six_digits(value)));
        }
        let main = self.file_name(self.cursor.frame.file.file).to_owned();
        self.predeclare("input_file_name", Value::String(main.into()));
        for (name, value) in &o.declares {
            self.predeclare(name, value.to_value());
        }
    }

    fn predeclare(&mut self, name: &str, value: Value) {
        let symbol = self.symbols.intern(name);
        if symbol.keyword().is_none() {
            let slot = self.scopes.bind(symbol, 0);
            *self.scopes.entry_mut(slot) = super::scope::Entry::Value(value);
        }
    }

    /// What is settled when the whole text has been read.
    pub(super) fn end(&mut self) {
        self.update_gamma();
        let language = self.lang();
        if language < 350 {
            let message = "the scene ends with a #version below 3.5 and is rendered as 3.5";
            self.note("old-version", message);
            self.settings.version = Version { language: 350, ..self.settings.version };
        }
        if !self.version.set && !self.gamma_explicit {
            self.note(
                "no-version",
                "no #version and no assumed_gamma: colours are written without gamma correction",
            );
        } else if !self.gamma_explicit && self.settings.version.effective >= CURRENT {
            self.note("no-assumed-gamma", "assumed_gamma is not given; 1.0 is taken");
        }
    }
}
