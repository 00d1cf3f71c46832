//! Macros: definition and call (language spec, section 1.5). What a macro "returns" is its text.
use std::rc::Rc;

use raggio_diag::Span;
use smallvec::SmallVec;

use super::compiled::Level;
use super::expr::value_of;
use super::scope::Entry;
use super::symbol::Symbol;
use super::token::{Lexed, Lexeme, NONE};
use super::{Parser, Result, Tok};
use crate::value::Kind;

/// A macro: its parameters and where its body stands.
#[derive(Debug)]
pub struct Macro {
    name: Symbol,
    params: SmallVec<[Param; 4]>,
    file: Rc<Lexed>,
    body: (u32, u32),
    /// Where it was defined.
    pub span: Span,
}

#[derive(Clone, Copy, Debug)]
struct Param {
    name: Symbol,
    /// May be left out (version 3.8).
    optional: bool,
}

/// Most parameters of a macro.
const MAX_PARAMS: usize = 55;

impl Parser<'_> {
    /// `#macro NAME ( params ) body #end`: notes the body and walks past it.
    pub(super) fn define_macro(&mut self, d: u32) -> Result<()> {
        let start = self.here();
        if self.lang() < 310 {
            return self.error("macro-version", "macros need #version 3.1 or later", start);
        }
        let (name, span) = self.raw_name()?;
        if let Some(slot) = self.scopes.lookup(name)
            && !matches!(self.scopes.entry(slot), Entry::Macro(_) | Entry::Undeclared)
        {
            let message = format!("`{}` is a variable and can't become a macro", self.symbols.name(name));
            return self.error("macro-name", message, span);
        }
        let params = self.params()?;
        let file = self.cursor.frame.file.clone();
        let end = file.directives[d as usize].end;
        if end == NONE {
            return self.error("missing-end", "this macro has no matching #end", start);
        }
        let end = file.directives[end as usize].token;
        let body = (self.cursor.frame.pos, end);
        self.cursor.frame.pos = end + 1;
        let slot = self.scopes.lookup(name).unwrap_or_else(|| self.scopes.bind(name, 0));
        *self.scopes.entry_mut(slot) = Entry::Macro(Rc::new(Macro { name, params, file, body, span }));
        Ok(())
    }

    fn params(&mut self) -> Result<SmallVec<[Param; 4]>> {
        let mut params = SmallVec::new();
        if self.raw()? != Some(Lexeme::Punct('(')) {
            return self.error("expected", "expected `(` and the parameters of the macro", self.here());
        }
        let mut optional = false;
        loop {
            match self.raw()? {
                Some(Lexeme::Punct(')')) => return Ok(params),
                Some(Lexeme::Punct(',')) => {}
                Some(Lexeme::Ident(name))
                    if self.lang() >= 380 && &**self.symbols.name(name) == "optional" =>
                {
                    optional = true;
                }
                Some(Lexeme::Ident(name)) if params.len() < MAX_PARAMS => {
                    params.push(Param { name, optional: std::mem::take(&mut optional) });
                }
                Some(Lexeme::Ident(_)) => {
                    let message = format!("a macro has at most {MAX_PARAMS} parameters");
                    return self.error("too-many-parameters", message, self.here());
                }
                Some(Lexeme::Kw(kw)) => {
                    let message =
                        format!("`{}` is a word of the language and can't be a parameter", kw.word());
                    return self.error("reserved-word", message, self.here());
                }
                _ => return self.error("expected", "expected a parameter's name or `)`", self.here()),
            }
        }
    }

    /// Reads the arguments and goes into the body.
    pub(super) fn call_macro(&mut self, called: Rc<Macro>) -> Result<()> {
        let call = self.here();
        if !self.accept_punct('(')? {
            let name = self.symbols.name(called.name).clone();
            let found = self.text();
            let message = format!("the macro `{name}` must be called with `(`, found `{found}`");
            return self.error("expected", message, self.here());
        }
        let arguments = self.nested(|p| p.arguments(&called, call))?;
        self.enter_frame(called.file.clone(), called.body, Some(called.clone()), call)?;
        let table = self.scopes.depth();
        for (param, argument) in called.params.iter().zip(arguments) {
            let slot = self.scopes.bind(param.name, table);
            *self.scopes.entry_mut(slot) = argument;
        }
        Ok(())
    }

    fn arguments(&mut self, called: &Macro, call: Span) -> Result<SmallVec<[Entry; 4]>> {
        let mut arguments = SmallVec::new();
        for (i, param) in called.params.iter().enumerate() {
            let given = !matches!(self.peek()?, Tok::Punct(')' | ','));
            if !given && !param.optional {
                return self.wrong_count(called, i, call);
            }
            arguments.push(if given { self.argument()? } else { Entry::Undeclared });
            self.comma()?;
        }
        if !self.accept_punct(')')? {
            if self.peek()? == Tok::End {
                return self.unclosed("a macro's arguments", call);
            }
            return self.wrong_count(called, called.params.len() + 1, call);
        }
        Ok(arguments)
    }

    fn wrong_count<T>(&mut self, called: &Macro, given: usize, call: Span) -> Result<T> {
        let name = self.symbols.name(called.name).clone();
        let (wants, few) = (called.params.len(), given < called.params.len());
        let given = if few { "fewer are given" } else { "more are given" };
        let message = format!("the macro `{name}` takes {wants} arguments, but {given}");
        let fault = raggio_diag::Diagnostic::error("argument-count", message, call);
        Err(Box::new(fault.related(called.span, "defined here")))
    }

    /// One argument: a bare identifier or array element by reference, anything else by value.
    fn argument(&mut self) -> Result<Entry> {
        if let Some(value) = self.compiled(Level::Argument) {
            return Ok(Entry::Value(value_of(value)));
        }
        let Tok::Value(kind) = self.peek()? else {
            if self.peek()? == Tok::Unknown {
                return self.undeclared("can't be given to a macro");
            }
            return self.value().map(Entry::Value);
        };
        let place = self.cursor.place.clone();
        let value = self.take_value()?;
        let operand =
            matches!(kind, Kind::Float | Kind::Vector | Kind::Color | Kind::Function | Kind::Spline);
        let operator = match self.peek()? {
            Tok::Punct('+' | '-' | '*' | '/' | '.') => operand,
            Tok::Punct('(') => matches!(kind, Kind::Function | Kind::Spline),
            _ => false,
        };
        if operator {
            return self.value_from(value).map(Entry::Value);
        }
        // Where another number's name follows without a comma POV-Ray takes that one's value for both.
        let is_number = |kind| matches!(kind, Kind::Float | Kind::Vector | Kind::Color);
        if let Tok::Value(next) = self.peek()?
            && is_number(kind)
            && is_number(next)
            && self.cursor.place.path.is_empty()
        {
            return Ok(Entry::Value(self.current_value().clone()));
        }
        let copied = kind == Kind::Function || !self.scopes.is_alive(place.slot);
        Ok(if copied { Entry::Value(value) } else { Entry::Ref(place) })
    }

    /// A macro's name, for back-traces.
    pub(super) fn macro_name(&self, of: &Macro) -> &str {
        self.symbols.name(of.name)
    }
}
