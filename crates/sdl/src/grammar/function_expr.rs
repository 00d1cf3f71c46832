//! The text of a function body as an expression tree, by precedence climbing.
use std::sync::Arc;

use raggio_function::{BinaryOp, Builtin, Expr};
use raggio_scene::Function;

use super::util::take;
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Most parentheses and calls within one another.
const MAX_DEPTH: u32 = 200;

/// The names that a body knows while it is read.
pub struct Body {
    /// Parameters, then the counters of the sums around.
    slots: Vec<String>,
    /// Are x, y, z, u, v the parameters, as nothing else was said?
    standard: bool,
    depth: u32,
}

impl Body {
    /// A body with the given parameters; none means x, y, z.
    pub fn new(parameters: &[String]) -> Self {
        let standard = parameters.is_empty();
        let slots = if standard { ["x", "y", "z"].map(String::from).to_vec() } else { parameters.to_vec() };
        Body { slots, standard, depth: 0 }
    }

    /// A whole expression.
    pub fn expression(&mut self, p: &mut Parser) -> Result<Expr> {
        if self.depth >= MAX_DEPTH {
            let span = p.span();
            return p.error("nested-too-deeply", format!("more than {MAX_DEPTH} levels in a function"), span);
        }
        self.depth += 1;
        let expr = self.binary(p, 1);
        self.depth -= 1;
        expr
    }

    /// Operators of at least this precedence, from left to right.
    fn binary(&mut self, p: &mut Parser, least: u8) -> Result<Expr> {
        let mut left = self.unary(p)?;
        loop {
            let Tok::Punct(c) = p.peek()? else { return Ok(left) };
            let Some((op, precedence)) = operator(c) else { return Ok(left) };
            if precedence < least {
                return Ok(left);
            }
            p.next()?;
            let span = p.span();
            let right = self.binary(p, precedence + 1)?;
            if op == BinaryOp::Div && matches!(right, Expr::Const(0.0)) {
                return p.error("division-by-zero", "division by the constant 0 in a function", span);
            }
            left = folded(op, left, right);
        }
    }

    /// Any number of signs and their operand.
    fn unary(&mut self, p: &mut Parser) -> Result<Expr> {
        let mut negative = false;
        while let Tok::Punct(sign @ ('+' | '-')) = p.peek()? {
            negative ^= sign == '-';
            p.next()?;
        }
        let operand = self.operand(p)?;
        Ok(match operand {
            Expr::Const(c) if negative => Expr::Const(-c),
            operand if negative => Expr::Neg(Box::new(operand)),
            operand => operand,
        })
    }

    fn operand(&mut self, p: &mut Parser) -> Result<Expr> {
        match p.peek()? {
            Tok::Number(n) => {
                p.next()?;
                Ok(Expr::Const(n))
            }
            Tok::Punct('(') => {
                p.next()?;
                let inner = self.expression(p)?;
                p.expect(')')?;
                Ok(inner)
            }
            Tok::Kw(_) | Tok::Value(_) | Tok::Unknown => {
                let name = p.text();
                match self.slots.iter().rposition(|slot| *slot == name) {
                    Some(slot) => {
                        p.next()?;
                        Ok(Expr::Slot(slot))
                    }
                    None => self.named(p),
                }
            }
            _ => p.expected("an operand of the function"),
        }
    }

    /// A word or an identifier that is no parameter.
    fn named(&mut self, p: &mut Parser) -> Result<Expr> {
        match p.peek()? {
            Tok::Value(Kind::Float) => Ok(Expr::Const(take!(p, Float))),
            Tok::Value(Kind::Function) => {
                let function = take!(p, Function);
                self.call(p, function)
            }
            Tok::Value(Kind::Spline) => {
                let spline = take!(p, Spline);
                self.call(p, Arc::new(Function::external(1, spline)))
            }
            Tok::Kw(word) => match word {
                Kw::Pi => self.word(p, Expr::Const(std::f64::consts::PI)),
                Kw::Clock => {
                    let clock = p.clock();
                    self.word(p, Expr::Const(clock))
                }
                Kw::U if self.standard => self.word(p, Expr::Slot(0)),
                Kw::V if self.standard => self.word(p, Expr::Slot(1)),
                Kw::X | Kw::Y | Kw::Z | Kw::U | Kw::V => self.word(p, Expr::Const(0.0)),
                Kw::Sum | Kw::Prod => self.sum(p, word == Kw::Prod),
                _ => match builtin(word) {
                    Some((builtin, counts)) => self.builtin(p, builtin, counts),
                    None => p.expected("an operand of the function"),
                },
            },
            Tok::Unknown => {
                let (name, span) = (p.text(), p.span());
                p.error("unknown-identifier", format!("`{name}` is not known in this function"), span)
            }
            _ => p.expected("a number, a parameter or a function"),
        }
    }

    fn word(&self, p: &mut Parser, expr: Expr) -> Result<Expr> {
        p.next()?;
        Ok(expr)
    }

    /// `( a, b, ... )`
    fn arguments(&mut self, p: &mut Parser) -> Result<Vec<Expr>> {
        p.expect('(')?;
        let mut arguments = Vec::new();
        while !p.accept_punct(')')? {
            arguments.push(self.expression(p)?);
            p.comma()?;
        }
        Ok(arguments)
    }

    fn builtin(
        &mut self,
        p: &mut Parser,
        builtin: Builtin,
        counts: std::ops::RangeInclusive<usize>,
    ) -> Result<Expr> {
        let span = p.span();
        p.next()?;
        let arguments = self.arguments(p)?;
        if !counts.contains(&arguments.len()) {
            return p.error("wrong-arguments", "wrong number of arguments for this function", span);
        }
        Ok(Expr::Call(builtin, arguments))
    }

