//! The walk over tokens: files, macro bodies, and the one token looked at.
use std::rc::Rc;

use raggio_diag::{FileId, Span};

use super::macros::Macro;
use super::scope::{Entry, Place};
use super::symbol::Symbol;
use super::token::{Lexed, Lexeme};
use super::{Parser, Result, Tok, lexer};
use crate::keyword::Kw;
use crate::value::{Kind, Value};

/// Most files and macro calls within one another.
const MAX_FRAMES: usize = 200;

/// A file or macro body that is being walked.
pub struct Frame {
    /// Where the tokens are.
    pub file: Rc<Lexed>,
    /// The next token.
    pub pos: u32,
    /// One past the last.
    pub end: u32,
    /// The macro, if it is one's body.
    pub of_macro: Option<Rc<Macro>>,
    /// How many constructs were open when it began.
    pub controls: usize,
    /// Where it was called or included; `None` for the main file.
    pub call: Option<Span>,
}

/// Does a directive end the right side of a declaration? (Otherwise it is executed there.) A macro call always does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// No declaration is being read, or we are inside brackets.
    Never,
    /// Directives that are statements do; conditionals and loops run.
    Statements,
    /// Every directive does.
    All,
}

/// Where the walk is.
pub struct Cursor {
    /// The token looked at but not consumed.
    pub ahead: Option<Tok>,
    /// Was that the raw token before the walk's place, and nothing more?
    pub ahead_alone: bool,
    /// File of the token last looked at.
    pub at_file: FileId,
    /// First byte of it.
    pub at: u32,
    /// Where its value lives, for `Tok::Value`.
    pub place: Place,
    /// The file or macro body that is being walked.
    pub frame: Frame,
    /// Those that wait for it to end.
    pub callers: Vec<Frame>,
    /// Constructs that are open, of all frames.
    pub controls: Vec<super::control::Control>,
    /// How a right side ends.
    pub stop: Stop,
    /// The frame in which that right side began.
    pub stop_frame: usize,
}

impl Cursor {
    /// At the start of the main file.
    pub fn new(file: Rc<Lexed>) -> Self {
        let (at_file, end) = (file.file, file.tokens.len() as u32);
        Cursor {
            ahead: None,
            ahead_alone: false,
            at_file,
            at: 0,
            place: Place::variable(0),
            frame: Frame { file, pos: 0, end, of_macro: None, controls: 0, call: None },
            callers: Vec::new(),
            controls: Vec::new(),
            stop: Stop::Never,
            stop_frame: 0,
        }
    }

    /// Notes the token at `pos` of the current frame as the one looked at.
    fn mark(&mut self, pos: u32) {
        self.at_file = self.frame.file.file;
        self.at = self.frame.file.tokens[pos as usize].start;
    }
}

