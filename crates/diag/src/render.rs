//! Diagnostics as text for people, through `codespan-reporting`.
use std::borrow::Cow;
use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic as Report, Label, Severity as Level};
use codespan_reporting::files::{Error, Files};
use codespan_reporting::term::termcolor::Buffer;
use codespan_reporting::term::{self, Chars, Config, Styles, StylesWriter};

use crate::{Diagnostic, FileId, Severity, Source, Sources, Span};

/// Lines longer than twice this are shown in part, this many bytes to both sides of the place.
const WINDOW: usize = 120;
/// Most steps of a back-trace that are shown at each end.
const TRACE_ENDS: usize = 5;

impl Diagnostic {
    /// The message with its source line, caret, label, hints and back-trace; in colour for a terminal.
    pub fn render(&self, sources: &Sources, color: bool) -> String {
        let mut spans: Vec<Span> =
            self.span.into_iter().chain(self.related.iter().map(|(span, _)| *span)).collect();
        spans.dedup();
        let view = View { sources, spans };
        let config = Config { chars: Chars::ascii(), ..Config::default() };
        let report = self.report(sources);
        let mut buffer = if color { Buffer::ansi() } else { Buffer::no_color() };
        let styles = Styles::default();
        let mut writer = StylesWriter::new(&mut buffer, &styles);
        match term::emit_to_write_style(&mut writer, &config, &view, &report) {
            Ok(()) => String::from_utf8_lossy(buffer.as_slice()).into_owned(),
            Err(_) => format!("{}: {}\n", self.severity.name(), self.message),
        }
    }

    fn report(&self, sources: &Sources) -> Report<FileId> {
        let level = match self.severity {
            Severity::Error => Level::Error,
            Severity::Warning => Level::Warning,
            Severity::Note => Level::Note,
        };
        let mut labels = Vec::new();
        if let Some(span) = self.span {
            labels.push(Label::primary(span.file, sources.on_one_line(span)).with_message(&self.label));
        }
        for (span, text) in &self.related {
            labels.push(Label::secondary(span.file, sources.on_one_line(*span)).with_message(text));
        }
        let notes = self.hints.iter().map(|hint| format!("help: {hint}")).chain(self.trace_notes(sources));
        Report::new(level)
            .with_code(self.code)
            .with_message(&self.message)
            .with_labels(labels)
            .with_notes(notes.collect())
    }

    /// One line a step; the middle of a long way is left out.
    fn trace_notes(&self, sources: &Sources) -> Vec<String> {
        let steps = self.trace.len();
        let shown = |i: &usize| *i < TRACE_ENDS || *i >= steps - TRACE_ENDS.min(steps);
        let mut notes: Vec<String> = (0..steps)
            .filter(shown)
            .map(|i| {
                let frame = &self.trace[i];
                let (line, column) = sources.line_column(frame.span);
                format!("in {}, from {}:{line}:{column}", frame.what, sources.get(frame.span.file).name)
            })
            .collect();
        if notes.len() < steps {
            notes.insert(TRACE_ENDS, format!("... {} more", steps - notes.len()));
        }
        notes
    }
}

impl Severity {
    /// `error`, `warning` or `note`.
    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        }
    }
}

/// The sources as the renderer wants them: text, and long lines cut to what is near the places of interest.
struct View<'a> {
    sources: &'a Sources,
    spans: Vec<Span>,
}

impl View<'_> {
    fn text(&self, id: FileId) -> &Source {
        self.sources.get(id)
    }
}

/// The text with every byte that is no UTF-8 replaced by one `?`, so that places stay what they are.
fn same_length(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|&b| if b.is_ascii() { b as char } else { '?' }).collect()),
    }
}

