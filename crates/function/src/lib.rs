//! User functions: one expression tree and the ways to evaluate it.
//!
//! The language compiles `function { ... }` into an [`Expr`]; [`Function::new`] folds constants and makes the form
//! that is evaluated. Pigments, patterns, splines and transforms used as functions are [`External`]s, linked when
//! the function is made, so this crate knows no texture and no shape.
#![warn(missing_docs)]

mod expr;
mod function;

pub use expr::{BinaryOp, Builtin, Expr, External, Internal};
pub use function::Function;