impl Parser<'_> {
    /// Looks at the next token, executing what stands before it.
    pub(super) fn advance(&mut self) -> Result<Tok> {
        if let Some(fault) = self.fault.take() {
            return Err(fault);
        }
        loop {
            let frame = &mut self.cursor.frame;
            if frame.pos >= frame.end {
                if self.leave_frame()? {
                    continue;
                }
                return Ok(Tok::End);
            }
            let pos = frame.pos;
            frame.pos += 1;
            let token = frame.file.tokens[pos as usize];
            self.cursor.at_file = frame.file.file;
            self.cursor.at = token.start;
            let tok = match token.lexeme() {
                Lexeme::Number(i) => Tok::Number(frame.file.numbers[i as usize]),
                Lexeme::Punct(c) => Tok::Punct(c),
                Lexeme::Kw(kw) => Tok::Kw(kw),
                Lexeme::String(_) => Tok::String,
                Lexeme::Ident(symbol) => match self.resolve(symbol)? {
                    Some(Tok::End) => {
                        self.cursor.frame.pos = pos;
                        return Ok(Tok::End);
                    }
                    Some(tok) => tok,
                    None => continue,
                },
                Lexeme::Directive(d) => {
                    if self.stops_at(d) {
                        self.cursor.frame.pos = pos;
                        return Ok(Tok::End);
                    }
                    self.run_directive(d)?;
                    match self.cursor.ahead {
                        Some(tok) => return Ok(tok),
                        None => continue,
                    }
                }
                Lexeme::Error(i) => return self.lex_error(i, pos),
            };
            self.cursor.ahead = Some(tok);
            self.cursor.ahead_alone = self.cursor.frame.pos == pos + 1;
            return Ok(tok);
        }
    }

    fn run_directive(&mut self, d: u32) -> Result<()> {
        let frame = self.cursor.stop_frame;
        let stop = std::mem::replace(&mut self.cursor.stop, Stop::Never);
        self.directive(d)?;
        self.cursor.stop = stop;
        self.cursor.stop_frame = frame;
        Ok(())
    }

    fn stops_at(&self, d: u32) -> bool {
        let flow = |word| {
            matches!(
                word,
                Kw::If
                    | Kw::Ifdef
                    | Kw::Ifndef
                    | Kw::Else
                    | Kw::Elseif
                    | Kw::End
                    | Kw::While
                    | Kw::For
                    | Kw::Switch
                    | Kw::Case
                    | Kw::Range
                    | Kw::Break
            )
        };
        match self.cursor.stop {
            Stop::Never => false,
            Stop::All => true,
            Stop::Statements => !self.cursor.frame.file.directives[d as usize].word.is_some_and(flow),
        }
    }

    fn lex_error<T>(&mut self, i: u32, pos: u32) -> Result<T> {
        self.cursor.frame.pos = pos;
        let fault = self.cursor.frame.file.errors[i as usize].clone();
        let span = Span { file: self.cursor.at_file, start: self.cursor.at, end: fault.end };
        self.error(fault.code, fault.message, span)
    }

    /// At the end of a frame: goes back to the caller. False where there is none, or where a right side ends here.
    pub(super) fn leave_frame(&mut self) -> Result<bool> {
        let c = &mut self.cursor;
        if c.stop != Stop::Never && c.callers.len() <= c.stop_frame {
            return Ok(false);
        }
        self.check_open_constructs()?;
        let c = &mut self.cursor;
        let Some(caller) = c.callers.pop() else { return Ok(false) };
        c.frame = caller;
        self.scopes.close();
        Ok(true)
    }

    /// Goes into a file or macro body; `call` is where it was asked for.
    pub(super) fn enter_frame(
        &mut self,
        file: Rc<Lexed>,
        range: (u32, u32),
        of_macro: Option<Rc<Macro>>,
        call: Span,
    ) -> Result<()> {
        if self.cursor.callers.len() >= MAX_FRAMES {
            let message = format!("more than {MAX_FRAMES} macro calls and included files within one another");
            return self.error("nested-too-deeply", message, call);
        }
        self.check_cancel()?;
        let controls = self.cursor.controls.len();
        let frame = Frame { file, pos: range.0, end: range.1, of_macro, controls, call: Some(call) };
        let caller = std::mem::replace(&mut self.cursor.frame, frame);
        self.cursor.callers.push(caller);
        self.scopes.open();
        Ok(())
    }

    /// What an identifier stands for; `None` after a macro call, which has changed the stream. A macro after the
    /// right side of a declaration is not called yet: `Tok::End`.
    fn resolve(&mut self, symbol: Symbol) -> Result<Option<Tok>> {
        let Some(slot) = self.scopes.lookup(symbol) else {
            return Ok(self.resolve_contextual(symbol));
        };
        if let Some(message) = self.scopes.deprecation(slot) {
            self.warn_deprecated(symbol, message);
        }
        let array = match self.scopes.entry(slot) {
            Entry::Undeclared => return Ok(Some(Tok::Unknown)),
            Entry::Macro(_) if self.cursor.stop != Stop::Never => return Ok(Some(Tok::End)),
            Entry::Macro(called) => {
                let called = called.clone();
                self.call_macro(called)?;
                return Ok(None);
            }
            Entry::Value(value) => {
                let kind = value.kind();
                self.cursor.place.slot = slot;
                self.cursor.place.path.clear();
                if kind != Kind::Array {
                    return Ok(Some(Tok::Value(kind)));
                }
                true
            }
            Entry::Ref(place) => {
                self.cursor.place.clone_from(place);
                false
            }
        };
        if !array && self.current_kind()? != Kind::Array {
            return self.current_kind().map(|kind| Some(Tok::Value(kind)));
        }
        if self.next_raw_is('[') {
            let (at_file, at) = (self.cursor.at_file, self.cursor.at);
            let place = self.cursor.place.clone();
            self.cursor.place = self.subscripted(place)?;
            (self.cursor.at_file, self.cursor.at) = (at_file, at);
        }
        self.current_kind().map(|kind| Some(Tok::Value(kind)))
    }

    /// Names that mean something only in later versions.
    fn resolve_contextual(&mut self, _symbol: Symbol) -> Option<Tok> {
        Some(Tok::Unknown)
    }

    /// Follows as many subscripts as there are after the name of an array.
    pub(super) fn subscripted(&mut self, mut place: Place) -> Result<Place> {
        while self.next_raw_is('[') {
            let dims = match self.value_at(&place) {
                Some(Value::Array(array)) => array.dims.clone(),
                Some(_) => return self.error("not-an-array", "this is not an array", self.here()),
                None => {
                    return self.error("uninitialized", "this array element has no value yet", self.here());
                }
            };
            let index = self.subscripts(&dims)?;
            place.path.push(index);
        }
        Ok(place)
    }

    fn current_kind(&mut self) -> Result<Kind> {
        match self.value_at(&self.cursor.place) {
            Some(value) => Ok(value.kind()),
            None => self.error("uninitialized", "this has no value yet", self.here()),
        }
    }

    /// The value at a place, if it has one.
    pub(super) fn value_at(&self, place: &Place) -> Option<&Value> {
        let Entry::Value(variable) = self.scopes.entry(place.slot) else { return None };
        let mut value = variable;
        for &index in &place.path {
            let Value::Array(array) = value else { return None };
            value = array.items.get(index as usize)?.as_ref()?;
        }
        Some(value)
    }

    /// The value of a name, if it has one that can be had without saying or changing anything.
    #[inline]
    pub(super) fn plain_value(&self, symbol: Symbol) -> Option<&Value> {
        let slot = self.scopes.lookup(symbol)?;
        if self.scopes.is_deprecated(slot) {
            return None;
        }
        match self.scopes.entry(slot) {
            Entry::Value(value) => Some(value),
            Entry::Ref(place) => self.value_at(place),
            Entry::Undeclared | Entry::Macro(_) => None,
        }
    }

    /// The value of the `Tok::Value` last looked at.
    #[inline]
    pub(super) fn current_value(&self) -> &Value {
        const NOTHING: &Value = &Value::Float(0.0);
        self.value_at(&self.cursor.place).unwrap_or(NOTHING)
    }

    /// Is the very next character of the walk this one? Nothing is executed to find out.
    #[inline]
    pub(super) fn next_raw_is(&self, c: char) -> bool {
        let frame = &self.cursor.frame;
        frame.pos < frame.end && frame.file.tokens[frame.pos as usize].is_punct(c)
    }

    /// Does a name come next, which may be a macro's? Nothing is executed to find out, as a peek would.
    pub fn next_is_name(&self) -> bool {
        let frame = &self.cursor.frame;
        self.cursor.ahead.is_none()
            && frame.pos < frame.end
            && matches!(frame.file.tokens[frame.pos as usize].lexeme(), Lexeme::Ident(_))
    }

    /// Consumes the next token without giving it a meaning: for names in `#declare`, `#ifdef` and the like.
    pub(super) fn raw(&mut self) -> Result<Option<Lexeme>> {
        loop {
            let frame = &mut self.cursor.frame;
            if frame.pos >= frame.end {
                if self.leave_frame()? {
                    continue;
                }
                return Ok(None);
            }
            let pos = frame.pos;
            frame.pos += 1;
            let lexeme = frame.file.tokens[pos as usize].lexeme();
            self.cursor.mark(pos);
            match lexeme {
                Lexeme::Error(i) => return self.lex_error(i, pos),
                lexeme => return Ok(Some(lexeme)),
            }
        }
    }

    /// The place of the token last looked at, consumed or not.
    pub(super) fn here(&self) -> Span {
        let (file, start) = (self.cursor.at_file, self.cursor.at);
        let end = lexer::token_end(&self.sources.get(file).text, start as usize) as u32;
        Span { file, start, end }
    }

    /// The text at a place.
    pub(super) fn source_text(&self, span: Span) -> String {
        let text = &self.sources.get(span.file).text;
        String::from_utf8_lossy(&text[span.start as usize..span.end as usize]).into_owned()
    }
}
