//! Messages: what was expected, what was found, what may have been meant.
use raggio_diag::{Diagnostic, Frame, Span};

use super::symbol::Symbol;
use super::{Parser, Result, Tok};
use crate::keyword::Kw;
use crate::suggest;

/// After so many warnings the rest is dropped: a loop may repeat one a million times.
const MAX_WARNINGS: usize = 200;

impl Parser<'_> {
    /// "expected `what`, found ...", at the token that `peek` shows.
    pub fn expected<T>(&mut self, what: &str) -> Result<T> {
        let tok = match self.cursor.ahead {
            Some(tok) => tok,
            None => self.peek()?,
        };
        if tok == Tok::Unknown {
            return self.undeclared(&format!("is not declared, and {what} is expected here"));
        }
        let found = self.found(tok);
        let fault = Diagnostic::error("expected", format!("expected {what}, found {found}"), self.here());
        Err(Box::new(fault.label(format!("expected {what}"))))
    }

    fn found(&self, tok: Tok) -> String {
        let text = || self.source_text(self.here());
        match tok {
            Tok::End => "the end".to_owned(),
            Tok::Kw(kw) => format!("`{}`", kw.word()),
            Tok::Value(kind) => format!("`{}`, a {}", text(), kind.name()),
            Tok::String => "a string".to_owned(),
            Tok::Number(_) | Tok::Unknown | Tok::Punct(_) => format!("`{}`", text()),
        }
    }

    /// An error about the identifier that `peek` shows, which is not declared.
    pub(super) fn undeclared<T>(&mut self, why: &str) -> Result<T> {
        let name = self.text();
        let why = if why.contains("not declared") {
            why.to_owned()
        } else {
            format!("is not declared, so it {why}")
        };
        let mut fault = Diagnostic::error("unknown-identifier", format!("`{name}` {why}"), self.here());
        fault.label = "not declared".to_owned();
        let words = Kw::ALL.iter().map(|kw| kw.word());
        let names: Vec<String> =
            self.scopes.visible().map(|s: Symbol| self.symbols.name(s).to_string()).collect();
        if let Some(hint) = suggest::nearest(&name, words.chain(names.iter().map(String::as_str))) {
            fault = fault.hint(format!("did you mean `{hint}`?"));
        }
        Err(Box::new(fault))
    }

    /// An item that a block does not know.
    pub(super) fn not_taken<T>(&mut self, what: &str) -> Result<T> {
        let tok = self.peek()?;
        if tok == Tok::Unknown {
            return self.undeclared(&format!("means nothing in {what}"));
        }
        let message = format!("{what} does not take {}", self.found(tok));
        self.error("unexpected", message, self.here())
    }

    /// The text ended inside something.
    pub(super) fn unclosed<T>(&self, what: &str, open: Span) -> Result<T> {
        let fault = Diagnostic::error("unclosed", format!("{what} is not closed"), open);
        Err(Box::new(fault.label("opened here")))
    }

    /// A declaration without its `;` at its name, since what follows the value may be far away.
    pub(super) fn missing_semicolon(&self, symbol: Symbol, name: Span) -> Box<Diagnostic> {
        let message = format!("the declaration of `{}` must end with `;`", self.symbols.name(symbol));
        let fault = Diagnostic::error("missing-semicolon", message, name)
            .label("a number, vector or colour is declared here")
            .hint("add `;` after the value, or begin an old scene with `#version 3.1;`");
        Box::new(fault)
    }

    /// An error at a place.
    pub fn error<T>(&self, code: &'static str, message: impl Into<String>, span: Span) -> Result<T> {
        Err(Box::new(Diagnostic::error(code, message, span)))
    }

    /// A warning at a place; the scene goes on. The same warning at the same place is said once.
    pub fn warn(&mut self, code: &'static str, message: impl Into<String>, span: Span) {
        let known = |w: &Diagnostic| w.code == code && w.span == Some(span);
        if self.warnings.len() >= MAX_WARNINGS || self.warnings.iter().any(known) {
            return;
        }
        let mut warning = Diagnostic::warning(code, message, span);
        warning.trace = self.backtrace();
        self.warnings.push(warning);
    }

    /// A warning about the whole scene.
    pub(super) fn note(&mut self, code: &'static str, message: &str) {
        self.warnings.push(Diagnostic::warning(code, message, None));
    }

    pub(super) fn warn_deprecated(&mut self, symbol: Symbol, message: Option<String>) {
        let name = self.symbols.name(symbol);
        let message = message.unwrap_or_else(|| format!("`{name}` is deprecated"));
        self.warn("deprecated", message, self.here());
    }

    /// The macro calls and inclusions on the way here, innermost first.
    pub(super) fn backtrace(&self) -> Vec<Frame> {
        let frames = std::iter::once(&self.cursor.frame).chain(self.cursor.callers.iter().rev());
        let step = |frame: &super::cursor::Frame| {
            let what = match &frame.of_macro {
                Some(called) => format!("macro {}", self.macro_name(called)),
                None => format!("include \"{}\"", self.file_name(frame.file.file)),
            };
            frame.call.map(|span| Frame { what, span })
        };
        frames.filter_map(step).collect()
    }
}
