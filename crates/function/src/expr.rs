//! The expression tree of a user function (language spec, section 3).
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use crate::{Bounds, Function};

/// A node of a function's body. Parameters and `sum`/`prod` counters are numbered slots.
#[derive(Clone, Debug)]
pub enum Expr {
    /// A number.
    Const(f64),
    /// The value of slot `n`: parameters first, in their order, then the counters of `sum` and `prod`.
    Slot(usize),
    /// `-e`
    Neg(Box<Expr>),
    /// Arithmetic, comparison and logic; comparisons are exact and give 1 or 0.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A built-in function.
    Call(Builtin, Vec<Expr>),
    /// `sum(k, from, to, e)` or `prod(...)`: `slot` is the counter's.
    Loop {
        /// Multiply instead of add?
        product: bool,
        /// The counter's slot.
        slot: usize,
        /// First value of the counter.
        from: Box<Expr>,
        /// The counter runs while it is at most this.
        to: Box<Expr>,
        /// The term.
        body: Box<Expr>,
    },
    /// One of the numbered internal functions (`internal(n)`), with all its arguments (x, y, z, then p1 ...).
    Internal(Internal, Vec<Expr>),
    /// Another user function.
    User(Arc<Function>, Vec<Expr>),
    /// One component (0..5) of an external function's value.
    External {
        /// What is asked.
        function: Arc<dyn External>,
        /// Its arguments: x, y, z; a spline has only one.
        args: Vec<Expr>,
        /// Which component of the answer.
        component: usize,
    },
}

/// Operators with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `=`
    Eq,
    /// `!=`
    Ne,
    /// `<`
    Lt,
    /// `<=`
    Le,
    /// `>`
    Gt,
    /// `>=`
    Ge,
    /// `&`
    And,
    /// `|`
    Or,
}

/// Built-in functions that a function body may call; meaning as in section 3.2 of the language spec.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Builtin {
    Abs,
    Acos,
    Acosh,
    Asin,
    Asinh,
    Atan,
    Atan2,
    Atanh,
    Ceil,
    Cos,
    Cosh,
    Degrees,
    Div,
    Exp,
    Floor,
    Int,
    Ln,
    Log,
    Max,
    Min,
    Mod,
    Pow,
    Radians,
    Select,
    Sin,
    Sinh,
    Sqr,
    Sqrt,
    Tan,
    Tanh,
}

/// A numbered internal function: the `n` of `internal(n)` (table in section 3.4 of the language spec).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Internal(pub u8);

/// A pigment, pattern, transform or spline that a function asks for values.
///
/// Implementors live on higher floors (`shading` for pigments and patterns, `sdl` for splines) and can be got back by
/// [`External::as_any`], for engines that want the source and not the answer.
pub trait External: Debug + Send + Sync {
    /// The answer at `args` (three coordinates, or one for a spline); unused components are 0.
    fn eval(&self, args: &[f64]) -> [f64; 5];
    /// Where the answer lies over bounds of the arguments, and its slopes; by default nothing is known.
    fn enclose(&self, _args: &[Bounds]) -> [Bounds; 5] {
        [Bounds::UNKNOWN; 5]
    }
    /// How many components the answer has, 1 to 5. A pattern has 1, a transform 3, a pigment 5.
    fn components(&self) -> usize;
    /// The implementor itself.
    fn as_any(&self) -> &dyn Any;
}
