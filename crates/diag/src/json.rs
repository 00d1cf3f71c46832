//! Diagnostics as one line of JSON, for editors and other programs.
use serde::Serialize;

use crate::{Diagnostic, Sources, Span};

#[derive(Serialize)]
struct Place<'a> {
    file: &'a str,
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
}

#[derive(Serialize)]
struct Remark<'a> {
    message: &'a str,
    #[serde(flatten)]
    place: Place<'a>,
}

#[derive(Serialize)]
struct Message<'a> {
    severity: &'static str,
    code: &'a str,
    message: &'a str,
    #[serde(flatten)]
    place: Option<Place<'a>>,
    #[serde(skip_serializing_if = "str::is_empty")]
    label: &'a str,
    hints: &'a [String],
    related: Vec<Remark<'a>>,
    trace: Vec<Remark<'a>>,
}

impl Diagnostic {
    /// One line of JSON without a line end. Lines and columns count from 1, columns in bytes.
    pub fn to_json(&self, sources: &Sources) -> String {
        let place = |span: Span| {
            let (line, column) = sources.line_column(span);
            let (end_line, end_column) = sources.line_column(Span { start: span.end, ..span });
            Place { file: &sources.get(span.file).name, line, column, end_line, end_column }
        };
        let message = Message {
            severity: self.severity.name(),
            code: self.code,
            message: &self.message,
            place: self.span.map(place),
            label: &self.label,
            hints: &self.hints,
            related: self
                .related
                .iter()
                .map(|(span, text)| Remark { message: text, place: place(*span) })
                .collect(),
            trace: self
                .trace
                .iter()
                .map(|step| Remark { message: &step.what, place: place(step.span) })
                .collect(),
        };
        serde_json::to_string(&message).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_everything() {
        let mut sources = Sources::default();
        let file = sources.add("a.pov", *b"x\nyz");
        let fault = Diagnostic::error("bad", "no \"good\"", Span { file, start: 2, end: 4 }).hint("try");
        let expected = r#"{"severity":"error","code":"bad","message":"no \"good\"","file":"a.pov","line":2,"column":1,"end_line":2,"end_column":3,"hints":["try"],"related":[],"trace":[]}"#;
        assert_eq!(fault.to_json(&sources), expected);
        let whole = Diagnostic::warning("w", "m", None).to_json(&sources);
        assert_eq!(
            whole,
            r#"{"severity":"warning","code":"w","message":"m","hints":[],"related":[],"trace":[]}"#
        );
    }
}
