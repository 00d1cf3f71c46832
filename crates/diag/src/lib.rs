//! Source files, spans and diagnostics with hints and back-traces.
//!
//! Invariants: a [`Span`] is only meaningful together with the [`Sources`] that made its [`FileId`]. Deliberately
//! absent: any knowledge of the language.
#![warn(missing_docs)]

mod diagnostic;
mod json;
mod render;
mod source;

pub use diagnostic::{Diagnostic, Frame, Severity};
pub use source::{FileId, Source, Sources, Span};
