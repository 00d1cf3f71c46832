//! Expressions (language spec, section 2.1).
use raggio_diag::Span;

use super::compiled::Level;
use super::cursor::Stop;
use super::num::{Num, equal, truth};
use super::{Parser, Result, Tok};
use crate::keyword::Kw;
use crate::value::{Kind, Value};

impl Parser<'_> {
    /// What follows an operand: on the right side of a declaration a directive ends the expression.
    #[inline]
    fn operator(&mut self) -> Result<Tok> {
        self.peek()
    }

    /// The next token where an operand is wanted: directives are executed even on a right side.
    #[inline]
    fn operand(&mut self) -> Result<Tok> {
        if let Some(tok) = self.cursor.ahead {
            return Ok(tok);
        }
        let stop = std::mem::replace(&mut self.cursor.stop, Stop::Never);
        let tok = self.peek();
        self.cursor.stop = stop;
        tok
    }

    /// `logical [? full : full]`; every branch is evaluated.
    pub fn full(&mut self) -> Result<Num> {
        if let Some(value) = self.compiled(Level::Full) {
            return Ok(value);
        }
        let condition = self.logical()?;
        if self.operator()? != Tok::Punct('?') {
            return Ok(condition);
        }
        self.next()?;
        let span = self.here();
        if condition.len != 1 {
            return self.error("expected", "the condition of `? :` must be one number", span);
        }
        let (yes, no) = self.nested(|p| {
            let yes = p.full()?;
            p.expect(':')?;
            Ok((yes, p.full()?))
        })?;
        Ok(if truth(condition.v[0]) { yes } else { no })
    }

    /// A full expression of one component.
    pub fn full_float(&mut self) -> Result<f64> {
        let num = self.full()?;
        self.one_component(num)
    }

    fn logical(&mut self) -> Result<Num> {
        let mut left = self.relation()?;
        loop {
            let op: fn(f64, f64) -> bool = match self.operator()? {
                Tok::Punct('&') => |a, b| truth(a) && truth(b),
                Tok::Punct('|') => |a, b| truth(a) || truth(b),
                _ => return Ok(left),
            };
            self.next()?;
            left = left.compare(self.relation()?, op);
        }
    }

    fn relation(&mut self) -> Result<Num> {
        if self.at_string()? {
            return self.string_relation();
        }
        let mut left = self.additive()?;
        loop {
            let op: fn(f64, f64) -> bool = match self.operator()? {
                Tok::Punct('<') => |a, b| a < b,
                Tok::Punct('≤') => |a, b| a < b || equal(a, b),
                Tok::Punct('=') => equal,
                Tok::Punct('≠') => |a, b| !equal(a, b),
                Tok::Punct('≥') => |a, b| a > b || equal(a, b),
                Tok::Punct('>') => |a, b| a > b,
                _ => return Ok(left),
            };
            self.next()?;
            left = left.compare(self.additive()?, op);
        }
    }

    fn string_relation(&mut self) -> Result<Num> {
        let left = self.string()?;
        let op = self.next()?;
        if !matches!(op, Tok::Punct('<' | '≤' | '=' | '≠' | '≥' | '>')) {
            return self.error("expected", "expected a comparison after this string", self.here());
        }
        let right = self.string()?;
        let order = left.encode_utf16().cmp(right.encode_utf16());
        let holds = match op {
            Tok::Punct('<') => order.is_lt(),
            Tok::Punct('≤') => order.is_le(),
            Tok::Punct('=') => order.is_eq(),
            Tok::Punct('≠') => order.is_ne(),
            Tok::Punct('≥') => order.is_ge(),
            _ => order.is_gt(),
        };
        Ok(Num::float(f64::from(u8::from(holds))))
    }

    /// `term { (+|-) term }`: what most slots take. Below version 1.5 a single factor.
    pub fn additive(&mut self) -> Result<Num> {
        if let Tok::Number(x) = self.operand()?
            && self.expression_ends_here()
        {
            self.cursor.ahead = None;
            return Ok(Num::float(x));
        }
        if let Some(value) = self.compiled(Level::Additive) {
            return Ok(value);
        }
        if self.lang() < 150 {
            return self.factor();
        }
        let left = self.term()?;
        self.additive_rest(left)
    }

    /// Does the raw stream show a bracket, comma or semicolon after the token looked at?
    #[inline]
    fn expression_ends_here(&self) -> bool {
        let frame = &self.cursor.frame;
        frame.pos < frame.end && frame.file.tokens[frame.pos as usize].ends_expression()
    }

    fn additive_rest(&mut self, mut left: Num) -> Result<Num> {
        loop {
            match self.operator()? {
                Tok::Punct('+') => {
                    self.next()?;
                    left = left.zip(self.term()?, |a, b| a + b);
                }
                Tok::Punct('-') => {
                    self.next()?;
                    left = left.zip(self.term()?, |a, b| a - b);
                }
                _ => return Ok(left),
            }
        }
    }

    fn term(&mut self) -> Result<Num> {
        let left = self.factor()?;
        self.term_rest(left)
    }

    fn term_rest(&mut self, mut left: Num) -> Result<Num> {
        loop {
            match self.operator()? {
                Tok::Punct('*') => {
                    self.next()?;
                    left = left.zip(self.factor()?, |a, b| a * b);
                }
                Tok::Punct('/') => {
                    self.next()?;
                    let span = self.here();
                    let right = self.factor()?;
                    left = self.divide(left, right, span);
                }
                _ => return Ok(left),
            }
        }
    }

    /// Division; by exactly zero gives infinity and a warning.
    fn divide(&mut self, left: Num, right: Num, span: Span) -> Num {
        let right = right.padded(left.len);
        if right.v[..left.len.max(right.len) as usize].contains(&0.0) {
            self.warn("division-by-zero", "division by zero", span);
        }
        left.zip(right, |a, b| if b == 0.0 { f64::INFINITY } else { a / b })
    }

    fn factor(&mut self) -> Result<Num> {
        match self.operand()? {
            Tok::Punct('+') => {
                self.next()?;
                self.nested_factor()
            }
            Tok::Punct('-') => {
                self.next()?;
                Ok(self.nested_factor()?.map(|x| -x))
            }
            Tok::Punct('!') => {
                self.next()?;
                Ok(self.nested_factor()?.map(|x| f64::from(u8::from(!truth(x)))))
            }
            _ => {
                let primary = self.primary()?;
                self.member(primary)
            }
        }
    }

    /// A factor after a sign: counted, so that endless signs can't exhaust the stack.
    fn nested_factor(&mut self) -> Result<Num> {
        let stop = self.cursor.stop;
        self.nested(|p| {
            p.cursor.stop = stop;
            p.factor()
        })
    }

    /// `.x`, `.red` ... after an operand, at most once.
    fn member(&mut self, value: Num) -> Result<Num> {
        if self.operator()? != Tok::Punct('.') {
            return Ok(value);
        }
        self.next()?;
        let index = match self.peek()? {
            Tok::Kw(Kw::X | Kw::U | Kw::Red) => 0,
            Tok::Kw(Kw::Y | Kw::V | Kw::Green) => 1,
            Tok::Kw(Kw::Z | Kw::Blue) => 2,
            Tok::Kw(Kw::T | Kw::Filter) => 3,
            Tok::Kw(Kw::Transmit) => 4,
            Tok::Kw(Kw::Gray) => {
                self.next()?;
                return Ok(Num::float(value.gray()));
            }
            _ => return self.expected("a component: x y z t u v red green blue filter transmit gray"),
        };
        self.next()?;
        if index >= value.len as usize {
            let message =
                format!("a value of {} components has no `{}`", value.len, self.source_text(self.here()));
            return self.error("no-such-component", message, self.here());
        }
        Ok(Num::float(value.v[index]))
    }

    fn primary(&mut self) -> Result<Num> {
        match self.operand()? {
            Tok::Number(x) => {
                self.next()?;
                Ok(Num::float(x))
            }
            Tok::Value(kind) => self.identifier_operand(kind),
            Tok::Punct('(') => {
                self.next()?;
                let value = self.nested(Self::full)?;
                self.expect(')')?;
                Ok(value)
            }
            Tok::Punct('<') => {
                self.next()?;
                self.vector_literal()
            }
            Tok::Kw(kw) => match self.word_operand(kw)? {
                Some(value) => Ok(value),
                None => self.expected("a number"),
            },
            _ => self.expected("a number"),
        }
    }

    fn identifier_operand(&mut self, kind: Kind) -> Result<Num> {
        match kind {
            Kind::Float | Kind::Vector | Kind::Color => {
                let value = number_of(self.current_value());
                self.next()?;
                Ok(value)
            }
            Kind::Function | Kind::Spline => {
                let value = self.take_value()?;
                self.call_value(&value)
            }
            _ => self.expected("a number"),
        }
    }

    /// `<a, b ...>`, the bracket already read: 2 to 5 components, commas optional.
    fn vector_literal(&mut self) -> Result<Num> {
        let open = self.here();
        let mut v = [0.0; 5];
        let mut len = 0;
        self.nested(|p| {
            loop {
                match p.peek()? {
                    Tok::Punct('>') => return Ok(()),
                    Tok::End => return p.unclosed("a vector", open),
                    _ if len == 5 => {
                        return p.error("vector-size", "a vector has at most 5 components", open);
                    }
                    _ => {}
                }
                v[len] = p.float()?;
                len += 1;
                p.comma()?;
            }
        })?;
        self.expect('>')?;
        if len < 2 {
            return self.error("vector-size", "a vector has at least 2 components", open);
        }
        Ok(Num { v, len: len as u8 })
    }

    /// Continues an expression whose first operand has been read as an identifier's value.
    pub(super) fn additive_from(&mut self, first: &Value) -> Result<Num> {
        let operand = match first {
            Value::Function(_) | Value::Spline(_) => self.call_value(first)?,
            value => number_of(value),
        };
        let factor = self.member(operand)?;
        let term = self.term_rest(factor)?;
        self.additive_rest(term)
    }

    /// Does an expression come next?
    pub fn at_expression(&mut self) -> Result<bool> {
        Ok(match self.peek()? {
            Tok::Number(_) => true,
            Tok::Value(kind) => {
                matches!(kind, Kind::Float | Kind::Vector | Kind::Color | Kind::Function | Kind::Spline)
            }
            Tok::Punct(c) => matches!(c, '+' | '-' | '!' | '(' | '<'),
            Tok::Kw(kw) => super::float_fn::begins_number(kw),
            Tok::Unknown | Tok::String | Tok::End => false,
        })
    }
}

/// The number in a value; 0 for kinds that hold none.
pub fn number_of(value: &Value) -> Num {
    match *value {
        Value::Float(x) => Num::float(x),
        Value::Vector { v, len } => Num { v, len },
        Value::Color(v) => Num { v, len: 5 },
        _ => Num::float(0.0),
    }
}

/// The value that a number becomes when it is declared: five components are a colour, in single precision.
pub fn value_of(num: Num) -> Value {
    match num.len {
        1 => Value::Float(num.v[0]),
        5 => Value::Color(num.v.map(|x| f64::from(x as f32))),
        len => Value::Vector { v: num.v, len },
    }
}
