//! Words that stand for a number, and the functions whose value is one (language spec, section 2.3).
use super::num::Num;
use super::{Parser, Result, Tok};
use crate::keyword::Kw;
use crate::value::{Kind, Value};
use raggio_math::EPS;

/// Functions of one number that are defined everywhere, or give NaN like the arithmetic does.
pub fn unary(kw: Kw) -> Option<fn(f64) -> f64> {
    Some(match kw {
        Kw::Abs => f64::abs,
        Kw::Ceil => f64::ceil,
        Kw::Floor => f64::floor,
        Kw::Exp => f64::exp,
        Kw::Sin => f64::sin,
        Kw::Cos => f64::cos,
        Kw::Tan => f64::tan,
        Kw::Atan => f64::atan,
        Kw::Sinh => f64::sinh,
        Kw::Cosh => f64::cosh,
        Kw::Tanh => f64::tanh,
        Kw::Asinh => f64::asinh,
        Kw::Acosh => f64::acosh,
        Kw::Atanh => f64::atanh,
        Kw::Sqr => |x| x * x,
        Kw::Int => |x| f64::from(whole(x)),
        Kw::Degrees => |x| x / RADIAN,
        Kw::Radians => |x| x * RADIAN,
        _ => return None,
    })
}

/// The program's pi / 180.
const RADIAN: f64 = 0.01745329251994329576;

/// Truncation to 32 bits; out of range gives the least number, as the hardware does.
pub fn whole(x: f64) -> i32 {
    let x = x.trunc();
    if x >= f64::from(i32::MIN) && x <= f64::from(i32::MAX) { x as i32 } else { i32::MIN }
}

/// Does a number begin with this word?
pub fn begins_number(kw: Kw) -> bool {
    unary(kw).is_some()
        || matches!(
            kw,
            Kw::Pi
                | Kw::True
                | Kw::Yes
                | Kw::On
                | Kw::False
                | Kw::No
                | Kw::Off
                | Kw::Version
                | Kw::Clock
                | Kw::Clock_on
                | Kw::Now
                | Kw::X
                | Kw::Y
                | Kw::Z
                | Kw::U
                | Kw::V
                | Kw::T
                | Kw::Sqrt
                | Kw::Ln
                | Kw::Log
                | Kw::Asin
                | Kw::Acos
                | Kw::Atan2
                | Kw::Div
                | Kw::Mod
                | Kw::Pow
                | Kw::Min
                | Kw::Max
                | Kw::Select
                | Kw::Bitwise_and
                | Kw::Bitwise_or
                | Kw::Bitwise_xor
                | Kw::Vlength
                | Kw::Vdot
                | Kw::Strcmp
                | Kw::Strlen
                | Kw::Asc
                | Kw::Val
                | Kw::Defined
                | Kw::Dimensions
                | Kw::Dimension_size
                | Kw::File_exists
                | Kw::Inside
                | Kw::Seed
                | Kw::Rand
                | Kw::Vcross
                | Kw::Vnormalize
                | Kw::Vrotate
                | Kw::Vaxis_rotate
                | Kw::Vturbulence
                | Kw::Trace
                | Kw::Min_extent
                | Kw::Max_extent
        )
}

