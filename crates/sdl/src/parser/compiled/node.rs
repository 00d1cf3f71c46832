//! The tree of an expression and its two ways of evaluation: as one number, quickly, and as any number of them.
use std::sync::Arc;

use raggio_math::{EPS, Vec3, transform};
use smallvec::SmallVec;

use crate::keyword::Kw;
use crate::parser::Parser;
use crate::parser::expr::number_of;
use crate::parser::float_fn::whole;
use crate::parser::num::{Num, equal, truth};
use crate::parser::symbol::Symbol;
use crate::value::Value;

/// A part of an expression.
#[derive(Debug)]
pub enum Node {
    Const(f64),
    /// A constant vector.
    Constants(Num),
    Var(Symbol),
    /// An array's item.
    Item(Symbol, Vec<Node>),
    Vector(Vec<Node>),
    Member(Box<Node>, usize),
    Gray(Box<Node>),
    Neg(Box<Node>),
    Not(Box<Node>),
    Binary(Op, Box<[Node; 2]>),
    /// `c ? a : b`
    Choice(Box<[Node; 3]>),
    /// A function of one number.
    Unary(fn(f64) -> f64, Box<Node>),
    /// `sqrt ln log asin acos`, which refuse some numbers.
    Partial(Kw, Box<Node>),
    /// A function of several numbers.
    Several(Kw, Vec<Node>),
    /// A function of vectors.
    Vectors(Kw, Vec<Node>),
    Rand(Box<Node>),
    /// A user function.
    Call(Symbol, Vec<Node>),
}

/// An operator with two operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Less,
    LessEqual,
    Equal,
    NotEqual,
    GreaterEqual,
    Greater,
    And,
    Or,
}

fn flag(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}

impl Op {
    #[inline]
    fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Op::Add => a + b,
            Op::Sub => a - b,
            Op::Mul => a * b,
            Op::Div => a / b,
            Op::Less => flag(a < b),
            Op::LessEqual => flag(a < b || equal(a, b)),
            Op::Equal => flag(equal(a, b)),
            Op::NotEqual => flag(!equal(a, b)),
            Op::GreaterEqual => flag(a > b || equal(a, b)),
            Op::Greater => flag(a > b),
            Op::And => flag(truth(a) && truth(b)),
            Op::Or => flag(truth(a) || truth(b)),
        }
    }

    fn is_arithmetic(self) -> bool {
        matches!(self, Op::Add | Op::Sub | Op::Mul | Op::Div)
    }
}

impl Node {
    /// The value if it is one number.
    pub fn float(&self, p: &mut Parser) -> Option<f64> {
        match self {
            Node::Const(x) => Some(*x),
            Node::Var(symbol) => match p.plain_value(*symbol)? {
                Value::Float(x) => Some(*x),
                _ => None,
            },
            Node::Item(symbol, subscripts) => match item(*symbol, subscripts, p)? {
                Value::Float(x) => Some(*x),
                _ => None,
            },
            Node::Member(of, index) => member(of, *index, p),
            Node::Gray(of) => of.num(p).map(Num::gray),
            Node::Neg(of) => of.float(p).map(|x| -x),
            Node::Not(of) => of.float(p).map(|x| flag(!truth(x))),
            Node::Binary(op, sides) => {
                let (a, b) = (sides[0].float(p)?, sides[1].float(p)?);
                if *op == Op::Div && b == 0.0 { None } else { Some(op.apply(a, b)) }
            }
            Node::Choice(parts) => {
                let (c, a, b) = (parts[0].float(p)?, parts[1].float(p)?, parts[2].float(p)?);
                Some(if truth(c) { a } else { b })
            }
            Node::Unary(f, of) => of.float(p).map(f),
            Node::Partial(kw, of) => partial(*kw, of.float(p)?),
            Node::Several(kw, args) => several(*kw, args, p),
            Node::Vectors(Kw::Vlength, args) => vec3(&args[0], p).map(Vec3::length),
            Node::Vectors(Kw::Vdot, args) => Some(vec3(&args[0], p)?.dot(vec3(&args[1], p)?)),
            Node::Rand(stream) => {
                let index = stream.float(p)?;
                p.streams.next(index)
            }
            Node::Call(..) => self.num(p).filter(|n| n.len == 1).map(|n| n.v[0]),
            Node::Constants(_) | Node::Vector(_) | Node::Vectors(..) => None,
        }
    }

    /// The value, of any size.
    pub fn num(&self, p: &mut Parser) -> Option<Num> {
        match self {
            Node::Constants(num) => Some(*num),
            Node::Var(symbol) => numeric(p.plain_value(*symbol)?),
            Node::Item(symbol, subscripts) => numeric(item(*symbol, subscripts, p)?),
            Node::Vector(parts) => {
                let mut v = [0.0; 5];
                for (slot, part) in v.iter_mut().zip(parts) {
                    *slot = part.float(p)?;
                }
                Some(Num { v, len: parts.len() as u8 })
            }
            Node::Neg(of) => of.num(p).map(|n| n.map(|x| -x)),
            Node::Not(of) => of.num(p).map(|n| n.map(|x| flag(!truth(x)))),
            Node::Binary(op, sides) => binary(*op, sides[0].num(p)?, sides[1].num(p)?),
            Node::Choice(parts) => {
                let (c, a, b) = (parts[0].num(p)?, parts[1].num(p)?, parts[2].num(p)?);
                (c.len == 1).then_some(if truth(c.v[0]) { a } else { b })
            }
            Node::Vectors(kw, args) if !matches!(kw, Kw::Vlength | Kw::Vdot) => vectors(*kw, args, p),
            Node::Call(symbol, args) => call(*symbol, args, p),
            _ => self.float(p).map(Num::float),
        }
    }
}

