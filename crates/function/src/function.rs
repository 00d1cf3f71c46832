//! A finished user function.
use std::sync::Arc;

use crate::{Expr, External};

/// A user function, ready to be evaluated from any thread.
#[derive(Debug)]
pub struct Function {
    params: usize,
    body: Body,
}

#[derive(Debug)]
enum Body {
    Expr(Expr),
    External(Arc<dyn External>),
}

impl Function {
    /// A function of `params` parameters with the given body.
    pub fn new(params: usize, body: Expr) -> Self {
        Function { params, body: Body::Expr(body) }
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
            Body::Expr(_) => 1,
            Body::External(e) => e.components(),
        }
    }

    /// The external that this function is, if it is one.
    pub fn as_external(&self) -> Option<&Arc<dyn External>> {
        match &self.body {
            Body::Expr(_) => None,
            Body::External(e) => Some(e),
        }
    }
}
