//! User functions: one expression tree and the ways to evaluate it.
//!
//! The language compiles `function { ... }` into an [`Expr`]; [`Function::new`] folds constants, shares equal
//! subexpressions and makes a short register program that is evaluated without allocating. Pigments, patterns, splines
//! and transforms used as functions are [`External`]s, linked when the function is made, so this crate knows no texture
//! and no shape.
//!
//! Invariants: evaluation cannot fail; what has no value is NaN or infinite, as IEEE arithmetic has it.
//! Deliberately absent: the function grammar and its errors (that is `sdl`).
#![warn(missing_docs)]

mod allocate;
mod bounds;
mod builtin;
mod compile;
mod expr;
mod function;
mod internal;
#[cfg_attr(
    not(all(feature = "native", any(target_arch = "x86_64", target_arch = "aarch64"), not(miri))),
    path = "native/absent.rs"
)]
mod native;
mod program;

pub use bounds::{Bounds, Range, VARIABLES};
pub use expr::{BinaryOp, Builtin, Expr, External, Internal};
pub use function::{Function, MAX_PARAMS};
