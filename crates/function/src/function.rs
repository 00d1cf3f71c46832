//! A finished user function.
use std::sync::Arc;

use crate::compile::compile;
use crate::program::Program;
use crate::{Bounds, Expr, External};

/// The most parameters that a function may have.
pub const MAX_PARAMS: usize = 56;

/// The noise generator of scenes that name none.
const DEFAULT_NOISE_GENERATOR: u8 = 2;

/// A user function, ready to be evaluated from any thread.
#[derive(Debug)]
pub struct Function {
    params: usize,
    body: Body,
}

#[derive(Debug)]
enum Body {
    Expr { expr: Expr, noise_generator: u8, program: Program },
    External(Arc<dyn External>),
}

impl Function {
    /// A function of `params` parameters with the given body. `internal(76)` uses noise generator 2.
    pub fn new(params: usize, body: Expr) -> Self {
        Function::with_noise_generator(params, body, DEFAULT_NOISE_GENERATOR)
    }

    /// The same for scenes that choose another noise generator, 1 to 3.
    pub fn with_noise_generator(params: usize, expr: Expr, noise_generator: u8) -> Self {
        let program = compile(params, &expr, noise_generator);
        Function { params, body: Body::Expr { expr, noise_generator, program } }
    }

    /// A function that is a pigment, pattern, transform or spline.
    pub fn external(params: usize, external: Arc<dyn External>) -> Self {
        Function { params, body: Body::External(external) }
    }

    /// The number of parameters.
    pub fn params(&self) -> usize {
        self.params
    }

    /// How many components the value has: 1 for expressions, up to 5 for pigments and splines.
    pub fn components(&self) -> usize {
        match &self.body {
            Body::Expr { .. } => 1,
            Body::External(e) => e.components(),
        }
    }

    /// Does another function surely give the same values, bit for bit?
    pub fn same(&self, other: &Function) -> bool {
        self.params == other.params
            && match (&self.body, &other.body) {
                (Body::Expr { program: a, .. }, Body::Expr { program: b, .. }) => a.same(b),
                (Body::External(a), Body::External(b)) => Arc::ptr_eq(a, b),
                _ => false,
            }
    }

    /// The external that this function is, if it is one.
    pub fn as_external(&self) -> Option<&Arc<dyn External>> {
        match &self.body {
            Body::Expr { .. } => None,
            Body::External(e) => Some(e),
        }
    }

    /// The expression that this function is, if it is one.
    pub fn as_expr(&self) -> Option<&Expr> {
        match &self.body {
            Body::Expr { expr, .. } => Some(expr),
            Body::External(_) => None,
        }
    }

    /// The value, or its first component. Missing arguments read 0, surplus ones are ignored.
    #[inline]
    pub fn eval(&self, args: &[f64]) -> f64 {
        match &self.body {
            Body::Expr { program, .. } => program.run(args),
            Body::External(e) => e.eval(args)[0],
        }
    }

    /// Makes native code at once that else comes after some thousand evaluations; answers whether there is any. The
    /// values are the same.
    pub fn prepare(&self) -> bool {
        match &self.body {
            Body::Expr { program, .. } => program.prepare(),
            Body::External(_) => false,
        }
    }

    /// All components of the value; those beyond [`Function::components`] are 0.
    pub fn eval5(&self, args: &[f64]) -> [f64; 5] {
        match &self.body {
            Body::Expr { program, .. } => [program.run(args), 0.0, 0.0, 0.0, 0.0],
            Body::External(e) => e.eval(args),
        }
    }

    /// Where the value and its slopes lie over bounds of the arguments.
    pub fn enclose(&self, args: &[Bounds]) -> Bounds {
        self.enclose_openly(args).settled()
    }

    /// The same; an angle may still be known but for whole turns.
    pub(crate) fn enclose_openly(&self, args: &[Bounds]) -> Bounds {
        match &self.body {
            Body::Expr { program, .. } => program.enclose(args),
            Body::External(e) => e.enclose(args)[0],
        }
    }

    /// What the compiler needs to open a call of this function in place: its body and generator, if it is short.
    pub(crate) fn inlinable(&self, most_ops: usize) -> Option<(&Expr, u8)> {
        match &self.body {
            Body::Expr { expr, noise_generator, program } if program.len() <= most_ops => {
                Some((expr, *noise_generator))
            }
            _ => None,
        }
    }
}
