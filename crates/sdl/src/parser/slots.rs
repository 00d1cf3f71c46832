//! Slots of blocks: numbers and vectors of a wanted size, and values of any kind.
use std::ops::RangeInclusive;

use raggio_math::{Vec2, Vec3};

use super::expr::value_of;
use super::num::Num;
use super::{Parser, Result, Tok};
use crate::grammar;
use crate::keyword::Kw;
use crate::value::{Kind, Value};

impl Parser<'_> {
    /// A float slot: an additive expression of one component.
    pub fn float(&mut self) -> Result<f64> {
        let num = self.additive()?;
        self.one_component(num)
    }

    pub(super) fn one_component(&self, num: Num) -> Result<f64> {
        if num.len == 1 {
            return Ok(num.v[0]);
        }
        self.error("wrong-size", format!("expected one number, found {}", num.len), self.here())
    }

    /// A float slot that must be a whole number in range; outside: an error naming `what`.
    pub fn int(&mut self, what: &str, range: RangeInclusive<i64>) -> Result<i64> {
        let span = self.span();
        let value = self.float()?;
        if value.is_finite() && range.contains(&(value as i64)) {
            return Ok(value as i64);
        }
        let message = format!("{what} must be from {} to {}, not {value}", range.start(), range.end());
        self.error("out-of-range", message, span)
    }

    /// An optional float if an expression comes next (`hollow`, `metallic`), else `default`.
    pub fn optional_float(&mut self, default: f64) -> Result<f64> {
        if self.at_expression()? { self.float() } else { Ok(default) }
    }

    /// A flag: `word`, `word on`, `word off`, `word 0`.
    pub fn flag(&mut self) -> Result<bool> {
        Ok(self.optional_float(1.0)? > 0.0)
    }

    /// A slot of `size` components: one number fills it, a shorter vector is filled up with zeros.
    fn sized(&mut self, size: u8) -> Result<Num> {
        let span = self.span();
        let num = self.additive()?;
        if num.len <= size {
            return Ok(num.padded(size));
        }
        self.error("wrong-size", format!("expected {size} components, found {}", num.len), span)
    }

    /// A slot of two components.
    pub fn vec2(&mut self) -> Result<Vec2> {
        let v = self.sized(2)?.v;
        Ok(Vec2::new(v[0], v[1]))
    }

    /// A slot of three components.
    pub fn vec3(&mut self) -> Result<Vec3> {
        let v = self.sized(3)?.v;
        Ok(Vec3::new(v[0], v[1], v[2]))
    }

    /// A slot of four components.
    pub fn vec4(&mut self) -> Result<[f64; 4]> {
        let v = self.sized(4)?.v;
        Ok([v[0], v[1], v[2], v[3]])
    }

    /// An expression of any size: its components (replicated to five where it is one number) and how many it has.
    pub fn tuple(&mut self) -> Result<([f64; 5], u8)> {
        let num = self.additive()?;
        Ok((num.padded(5).v, num.len))
    }

    /// A value of any kind: the right side of a declaration, an argument, an array's item.
    pub fn value(&mut self) -> Result<Value> {
        match self.peek()? {
            Tok::Kw(Kw::Array) => {
                self.next()?;
                Ok(Value::Array(self.array()?.into()))
            }
            Tok::Kw(Kw::Spline) => {
                self.next()?;
                Ok(Value::Spline(self.spline()?))
            }
            Tok::Kw(Kw::Function) => {
                self.next()?;
                Ok(Value::Function(grammar::function::function_value(self)?))
            }
            Tok::Value(Kind::Color) if self.lang() < 350 => Ok(Value::Color(self.channels()?)),
            Tok::Value(Kind::Float | Kind::Vector | Kind::Color) => self.additive().map(value_of),
            Tok::Value(Kind::Function | Kind::Spline) => {
                let value = self.take_value()?;
                if self.peek()? == Tok::Punct('(') { self.value_from(value) } else { Ok(value) }
            }
            Tok::Value(_) => match grammar::declared_value(self)? {
                Some(value) => Ok(value),
                None => self.take_value(),
            },
            // Some blocks begin with a word that is not reserved.
            Tok::Unknown => match grammar::declared_value(self)? {
                Some(value) => Ok(value),
                None => self.undeclared("has no value"),
            },
            _ if self.at_color_word()? => Ok(Value::Color(self.channels()?)),
            _ if self.at_string()? => Ok(Value::String(self.string()?)),
            _ if self.at_expression()? => self.additive().map(value_of),
            _ => match grammar::declared_value(self)? {
                Some(value) => Ok(value),
                None => self.expected("a value"),
            },
        }
    }

    /// Goes on with an expression whose first operand is the value of an identifier already consumed.
    pub(super) fn value_from(&mut self, first: Value) -> Result<Value> {
        self.additive_from(&first).map(value_of)
    }
}
