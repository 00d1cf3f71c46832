//! Messages of the modern door, for people or for programs, on standard error.
use std::io::IsTerminal;
use std::time::Duration;

use raggio::Failure;
use raggio::diag::{Diagnostic, Sources};

use crate::args::MessageFormat;

/// Where messages go.
#[derive(Clone, Copy)]
pub(crate) struct Report {
    format: MessageFormat,
    color: bool,
}

impl Report {
    pub(crate) fn new(format: MessageFormat) -> Self {
        let color = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
        Report { format, color }
    }

    /// Are people reading?
    pub(crate) fn human(&self) -> bool {
        self.format == MessageFormat::Human
    }

    pub(crate) fn diagnostics(&self, list: &[Diagnostic], sources: &Sources) {
        for diagnostic in list {
            match self.format {
                MessageFormat::Human => eprint!("{}", diagnostic.render(sources, self.color)),
                MessageFormat::Json => eprintln!("{}", diagnostic.to_json(sources)),
            }
        }
    }

    pub(crate) fn failure(&self, failure: &Failure) {
        self.diagnostics(&failure.diagnostics, &failure.sources);
    }

    /// A message without a place. `severity` is `error`, `warning` or `note`.
    pub(crate) fn say(&self, severity: &str, message: &str) {
        match self.format {
            MessageFormat::Human => eprintln!("{severity}: {message}"),
            MessageFormat::Json => {
                let code = "program";
                eprintln!(
                    "{}",
                    serde_json::json!({ "severity": severity, "code": code, "message": message })
                );
            }
        }
    }

    /// How long the steps took, in order.
    pub(crate) fn timing(&self, steps: &[(&str, Duration)]) {
        match self.format {
            MessageFormat::Human => {
                let said: Vec<String> =
                    steps.iter().map(|(name, time)| format!("{name} {:.3} s", time.as_secs_f64())).collect();
                eprintln!("{}", said.join(", "));
            }
            MessageFormat::Json => {
                let seconds: serde_json::Map<_, _> =
                    steps.iter().map(|(name, time)| (name.to_string(), time.as_secs_f64().into())).collect();
                eprintln!(
                    "{}",
                    serde_json::json!({ "severity": "note", "code": "timing", "seconds": seconds })
                );
            }
        }
    }

    /// What the scene says by `#debug`; it brings its own line ends.
    pub(crate) fn debug(&self, text: &str) {
        match self.format {
            MessageFormat::Human => eprint!("{text}"),
            MessageFormat::Json => {
                eprintln!("{}", serde_json::json!({ "severity": "note", "code": "debug", "message": text }));
            }
        }
    }
}
