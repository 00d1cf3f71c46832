//! The directives, `#declare` and its kin among them (language spec, sections 1.3 and 1.7).
use std::sync::Arc;

use raggio_diag::{Diagnostic, Span};

use super::compiled::Level;
use super::cursor::Stop;
use super::expr::value_of;
use super::scope::{Deprecation, Entry, Place};
use super::symbol::Symbol;
use super::token::Lexeme;
use super::{Parser, Result, Tok};
use crate::grammar;
use crate::keyword::Kw;
use crate::value::{Kind, Value};

impl Parser<'_> {
    /// Executes a directive whose word has been consumed.
    pub(super) fn directive(&mut self, d: u32) -> Result<()> {
        match self.directive_word(d) {
            Some(Kw::Declare) => self.declare(false),
            Some(Kw::Local) => self.declare(true),
            Some(Kw::If) => {
                let taken = self.condition()?.abs() > raggio_math::EPS;
                self.branch(d, taken)
            }
            Some(Kw::Ifdef) => self.if_defined(d, true),
            Some(Kw::Ifndef) => self.if_defined(d, false),
            Some(Kw::Else | Kw::Elseif | Kw::Case | Kw::Range) => self.next_branch(d),
            Some(Kw::End) => self.end_construct(d),
            Some(Kw::While) => self.while_loop(d),
            Some(Kw::For) => self.for_loop(d),
            Some(Kw::Switch) => self.switch(d),
            Some(Kw::Break) => self.break_out(d),
            Some(Kw::Macro) => self.define_macro(d),
            Some(Kw::Include) => self.include(),
            Some(Kw::Undef) => self.undef(),
            Some(Kw::Version) => self.version_directive(),
            Some(Kw::Default) => grammar::defaults::default_directive(self),
            Some(Kw::Fopen) => self.fopen(),
            Some(Kw::Fclose) => self.fclose(),
            Some(Kw::Read) => self.read_items(),
            Some(Kw::Write) => self.write_items(),
            Some(Kw::Debug | Kw::Render | Kw::Statistics) => {
                let text = self.string()?;
                (self.debug)(&text);
                Ok(())
            }
            Some(Kw::Warning) => {
                let span = self.here();
                let text = self.string()?;
                self.warn("scene-warning", text.trim_end().to_owned(), span);
                Ok(())
            }
            Some(Kw::Error) => {
                let span = self.here();
                let text = self.string()?;
                self.error("scene-error", text.trim_end().to_owned(), span)
            }
            _ => self.lone_hash(),
        }
    }

    /// A `#` before anything but a directive's word means nothing; but before an unknown word it is surely a mistake.
    fn lone_hash(&mut self) -> Result<()> {
        let span = self.here();
        let frame = &self.cursor.frame;
        if let Some(Lexeme::Ident(symbol)) = frame.file.tokens.get(frame.pos as usize).map(|t| t.lexeme())
            && self.scopes.lookup(symbol).is_none()
        {
            let message = format!("`#{}` is no directive", self.symbols.name(symbol));
            return self.error("unknown-directive", message, span);
        }
        self.warn("stray-hash", "a lone `#` means nothing", span);
        Ok(())
    }

    /// `declare`, `include`, `version` and `default` without `#`, tolerated where a statement may begin.
    pub(super) fn bare_directive(&mut self) -> Result<bool> {
        let Tok::Kw(word @ (Kw::Declare | Kw::Include | Kw::Version | Kw::Default | Kw::Local)) =
            self.peek()?
        else {
            return Ok(false);
        };
        let span = self.here();
        self.warn("missing-hash", format!("`{}` should be `#{}`", word.word(), word.word()), span);
        self.next()?;
        match word {
            Kw::Declare => self.declare(false)?,
            Kw::Local => self.declare(true)?,
            Kw::Include => self.include()?,
            Kw::Version => self.version_directive()?,
            _ => grammar::defaults::default_directive(self)?,
        }
        Ok(true)
    }

    // ---- #declare, #local
    fn declare(&mut self, local: bool) -> Result<()> {
        let mut lexeme = self.raw()?;
        if lexeme == Some(Lexeme::Punct('(')) && self.lang() >= 380 {
            return self.declare_tuple(local);
        }
        let deprecation = self.deprecation(&mut lexeme)?;
        let span = self.here();
        let symbol = match lexeme {
            Some(Lexeme::Ident(symbol)) => symbol,
            Some(Lexeme::Kw(kw)) => {
                let message = format!("`{}` is a word of the language and can't be declared", kw.word());
                return self.error("reserved-word", message, span);
            }
            _ => return self.error("expected", "expected the name that is to be declared", span),
        };
        let target = self.target(symbol, local, span)?;
        self.expect('=')?;
        let value = match self.right_side() {
            Ok(value) => value,
            Err(fault) => return Err(self.blame_semicolon(fault, symbol, span)),
        };
        let kind = value.kind();
        let place = self.assign(target, value, span)?;
        if let Some(deprecation) = deprecation {
            self.scopes.deprecate(place.slot, deprecation);
        }
        self.end_declaration(kind, symbol, span)
    }

    /// `deprecated ["once"] ["message"]`; leaves the lexeme after it.
    fn deprecation(&mut self, lexeme: &mut Option<Lexeme>) -> Result<Option<Deprecation>> {
        if *lexeme != Some(Lexeme::Kw(Kw::Deprecated)) {
            return Ok(None);
        }
        let mut found = Deprecation { once: false, message: None };
        loop {
            *lexeme = self.raw()?;
            match *lexeme {
                Some(Lexeme::Kw(Kw::Once)) => found.once = true,
                Some(Lexeme::String(i)) => found.message = Some(self.literal(i)?.to_string()),
                _ => return Ok(Some(found)),
            }
        }
    }

    /// `#declare (A, B) = (1, 2);` (version 3.8)
    fn declare_tuple(&mut self, local: bool) -> Result<()> {
        let mut targets = Vec::new();
        loop {
            let (symbol, span) = self.raw_name()?;
            targets.push((self.target(symbol, local, span)?, span));
            if !self.accept_punct(',')? {
                break;
            }
        }
        self.expect(')')?;
        self.expect('=')?;
        self.expect('(')?;
        let mut values = Vec::new();
        for i in 0..targets.len() {
            if i > 0 {
                self.expect(',')?;
            }
            values.push(self.nested(Self::value)?);
        }
        self.expect(')')?;
        for ((target, span), value) in targets.into_iter().zip(values) {
            self.assign(target, value, span)?;
        }
        self.accept_punct(';').map(|_| ())
    }

    /// What a declaration writes to.
    pub(super) fn target(&mut self, symbol: Symbol, local: bool, span: Span) -> Result<Target> {
        let visible = self.scopes.lookup(symbol);
        if let Some(slot) = visible
            && self.next_raw_is('[')
        {
            let place = self.slot_place(slot);
            return Ok(Target::Place(self.subscripted(place)?));
        }
        if local {
            return Ok(Target::Local(symbol, self.scopes.depth()));
        }
        match visible {
            Some(slot) if matches!(self.scopes.entry(slot), Entry::Macro(_)) => {
                let message =
                    format!("`{}` is a macro; only #macro can replace it", self.symbols.name(symbol));
                self.error("macro-name", message, span)
            }
            Some(slot) => Ok(Target::Place(self.slot_place(slot))),
            None => Ok(Target::Global(symbol)),
        }
    }

    /// The variable behind a slot: its own, or the one that a parameter refers to.
    pub(super) fn slot_place(&self, slot: u32) -> Place {
        match self.scopes.entry(slot) {
            Entry::Ref(place) => place.clone(),
            _ => Place::variable(slot),
        }
    }

    /// The right side of a declaration: what follows it is not executed before the name is bound.
    fn right_side(&mut self) -> Result<Value> {
        if self.lang() >= 350
            && let Some(value) = self.compiled(Level::Additive)
        {
            return Ok(value_of(value));
        }
        let frame = self.cursor.callers.len();
        self.peek()?;
        let numeric = self.at_expression()? || self.at_color_word()?;
        self.cursor.stop = if numeric && self.lang() >= 350 { Stop::Statements } else { Stop::All };
        self.cursor.stop_frame = frame;
        let value = self.value();
        self.cursor.stop = Stop::Never;
        value
    }

    /// Binds or overwrites.
    pub(super) fn assign(&mut self, target: Target, value: Value, span: Span) -> Result<Place> {
        let place = match target {
            Target::Place(place) => place,
            Target::Global(symbol) => Place::variable(self.scopes.bind(symbol, 0)),
            // A parameter given by reference is written through, by #local as well.
            Target::Local(symbol, table) => {
                let slot = self.scopes.bind(symbol, table.min(self.scopes.depth()));
                self.slot_place(slot)
            }
        };
        self.store(&place, value, span)?;
        Ok(place)
    }

    /// Writes a value to a place.
    pub(super) fn store(&mut self, place: &Place, value: Value, span: Span) -> Result<()> {
        if let Some((&index, path)) = place.path.split_last() {
            let array = Place { slot: place.slot, path: path.into() };
            if let Some(Value::Array(array)) = self.value_at(&array) {
                self.check_item(array, &value)?;
            }
            if let Some(array) = self.array_mut(&array) {
                array.set(index, value);
            }
            return Ok(());
        }
        if matches!(self.scopes.entry(place.slot), Entry::Value(Value::Function(_))) {
            return self.error(
                "function-exists",
                "a function must be #undef-ed before it is declared anew",
                span,
            );
        }
        *self.scopes.entry_mut(place.slot) = Entry::Value(value);
        Ok(())
    }

    /// The array at a place, unshared so that it can be changed.
    fn array_mut(&mut self, place: &Place) -> Option<&mut super::Array> {
        let Entry::Value(variable) = self.scopes.entry_mut(place.slot) else { return None };
        let mut value = variable;
        for &index in &place.path {
            let Value::Array(array) = value else { return None };
            value = Arc::make_mut(array).items.get_mut(index as usize)?.as_mut()?;
        }
        match value {
            Value::Array(array) => Some(Arc::make_mut(array)),
            _ => None,
        }
    }

    /// The semicolon: required after numbers and colours, optional after anything else.
    fn end_declaration(&mut self, kind: Kind, symbol: Symbol, name: Span) -> Result<()> {
        let numeric = matches!(kind, Kind::Float | Kind::Vector | Kind::Color);
        if self.accept_raw_semicolon()? {
            // After numbers one too many is forgiven, as `#include "numbers.inc";` leaves behind.
            return if numeric { self.accept_raw_semicolon().map(|_| ()) } else { Ok(()) };
        }
        if !numeric {
            return Ok(());
        }
        match self.lang() {
            ..310 => {}
            310..350 => {
                let span = self.here();
                self.warn("missing-semicolon", "a declaration of a number should end with `;`", span);
            }
            _ => return Err(self.missing_semicolon(symbol, name)),
        }
        Ok(())
    }

    /// Without its `;`, a number is still being read in the `#if` or `#while` after it, which may ask for the very
    /// name that is being declared: what is missing is the semicolon, not the name.
    fn blame_semicolon(&self, fault: Box<Diagnostic>, symbol: Symbol, name: Span) -> Box<Diagnostic> {
        let Some(at) = fault.span.filter(|at| fault.code == "unknown-identifier" && at.file == name.file)
        else {
            return fault;
        };
        let same = *self.source_text(at) == **self.symbols.name(symbol);
        let between = Span { file: name.file, start: name.end, end: at.start.max(name.end) };
        if same && self.source_text(between).contains('#') {
            self.missing_semicolon(symbol, name)
        } else {
            fault
        }
    }

    /// Consumes a semicolon if it comes next, executing nothing on the way but the return from macros and files.
    pub(super) fn accept_raw_semicolon(&mut self) -> Result<bool> {
        if let Some(tok) = self.cursor.ahead {
            return if tok == Tok::Punct(';') { self.next().map(|_| true) } else { Ok(false) };
        }
        while self.cursor.frame.pos >= self.cursor.frame.end && self.cursor.frame.call.is_some() {
            if !self.leave_frame()? {
                break;
            }
        }
        let found = self.next_raw_is(';');
        self.cursor.frame.pos += u32::from(found);
        Ok(found)
    }

    // ---- #undef, #ifdef
    fn undef(&mut self) -> Result<()> {
        let (symbol, span) = self.raw_name()?;
        let Some(slot) = self.scopes.lookup(symbol) else {
            let message =
                format!("`{}` is not declared, so it can't be undefined", self.symbols.name(symbol));
            self.warn("unknown-identifier", message, span);
            return self.accept_raw_semicolon().map(|_| ());
        };
        if self.next_raw_is('[') {
            let place = self.slot_place(slot);
            let mut place = self.subscripted(place)?;
            let index = place.path.pop().unwrap_or(0);
            if let Some(array) = self.array_mut(&place) {
                array.items[index as usize] = None;
            }
        } else {
            self.scopes.undefine(slot);
        }
        self.accept_raw_semicolon().map(|_| ())
    }

    fn if_defined(&mut self, d: u32, wanted: bool) -> Result<()> {
        self.expect('(')?;
        let defined = self.defined()?;
        self.expect(')')?;
        self.branch(d, defined == wanted)
    }

    /// The name or array element inside `defined( )`: has it a value?
    pub(super) fn defined(&mut self) -> Result<bool> {
        match self.raw()? {
            Some(Lexeme::Kw(_)) => Ok(false),
            Some(Lexeme::Ident(symbol)) => {
                let Some(slot) = self.scopes.lookup(symbol) else {
                    self.skip_subscripts()?;
                    return Ok(false);
                };
                if matches!(self.scopes.entry(slot), Entry::Macro(_)) {
                    return Ok(true);
                }
                let mut place = self.slot_place(slot);
                if self.next_raw_is('[') {
                    place = self.subscripted(place)?;
                }
                Ok(self.value_at(&place).is_some())
            }
            _ => self.error("expected", "expected a name", self.here()),
        }
    }

    /// Reads the subscripts of something that is not declared.
    fn skip_subscripts(&mut self) -> Result<()> {
        while self.accept_punct('[')? {
            self.nested(Self::float)?;
            self.expect(']')?;
        }
        Ok(())
    }
}

/// What a declaration writes to.
pub(super) enum Target {
    /// Something that exists.
    Place(Place),
    /// A new name for all.
    Global(Symbol),
    /// A name in the table with this index.
    Local(Symbol, u32),
}
