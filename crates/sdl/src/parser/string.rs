//! Strings: literals in text or path mode, and the functions of strings (language spec, sections 1.2 and 2.5).
use std::sync::Arc;

use super::token::{Lexed, Lexeme};
use super::{Parser, Result, Tok, datetime, format};
use crate::keyword::Kw;
use crate::value::{Kind, Value};

/// How bytes over 127 are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Charset {
    /// They become spaces (Latin-1 below version 3.5).
    #[default]
    Ascii,
    /// UTF-8.
    Utf8,
}

/// What a backslash means.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// The beginning of an escape.
    Text,
    /// A part of a file name.
    Path,
}

/// The longest string that functions may build.
const MAX_LENGTH: usize = 1 << 20;

impl Parser<'_> {
    /// A string expression in text mode.
    pub fn string(&mut self) -> Result<Arc<str>> {
        self.string_in(Mode::Text)
    }

    /// A string expression in path mode (file names).
    pub fn path(&mut self) -> Result<Arc<str>> {
        self.string_in(Mode::Path)
    }

    /// Does a string come next?
    pub fn at_string(&mut self) -> Result<bool> {
        Ok(match self.peek()? {
            Tok::String | Tok::Value(Kind::String) => true,
            Tok::Kw(kw) => matches!(
                kw,
                Kw::Str
                    | Kw::Vstr
                    | Kw::Concat
                    | Kw::Chr
                    | Kw::Substr
                    | Kw::Strupr
                    | Kw::Strlwr
                    | Kw::Datetime
            ),
            _ => false,
        })
    }

    fn string_in(&mut self, mode: Mode) -> Result<Arc<str>> {
        match self.peek()? {
            Tok::String => {
                // Nothing has moved since the look, so the literal is the last token of the walk.
                let frame = &self.cursor.frame;
                let literal = frame.file.tokens[frame.pos as usize - 1].lexeme();
                self.next()?;
                match literal {
                    Lexeme::String(i) => self.literal_in(i, mode),
                    _ => self.expected("a string"),
                }
            }
            Tok::Value(Kind::String) => match self.take_value()? {
                Value::String(text) => Ok(text),
                _ => self.expected("a string"),
            },
            Tok::Kw(kw) if self.at_string()? => {
                self.next()?;
                let text = self.in_parentheses(|p| p.string_function(kw, mode))?;
                Ok(text.into())
            }
            Tok::Unknown => self.undeclared("is no string"),
            _ => self.expected("a string"),
        }
    }

    /// A literal of the current file in text mode.
    pub(super) fn literal(&mut self, i: u32) -> Result<Arc<str>> {
        self.literal_in(i, Mode::Text)
    }

    /// A literal of any file in text mode.
    pub(super) fn literal_of(&mut self, file: &Lexed, i: u32) -> Result<Arc<str>> {
        self.decoded(file, i, Mode::Text)
    }

    fn literal_in(&mut self, i: u32, mode: Mode) -> Result<Arc<str>> {
        let file = self.cursor.frame.file.clone();
        self.decoded(&file, i, mode)
    }

    fn decoded(&mut self, file: &Lexed, i: u32, mode: Mode) -> Result<Arc<str>> {
        let (start, end) = file.strings[i as usize];
        let bytes = &file.text[start as usize..end as usize];
        if bytes.is_ascii() && !bytes.iter().any(|b| matches!(b, b'\\' | b'\r' | b'\n')) {
            return Ok(String::from_utf8_lossy(bytes).into());
        }
        let text: String = match (self.charset, mode) {
            (Charset::Ascii, Mode::Text) if self.lang() < 350 => bytes.iter().map(|&b| b as char).collect(),
            (Charset::Ascii, Mode::Text) => {
                bytes.iter().map(|&b| if b.is_ascii() { b as char } else { ' ' }).collect()
            }
            _ => String::from_utf8_lossy(bytes)
                .chars()
                .map(|c| if c > '\u{ffff}' { '\u{fffd}' } else { c })
                .collect(),
        };
        if !bytes.is_ascii() && self.charset == Charset::Ascii && mode == Mode::Text && self.lang() >= 350 {
            let span = self.here();
            self.warn("non-ascii-string", "characters outside ASCII become spaces; set `charset utf8`", span);
        }
        let text = text.replace("\r\n", "\n").replace("\n\r", "\n").replace('\r', "\n");
        self.unescaped(text, mode).map(Into::into)
    }

    fn unescaped(&self, text: String, mode: Mode) -> Result<String> {
        if mode == Mode::Path {
            return Ok(text.replace("\\\"", "\""));
        }
        let mut out = String::with_capacity(text.len());
        let mut rest = text.as_str();
        while let Some(at) = rest.find('\\') {
            out += &rest[..at];
            let mut after = rest[at + 1..].chars();
            out.push(match after.next() {
                Some('a') => '\x07',
                Some('b') => '\x08',
                Some('f') => '\x0c',
                Some('n') => '\n',
                Some('r') => '\r',
                Some('t') => '\t',
                Some('v') => '\x0b',
                Some(c @ ('\\' | '\'' | '"')) => c,
                Some('u') => {
                    let digits: String = after.by_ref().take(4).collect();
                    match u32::from_str_radix(&digits, 16) {
                        Ok(code) if digits.len() == 4 => char::from_u32(code).unwrap_or('\u{fffd}'),
                        _ => {
                            return self.error("bad-escape", "`\\u` wants 4 hexadecimal digits", self.here());
                        }
                    }
                }
                other => {
                    let letter = other.map(String::from).unwrap_or_default();
                    return self.error("bad-escape", format!("`\\{letter}` is no escape"), self.here());
                }
            });
            rest = after.as_str();
        }
        Ok(out + rest)
    }

    fn string_function(&mut self, kw: Kw, mode: Mode) -> Result<String> {
        match kw {
            Kw::Str => {
                let x = self.float()?;
                let (width, precision) = (self.next_float()?, self.next_float()?);
                Ok(format::fixed(x, width as i64, precision as i64))
            }
            Kw::Vstr => self.vstr(mode),
            Kw::Concat => {
                let mut text = self.string_in(mode)?.to_string();
                while self.peek()? != Tok::Punct(')') {
                    self.comma()?;
                    text += &self.string_in(mode)?;
                    self.check_length(&text)?;
                }
                Ok(text)
            }
            Kw::Chr => {
                let code = self.int("a character's code", 0..=65535)?;
                Ok(char::from_u32(code as u32).unwrap_or('\u{fffd}').into())
            }
            Kw::Substr => self.substr(mode),
            Kw::Strupr => Ok(self.string_in(mode)?.to_ascii_uppercase()),
            Kw::Strlwr => Ok(self.string_in(mode)?.to_ascii_lowercase()),
            _ => self.datetime(),
        }
    }

    fn check_length(&self, text: &str) -> Result<()> {
        if text.len() <= MAX_LENGTH {
            return Ok(());
        }
        self.error("string-too-long", "this string is longer than a million characters", self.here())
    }

    fn vstr(&mut self, mode: Mode) -> Result<String> {
        let count = (self.float()? as i64).clamp(2, 5) as usize;
        self.comma()?;
        let value = self.additive()?;
        self.comma()?;
        let separator = self.string_in(mode)?;
        let (width, precision) = (self.next_float()? as i64, self.next_float()? as i64);
        let parts: Vec<String> =
            value.v[..count].iter().map(|&x| format::fixed(x, width, precision)).collect();
        Ok(parts.join(&separator))
    }

    fn substr(&mut self, mode: Mode) -> Result<String> {
        let span = self.span();
        let text = self.string_in(mode)?;
        let (start, length) = (self.next_float()? as i64, self.next_float()? as i64);
        let units: Vec<u16> = text.encode_utf16().collect();
        let last = start.saturating_sub(1).saturating_add(length);
        if start < 1 || length < 0 || last > units.len() as i64 {
            let message = format!("characters {start} to {last} of a string of {}", units.len());
            return self.error("substr-range", message, span);
        }
        Ok(String::from_utf16_lossy(&units[start as usize - 1..last as usize]))
    }

    fn datetime(&mut self) -> Result<String> {
        let span = self.span();
        let days = self.float()?;
        let pattern = if self.accept_punct(',')? { self.string()? } else { "%Y-%m-%d %H:%M:%SZ".into() };
        let text = datetime::format(days, &pattern);
        if text.is_empty() || text.len() > 200 {
            return self.error("datetime-format", "this date is empty or too long", span);
        }
        Ok(text)
    }

    /// Functions of strings whose value is a number.
    pub(super) fn string_number(&mut self, kw: Kw) -> Result<f64> {
        self.in_parentheses(|p| {
            if kw == Kw::File_exists {
                let name = p.path()?;
                return Ok(f64::from(u8::from(p.files.find(&[name.to_string()]).is_some())));
            }
            let text = p.string()?;
            Ok(match kw {
                Kw::Strlen => text.encode_utf16().count() as f64,
                Kw::Asc => text.encode_utf16().next().map_or(0.0, f64::from),
                Kw::Val => leading_number(&text),
                _ => {
                    p.comma()?;
                    compare(&text, &p.string()?)
                }
            })
        })
    }
}

/// `strcmp`: the difference of the first units that differ.
fn compare(a: &str, b: &str) -> f64 {
    let (mut a, mut b) = (a.encode_utf16(), b.encode_utf16());
    loop {
        match (a.next(), b.next()) {
            (None, None) => return 0.0,
            (x, y) if x != y => return f64::from(x.unwrap_or(0)) - f64::from(y.unwrap_or(0)),
            _ => {}
        }
    }
}

/// `atof`: the number at the beginning of a text, 0 if there is none.
fn leading_number(text: &str) -> f64 {
    let text = text.trim_start();
    (1..=text.len())
        .rev()
        .filter(|&end| {
            text.is_char_boundary(end)
                && text.as_bytes()[end - 1].is_ascii_digit() | text[..end].ends_with('.')
        })
        .find_map(|end| text[..end].parse().ok())
        .unwrap_or(0.0)
}
