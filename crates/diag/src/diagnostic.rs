//! Diagnostics: what went wrong, where, what was expected, what may help.
use crate::Span;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The scene cannot be used.
    Error,
    /// The scene can be used, but perhaps not as meant.
    Warning,
    /// Something worth knowing; also the scene's own `#debug` text.
    Note,
}

/// One step of the way to the place: the call of a macro or the inclusion of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// `macro Foo` or `include "foo.inc"`.
    pub what: String,
    /// Where it was called or included.
    pub span: Span,
}

/// A message to the user with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// How bad.
    pub severity: Severity,
    /// A stable, short, lower-case name for the kind of fault (`unknown-identifier`), for machines.
    pub code: &'static str,
    /// The message: one sentence, no full stop.
    pub message: String,
    /// The place; `None` for faults of the whole run.
    pub span: Option<Span>,
    /// Said under the caret ("expected a float, found a string").
    pub label: String,
    /// Other places that matter ("declared here").
    pub related: Vec<(Span, String)>,
    /// Advice ("did you mean `sphere`?").
    pub hints: Vec<String>,
    /// Macro calls and inclusions on the way here, innermost first.
    pub trace: Vec<Frame>,
}

impl Diagnostic {
    fn new(severity: Severity, code: &'static str, message: String, span: Option<Span>) -> Self {
        Diagnostic {
            severity,
            code,
            message,
            span,
            label: String::new(),
            related: Vec::new(),
            hints: Vec::new(),
            trace: Vec::new(),
        }
    }

    /// An error at a place.
    pub fn error(code: &'static str, message: impl Into<String>, span: impl Into<Option<Span>>) -> Self {
        Self::new(Severity::Error, code, message.into(), span.into())
    }

    /// A warning at a place.
    pub fn warning(code: &'static str, message: impl Into<String>, span: impl Into<Option<Span>>) -> Self {
        Self::new(Severity::Warning, code, message.into(), span.into())
    }

    /// Sets the text under the caret.
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Adds advice.
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }

    /// Adds another place.
    pub fn related(mut self, span: Span, text: impl Into<String>) -> Self {
        self.related.push((span, text.into()));
        self
    }
}
