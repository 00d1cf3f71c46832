//! A file as compact tokens, and the table that says where skipped branches end.
use std::cell::RefCell;
use std::sync::Arc;

use raggio_diag::FileId;

use super::symbol::Symbol;
use crate::keyword::Kw;

/// "No such directive."
pub const NONE: u32 = u32::MAX;

/// Eight bytes a token: four bits of kind, 28 of payload, and where it begins.
#[derive(Clone, Copy, Debug)]
pub struct Token {
    bits: u32,
    /// First byte in the file.
    pub start: u32,
}

/// A token taken apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lexeme {
    /// A reserved word.
    Kw(Kw),
    /// Any other word.
    Ident(Symbol),
    /// Index into [`Lexed::numbers`].
    Number(u32),
    /// Index into [`Lexed::strings`].
    String(u32),
    /// A character; two-character operators are `≤ ≥ ≠`.
    Punct(char),
    /// Index into [`Lexed::directives`].
    Directive(u32),
    /// Index into [`Lexed::errors`].
    Error(u32),
}

const PAYLOAD: u32 = (1 << 28) - 1;

impl Token {
    /// Packs a token. Payloads of 28 bits are enough for any file that [`super::lexer`] accepts.
    pub fn new(lexeme: Lexeme, start: u32) -> Self {
        let (kind, payload) = match lexeme {
            Lexeme::Kw(kw) => (0, kw as u32),
            Lexeme::Ident(symbol) => (1, symbol.0),
            Lexeme::Number(i) => (2, i),
            Lexeme::String(i) => (3, i),
            Lexeme::Punct(c) => (4, c as u32),
            Lexeme::Directive(i) => (5, i),
            Lexeme::Error(i) => (6, i),
        };
        Token { bits: kind << 28 | payload & PAYLOAD, start }
    }

    /// Unpacks it.
    #[inline]
    pub fn lexeme(self) -> Lexeme {
        let payload = self.bits & PAYLOAD;
        match self.bits >> 28 {
            0 => Lexeme::Kw(Kw::ALL[payload as usize]),
            1 => Lexeme::Ident(Symbol(payload)),
            2 => Lexeme::Number(payload),
            3 => Lexeme::String(payload),
            4 => Lexeme::Punct(char::from_u32(payload).unwrap_or('?')),
            5 => Lexeme::Directive(payload),
            _ => Lexeme::Error(payload),
        }
    }

    /// Is it this character? Quicker than unpacking.
    #[inline]
    pub fn is_punct(self, c: char) -> bool {
        self.bits == (4 << 28 | c as u32)
    }

    /// Does it end an expression for certain: `, > ) ; } ]`?
    #[inline]
    pub fn ends_expression(self) -> bool {
        self.bits >> 28 == 4 && matches!(self.bits & PAYLOAD, 0x2c | 0x3e | 0x29 | 0x3b | 0x7d | 0x5d)
    }
}

/// A `#word` and its place among the others.
#[derive(Clone, Copy, Debug)]
pub struct Directive {
    /// The word, if it is a reserved one.
    pub word: Option<Kw>,
    /// Index of its token.
    pub token: u32,
    /// The next `#else #elseif #case #range #end` of the same construct, or [`NONE`].
    pub next: u32,
    /// The `#end` of the same construct, or [`NONE`].
    pub end: u32,
}

/// A file as tokens.
#[derive(Debug)]
pub struct Lexed {
    /// Which file.
    pub file: FileId,
    /// Its bytes.
    pub text: Arc<[u8]>,
    /// Its tokens.
    pub tokens: Vec<Token>,
    /// Values of number tokens.
    pub numbers: Vec<f64>,
    /// Bytes between the quotes of string tokens.
    pub strings: Vec<(u32, u32)>,
    /// All directives, in order.
    pub directives: Vec<Directive>,
    /// What could not be read, where, raised when the walk comes there.
    pub errors: Vec<LexError>,
    /// Expressions of it that have been met in loops and macros.
    pub cache: RefCell<super::compiled::Cache>,
    /// Does the text begin with bytes over 127 (a byte order mark)?
    pub marked_utf8: bool,
}

/// A fault in the text itself.
#[derive(Clone, Debug)]
pub struct LexError {
    /// Stable code of the diagnostic.
    pub code: &'static str,
    /// What is wrong.
    pub message: String,
    /// One past the last byte concerned.
    pub end: u32,
}

/// Links every conditional, loop, switch and macro to its branches and its `#end`.
pub fn link(directives: &mut [Directive]) {
    let mut open: Vec<(usize, usize)> = Vec::new();
    for i in 0..directives.len() {
        match directives[i].word {
            Some(Kw::If | Kw::Ifdef | Kw::Ifndef | Kw::While | Kw::For | Kw::Switch | Kw::Macro) => {
                open.push((i, i))
            }
            Some(Kw::Else | Kw::Elseif | Kw::Case | Kw::Range) => {
                if let Some((_, last)) = open.last_mut() {
                    directives[*last].next = i as u32;
                    *last = i;
                }
            }
            Some(Kw::End) => {
                if let Some((first, last)) = open.pop() {
                    directives[last].next = i as u32;
                    close(directives, first, i);
                }
            }
            _ => {}
        }
    }
}

/// Tells the end to every branch of the chain that begins with `first`.
fn close(directives: &mut [Directive], first: usize, end: usize) {
    let mut branch = first;
    while branch != end {
        directives[branch].end = end as u32;
        branch = directives[branch].next as usize;
    }
}
