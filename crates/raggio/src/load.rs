//! From a scene's file to a scene that can be rendered.
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio_diag::{Diagnostic, Sources};
use raggio_import::Format;
use raggio_render::World;
use raggio_scene::Scene;
use raggio_sdl::ParseOptions;

use crate::engine::LiveEngine;
use crate::files::{DiskFiles, InstalledLibrary};
use crate::model;

/// Which scene, and what it may ask about its surroundings.
#[derive(Default)]
pub struct SceneOptions {
    /// The scene's file, or a model (`.obj`, `.ply`, `.stl`) to show; also names the folder where its files are looked for.
    pub path: Option<PathBuf>,
    /// The text, where it does not come from `path`, and the name to call it by.
    pub text: Option<(String, Vec<u8>)>,
    /// More folders to look for files in (`--library`, `+L`).
    pub libraries: Vec<PathBuf>,
    /// When are the include files of an installed POV-Ray looked at?
    pub installed_library: InstalledLibrary,
    /// Clock, frames, picture size, declared names, language version, cancelling.
    pub parse: ParseOptions,
}

impl SceneOptions {
    /// A scene file with everything else at its default.
    pub fn file(path: impl Into<PathBuf>) -> Self {
        SceneOptions { path: Some(path.into()), ..Self::default() }
    }

    /// A scene given as text.
    pub fn text(name: impl Into<String>, text: impl Into<Vec<u8>>) -> Self {
        SceneOptions { text: Some((name.into(), text.into())), ..Self::default() }
    }
}

/// A scene that cannot be rendered, and why.
#[derive(Debug)]
pub struct Failure {
    /// At least one error, perhaps warnings before it.
    pub diagnostics: Vec<Diagnostic>,
    /// What their places refer to.
    pub sources: Sources,
}

impl Failure {
    /// All of it as text for a person, without colours.
    pub fn render(&self) -> String {
        self.diagnostics.iter().map(|d| d.render(&self.sources, false)).collect()
    }
}

/// A scene that has been read.
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// What its author should know.
    pub warnings: Vec<Diagnostic>,
    /// What the places in `warnings` refer to.
    pub sources: Sources,
}

/// Reads and runs a scene, in silence.
///
/// # Errors
/// All diagnostics up to the error that stopped it.
pub fn load(options: &SceneOptions) -> Result<Loaded, Failure> {
    load_with(options, &mut |_| {}, &Arc::new(AtomicBool::new(false)))
}

/// Reads and runs a scene. `debug` receives the text of `#debug` as it comes; setting `cancel` stops the run with an
/// error of code `cancelled`.
///
/// # Errors
/// All diagnostics up to the error that stopped it.
pub fn load_with(
    options: &SceneOptions,
    debug: &mut (dyn FnMut(&str) + Send),
    cancel: &Arc<AtomicBool>,
) -> Result<Loaded, Failure> {
    let mut sources = Sources::default();
    if let (Some(path), None) = (&options.path, &options.text)
        && Format::from_name(&path.to_string_lossy()).is_some()
    {
        return model::load(path, options);
    }
    let (name, text) = match source_text(options) {
        Ok(found) => found,
        Err(diagnostic) => return Err(Failure { diagnostics: vec![*diagnostic], sources }),
    };
    let folder = options.path.as_deref().and_then(Path::parent);
    let files = DiskFiles::new(folder, &options.libraries, options.installed_library);
    let engine = LiveEngine::default();
    match raggio_sdl::parse(&mut sources, &name, text, &engine, &files, &options.parse, debug, cancel) {
        Ok(parsed) => Ok(Loaded { scene: parsed.scene, warnings: parsed.warnings, sources }),
        Err(diagnostics) => Err(Failure { diagnostics, sources }),
    }
}

fn source_text(options: &SceneOptions) -> Result<(String, Vec<u8>), Box<Diagnostic>> {
    if let Some((name, text)) = &options.text {
        return Ok((name.clone(), text.clone()));
    }
    let Some(path) = &options.path else {
        return Ok(("default.pov".to_owned(), crate::DEFAULT_SCENE.as_bytes().to_vec()));
    };
    let name = path.display().to_string();
    std::fs::read(path).map(|text| (name, text)).map_err(|error| unreadable(path, &error))
}

/// That the file that was asked for cannot be read.
pub(crate) fn unreadable(path: &Path, error: &std::io::Error) -> Box<Diagnostic> {
    let message = format!("cannot read {}: {error}", path.display());
    Box::new(Diagnostic::error("missing-scene", message, None))
}

impl Loaded {
    /// Makes the scene ready for rays.
    pub fn build(&self) -> Result<World, Failure> {
        World::build(&self.scene).map_err(|error| Failure {
            diagnostics: vec![Diagnostic::error("unsupported", error.to_string(), None)],
            sources: self.sources.clone(),
        })
    }
}
