//! The numeric rules of operators and built-in functions (language spec, sections 2.3 and 3.2).
use crate::{BinaryOp, Builtin};

/// Degrees to radians, the language's constant.
pub(crate) const RADIAN: f64 = std::f64::consts::PI / 180.0;

/// Truth as a number.
#[inline]
fn truth(b: bool) -> f64 {
    f64::from(u8::from(b))
}

impl BinaryOp {
    /// The operator's value. Not-a-number counts as greater than everything: it fails `<`, `<=` and `=`, and the other
    /// three are their opposites.
    #[inline]
    pub(crate) fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            BinaryOp::Add => a + b,
            BinaryOp::Sub => a - b,
            BinaryOp::Mul => a * b,
            BinaryOp::Div => a / b,
            BinaryOp::Eq => truth(a == b),
            BinaryOp::Ne => truth(a != b),
            BinaryOp::Lt => truth(a < b),
            BinaryOp::Le => truth(a <= b),
            BinaryOp::Gt => 1.0 - truth(a <= b),
            BinaryOp::Ge => 1.0 - truth(a < b),
            BinaryOp::And => truth(a != 0.0 && b != 0.0),
            BinaryOp::Or => truth(a != 0.0 || b != 0.0),
        }
    }

    /// May the operands change places?
    pub(crate) fn commutes(self) -> bool {
        use BinaryOp::*;
        matches!(self, Add | Mul | Eq | Ne | And | Or)
    }
}

impl Builtin {
    /// The value for one or two arguments; `b` is ignored where there is only one. `select` and longer lists of `min`
    /// and `max` are opened by the compiler.
    pub(crate) fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Builtin::Abs => a.abs(),
            Builtin::Acos => a.acos(),
            Builtin::Acosh => a.acosh(),
            Builtin::Asin => a.asin(),
            Builtin::Asinh => a.asinh(),
            Builtin::Atan => a.atan(),
            Builtin::Atan2 => a.atan2(b),
            Builtin::Atanh => a.atanh(),
            Builtin::Ceil => a.ceil(),
            Builtin::Cos => a.cos(),
            Builtin::Cosh => a.cosh(),
            Builtin::Degrees => a / RADIAN,
            Builtin::Div => truncate(a / b),
            Builtin::Exp => a.exp(),
            Builtin::Floor => a.floor(),
            Builtin::Int => truncate(a),
            Builtin::Ln => a.ln(),
            Builtin::Log => a.log10(),
            Builtin::Max => maximum(a, b),
            Builtin::Min => minimum(a, b),
            Builtin::Mod => a % b,
            Builtin::Pow => a.powf(b),
            Builtin::Radians => a * RADIAN,
            Builtin::Select => select(a, b, 0.0, 0.0),
            Builtin::Sin => a.sin(),
            Builtin::Sinh => a.sinh(),
            Builtin::Sqr => a * a,
            Builtin::Sqrt => a.sqrt(),
            Builtin::Tan => a.tan(),
            Builtin::Tanh => a.tanh(),
        }
    }
}

/// Toward zero through a 32-bit integer; what does not fit becomes its least value.
pub(crate) fn truncate(a: f64) -> f64 {
    let t = a.trunc();
    if (-2_147_483_648.0..=2_147_483_647.0).contains(&t) { t + 0.0 } else { -2_147_483_648.0 }
}

/// The smaller; not-a-number on either side gives `b`.
#[inline]
pub(crate) fn minimum(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater; not-a-number on either side gives `a`.
#[inline]
pub(crate) fn maximum(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// One of three by the sign of `a`.
pub(crate) fn select(a: f64, less: f64, equal: f64, greater: f64) -> f64 {
    if a < 0.0 {
        less
    } else if a == 0.0 {
        equal
    } else {
        greater
    }
}