    /// A call of a declared function; one that gives a vector is followed by `.member`.
    fn call(&mut self, p: &mut Parser, function: Arc<Function>) -> Result<Expr> {
        let span = p.span();
        let args = self.arguments(p)?;
        if args.len() != function.params() {
            let message =
                format!("this function takes {} arguments, but {} are given", function.params(), args.len());
            return p.error("wrong-arguments", message, span);
        }
        let Some(external) = function.as_external().cloned() else {
            return Ok(Expr::User(function, args));
        };
        let component =
            |component| Expr::External { function: external.clone(), args: args.clone(), component };
        if external.components() == 1 {
            return Ok(component(0));
        }
        p.expect('.')?;
        let name = p.text();
        p.next()?;
        let weighted = |weight: f64, i| folded(BinaryOp::Mul, Expr::Const(weight), component(i));
        let add = |a, b| folded(BinaryOp::Add, a, b);
        Ok(match name.as_str() {
            "x" | "u" | "red" => component(0),
            "y" | "v" | "green" => component(1),
            "z" | "blue" => component(2),
            "t" | "filter" => component(3),
            "transmit" => component(4),
            "gray" | "grey" => add(add(weighted(0.297, 0), weighted(0.589, 1)), weighted(0.114, 2)),
            "hf" => {
                folded(BinaryOp::Mul, Expr::Const(0.996_093), add(component(0), weighted(1.0 / 255.0, 1)))
            }
            _ => {
                return p.error(
                    "unknown-member",
                    format!("`{name}` is no member of a vector or colour"),
                    span,
                );
            }
        })
    }

    /// `sum(k, from, to, term)`, `prod(...)`
    fn sum(&mut self, p: &mut Parser, product: bool) -> Result<Expr> {
        p.next()?;
        p.expect('(')?;
        let counter = p.text();
        p.next()?;
        p.comma()?;
        let from = Box::new(self.expression(p)?);
        p.comma()?;
        let to = Box::new(self.expression(p)?);
        p.comma()?;
        let slot = self.slots.len();
        self.slots.push(counter);
        let body = self.expression(p);
        self.slots.pop();
        let body = Box::new(body?);
        p.expect(')')?;
        Ok(Expr::Loop { product, slot, from, to, body })
    }
}

/// Operators with their precedences; all group to the left.
fn operator(c: char) -> Option<(BinaryOp, u8)> {
    Some(match c {
        '|' => (BinaryOp::Or, 1),
        '&' => (BinaryOp::And, 2),
        '=' => (BinaryOp::Eq, 3),
        '≠' => (BinaryOp::Ne, 3),
        '<' => (BinaryOp::Lt, 3),
        '≤' => (BinaryOp::Le, 3),
        '>' => (BinaryOp::Gt, 3),
        '≥' => (BinaryOp::Ge, 3),
        '+' => (BinaryOp::Add, 4),
        '-' => (BinaryOp::Sub, 4),
        '*' => (BinaryOp::Mul, 5),
        '/' => (BinaryOp::Div, 5),
        _ => return None,
    })
}

/// The operation, done at once where both sides are constant.
fn folded(op: BinaryOp, left: Expr, right: Expr) -> Expr {
    match (op, &left, &right) {
        (BinaryOp::Add, Expr::Const(a), Expr::Const(b)) => Expr::Const(a + b),
        (BinaryOp::Sub, Expr::Const(a), Expr::Const(b)) => Expr::Const(a - b),
        (BinaryOp::Mul, Expr::Const(a), Expr::Const(b)) => Expr::Const(a * b),
        (BinaryOp::Div, Expr::Const(a), Expr::Const(b)) => Expr::Const(a / b),
        _ => Expr::Binary(op, Box::new(left), Box::new(right)),
    }
}

/// The built-in function of a word, and how many arguments it takes.
fn builtin(word: Kw) -> Option<(Builtin, std::ops::RangeInclusive<usize>)> {
    let one = |builtin| Some((builtin, 1..=1));
    let two = |builtin| Some((builtin, 2..=2));
    match word {
        Kw::Abs => one(Builtin::Abs),
        Kw::Acos => one(Builtin::Acos),
        Kw::Acosh => one(Builtin::Acosh),
        Kw::Asin => one(Builtin::Asin),
        Kw::Asinh => one(Builtin::Asinh),
        Kw::Atan => one(Builtin::Atan),
        Kw::Atan2 => two(Builtin::Atan2),
        Kw::Atanh => one(Builtin::Atanh),
        Kw::Ceil => one(Builtin::Ceil),
        Kw::Cos => one(Builtin::Cos),
        Kw::Cosh => one(Builtin::Cosh),
        Kw::Degrees => one(Builtin::Degrees),
        Kw::Div => two(Builtin::Div),
        Kw::Exp => one(Builtin::Exp),
        Kw::Floor => one(Builtin::Floor),
        Kw::Int => one(Builtin::Int),
        Kw::Ln => one(Builtin::Ln),
        Kw::Log => one(Builtin::Log),
        Kw::Max => Some((Builtin::Max, 2..=256)),
        Kw::Min => Some((Builtin::Min, 2..=256)),
        Kw::Mod => two(Builtin::Mod),
        Kw::Pow => two(Builtin::Pow),
        Kw::Radians => one(Builtin::Radians),
        Kw::Select => Some((Builtin::Select, 3..=4)),
        Kw::Sin => one(Builtin::Sin),
        Kw::Sinh => one(Builtin::Sinh),
        Kw::Sqr => one(Builtin::Sqr),
        Kw::Sqrt => one(Builtin::Sqrt),
        Kw::Tan => one(Builtin::Tan),
        Kw::Tanh => one(Builtin::Tanh),
        _ => None,
    }
}
