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
        if self.peek()? == Tok::Value(Kind::String) {
            return match self.take_value()? {
                Value::String(text) => Ok(text),
                _ => self.expected("a string"),
            };
        }
        let mut text = String::new();
        self.append_string(&mut text, mode)?;
        Ok(text.into())
    }

    /// A string expression, added to what is there: so that no part of a long one is a string of its own.
    fn append_string(&mut self, out: &mut String, mode: Mode) -> Result<()> {
        match self.peek()? {
            Tok::String => {
                // Nothing has moved since the look, so the literal is the last token of the walk.
                let frame = &self.cursor.frame;
                let literal = frame.file.tokens[frame.pos as usize - 1].lexeme();
                self.next()?;
                match literal {
                    Lexeme::String(i) => {
                        let file = self.cursor.frame.file.clone();
                        self.append_literal(out, &file, i, mode)
                    }
                    _ => self.expected("a string"),
                }
            }
            Tok::Value(Kind::String) => {
                if let Value::String(text) = self.current_value() {
                    *out += text;
                }
                self.next().map(|_| ())
            }
            Tok::Kw(kw) if self.at_string()? => {
                self.next()?;
                self.in_parentheses(|p| p.string_function(out, kw, mode))
            }
            Tok::Unknown => self.undeclared("is no string"),
            _ => self.expected("a string"),
        }
    }

    /// A literal of the current file in text mode.
    pub(super) fn literal(&mut self, i: u32) -> Result<Arc<str>> {
        let file = self.cursor.frame.file.clone();
        self.literal_of(&file, i)
    }

    /// A literal of any file in text mode.
    pub(super) fn literal_of(&mut self, file: &Lexed, i: u32) -> Result<Arc<str>> {
        let mut text = String::new();
        self.append_literal(&mut text, file, i, Mode::Text)?;
        Ok(text.into())
    }

    fn append_literal(&mut self, out: &mut String, file: &Lexed, i: u32, mode: Mode) -> Result<()> {
        let (start, end) = file.strings[i as usize];
        let bytes = &file.text[start as usize..end as usize];
        if let Some(plain) = plain_text(bytes) {
            *out += plain;
            return Ok(());
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
        *out += &self.unescaped(text, mode)?;
        Ok(())
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

    fn string_function(&mut self, out: &mut String, kw: Kw, mode: Mode) -> Result<()> {
        let start = out.len();
        match kw {
            Kw::Str => {
                let x = self.float()?;
                let (width, precision) = (self.next_float()?, self.next_float()?);
                format::append_fixed(out, x, width as i64, precision as i64);
                Ok(())
            }
            Kw::Vstr => self.vstr(out, mode),
            Kw::Concat => {
                self.append_string(out, mode)?;
                while self.peek()? != Tok::Punct(')') {
                    self.comma()?;
                    self.append_string(out, mode)?;
                    self.check_length(&out[start..])?;
                }
                Ok(())
            }
            Kw::Chr => {
                let code = self.int("a character's code", 0..=65535)?;
                out.push(char::from_u32(code as u32).unwrap_or('\u{fffd}'));
                Ok(())
            }
            Kw::Substr => self.substr(out, mode),
            Kw::Strupr => self.append_string(out, mode).map(|()| out[start..].make_ascii_uppercase()),
            Kw::Strlwr => self.append_string(out, mode).map(|()| out[start..].make_ascii_lowercase()),
            _ => self.datetime().map(|text| *out += &text),
        }
    }

    fn check_length(&self, text: &str) -> Result<()> {
        if text.len() <= MAX_LENGTH {
            return Ok(());
        }
        self.error("string-too-long", "this string is longer than a million characters", self.here())
    }

    fn vstr(&mut self, out: &mut String, mode: Mode) -> Result<()> {
        let count = (self.float()? as i64).clamp(2, 5) as usize;
        self.comma()?;
        let value = self.additive()?;
        self.comma()?;
        let separator = self.string_in(mode)?;
        let (width, precision) = (self.next_float()? as i64, self.next_float()? as i64);
        for (i, &x) in value.v[..count].iter().enumerate() {
            if i > 0 {
                *out += &separator;
            }
            format::append_fixed(out, x, width, precision);
        }
        Ok(())
    }

    /// The whole text is added, then all but the wanted part of it taken away: nothing is left from the place before the
    /// first character.
    fn substr(&mut self, out: &mut String, mode: Mode) -> Result<()> {
        let (span, start) = (self.span(), out.len());
        self.append_string(out, mode)?;
        let (first, length) = (self.next_float()? as i64, self.next_float()? as i64);
        let last = first.saturating_sub(1).saturating_add(length);
        let size = units(&out[start..]);
        if first < 0 || length < 0 || last > size as i64 {
            let message = format!("characters {first} to {last} of a string of {size}");
            return self.error("substr-range", message, span);
        }
        if first == 0 {
            out.truncate(start);
            return Ok(());
        }
        let (first, last) = (first as usize - 1, last as usize);
        if out[start..].is_ascii() {
            out.truncate(start + last);
            out.drain(start..start + first);
        } else {
            let wide: Vec<u16> = out[start..].encode_utf16().collect();
            out.truncate(start);
            *out += &String::from_utf16_lossy(&wide[first..last]);
        }
        Ok(())
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
                Kw::Strlen => units(&text) as f64,
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

/// The text itself, where no byte of it means anything but itself.
fn plain_text(bytes: &[u8]) -> Option<&str> {
    let plain = bytes.iter().all(|&b| b.is_ascii() && !matches!(b, b'\\' | b'\r' | b'\n'));
    if plain { std::str::from_utf8(bytes).ok() } else { None }
}

/// How many UTF-16 units a text has: what the language counts as characters.
fn units(text: &str) -> usize {
    if text.is_ascii() { text.len() } else { text.encode_utf16().count() }
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
    let of_number = |b: u8| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E');
    let most = text.bytes().take_while(|&b| of_number(b)).count();
    (1..=most)
        .rev()
        .filter(|&end| matches!(text.as_bytes()[end - 1], b'0'..=b'9' | b'.'))
        .find_map(|end| text[..end].parse().ok())
        .unwrap_or(0.0)
}
