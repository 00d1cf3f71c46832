//! The running scene: tokens in, values and statements out.
//!
//! This file fixes what the grammar may ask of the parser. `peek` and `next` deliver a stream in which directives have
//! been executed, macros expanded, and declared identifiers (with their subscripts) replaced by their values.
mod builder;

use std::sync::Arc;

pub use builder::SceneBuilder;
use raggio_diag::{Diagnostic, Span};
use raggio_math::{Affine, Vec2, Vec3};
use raggio_scene::{Bitmap, Color, Settings};

use crate::keyword::Kw;
use crate::value::{Kind, Value};

/// Errors are boxed: they are rare and large.
pub type Result<T> = std::result::Result<T, Box<Diagnostic>>;

/// An array value: shared by reference between macro parameters, copied deeply by `#declare`.
pub type ArrayRef = ();
/// A `spline { ... }` value; lives in `parser/spline.rs`.
#[derive(Debug)]
pub struct Spline;
/// An open file.
pub type FileHandle = u32;

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
    /// The end of the scene.
    End,
}

pub struct Parser<'a> {
    /// Settings so far, `version` among them; the grammar of `global_settings` writes them.
    pub settings: Settings,
    /// What the statements have added so far.
    pub scene: SceneBuilder,
    _engine: &'a dyn crate::Engine,
}

#[allow(unused_variables, clippy::todo)]
impl Parser<'_> {
    // ---- tokens
    /// The next token, not consumed.
    pub fn peek(&mut self) -> Result<Tok> {
        todo!()
    }
    /// Consumes and returns the next token.
    pub fn next(&mut self) -> Result<Tok> {
        todo!()
    }
    /// The place of the token that `peek` shows.
    pub fn span(&mut self) -> Span {
        todo!()
    }
    /// The text of the token that `peek` shows, for messages and for names.
    pub fn text(&mut self) -> String {
        todo!()
    }
    /// Consumes the word if it comes next.
    pub fn accept(&mut self, word: Kw) -> Result<bool> {
        todo!()
    }
    /// Consumes the character if it comes next.
    pub fn accept_punct(&mut self, c: char) -> Result<bool> {
        todo!()
    }
    /// Consumes the character or fails, naming what was expected.
    pub fn expect(&mut self, c: char) -> Result<()> {
        todo!()
    }
    /// An optional comma.
    pub fn comma(&mut self) -> Result<()> {
        todo!()
    }
    /// `{ ... }`: calls `item` until the closing brace; `item` consumes one item and says false if it knows none that
    /// begins so, which becomes an error "`what` does not take ..." with a suggestion from `words`.
    pub fn block(&mut self, what: &str, item: impl FnMut(&mut Self) -> Result<bool>) -> Result<()> {
        todo!()
    }
    /// The value that `peek` showed as `Tok::Value`, cloned; consumes the token.
    pub fn take_value(&mut self) -> Result<Value> {
        todo!()
    }

    // ---- numbers (language spec, section 2)
    /// A float slot: an additive expression of one component.
    pub fn float(&mut self) -> Result<f64> {
        todo!()
    }
    /// A float slot that must be a whole number in range; outside: an error naming `what`.
    pub fn int(&mut self, what: &str, range: std::ops::RangeInclusive<i64>) -> Result<i64> {
        todo!()
    }
    /// An optional float if an expression comes next (`hollow`, `metallic`), else `default`.
    pub fn optional_float(&mut self, default: f64) -> Result<f64> {
        todo!()
    }
    /// A flag: `word`, `word on`, `word off`, `word 0`.
    pub fn flag(&mut self) -> Result<bool> {
        Ok(self.optional_float(1.0)? != 0.0)
    }
    /// Does an expression come next?
    pub fn at_expression(&mut self) -> Result<bool> {
        todo!()
    }
    pub fn vec2(&mut self) -> Result<Vec2> {
        todo!()
    }
    pub fn vec3(&mut self) -> Result<Vec3> {
        todo!()
    }
    pub fn vec4(&mut self) -> Result<[f64; 4]> {
        todo!()
    }
    /// An expression of any size: its components (replicated to five where it is one number) and how many it has.
    pub fn tuple(&mut self) -> Result<([f64; 5], u8)> {
        todo!()
    }
    /// A colour slot with all five channels: `rgb`, `rgbf`, `srgb`, `color`, a colour identifier, `red .. green ..`.
    pub fn color(&mut self) -> Result<Color> {
        todo!()
    }
    /// A colour slot where filter and transmit mean nothing.
    pub fn rgb(&mut self) -> Result<raggio_scene::Rgb> {
        Ok(self.color()?.rgb)
    }
    /// A string expression in text mode.
    pub fn string(&mut self) -> Result<Arc<str>> {
        todo!()
    }
    /// A string expression in path mode (file names).
    pub fn path(&mut self) -> Result<Arc<str>> {
        todo!()
    }

    // ---- transforms
    /// One of `translate rotate scale matrix transform` if it comes next.
    pub fn accept_transform(&mut self) -> Result<Option<Affine>> {
        todo!()
    }

    // ---- files
    /// Finds and decodes an image by the rules of section 1.6; the type word has been read already (`None`: by name).
    pub fn image(&mut self, name: &str, format: Option<Kw>) -> Result<Arc<Bitmap>> {
        todo!()
    }
    /// Finds a file's bytes, trying the name and then the name with each extension.
    pub fn file(&mut self, name: &str, extensions: &[&str]) -> Result<Arc<[u8]>> {
        todo!()
    }

    // ---- messages
    /// "expected `what`, found ...", at the token that `peek` shows.
    pub fn expected<T>(&mut self, what: &str) -> Result<T> {
        todo!()
    }
    /// An error at a place.
    pub fn error<T>(&self, code: &'static str, message: impl Into<String>, span: Span) -> Result<T> {
        Err(Box::new(Diagnostic::error(code, message, span)))
    }
    /// A warning at a place; the scene goes on.
    pub fn warn(&mut self, code: &'static str, message: impl Into<String>, span: Span) {
        todo!()
    }
    /// The effective version (language spec, section 1.8) and the syntax version are in `settings.version`.
    pub fn engine(&self) -> &dyn crate::Engine {
        self._engine
    }
}
