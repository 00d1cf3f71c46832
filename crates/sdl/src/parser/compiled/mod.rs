//! Expressions in loops and macros, kept as trees.
//!
//! Walking tokens costs far more than the arithmetic they stand for. So an expression of plain operands that is met
//! again becomes a [`Node`] tree, remembered by the place where it begins. A tree knows nothing of messages or of
//! changing the stream: where it meets something out of the ordinary (a macro, an undeclared name, a division by
//! zero) it gives up without a trace, and the tokens are walked as ever.
mod compile;
mod node;

use std::rc::Rc;

use node::Node;

use super::Parser;
use super::num::Num;
use super::token::Lexed;

/// How much of the grammar a slot takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// `+ - * /`
    Additive,
    /// Comparisons and `? :` as well.
    Full,
    /// A macro's argument: additive, but a bare name is not for us, as it goes by reference.
    Argument,
}

/// An expression as a tree.
#[derive(Debug)]
struct Program {
    level: Level,
    root: Node,
    /// The token after the expression.
    end: u32,
    /// Was the value one number so far?
    scalar: std::cell::Cell<bool>,
}

/// What is known about the expression that begins at a token.
#[derive(Clone, Debug, Default)]
enum State {
    /// Nothing.
    #[default]
    New,
    /// It has been walked once, by this level; lower ones that begin at the same token don't count.
    Seen(Level),
    /// It can't be a tree.
    Never,
    /// Its tree.
    Ready(Rc<Program>),
}

/// By token of a file; empty until something in the file is met in a loop or macro.
#[derive(Debug, Default)]
pub struct Cache(Vec<State>);

impl Cache {
    fn at(&mut self, file: &Lexed, token: u32) -> &mut State {
        if self.0.is_empty() {
            self.0.resize(file.tokens.len(), State::New);
        }
        &mut self.0[token as usize]
    }
}

impl Parser<'_> {
    /// The value of the expression that comes next, if its tree is at hand.
    #[inline]
    pub(super) fn compiled(&mut self, level: Level) -> Option<Num> {
        let c = &self.cursor;
        if (c.controls.is_empty() && c.frame.of_macro.is_none()) || self.settings.version.language < 150 {
            return None;
        }
        let start = match c.ahead {
            None if c.frame.pos < c.frame.end => c.frame.pos,
            Some(_) if c.ahead_alone => c.frame.pos - 1,
            _ => return None,
        };
        self.compiled_at(start, level)
    }

    fn compiled_at(&mut self, start: u32, level: Level) -> Option<Num> {
        let file = self.cursor.frame.file.clone();
        let mut cache = file.cache.borrow_mut();
        let state = cache.at(&file, start);
        let program = match state {
            State::Never => return None,
            State::New => {
                *state = State::Seen(level);
                return None;
            }
            State::Seen(seen) if *seen != level => return None,
            State::Seen(_) => {
                let end = self.cursor.frame.end;
                let Some(program) = compile::compile(&file, start, end, level, &self.scopes) else {
                    *state = State::Never;
                    return None;
                };
                let program = Rc::new(program);
                *state = State::Ready(program.clone());
                program
            }
            State::Ready(program) => program.clone(),
        };
        // A macro's body may end where the file goes on.
        if program.level != level || program.end >= self.cursor.frame.end {
            return None;
        }
        match self.run_program(&program) {
            Some(value) => {
                self.cursor.ahead = None;
                self.cursor.frame.pos = program.end;
                self.cursor.at_file = file.file;
                self.cursor.at = file.tokens[program.end as usize - 1].start;
                Some(value)
            }
            None => {
                *state = State::Never;
                None
            }
        }
    }

    fn run_program(&mut self, program: &Program) -> Option<Num> {
        self.streams.remember();
        if program.scalar.get() {
            if let Some(x) = program.root.float(self) {
                return Some(Num::float(x));
            }
            self.streams.restore();
            self.streams.remember();
        }
        let value = program.root.num(self);
        match value {
            Some(value) => program.scalar.set(value.len == 1),
            None => self.streams.restore(),
        }
        value
    }
}