impl Parser<'_> {
    /// The value of `clock`, which arrives in single precision.
    pub fn clock(&self) -> f64 {
        f64::from(self.options.clock as f32)
    }

    /// The operand that begins with this word, consumed; `None` if there is none.
    pub(super) fn word_operand(&mut self, kw: Kw) -> Result<Option<Num>> {
        if !begins_number(kw) {
            return Ok(None);
        }
        self.next()?;
        if let Some(f) = unary(kw) {
            return Ok(Some(Num::float(f(self.condition()?))));
        }
        Ok(Some(match kw {
            Kw::Pi => Num::float(std::f64::consts::PI),
            Kw::True | Kw::Yes | Kw::On => Num::float(1.0),
            Kw::False | Kw::No | Kw::Off => Num::float(0.0),
            Kw::Version => Num::float(f64::from(self.lang()) / 100.0),
            Kw::Clock => Num::float(self.clock()),
            Kw::Clock_on => Num::float(f64::from(u8::from(self.options.clock_on))),
            Kw::Now => Num::float(super::datetime::now()),
            Kw::X => Num::vector(&[1.0, 0.0, 0.0]),
            Kw::Y => Num::vector(&[0.0, 1.0, 0.0]),
            Kw::Z => Num::vector(&[0.0, 0.0, 1.0]),
            Kw::U => Num::vector(&[1.0, 0.0]),
            Kw::V => Num::vector(&[0.0, 1.0]),
            Kw::T => Num::vector(&[0.0, 0.0, 0.0, 1.0]),
            Kw::Sqrt | Kw::Ln | Kw::Log | Kw::Asin | Kw::Acos => Num::float(self.partial_function(kw)?),
            Kw::Strcmp | Kw::Strlen | Kw::Asc | Kw::Val | Kw::File_exists => {
                Num::float(self.string_number(kw)?)
            }
            Kw::Vcross
            | Kw::Vnormalize
            | Kw::Vrotate
            | Kw::Vaxis_rotate
            | Kw::Vturbulence
            | Kw::Trace
            | Kw::Min_extent
            | Kw::Max_extent => self.vector_function(kw)?,
            _ => Num::float(self.in_parentheses(|p| p.float_function(kw))?),
        }))
    }

    /// `( inner )`
    pub(super) fn in_parentheses<T>(&mut self, inner: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        self.expect('(')?;
        let value = self.nested(inner)?;
        self.expect(')')?;
        Ok(value)
    }

    /// Functions of one number that refuse or clamp some arguments.
    fn partial_function(&mut self, kw: Kw) -> Result<f64> {
        let span = self.here();
        let x = self.condition()?;
        let refused = match kw {
            Kw::Sqrt => x < 0.0,
            Kw::Ln | Kw::Log => x <= 0.0,
            _ => false,
        };
        if refused {
            return self.error("domain", format!("{} of {x} is not defined", kw.word()), span);
        }
        if matches!(kw, Kw::Asin | Kw::Acos) && x.abs() > 1.0 {
            self.warn("domain", format!("{} of {x}: the argument is clamped to -1 .. 1", kw.word()), span);
        }
        Ok(match kw {
            Kw::Sqrt => x.sqrt(),
            Kw::Ln => x.ln(),
            Kw::Log => x.log10(),
            Kw::Asin => x.clamp(-1.0, 1.0).asin(),
            _ => x.clamp(-1.0, 1.0).acos(),
        })
    }

    /// Another argument.
    pub(super) fn next_float(&mut self) -> Result<f64> {
        self.comma()?;
        self.float()
    }

    fn float_function(&mut self, kw: Kw) -> Result<f64> {
        match kw {
            Kw::Atan2 | Kw::Div | Kw::Mod | Kw::Pow => self.binary_function(kw),
            Kw::Min => self.fold(f64::min),
            Kw::Max => self.fold(f64::max),
            Kw::Bitwise_and => self.fold(|a, b| f64::from(whole(a) & whole(b))),
            Kw::Bitwise_or => self.fold(|a, b| f64::from(whole(a) | whole(b))),
            Kw::Bitwise_xor => self.fold(|a, b| f64::from(whole(a) ^ whole(b))),
            Kw::Select => self.select(),
            Kw::Vlength => Ok(self.vec3()?.length()),
            Kw::Vdot => {
                let a = self.vec3()?;
                self.comma()?;
                Ok(a.dot(self.vec3()?))
            }
            Kw::Defined => Ok(f64::from(u8::from(self.defined()?))),
            Kw::Dimensions => self.array_dims().map(|dims| dims.len() as f64),
            Kw::Dimension_size => {
                let dims = self.array_dims()?;
                let k = self.next_float()? as usize;
                Ok(dims.get(k.wrapping_sub(1)).map_or(0.0, |&d| f64::from(d)))
            }
            Kw::Inside => self.inside(),
            Kw::Seed => {
                let n = self.float()?;
                Ok(self.streams.seed(n))
            }
            _ => {
                let (index, span) = (self.float()?, self.here());
                match self.streams.next(index) {
                    Some(x) => Ok(x),
                    None => self.error("rand-stream", "rand wants a value of seed(...)", span),
                }
            }
        }
    }

    fn binary_function(&mut self, kw: Kw) -> Result<f64> {
        let span = self.here();
        let a = self.float()?;
        let b = self.next_float()?;
        let refused = match kw {
            Kw::Atan2 => a.abs() <= EPS && b.abs() <= EPS,
            Kw::Pow => a == 0.0 && b == 0.0,
            _ => false,
        };
        if refused {
            return self.error("domain", format!("{}({a}, {b}) is not defined", kw.word()), span);
        }
        Ok(match kw {
            Kw::Atan2 => a.atan2(b),
            Kw::Div => f64::from(whole(a / b)),
            Kw::Mod => a % b,
            _ => a.powf(b),
        })
    }

    /// A function of one or more numbers, from left to right.
    fn fold(&mut self, op: fn(f64, f64) -> f64) -> Result<f64> {
        let mut value = self.float()?;
        while self.accept_punct(',')? {
            value = op(value, self.float()?);
        }
        Ok(value)
    }

    fn select(&mut self) -> Result<f64> {
        let (a, b, c) = (self.float()?, self.next_float()?, self.next_float()?);
        let d = if self.accept_punct(',')? { self.float()? } else { c };
        Ok(if a < 0.0 {
            b
        } else if a == 0.0 {
            c
        } else {
            d
        })
    }

    fn array_dims(&mut self) -> Result<smallvec::SmallVec<[u32; 2]>> {
        if self.peek()? != Tok::Value(Kind::Array) {
            return self.expected("the name of an array");
        }
        let dims = match self.current_value() {
            Value::Array(array) => array.dims.clone(),
            _ => Default::default(),
        };
        self.next()?;
        Ok(dims)
    }
}
