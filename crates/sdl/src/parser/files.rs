//! Files: `#include`, images and fonts, `#fopen`, `#fclose`, `#write` (language spec, section 1.6).
use std::rc::Rc;
use std::sync::Arc;

use raggio_diag::{Diagnostic, Span};
use raggio_scene::{GammaMode, Mesh};
use rustc_hash::FxHashMap;

use super::scope::Entry;
use super::token::Lexed;
use super::{Parser, Result, Tok, format, lexer};
use crate::keyword::Kw;
use crate::value::{Kind, Value};

/// An open file.
pub type FileHandle = u32;

/// Included files by the name that was asked for.
pub type LexedFiles = FxHashMap<String, Rc<Lexed>>;

/// Files of `#fopen`, by handle; `None` once closed.
pub type OpenFiles = Vec<Option<OpenFile>>;

/// An open file.
pub enum OpenFile {
    /// Its tokens and the next of them.
    Read {
        /// The tokens.
        file: Rc<Lexed>,
        /// The next of them.
        pos: usize,
    },
    /// What has not been written yet.
    Write {
        /// Its name.
        name: String,
        /// The bytes to come.
        buffer: Vec<u8>,
        /// Do they go behind what is there?
        append: bool,
    },
}

/// Buffered bytes are written out beyond this size.
const BUFFER: usize = 1 << 20;
/// Files larger than this are refused: places in them must fit in a token.
const MAX_FILE: usize = 1 << 31;
const INCLUDE: &[&str] = &[".inc"];

/// Names to try, in order: a name that has one of the extensions first as it is, any other last.
fn candidates(name: &str, extensions: &[&str]) -> Vec<String> {
    let mut names = Vec::new();
    let mut has_extension = false;
    for extension in extensions {
        let extension = extension.trim_start_matches('.');
        for extension in [format!(".{extension}"), format!(".{}", extension.to_ascii_uppercase())] {
            has_extension |= name.ends_with(&extension);
            names.push(format!("{name}{extension}"));
        }
    }
    let at = if has_extension { 0 } else { names.len() };
    names.insert(at, name.to_owned());
    if name.contains('\\') {
        let slashed: Vec<String> = names.iter().map(|n| n.replace('\\', "/")).collect();
        names.extend(slashed);
    }
    names
}

fn not_found<T>(name: &str, span: Span) -> Result<T> {
    let fault = Diagnostic::error("file-not-found", format!("the file \"{name}\" is not found"), span);
    Err(Box::new(fault.hint("files are looked for in the current folder and in the library folders")))
}

