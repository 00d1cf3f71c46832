//! `#read` (language spec, section 1.6).
use raggio_diag::Span;

use super::declare::Target;
use super::expr::value_of;
use super::files::{FileHandle, OpenFile};
use super::num::Num;
use super::token::Lexeme;
use super::{Parser, Result, Tok};
use crate::value::Value;

impl Parser<'_> {
    /// `#read ( NAME, a, b ... )`. At its end the file is closed and its name undefined.
    pub(super) fn read_items(&mut self) -> Result<()> {
        self.in_parentheses(|p| {
            let (handle, slot) = p.handle()?;
            while p.peek()? != Tok::Punct(')') {
                if !p.accept_punct(',')? {
                    return p.expected("`,` or `)`");
                }
                let (symbol, span) = p.raw_name()?;
                let target = p.target(symbol, false, span)?;
                p.read_one(handle, slot, target, span)?;
            }
            Ok(())
        })
    }

    /// Reads one item and the separator after it.
    fn read_one(&mut self, handle: FileHandle, slot: u32, target: Target, span: Span) -> Result<()> {
        if !matches!(self.open_files.get(handle as usize), Some(Some(OpenFile::Read { .. }) | None)) {
            if matches!(self.open_files.get(handle as usize), Some(None)) {
                return Ok(());
            }
            return self.error("not-readable", "this file is not open for reading", span);
        }
        match self.read_value(handle)? {
            Some(value) => {
                self.assign(target, value, span)?;
                // The separator, whatever it is; where there is none the file ends.
                if self.read_token(handle)?.is_none() {
                    self.end_of_file(handle, slot);
                }
            }
            None => self.end_of_file(handle, slot),
        }
        Ok(())
    }

    fn end_of_file(&mut self, handle: FileHandle, slot: u32) {
        self.open_files[handle as usize] = None;
        self.scopes.undefine(slot);
    }

    /// The next token of an open file, with its place.
    fn read_token(&mut self, handle: FileHandle) -> Result<Option<(Lexeme, Span)>> {
        let Some(Some(OpenFile::Read { file, pos })) = self.open_files.get_mut(handle as usize) else {
            return Ok(None);
        };
        let Some(token) = file.tokens.get(*pos) else { return Ok(None) };
        *pos += 1;
        let start = token.start;
        let span =
            Span { file: file.file, start, end: super::lexer::token_end(&file.text, start as usize) as u32 };
        if let Lexeme::Error(i) = token.lexeme() {
            let fault = file.errors[i as usize].clone();
            return self.error(fault.code, fault.message, span);
        }
        Ok(Some((token.lexeme(), span)))
    }

    /// A signed number, a vector of signed numbers, or a string; `None` at the end of the file.
    fn read_value(&mut self, handle: FileHandle) -> Result<Option<Value>> {
        let Some((lexeme, span)) = self.read_token(handle)? else { return Ok(None) };
        match lexeme {
            Lexeme::String(i) => {
                let Some(Some(OpenFile::Read { file, .. })) = self.open_files.get(handle as usize) else {
                    return Ok(None);
                };
                let file = file.clone();
                self.literal_of(&file, i).map(|text| Some(Value::String(text)))
            }
            Lexeme::Punct('<') => self.read_vector(handle, span).map(Some),
            lexeme => self.read_number(handle, lexeme, span).map(|x| Some(Value::Float(x))),
        }
    }

    fn read_number(&mut self, handle: FileHandle, first: Lexeme, span: Span) -> Result<f64> {
        let (sign, lexeme) = match first {
            Lexeme::Punct(c @ ('+' | '-')) => {
                let next = self.read_token(handle)?.map(|(lexeme, _)| lexeme);
                (if c == '-' { -1.0 } else { 1.0 }, next)
            }
            lexeme => (1.0, Some(lexeme)),
        };
        match (lexeme, self.open_files.get(handle as usize)) {
            (Some(Lexeme::Number(i)), Some(Some(OpenFile::Read { file, .. }))) => {
                Ok(sign * file.numbers[i as usize])
            }
            _ => self.error("bad-data", "a data file holds numbers, vectors and strings", span),
        }
    }

    fn read_vector(&mut self, handle: FileHandle, span: Span) -> Result<Value> {
        let mut v = Vec::new();
        loop {
            match self.read_token(handle)? {
                Some((Lexeme::Punct('>'), _)) if v.len() >= 2 => break,
                Some((Lexeme::Punct(','), _)) => {}
                Some((lexeme, span)) if v.len() < 5 => v.push(self.read_number(handle, lexeme, span)?),
                _ => return self.error("bad-data", "a vector has 2 to 5 numbers and ends with `>`", span),
            }
        }
        Ok(value_of(Num::vector(&v)))
    }
}
