//! From the first token to the finished scene.
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio_diag::{Diagnostic, Sources};
use raggio_scene::Scene;

use super::cursor::Cursor;
use super::files::{LexedFiles, OpenFiles};
use super::random::Streams;
use super::scope::Scopes;
use super::symbol::Symbols;
use super::version::VersionState;
use super::{Charset, Parser, Result, SceneBuilder, Tok, builder, lexer};
use crate::{Engine, Files, ParseOptions, Parsed, grammar};

/// What a run needs besides the text.
pub struct Surroundings<'a> {
    /// Where texts and their names are kept.
    pub sources: &'a mut Sources,
    /// Answers `trace` and the like.
    pub engine: &'a dyn Engine,
    /// Finds and writes files.
    pub files: &'a dyn Files,
    /// What the caller says about the run.
    pub options: &'a ParseOptions,
    /// Receives the text of `#debug`.
    pub debug: &'a mut (dyn FnMut(&str) + Send),
    /// Set from outside to stop the run.
    pub cancel: Arc<AtomicBool>,
}

/// Executes a scene.
pub fn run(
    name: &str,
    text: Arc<[u8]>,
    around: Surroundings,
) -> std::result::Result<Parsed, Vec<Diagnostic>> {
    let mut parser = Parser::new(name, text, around);
    parser.begin();
    match parser.statements() {
        Ok(()) => Ok(parser.finish()),
        Err(mut fault) => {
            fault.trace = parser.backtrace();
            let mut all = std::mem::take(&mut parser.warnings);
            all.push(*fault);
            Err(all)
        }
    }
}

impl<'a> Parser<'a> {
    fn new(name: &str, text: Arc<[u8]>, around: Surroundings<'a>) -> Self {
        let Surroundings { sources, engine, files, options, debug, cancel } = around;
        let mut symbols = Symbols::new();
        let file = sources.add(name, text.clone());
        let main = std::rc::Rc::new(lexer::lex(file, text, &mut symbols));
        let (version, language) = VersionState::new(options.version);
        Parser {
            settings: builder::default_settings(language),
            scene: SceneBuilder::default(),
            charset: if main.marked_utf8 { Charset::Utf8 } else { Charset::Ascii },
            defaults: grammar::Defaults::default(),
            engine,
            files,
            sources,
            options,
            debug,
            cancel,
            warnings: Vec::new(),
            symbols,
            scopes: Scopes::new(),
            cursor: Cursor::new(main),
            open_files: OpenFiles::new(),
            lexed: LexedFiles::default(),
            streams: Streams::default(),
            version,
            gamma_explicit: false,
            depth: 0,
            undefined: Default::default(),
            fault: None,
        }
    }

    fn statements(&mut self) -> Result<()> {
        while self.peek()? != Tok::End {
            if !self.bare_directive()? && !grammar::statement(self)? {
                return self.not_taken("a scene");
            }
        }
        self.close_files()
    }

    fn finish(mut self) -> Parsed {
        self.end();
        let SceneBuilder { objects, camera, atmosphere } = self.scene;
        let camera = camera.unwrap_or_else(builder::default_camera);
        Parsed {
            scene: Scene { settings: self.settings, camera, atmosphere, objects },
            warnings: self.warnings,
        }
    }
}
