//! Text to tokens (language spec, sections 1.1 and 1.2). Faults become error tokens, raised when the walk meets them.
use std::sync::Arc;

use raggio_diag::FileId;

use super::symbol::Symbols;
use super::token::{Directive, LexError, Lexed, Lexeme, NONE, Token, link};

/// Longest identifier that the language allows.
const MAX_IDENTIFIER: usize = 255;

/// Lexes a whole file.
pub fn lex(file: FileId, text: Arc<[u8]>, symbols: &mut Symbols) -> Lexed {
    let lexed = Lexed {
        file,
        text: text.clone(),
        tokens: Vec::with_capacity(text.len() / 4),
        numbers: Vec::new(),
        strings: Vec::new(),
        directives: Vec::new(),
        errors: Vec::new(),
        cache: Default::default(),
        marked_utf8: text.first().is_some_and(|&b| b > 127),
    };
    let mut lexer = Lexer { text: &text, all: std::str::from_utf8(&text).ok(), at: 0, out: lexed, symbols };
    while lexer.text.get(lexer.at).is_some_and(|&b| b > 127) {
        lexer.at += 1;
    }
    while lexer.token() {}
    link(&mut lexer.out.directives);
    lexer.out
}

/// One past the last byte of the token that begins at `start`; for messages.
pub fn token_end(text: &[u8], start: usize) -> usize {
    let mut end = start;
    match text.get(start) {
        Some(b'"') => {
            end = start + 1;
            while end < text.len() && text[end] != b'"' {
                end += if text[end] == b'\\' { 2 } else { 1 };
            }
            (end + 1).min(text.len())
        }
        Some(b'#') => {
            end += 1;
            while text.get(end).is_some_and(|&b| b == b' ' || b == b'\t') {
                end += 1;
            }
            word_end(text, end)
        }
        Some(b) if is_word_start(*b) => word_end(text, start),
        Some(b) if b.is_ascii_digit() => number_end(text, start).0,
        Some(b'.') if text.get(start + 1).is_some_and(u8::is_ascii_digit) => number_end(text, start).0,
        Some(b'!' | b'<' | b'>') if text.get(start + 1) == Some(&b'=') => start + 2,
        Some(_) => start + 1,
        None => start,
    }
}

fn is_word_start(b: u8) -> bool {
    b.is_ascii_alphabetic() || b == b'_'
}

fn word_end(text: &[u8], start: usize) -> usize {
    let rest = &text[start.min(text.len())..];
    start + rest.iter().position(|b| !(b.is_ascii_alphanumeric() || *b == b'_')).unwrap_or(rest.len())
}

/// One past the number at `start`, and one past the part of it that has a value (`1e` is 1).
fn number_end(text: &[u8], start: usize) -> (usize, usize) {
    let digits = |mut i: usize| {
        while text.get(i).is_some_and(u8::is_ascii_digit) {
            i += 1;
        }
        i
    };
    let mut i = digits(start);
    if text.get(i) == Some(&b'.') {
        i = digits(i + 1);
    }
    let mantissa = i;
    if matches!(text.get(i), Some(b'e' | b'E')) {
        i += 1;
        if matches!(text.get(i), Some(b'+' | b'-')) {
            i += 1;
        }
        let end = digits(i);
        return if end > i { (end, end) } else { (end, mantissa) };
    }
    (i, i)
}

/// A number without an exponent and of so few digits that one division gives the nearest double (Clinger, "How to Read
/// Floating Point Numbers Accurately", 1990), and one past its end; most are.
fn short_number(text: &[u8], start: usize) -> Option<(f64, usize)> {
    const MOST_DIGITS: usize = 15;
    const POWERS: [f64; MOST_DIGITS + 1] =
        [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];
    let (mut digits, mut i) = (0u64, start);
    let mut point = None;
    while let Some(&b) = text.get(i) {
        match b {
            b'0'..=b'9' if i - start <= MOST_DIGITS => digits = 10 * digits + u64::from(b - b'0'),
            b'.' if point.is_none() => point = Some(i),
            b'0'..=b'9' | b'.' | b'e' | b'E' => return None,
            _ => break,
        }
        i += 1;
    }
    let fraction = point.map_or(0, |point| i - point - 1);
    let count = i - start - usize::from(point.is_some());
    (count <= MOST_DIGITS).then(|| (digits as f64 / POWERS[fraction], i))
}

struct Lexer<'a> {
    text: &'a [u8],
    /// The text, if all of it is UTF-8: looked at once, not word by word.
    all: Option<&'a str>,
    at: usize,
    out: Lexed,
    symbols: &'a mut Symbols,
}

