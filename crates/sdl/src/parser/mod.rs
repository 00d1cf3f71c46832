//! The running scene: tokens in, values and statements out.
//!
//! This file is what the grammar may ask of the parser. `peek` and `next` deliver a stream in which directives have
//! been executed, macros expanded, and declared identifiers (with their subscripts) replaced by their values.
mod array;
mod builder;
mod call;
mod color;
mod compiled;
mod control;
mod cursor;
mod datetime;
mod declare;
mod expr;
mod files;
mod float_fn;
mod format;
mod input;
mod lexer;
mod macros;
mod message;
mod num;
mod picture;
mod random;
mod run;
mod scope;
mod slots;
mod spline;
mod string;
mod symbol;
mod token;
mod transform;
mod undefined;
mod vector_fn;
mod version;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

pub use array::Array;
pub use builder::SceneBuilder;
use cursor::{Cursor, Stop};
pub use files::FileHandle;
pub use format::six_digits;
use raggio_diag::{Diagnostic, FileId, Sources, Span};
use raggio_scene::Settings;
pub use run::{Surroundings, run};
use scope::Scopes;
pub use spline::Spline;
pub use string::Charset;
use symbol::Symbols;

use crate::keyword::Kw;
use crate::value::{Kind, Value};
use crate::{Engine, Files, ParseOptions};

/// Errors are boxed: they are rare and large.
pub type Result<T> = std::result::Result<T, Box<Diagnostic>>;

/// What a token is, after directives, macros and identifiers have been dealt with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tok {
    /// A reserved word.
    Kw(Kw),
    /// A declared identifier or array element; `Parser::take_value` hands the value out.
    Value(Kind),
    /// An identifier that is not declared.
    Unknown,
    /// A number literal.
    Number(f64),
    /// A string literal.
    String,
    /// One of `{ } ( ) [ ] < > , ; . + - * / = ! & | ? :` or, as `≤ ≥ ≠`, the two-character operators.
    Punct(char),
    /// The end of the scene; or, on the right side of a declaration, a directive that ends it.
    End,
}

/// The state of a scene that is being read.
pub struct Parser<'a> {
    /// Settings so far, `version` among them; the grammar of `global_settings` writes them.
    pub settings: Settings,
    /// What the statements have added so far.
    pub scene: SceneBuilder,
    /// `global_settings { charset }`
    pub charset: Charset,
    /// The running defaults of `#default`.
    pub defaults: crate::grammar::Defaults,
    engine: &'a dyn Engine,
    files: &'a dyn Files,
    sources: &'a mut Sources,
    options: &'a ParseOptions,
    debug: &'a mut (dyn FnMut(&str) + Send),
    cancel: Arc<AtomicBool>,
    warnings: Vec<Diagnostic>,
    symbols: Symbols,
    scopes: Scopes,
    cursor: Cursor,
    open_files: files::OpenFiles,
    lexed: files::LexedFiles,
    streams: random::Streams,
    version: version::VersionState,
    gamma_explicit: bool,
    depth: u32,
    undefined: undefined::Undefined,
    /// What `span` met, for the next `peek`.
    fault: Option<Box<Diagnostic>>,
}

/// Most brackets and blocks within one another.
const MAX_DEPTH: u32 = 400;

#[allow(clippy::should_implement_trait)]
impl Parser<'_> {
    // ---- tokens
    /// The next token, not consumed.
    #[inline]
    pub fn peek(&mut self) -> Result<Tok> {
        match self.cursor.ahead {
            Some(tok) => Ok(tok),
            None => self.advance(),
        }
    }

    /// Consumes and returns the next token.
    #[inline]
    pub fn next(&mut self) -> Result<Tok> {
        let tok = self.peek()?;
        self.cursor.ahead = None;
        Ok(tok)
    }

    /// The place of the token that `peek` shows.
    pub fn span(&mut self) -> Span {
        if let Err(fault) = self.peek() {
            self.fault = Some(fault);
        }
        self.here()
    }

    /// The text of the token that `peek` shows, for messages and for names.
    pub fn text(&mut self) -> String {
        let span = self.span();
        self.source_text(span)
    }

    /// Consumes the word if it comes next.
    #[inline]
    pub fn accept(&mut self, word: Kw) -> Result<bool> {
        self.accept_tok(Tok::Kw(word))
    }

    /// Consumes the character if it comes next.
    #[inline]
    pub fn accept_punct(&mut self, c: char) -> Result<bool> {
        self.accept_tok(Tok::Punct(c))
    }

    #[inline]
    fn accept_tok(&mut self, wanted: Tok) -> Result<bool> {
        let found = self.peek()? == wanted;
        if found {
            self.cursor.ahead = None;
        }
        Ok(found)
    }

    /// Consumes the character or fails, naming what was expected.
    #[inline]
    pub fn expect(&mut self, c: char) -> Result<()> {
        if self.accept_punct(c)? || self.accept_after_directives(c)? {
            return Ok(());
        }
        self.expected(&format!("`{c}`"))
    }

    /// What must come can't be the end of a right side: `#declare L = #if (M) merge #else union #end { ... }`.
    #[cold]
    fn accept_after_directives(&mut self, c: char) -> Result<bool> {
        let stop = std::mem::replace(&mut self.cursor.stop, Stop::Never);
        let found = stop != Stop::Never && self.accept_punct(c)?;
        self.cursor.stop = stop;
        Ok(found)
    }

    /// An optional comma.
    #[inline]
    pub fn comma(&mut self) -> Result<()> {
        self.accept_punct(',').map(|_| ())
    }

    /// `{ ... }`: calls `item` until the closing brace; `item` consumes one item and says false if it knows none that
    /// begins so, which becomes an error "`what` does not take ...".
    pub fn block(&mut self, what: &str, mut item: impl FnMut(&mut Self) -> Result<bool>) -> Result<()> {
        self.expect('{')?;
        let open = self.here();
        self.nested(|p| {
            loop {
                match p.peek()? {
                    Tok::Punct('}') => {
                        p.cursor.ahead = None;
                        return Ok(());
                    }
                    Tok::End => return p.unclosed(what, open),
                    _ => {}
                }
                if !item(p)? {
                    return p.not_taken(what);
                }
            }
        })
    }

    /// The value that `peek` showed as `Tok::Value`, cloned; consumes the token.
    pub fn take_value(&mut self) -> Result<Value> {
        match self.next()? {
            Tok::Value(_) => Ok(self.current_value().clone()),
            _ => self.expected("an identifier"),
        }
    }

    // ---- files and the engine
    /// The engine that answers `trace` and the like.
    pub fn engine(&self) -> &dyn Engine {
        self.engine
    }

    /// The language version in hundredths: 370 is 3.7.
    pub fn lang(&self) -> u16 {
        self.settings.version.language
    }

    /// The name of a source file.
    pub fn file_name(&self, file: FileId) -> &str {
        &self.sources.get(file).name
    }

    // ---- inside the parser
    /// Runs `inner` one bracket deeper: the right side of a declaration can't end in there, and depth is counted.
    pub fn nested<T>(&mut self, inner: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        if self.depth >= MAX_DEPTH {
            let message = format!("more than {MAX_DEPTH} brackets or blocks within one another");
            return self.error("nested-too-deeply", message, self.here());
        }
        let stop = std::mem::replace(&mut self.cursor.stop, Stop::Never);
        self.depth += 1;
        let result = inner(self);
        self.depth -= 1;
        self.cursor.stop = stop;
        result
    }
}