impl Parser<'_> {
    /// Finds a file's bytes, trying the name and the name with each extension.
    pub fn file(&mut self, name: &str, extensions: &[&str]) -> Result<Arc<[u8]>> {
        let span = self.here();
        self.find(name, extensions, span).map(|(_, bytes)| bytes.into())
    }

    /// The same with the name under which it was found.
    pub(super) fn find(&mut self, name: &str, extensions: &[&str], span: Span) -> Result<(String, Vec<u8>)> {
        match self.files.find(&candidates(name, extensions)) {
            Some((found, bytes)) if bytes.len() < MAX_FILE => Ok((found, bytes)),
            Some(_) => self.error("file-too-large", format!("the file \"{name}\" is larger than 2 GB"), span),
            None => not_found(name, span),
        }
    }

    /// The triangles of a model file.
    pub fn model(&mut self, name: &str) -> Result<Mesh> {
        let span = self.here();
        let working = match self.settings.gamma {
            GammaMode::None => None,
            GammaMode::Working(curve) => Some(curve),
        };
        match self.files.mesh(name, working) {
            Some(Ok(mesh)) => Ok(mesh),
            Some(Err(fault)) => self.error("bad-model", format!("\"{name}\": {fault}"), span),
            None => not_found(name, span),
        }
    }

    /// `#include "name"`, the word already read.
    pub(super) fn include(&mut self) -> Result<()> {
        let span = self.span();
        let name = self.path()?;
        let file = match self.lexed.get(&*name) {
            Some(file) => file.clone(),
            None => {
                let (found, bytes) = self.find(&name, INCLUDE, span)?;
                let file = self.lex(found, bytes);
                self.lexed.insert(name.to_string(), file.clone());
                file
            }
        };
        let end = file.tokens.len() as u32;
        self.enter_frame(file, (0, end), None, span)
    }

    fn lex(&mut self, name: String, bytes: Vec<u8>) -> Rc<Lexed> {
        let id = self.sources.add(name, bytes);
        let text = self.sources.get(id).text.clone();
        Rc::new(lexer::lex(id, text, &mut self.symbols))
    }

    // ---- #fopen, #fclose
    /// `#fopen NAME "file" read|write|append`
    pub(super) fn fopen(&mut self) -> Result<()> {
        let (symbol, _) = self.raw_name()?;
        let span = self.span();
        let name = self.path()?;
        let file = match self.next()? {
            Tok::Kw(Kw::Read) => {
                let (found, bytes) = self.find(&name, &[], span)?;
                OpenFile::Read { file: self.lex(found, bytes), pos: 0 }
            }
            Tok::Kw(mode @ (Kw::Write | Kw::Append)) => {
                let append = mode == Kw::Append;
                let name = name.to_string();
                if !append {
                    self.write_out(&name, &[], false, span)?;
                }
                OpenFile::Write { name, buffer: Vec::new(), append: true }
            }
            _ => return self.error("expected", "expected `read`, `write` or `append`", self.here()),
        };
        self.open_files.push(Some(file));
        let handle = self.open_files.len() as FileHandle - 1;
        let slot = self.scopes.bind(symbol, 0);
        *self.scopes.entry_mut(slot) = Entry::Value(Value::File(handle));
        Ok(())
    }

    fn write_out(&mut self, name: &str, bytes: &[u8], append: bool, span: Span) -> Result<()> {
        self.lexed.clear();
        match self.files.write(name, bytes, append) {
            Ok(()) => Ok(()),
            Err(fault) => self.error("write-failed", format!("can't write \"{name}\": {fault}"), span),
        }
    }

    /// `#fclose NAME`
    pub(super) fn fclose(&mut self) -> Result<()> {
        let (symbol, span) = self.raw_name()?;
        let Some(slot) = self.scopes.lookup(symbol) else { return Ok(()) };
        let place = self.slot_place(slot);
        let Some(&Value::File(handle)) = self.value_at(&place) else {
            return self.error("not-a-file", "this is no open file", span);
        };
        self.close_file(handle, span)?;
        self.scopes.undefine(place.slot);
        Ok(())
    }

    fn close_file(&mut self, handle: FileHandle, span: Span) -> Result<()> {
        match self.open_files[handle as usize].take() {
            Some(OpenFile::Write { name, buffer, append }) if !buffer.is_empty() => {
                self.write_out(&name, &buffer, append, span)
            }
            _ => Ok(()),
        }
    }

    /// Writes out what scenes have left open.
    pub(super) fn close_files(&mut self) -> Result<()> {
        let span = self.here();
        (0..self.open_files.len()).try_for_each(|handle| self.close_file(handle as FileHandle, span))
    }

    /// The handle that an identifier in `#read` or `#write` holds, with the place of the identifier.
    pub(super) fn handle(&mut self) -> Result<(FileHandle, u32)> {
        if self.peek()? != Tok::Value(Kind::File) {
            return self.expected("the name of an open file");
        }
        let slot = self.cursor.place.slot;
        match self.take_value()? {
            Value::File(handle) => Ok((handle, slot)),
            _ => self.expected("the name of an open file"),
        }
    }

    // ---- #write
    /// `#write ( NAME, item ... )`
    pub(super) fn write_items(&mut self) -> Result<()> {
        self.in_parentheses(|p| {
            let span = p.span();
            let (handle, _) = p.handle()?;
            let mut bytes = Vec::new();
            while p.peek()? != Tok::Punct(')') {
                p.comma()?;
                p.write_item(&mut bytes)?;
            }
            let Some(Some(OpenFile::Write { name, buffer, append })) = p.open_files.get_mut(handle as usize)
            else {
                return p.error("not-writable", "this file is not open for writing", span);
            };
            buffer.append(&mut bytes);
            if buffer.len() < BUFFER {
                return Ok(());
            }
            let (name, append, buffer) = (name.clone(), *append, std::mem::take(buffer));
            p.write_out(&name, &buffer, append, span)
        })
    }

    fn write_item(&mut self, out: &mut Vec<u8>) -> Result<()> {
        if self.at_string()? {
            let text = self.string()?;
            out.extend(text.chars().map(|c| if c.is_ascii() { c as u8 } else { b' ' }));
            return Ok(());
        }
        if let Tok::Kw(kw) = self.peek()?
            && let Some(binary) = Binary::of(kw)
        {
            self.next()?;
            while !matches!(self.peek()?, Tok::Punct(',' | ')')) {
                let num = self.additive()?;
                num.v[..num.len as usize].iter().for_each(|&x| binary.write(x, out));
            }
            return Ok(());
        }
        if matches!(self.peek()?, Tok::Value(Kind::Color)) {
            return self.expected("a string, a number or a vector; put a colour in parentheses");
        }
        let num = self.additive()?;
        let parts: Vec<String> = num.v[..num.len as usize].iter().map(|&x| format::general(x)).collect();
        match parts.as_slice() {
            [one] => out.extend(one.as_bytes()),
            parts => out.extend(format!("<{}> ", parts.join(",")).as_bytes()),
        }
        Ok(())
    }
}

/// A binary form of numbers.
#[derive(Clone, Copy)]
struct Binary {
    low: f64,
    high: f64,
    bytes: usize,
    big_endian: bool,
}

impl Binary {
    fn of(kw: Kw) -> Option<Binary> {
        let (low, high, bytes, big_endian) = match kw {
            Kw::Sint8 => (-128.0, 127.0, 1, true),
            Kw::Uint8 => (0.0, 255.0, 1, true),
            Kw::Sint16be => (-32768.0, 32767.0, 2, true),
            Kw::Sint16le => (-32768.0, 32767.0, 2, false),
            Kw::Uint16be => (0.0, 65535.0, 2, true),
            Kw::Uint16le => (0.0, 65535.0, 2, false),
            Kw::Sint32be => (f64::from(i32::MIN), f64::from(i32::MAX), 4, true),
            Kw::Sint32le => (f64::from(i32::MIN), f64::from(i32::MAX), 4, false),
            _ => return None,
        };
        Some(Binary { low, high, bytes, big_endian })
    }

    fn write(self, x: f64, out: &mut Vec<u8>) {
        let value = (x.clamp(self.low, self.high) + 0.5).floor().min(self.high) as i64;
        if self.big_endian {
            out.extend(&value.to_be_bytes()[8 - self.bytes..]);
        } else {
            out.extend(&value.to_le_bytes()[..self.bytes]);
        }
    }
}
