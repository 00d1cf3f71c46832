//! Lines and words of text files.
use crate::{ImportError, Result};

/// The words of one line.
pub(crate) struct Words<'a> {
    rest: &'a [u8],
    /// The line, counted from 1.
    pub line: usize,
}

/// The lines of a text that are not empty; a backslash at the end of a line goes on with the next.
pub(crate) struct Lines<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(text: &'a [u8]) -> Self {
        Lines { rest: text, line: 0 }
    }

    /// The next line without what ends it.
    fn raw(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.line += 1;
        let end = self.rest.iter().position(|&b| b == b'\n').unwrap_or(self.rest.len());
        let line = &self.rest[..end];
        self.rest = &self.rest[(end + 1).min(self.rest.len())..];
        Some(line)
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Words<'a>;

    fn next(&mut self) -> Option<Words<'a>> {
        let all = loop {
            let all = self.rest;
            let mut line = self.raw()?;
            let first = self.line;
            while line.trim_ascii_end().ends_with(b"\\")
                && let Some(next) = self.raw()
            {
                line = next;
            }
            let length = all.len() - self.rest.len();
            let words = Words::new(&all[..length], first);
            if !words.rest.trim_ascii().is_empty() {
                break words;
            }
        };
        Some(all)
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        let space = |b: u8| b.is_ascii_whitespace() || b == b'\\';
        let start = self.rest.iter().position(|&b| !space(b))?;
        let rest = &self.rest[start..];
        let end = rest.iter().position(|&b| space(b)).unwrap_or(rest.len());
        self.rest = &rest[end..];
        Some(&rest[..end])
    }
}

impl<'a> Words<'a> {
    pub(crate) fn new(text: &'a [u8], line: usize) -> Self {
        Words { rest: text, line }
    }

    /// An error in this line.
    pub(crate) fn error<T>(&self, what: impl Into<String>) -> Result<T> {
        Err(ImportError::Line { line: self.line, what: what.into() })
    }

    /// The next word as a finite number.
    pub(crate) fn number(&mut self) -> Result<f64> {
        match self.next() {
            Some(word) => match number(word) {
                Some(value) => Ok(value),
                None => self.error(format!("`{}` is no number", String::from_utf8_lossy(word))),
            },
            None => self.error("a number is missing"),
        }
    }

    /// The next words as numbers.
    pub(crate) fn numbers<const N: usize>(&mut self) -> Result<[f64; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = self.number()?;
        }
        Ok(values)
    }

    /// The next words as a point in single precision.
    pub(crate) fn point<const N: usize>(&mut self) -> Result<[f32; N]> {
        let values = self.numbers()?;
        match crate::draft::point(values) {
            Some(point) => Ok(point),
            None => self.error("this number is too large"),
        }
    }

    /// All that is left of the line, as one name that may hold spaces.
    pub(crate) fn name(&mut self) -> String {
        String::from_utf8_lossy(self.rest.trim_ascii()).into_owned()
    }
}

/// A finite number.
pub(crate) fn number(word: &[u8]) -> Option<f64> {
    let value: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_go_on_behind_a_backslash() {
        let all: Vec<(usize, Vec<&[u8]>)> =
            Lines::new(b"a b\r\n\n c \\\n d\ne").map(|w| (w.line, w.collect())).collect();
        let word = |w: &'static str| w.as_bytes();
        assert_eq!(all[0], (1, vec![word("a"), word("b")]));
        assert_eq!(all[1], (3, vec![word("c"), word("d")]));
        assert_eq!(all[2], (5, vec![word("e")]));
        assert_eq!(all.len(), 3);
    }

    #[test]
    fn numbers_must_be_finite() {
        assert_eq!(number(b"-1.5e2"), Some(-150.0));
        assert_eq!([number(b"nan"), number(b"inf"), number(b"1x"), number(b"")], [None; 4]);
    }
}