impl<'a> Files<'a> for View<'_> {
    type FileId = FileId;
    type Name = &'a str;
    type Source = Cow<'a, str>;

    fn name(&'a self, id: FileId) -> Result<&'a str, Error> {
        Ok(&self.text(id).name)
    }

    fn source(&'a self, id: FileId) -> Result<Cow<'a, str>, Error> {
        Ok(same_length(&self.text(id).text))
    }

    fn line_index(&'a self, id: FileId, byte_index: usize) -> Result<usize, Error> {
        let at = byte_index as u32;
        Ok(self.sources.line_column(Span { file: id, start: at, end: at }).0 - 1)
    }

    fn column_number(&'a self, id: FileId, line_index: usize, byte_index: usize) -> Result<usize, Error> {
        Ok(byte_index - self.text(id).line(line_index).start + 1)
    }

    fn line_range(&'a self, id: FileId, line_index: usize) -> Result<Range<usize>, Error> {
        let source = self.text(id);
        let line = source.line(line_index);
        let inside = |s: &&Span| s.file == id && line.contains(&(s.start as usize));
        match self.spans.iter().find(inside) {
            Some(span) if line.len() > 2 * WINDOW => {
                let (start, end) = (span.start as usize, (span.end as usize).min(line.end));
                let near = start.saturating_sub(WINDOW).max(line.start)..(end + WINDOW).min(line.end);
                Ok(whole_characters(&source.text, near))
            }
            _ => Ok(line),
        }
    }
}

/// Widens a range so that it cuts no UTF-8 sequence.
fn whole_characters(text: &[u8], mut range: Range<usize>) -> Range<usize> {
    let inner = |at: usize| text.get(at).is_some_and(|b| b & 0xc0 == 0x80);
    while range.start > 0 && inner(range.start) {
        range.start -= 1;
    }
    while inner(range.end) {
        range.end += 1;
    }
    range
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Frame;

    fn sources(text: &[u8]) -> (Sources, FileId) {
        let mut sources = Sources::default();
        let file = sources.add("scene.pov", text);
        (sources, file)
    }

    #[test]
    fn a_message_shows_place_label_hint_and_way() {
        let (sources, file) = sources(b"camera {}\nshpere { 0, 1 }\nM()\n");
        let mut fault = Diagnostic::error(
            "unknown-identifier",
            "`shpere` is not declared",
            Span { file, start: 10, end: 16 },
        )
        .label("not declared")
        .hint("did you mean `sphere`?");
        fault.trace = vec![Frame { what: "macro M".into(), span: Span { file, start: 26, end: 27 } }];
        let expected = "\
error[unknown-identifier]: `shpere` is not declared
  --> scene.pov:2:1
  |
2 | shpere { 0, 1 }
  | ^^^^^^ not declared
  |
  = help: did you mean `sphere`?
  = in macro M, from scene.pov:3:1

";
        assert_eq!(fault.render(&sources, false), expected);
        assert!(fault.render(&sources, true).contains("\u{1b}["));
    }

    #[test]
    fn bytes_of_any_kind_and_long_lines_can_be_shown() {
        let mut text = vec![b'a'; 5000];
        text[10] = 0xff;
        text.extend("é x".as_bytes());
        let (sources, file) = sources(&text);
        let shown = Diagnostic::warning("w", "far out", Span { file, start: 4000, end: 4001 })
            .render(&sources, false);
        assert!(shown.contains("scene.pov:1:4001") && shown.len() < 1000, "{shown}");
        let end = Span { file, start: 5004, end: 5004 };
        assert!(
            Diagnostic::error("e", "at the end", end).render(&sources, false).contains("scene.pov:1:5005")
        );
    }

    #[test]
    fn places_over_several_lines_are_cut_to_the_first() {
        let (sources, file) = sources(b"one {\ntwo }");
        let shown = Diagnostic::error("e", "m", Span { file, start: 0, end: 11 }).render(&sources, false);
        assert!(shown.contains("one {") && !shown.contains("two"), "{shown}");
    }

    #[test]
    fn long_ways_are_shortened() {
        let (sources, file) = sources(b"M()");
        let mut fault = Diagnostic::error("e", "m", None);
        fault.trace = vec![Frame { what: "macro M".into(), span: Span { file, start: 0, end: 1 } }; 30];
        let shown = fault.render(&sources, false);
        assert_eq!(shown.matches("macro M").count(), 10);
        assert!(shown.contains("... 20 more"));
    }
}
