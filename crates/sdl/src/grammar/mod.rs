//! The grammar: one file a block of the language.
use crate::parser::{Parser, Result};
use crate::value::Value;

/// The running defaults.
#[derive(Default)]
pub struct Defaults;

pub fn statement(_: &mut Parser) -> Result<bool> {
    Ok(false)
}

pub fn declared_value(_: &mut Parser) -> Result<Option<Value>> {
    Ok(None)
}

pub mod defaults {
    pub fn default_directive(p: &mut crate::parser::Parser) -> crate::parser::Result<()> {
        p.expected("a grammar")
    }
}

pub mod function {
    pub fn function_value(
        p: &mut crate::parser::Parser,
    ) -> crate::parser::Result<std::sync::Arc<raggio_function::Function>> {
        p.expected("a grammar")
    }
}
