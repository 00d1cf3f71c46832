//! `#if`, `#while`, `#for`, `#switch`, `#break` (language spec, section 1.7).
use std::sync::atomic::Ordering;

use raggio_diag::{Diagnostic, Span};

use super::scope::{Entry, Slot};
use super::token::{Lexeme, NONE};
use super::{Parser, Result};
use crate::keyword::Kw;
use crate::value::Value;
use raggio_math::EPS;

/// An open construct.
#[derive(Clone, Copy, Debug)]
pub struct Control {
    kind: ControlKind,
    /// Its directive, in the file of its frame.
    open: u32,
    /// Where that stands.
    span: Span,
}

#[derive(Clone, Copy, Debug)]
enum ControlKind {
    /// A branch that is being taken.
    If,
    /// A case that is being taken.
    Switch,
    /// `condition` is the token after `#while`.
    While { condition: u32 },
    /// `body` is the first token after `#for (...)`.
    For { variable: Slot, last: f64, step: f64, body: u32 },
}

impl Parser<'_> {
    /// Stops the run when asked to from outside.
    pub(super) fn check_cancel(&self) -> Result<()> {
        if self.cancel.load(Ordering::Relaxed) {
            return self.error("cancelled", "stopped while reading the scene", self.here());
        }
        Ok(())
    }

    /// `( full expression )`, one number.
    pub(super) fn condition(&mut self) -> Result<f64> {
        self.expect('(')?;
        let value = self.nested(Self::full_float)?;
        self.expect(')')?;
        Ok(value)
    }

    fn push_control(&mut self, kind: ControlKind, open: u32) {
        let span = self.directive_span(open);
        self.cursor.controls.push(Control { kind, open, span });
    }

    fn directive_span(&self, d: u32) -> Span {
        let file = &self.cursor.frame.file;
        let start = file.tokens[file.directives[d as usize].token as usize].start;
        let end = super::lexer::token_end(&file.text, start as usize) as u32;
        Span { file: file.file, start, end }
    }

    /// The innermost open construct of the current frame. A conditional may reach out of an included file.
    fn top_control(&self) -> Option<Control> {
        let top = *self.cursor.controls.last()?;
        let own = self.cursor.controls.len() > self.cursor.frame.controls;
        let crossing = self.cursor.frame.of_macro.is_none() && matches!(top.kind, ControlKind::If);
        (own || crossing).then_some(top)
    }

    /// Loops must end in the file in which they begin, conditionals before the end of the scene.
    pub(super) fn check_open_constructs(&self) -> Result<()> {
        let first = if self.cursor.callers.is_empty() { 0 } else { self.cursor.frame.controls };
        let open = self.cursor.controls.get(first..).unwrap_or_default();
        let may_stay = !self.cursor.callers.is_empty();
        match open.iter().rev().find(|c| !(may_stay && matches!(c.kind, ControlKind::If))) {
            Some(control) => self.missing_end(control.span),
            None => Ok(()),
        }
    }

    fn missing_end<T>(&self, span: Span) -> Result<T> {
        self.error("missing-end", "this has no matching #end", span)
    }

    // ---- #if
    /// `#if` and its kin, the condition already known.
    pub(super) fn branch(&mut self, d: u32, taken: bool) -> Result<()> {
        if taken {
            self.push_control(ControlKind::If, d);
            return Ok(());
        }
        let mut at = d;
        loop {
            at = self.skip_to_branch(at, d)?;
            match self.directive_word(at) {
                Some(Kw::End) => return Ok(()),
                Some(Kw::Elseif) if self.condition()?.abs() <= EPS => {}
                Some(Kw::Else | Kw::Elseif) => {
                    self.push_control(ControlKind::If, at);
                    return Ok(());
                }
                _ => return self.unexpected_directive(at),
            }
        }
    }

    pub(super) fn directive_word(&self, d: u32) -> Option<Kw> {
        self.cursor.frame.file.directives[d as usize].word
    }

    /// `#else` and `#elseif` at the end of a taken branch; `#case`, `#range` and `#else` in a taken `#switch` are
    /// walked through.
    pub(super) fn next_branch(&mut self, d: u32) -> Result<()> {
        let word = self.directive_word(d);
        match self.top_control().map(|c| c.kind) {
            Some(ControlKind::If) if matches!(word, Some(Kw::Else | Kw::Elseif)) => {
                self.cursor.controls.pop();
                self.skip_to_end(d)
            }
            Some(ControlKind::Switch) if word == Some(Kw::Else) => Ok(()),
            Some(ControlKind::Switch) if matches!(word, Some(Kw::Case | Kw::Range)) => {
                self.case_matches(d, 0.0).map(|_| ())
            }
            _ => self.unexpected_directive(d),
        }
    }

    fn unexpected_directive<T>(&self, d: u32) -> Result<T> {
        let word = self.directive_word(d).map_or("", Kw::word);
        self.error("unexpected-directive", format!("#{word} does not belong here"), self.directive_span(d))
    }

    /// Walks to just after the next branch (or the end) of the construct of which `d` is a branch; `first` is its
    /// beginning, for messages.
    fn skip_to_branch(&mut self, d: u32, first: u32) -> Result<u32> {
        let file = &self.cursor.frame.file;
        let next = file.directives[d as usize].next;
        if next != NONE {
            self.cursor.frame.pos = file.directives[next as usize].token + 1;
            return Ok(next);
        }
        let span = self.directive_span(first.min(file.directives.len() as u32 - 1));
        self.skip_across_files(span)
    }

    /// The construct was begun in an included file and ends in the one that includes it, or the other way round:
    /// looks for its next branch from here on.
    fn skip_across_files(&mut self, span: Span) -> Result<u32> {
        loop {
            if let Some(branch) = self.next_branch_here() {
                self.cursor.frame.pos = self.cursor.frame.file.directives[branch as usize].token + 1;
                return Ok(branch);
            }
            self.cursor.frame.pos = self.cursor.frame.end;
            if self.cursor.frame.of_macro.is_some()
                || self.cursor.callers.is_empty()
                || !self.leave_frame()?
            {
                return self.missing_end(span);
            }
        }
    }

    /// The next branch or end, after the walk's place, of a construct that was begun elsewhere.
    fn next_branch_here(&self) -> Option<u32> {
        let frame = &self.cursor.frame;
        let from = frame.file.directives.partition_point(|d| d.token < frame.pos);
        let mut depth = 0;
        for (i, d) in frame.file.directives.iter().enumerate().skip(from) {
            match d.word {
                Some(Kw::If | Kw::Ifdef | Kw::Ifndef | Kw::While | Kw::For | Kw::Switch | Kw::Macro) => {
                    depth += 1
                }
                Some(Kw::End) if depth > 0 => depth -= 1,
                Some(Kw::End | Kw::Else | Kw::Elseif) if depth == 0 => return Some(i as u32),
                _ => {}
            }
        }
        None
    }

    /// Walks to just after the `#end` of the construct of which `d` is a branch.
    fn skip_to_end(&mut self, d: u32) -> Result<()> {
        let file = &self.cursor.frame.file;
        let end = file.directives[d as usize].end;
        if end != NONE {
            self.cursor.frame.pos = file.directives[end as usize].token + 1;
            return Ok(());
        }
        let mut at = d;
        while self.directive_word(at) != Some(Kw::End) {
            at = self.skip_to_branch(at, at)?;
        }
        Ok(())
    }

    // ---- loops
    /// `#while ( e )`
    pub(super) fn while_loop(&mut self, d: u32) -> Result<()> {
        let condition = self.cursor.frame.pos;
        if self.cursor.frame.file.directives[d as usize].end == NONE {
            return self.missing_end(self.directive_span(d));
        }
        if self.condition()?.abs() <= EPS {
            return self.skip_to_end(d);
        }
        self.push_control(ControlKind::While { condition }, d);
        Ok(())
    }

    /// `#for ( I, first, last [, step] )`
    pub(super) fn for_loop(&mut self, d: u32) -> Result<()> {
        if self.cursor.frame.file.directives[d as usize].end == NONE {
            return self.missing_end(self.directive_span(d));
        }
        let table = self.scopes.depth();
        self.expect('(')?;
        let (symbol, span) = self.raw_name()?;
        let (first, last, step) = self.nested(|p| {
            p.comma()?;
            let first = p.float()?;
            p.comma()?;
            let last = p.float()?;
            Ok((first, last, if p.accept_punct(',')? { p.float()? } else { 1.0 }))
        })?;
        self.expect(')')?;
        if step.abs() < EPS {
            return self.error("zero-step", "the step of #for is zero", span);
        }
        let own = self.scopes.bind(symbol, table);
        let place = self.slot_place(own);
        let variable = if place.path.is_empty() { place.slot } else { own };
        *self.scopes.entry_mut(variable) = Entry::Value(Value::Float(first));
        if !in_range(first, last, step) {
            return self.skip_to_end(d);
        }
        let body = self.cursor.frame.pos;
        self.push_control(ControlKind::For { variable, last, step, body }, d);
        Ok(())
    }

    /// `#end`
    pub(super) fn end_construct(&mut self, d: u32) -> Result<()> {
        let Some(control) = self.top_control() else { return self.unexpected_directive(d) };
        match control.kind {
            ControlKind::If | ControlKind::Switch => {
                self.cursor.controls.pop();
            }
            ControlKind::While { condition } => {
                self.check_cancel()?;
                let after = self.cursor.frame.pos;
                self.cursor.frame.pos = condition;
                if self.condition()?.abs() <= EPS {
                    self.cursor.controls.pop();
                    self.cursor.frame.pos = after;
                }
            }
            ControlKind::For { variable, last, step, body } => {
                self.check_cancel()?;
                let Entry::Value(Value::Float(value)) = self.scopes.entry_mut(variable) else {
                    return self.error(
                        "loop-variable",
                        "the variable of #for is no number any more",
                        control.span,
                    );
                };
                *value += step;
                if in_range(*value, last, step) {
                    self.cursor.frame.pos = body;
                } else {
                    self.cursor.controls.pop();
                }
            }
        }
        Ok(())
    }

    // ---- #switch and #break
    /// `#switch ( e )`
    pub(super) fn switch(&mut self, d: u32) -> Result<()> {
        let value = self.condition()?;
        let frame = &self.cursor.frame;
        let next = frame.file.directives[d as usize].next;
        if next == NONE {
            return self.missing_end(self.directive_span(d));
        }
        let follows = frame.pos == frame.file.directives[next as usize].token;
        if !follows || !matches!(self.directive_word(next), Some(Kw::Case | Kw::Range)) {
            return self.error(
                "switch-case",
                "#switch must be followed by #case or #range",
                self.directive_span(d),
            );
        }
        let mut at = d;
        loop {
            at = self.skip_to_branch(at, d)?;
            let taken = match self.directive_word(at) {
                Some(Kw::End) => return Ok(()),
                Some(Kw::Else) => true,
                _ => self.case_matches(at, value)?,
            };
            if taken {
                self.push_control(ControlKind::Switch, at);
                return Ok(());
            }
        }
    }

    /// Reads the numbers of `#case` or `#range`; is `value` among them?
    fn case_matches(&mut self, d: u32, value: f64) -> Result<bool> {
        if self.directive_word(d) != Some(Kw::Range) {
            return Ok((value - self.condition()?).abs() < EPS);
        }
        self.expect('(')?;
        let (low, high) = self.nested(|p| {
            let low = p.full_float()?;
            p.comma()?;
            Ok((low, p.full_float()?))
        })?;
        self.expect(')')?;
        Ok(low <= value && value <= high)
    }

    /// `#break`: out of the innermost loop or `#switch`, else out of the macro.
    pub(super) fn break_out(&mut self, d: u32) -> Result<()> {
        let span = self.directive_span(d);
        loop {
            while self.cursor.controls.len() > self.cursor.frame.controls {
                let Some(control) = self.cursor.controls.pop() else { break };
                if !matches!(control.kind, ControlKind::If) {
                    return self.skip_to_end(control.open);
                }
            }
            self.cursor.frame.pos = self.cursor.frame.end;
            if self.cursor.frame.of_macro.is_some() {
                return Ok(());
            }
            if self.cursor.callers.is_empty() || !self.leave_frame()? {
                let fault =
                    Diagnostic::error("unexpected-directive", "#break is in no loop, #switch or macro", span);
                return Err(Box::new(fault));
            }
        }
    }

    /// A name that is about to be declared or asked for; reserved words are refused.
    pub(super) fn raw_name(&mut self) -> Result<(super::symbol::Symbol, Span)> {
        let lexeme = self.raw()?;
        let span = self.here();
        match lexeme {
            Some(Lexeme::Ident(symbol)) => Ok((symbol, span)),
            Some(Lexeme::Kw(kw)) => {
                let message = format!("`{}` is a word of the language and can't be a name", kw.word());
                self.error("reserved-word", message, span)
            }
            _ => self.error("expected", "expected a name", span),
        }
    }
}

fn in_range(value: f64, last: f64, step: f64) -> bool {
    if step > 0.0 { value < last + EPS } else { value > last - EPS }
}
