//! Source texts and places in them.
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// Which source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileId(pub u32);

/// A range of bytes in a source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The file.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The smallest span around both; `other` must be of the same file, else `self` is the answer.
    pub fn to(self, other: Span) -> Span {
        if self.file != other.file {
            return self;
        }
        Span { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// One source text with its name.
#[derive(Clone, Debug)]
pub struct Source {
    /// The name as the user would write it.
    pub name: String,
    /// The text, as bytes: scenes hold any encoding in their comments.
    pub text: Arc<[u8]>,
    /// Looked for when first a message names a line.
    line_starts: OnceLock<Vec<u32>>,
}

impl Source {
    /// The bytes of a line, counted from 0, without its end.
    pub(crate) fn line(&self, index: usize) -> Range<usize> {
        let (size, starts) = (self.text.len(), self.line_starts());
        let start = starts.get(index).map_or(size, |&s| s as usize);
        let mut end = starts.get(index + 1).map_or(size, |&s| s as usize);
        while end > start && matches!(self.text[end - 1], b'\r' | b'\n') {
            end -= 1;
        }
        start..end
    }

    fn line_starts(&self) -> &[u32] {
        self.line_starts.get_or_init(|| line_starts(&self.text))
    }
}

/// All source texts of one run.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<Source>,
}

impl Sources {
    /// Adds a text; the id is what spans name.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<Arc<[u8]>>) -> FileId {
        self.files.push(Source { name: name.into(), text: text.into(), line_starts: OnceLock::new() });
        FileId(self.files.len() as u32 - 1)
    }

    /// The source of an id that this collection made.
    pub fn get(&self, id: FileId) -> &Source {
        &self.files[id.0 as usize]
    }

    /// 1-based line and column (in bytes) of the start of a span.
    pub fn line_column(&self, span: Span) -> (usize, usize) {
        let starts = self.get(span.file).line_starts();
        let line = starts.partition_point(|&s| s <= span.start);
        (line, (span.start - starts[line - 1]) as usize + 1)
    }

    /// The bytes of a span as far as they are on its first line.
    pub(crate) fn on_one_line(&self, span: Span) -> Range<usize> {
        let line = self.get(span.file).line(self.line_column(span).0 - 1);
        let start = (span.start as usize).min(line.end.max(line.start));
        start..(span.end as usize).clamp(start, line.end.max(start))
    }
}

/// LF, CR, CR LF and LF CR each end a line (language spec, section 1.1).
fn line_starts(text: &[u8]) -> Vec<u32> {
    let mut starts = vec![0];
    let mut i = 0;
    while i < text.len() {
        let two = matches!((text[i], text.get(i + 1)), (b'\r', Some(b'\n')) | (b'\n', Some(b'\r')));
        let ends = two || matches!(text[i], b'\r' | b'\n');
        i += 1 + usize::from(two);
        if ends {
            starts.push(i as u32);
        }
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_end_counts_once() {
        let mut sources = Sources::default();
        let file = sources.add("t", *b"a\nb\rc\r\nd\n\re");
        let at = |start| sources.line_column(Span { file, start, end: start });
        assert_eq!([at(0), at(2), at(4), at(7), at(10)], [(1, 1), (2, 1), (3, 1), (4, 1), (5, 1)]);
    }
}
