//! The scene language: text in, [`raggio_scene::Scene`] and warnings out.
//!
//! The language is executed, not just parsed: directives and macros may stand anywhere. So each file is lexed once
//! into tokens, and the [`parser::Parser`] walks them; loops and macro calls jump to token positions. The grammar
//! (folder `grammar`) sees a stream in which directives and macros have already happened.
//!
//! Deliberately absent: intersectors, pixels, the file system. What the language asks of the engine while it runs
//! comes through [`Engine`], files through [`Files`]; the façade wires both.

mod engine;
mod grammar;
mod keyword;
mod parser;
mod value;

pub use engine::{Engine, Files};