impl<'a> Lexer<'a> {
    /// A part that is ASCII.
    fn ascii(&self, start: usize, end: usize) -> &'a str {
        match self.all {
            Some(all) => &all[start..end],
            None => std::str::from_utf8(&self.text[start..end]).unwrap_or_default(),
        }
    }

    fn push(&mut self, lexeme: Lexeme, start: usize) {
        self.out.tokens.push(Token::new(lexeme, start as u32));
    }

    fn fault(&mut self, code: &'static str, message: impl Into<String>, start: usize) {
        self.push(Lexeme::Error(self.out.errors.len() as u32), start);
        self.out.errors.push(LexError { code, message: message.into(), end: self.at as u32 });
    }

    /// Reads one token; false at the end.
    fn token(&mut self) -> bool {
        if !self.blanks() {
            return false;
        }
        let start = self.at;
        let b = self.text[start];
        match b {
            b if is_word_start(b) => self.word(),
            b'0'..=b'9' => self.number(),
            b'.' if self.text.get(start + 1).is_some_and(u8::is_ascii_digit) => self.number(),
            b'"' => self.string(),
            b'#' => self.directive(),
            b'!' | b'<' | b'>' if self.text.get(start + 1) == Some(&b'=') => {
                self.at += 2;
                self.push(
                    Lexeme::Punct(if b == b'!' {
                        '≠'
                    } else if b == b'<' {
                        '≤'
                    } else {
                        '≥'
                    }),
                    start,
                );
            }
            b'!'..=b'~' => {
                self.at += 1;
                self.push(Lexeme::Punct(b as char), start);
            }
            _ => {
                while self.text.get(self.at).is_some_and(|&b| b > 127) {
                    self.at += 1;
                }
                self.at = self.at.max(start + 1);
                self.fault("illegal-character", "only ASCII may stand outside comments and strings", start);
            }
        }
        true
    }

    /// Skips blanks and comments; false at the end of the text.
    fn blanks(&mut self) -> bool {
        while let Some(&b) = self.text.get(self.at) {
            match b {
                b' ' | b'\t' | b'\n' | b'\r' | 0 | 0x0b | 0x0c | 0x1a => self.at += 1,
                b'/' if self.text.get(self.at + 1) == Some(&b'/') => self.line_comment(),
                b'/' if self.text.get(self.at + 1) == Some(&b'*') => self.block_comment(),
                _ => return true,
            }
        }
        false
    }

    fn line_comment(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
    }

    fn block_comment(&mut self) {
        let start = self.at;
        let mut depth = 0;
        while self.at + 1 < self.text.len() {
            match (self.text[self.at], self.text[self.at + 1]) {
                (b'/', b'*') => depth += 1,
                (b'*', b'/') => depth -= 1,
                _ => {
                    self.at += 1;
                    continue;
                }
            }
            self.at += 2;
            if depth == 0 {
                return;
            }
        }
        self.at = start + 2;
        self.fault("unclosed-comment", "this comment is never closed by `*/`", start);
        self.at = self.text.len();
    }

    fn word(&mut self) {
        let start = self.at;
        self.at = word_end(self.text, start);
        if self.at - start > MAX_IDENTIFIER {
            return self.fault("identifier-too-long", "this identifier is longer than 255 characters", start);
        }
        let word = self.ascii(start, self.at);
        let symbol = self.symbols.intern(word);
        let lexeme = symbol.keyword().map_or(Lexeme::Ident(symbol), Lexeme::Kw);
        self.push(lexeme, start);
    }

    fn number(&mut self) {
        let start = self.at;
        if let Some((value, end)) = short_number(self.text, start) {
            self.at = end;
            self.push(Lexeme::Number(self.out.numbers.len() as u32), start);
            self.out.numbers.push(value);
            return;
        }
        let (end, valued) = number_end(self.text, start);
        self.at = end;
        let text = self.ascii(start, valued);
        if self.text.get(end) == Some(&b'.') && text.contains('.') {
            self.at += 1;
            return self.fault("malformed-number", "this number has an additional `.`", start);
        }
        self.push(Lexeme::Number(self.out.numbers.len() as u32), start);
        self.out.numbers.push(text.parse().unwrap_or(0.0));
    }

    fn string(&mut self) {
        let start = self.at;
        let mut i = start + 1;
        loop {
            match (self.text.get(i), self.text.get(i + 1)) {
                (None, _) => {
                    self.at = start + 1;
                    self.fault("unclosed-string", "this string is never closed by `\"`", start);
                    self.at = self.text.len();
                    return;
                }
                (Some(b'"'), _) => break,
                (Some(b'\\'), Some(b'\n' | b'\r')) => {
                    self.at = i + 1;
                    self.fault("bad-escape", "a backslash may not stand at the end of a line", i);
                    i += 1;
                }
                (Some(b'\\'), Some(b'"' | b'\\')) => i += 2,
                _ => i += 1,
            }
        }
        self.at = i + 1;
        self.push(Lexeme::String(self.out.strings.len() as u32), start);
        self.out.strings.push((start as u32 + 1, i as u32));
    }

    fn directive(&mut self) {
        let start = self.at;
        self.at += 1;
        self.blanks();
        let from = self.at;
        self.at = word_end(self.text, from);
        let word = self.ascii(from, self.at);
        let word = self.symbols.intern(word).keyword().filter(|word| word.is_directive());
        if word.is_none() {
            // The `#` stands alone; what follows is read as if it were not there.
            self.at = start + 1;
        }
        let token = self.out.tokens.len() as u32;
        self.push(Lexeme::Directive(self.out.directives.len() as u32), start);
        self.out.directives.push(Directive { word, token, next: NONE, end: NONE });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_numbers_are_the_nearest_doubles() {
        let read = |text: &str| short_number(text.as_bytes(), 0);
        for text in ["0", "7", "0.1", ".1", "3.", "2.675", "0.33333333333333", "123456789012345", "1.10"] {
            assert_eq!(read(text), Some((text.parse().unwrap(), text.len())), "{text}");
        }
        let mut state = 1u64;
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let (whole, part) = (state >> 44, state >> 30 & 0x3ff_ffff);
            let text = format!("{whole}.{part:08}");
            assert_eq!(read(&text), Some((text.parse().unwrap(), text.len())), "{text}");
        }
        assert_eq!(read("12,5"), Some((12.0, 2)));
        for other in ["1e5", "1E", "1.2.3", "1..", "1234567890123456", "0.1234567890123456"] {
            assert_eq!(read(other), None, "{other}");
        }
    }
}
