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
mod options;
mod parser;
mod suggest;
mod value;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

pub use engine::{Engine, Files};
pub use options::{Declared, ParseOptions, Parsed};
pub use parser::Spline;
use parser::Surroundings;
use raggio_diag::{Diagnostic, Sources};

/// Blocks, brackets and macros may stand within one another some hundred times; this is enough for all of them.
const STACK: usize = 256 << 20;

/// Executes a scene.
///
/// `name` and `text` are the main file's; everything else is found through `files` and noted in `sources`, to which
/// the places in diagnostics refer. `debug` receives the text of `#debug` as it comes. Setting `cancel` from another
/// thread stops the run with an error of code `cancelled`.
///
/// # Errors
/// The last diagnostic is the error, those before it are the warnings up to there.
pub fn parse(
    sources: &mut Sources,
    name: &str,
    text: impl Into<Arc<[u8]>>,
    engine: &dyn Engine,
    files: &dyn Files,
    options: &ParseOptions,
    debug: &mut (dyn FnMut(&str) + Send),
    cancel: &Arc<AtomicBool>,
) -> Result<Parsed, Vec<Diagnostic>> {
    let text = text.into();
    let around = Surroundings { sources, engine, files, options, debug, cancel: cancel.clone() };
    let failed = |why: String| Err(vec![Diagnostic::error("internal", why, None)]);
    std::thread::scope(|scope| {
        let builder = std::thread::Builder::new().name("scene".to_owned()).stack_size(STACK);
        match builder.spawn_scoped(scope, || parser::run(name, text, around)) {
            Ok(thread) => {
                thread.join().unwrap_or_else(|_| failed("the reader of scenes broke down".to_owned()))
            }
            Err(fault) => failed(format!("no thread for reading the scene: {fault}")),
        }
    })
}