fn numeric(value: &Value) -> Option<Num> {
    matches!(value, Value::Float(_) | Value::Vector { .. } | Value::Color(_)).then(|| number_of(value))
}

fn binary(op: Op, a: Num, b: Num) -> Option<Num> {
    if !op.is_arithmetic() {
        return Some(a.compare(b, |x, y| op.apply(x, y) != 0.0));
    }
    if op == Op::Div && b.padded(a.len).v[..a.len.max(b.len) as usize].contains(&0.0) {
        return None;
    }
    Some(a.zip(b, |x, y| op.apply(x, y)))
}

fn item<'p>(symbol: Symbol, subscripts: &[Node], p: &'p mut Parser) -> Option<&'p Value> {
    let mut indices: SmallVec<[f64; 4]> = SmallVec::new();
    for subscript in subscripts {
        indices.push(subscript.float(p)? + EPS);
    }
    let mut rest = indices.as_slice();
    let mut value = p.plain_value(symbol)?;
    while !rest.is_empty() {
        let Value::Array(array) = value else { return None };
        let (these, after) = rest.split_at_checked(array.dims.len())?;
        let mut index = 0;
        for (&i, &dim) in these.iter().zip(&array.dims) {
            if !(i >= 0.0 && i < f64::from(dim)) {
                return None;
            }
            index = index * dim as usize + i as usize;
        }
        value = array.items[index].as_ref()?;
        rest = after;
    }
    Some(value)
}

fn member(of: &Node, index: usize, p: &mut Parser) -> Option<f64> {
    let num = of.num(p)?;
    (index < num.len as usize).then(|| num.v[index])
}

fn partial(kw: Kw, x: f64) -> Option<f64> {
    match kw {
        Kw::Sqrt if x >= 0.0 => Some(x.sqrt()),
        Kw::Ln if x > 0.0 => Some(x.ln()),
        Kw::Log if x > 0.0 => Some(x.log10()),
        Kw::Asin if x.abs() <= 1.0 => Some(x.asin()),
        Kw::Acos if x.abs() <= 1.0 => Some(x.acos()),
        _ => None,
    }
}

fn several(kw: Kw, args: &[Node], p: &mut Parser) -> Option<f64> {
    let mut values: SmallVec<[f64; 4]> = SmallVec::new();
    for arg in args {
        values.push(arg.float(p)?);
    }
    match (kw, values.as_slice()) {
        (Kw::Atan2, &[a, b]) if a.abs() > EPS || b.abs() > EPS => Some(a.atan2(b)),
        (Kw::Pow, &[a, b]) if a != 0.0 || b != 0.0 => Some(a.powf(b)),
        (Kw::Div, &[a, b]) => Some(f64::from(whole(a / b))),
        (Kw::Mod, &[a, b]) => Some(a % b),
        (Kw::Min, all) => all.iter().copied().reduce(f64::min),
        (Kw::Max, all) => all.iter().copied().reduce(f64::max),
        (Kw::Select, &[a, b, c]) => Some(if a < 0.0 { b } else { c }),
        (Kw::Select, &[a, b, c, d]) => Some(if a < 0.0 {
            b
        } else if a == 0.0 {
            c
        } else {
            d
        }),
        _ => None,
    }
}

fn vec3(node: &Node, p: &mut Parser) -> Option<Vec3> {
    let num = node.num(p)?;
    (num.len <= 3).then(|| Vec3::from_slice(&num.padded(3).v))
}

fn vectors(kw: Kw, args: &[Node], p: &mut Parser) -> Option<Num> {
    let first = vec3(&args[0], p)?;
    let value = match (kw, args) {
        (Kw::Vnormalize, [_]) => first.try_normalize().unwrap_or(Vec3::ZERO),
        (Kw::Vcross, [_, b]) => first.cross(vec3(b, p)?),
        (Kw::Vrotate, [_, b]) => transform::rotate(vec3(b, p)?).transform_vector3(first),
        (Kw::Vaxis_rotate, [_, b, c]) => {
            let axis = vec3(b, p)?;
            transform::rotate_about(axis, c.float(p)?).transform_vector3(first)
        }
        _ => return None,
    };
    Some(Num::vector(&value.to_array()))
}

fn call(symbol: Symbol, args: &[Node], p: &mut Parser) -> Option<Num> {
    let mut values: SmallVec<[f64; 8]> = SmallVec::new();
    for arg in args {
        values.push(arg.float(p)?);
    }
    match p.plain_value(symbol)? {
        Value::Function(function) if function.params() == values.len() => {
            let function = Arc::clone(function);
            Some(match function.components() {
                1 => Num::float(function.eval(&values)),
                n => Num { v: function.eval5(&values), len: n as u8 },
            })
        }
        Value::Spline(spline) => match values.as_slice() {
            &[t] => Some(Num { v: spline.value(t, spline.kind()), len: spline.size() }),
            _ => None,
        },
        _ => None,
    }
}
