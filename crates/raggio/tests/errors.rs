//! Broken scenes: each brings the diagnostic that its first line announces.
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio_diag::{Diagnostic, Severity, Sources};
use raggio_function::External;
use raggio_math::{Aabb, Vec3};
use raggio_scene::{Object, Pattern, Pigment, Settings};
use raggio_sdl::{Engine, Files, ParseOptions, parse};

/// An engine of empty space: broken scenes ask it nothing that matters.
struct Emptiness;

impl Engine for Emptiness {
    fn trace(&self, _: &Arc<Object>, _: Vec3, _: Vec3) -> Option<(Vec3, Vec3)> {
        None
    }
    fn inside(&self, _: &Arc<Object>, _: Vec3) -> Option<bool> {
        None
    }
    fn bounds(&self, _: &Arc<Object>) -> Aabb {
        Aabb::new(Vec3::ZERO, Vec3::ZERO)
    }
    fn pigment_function(&self, _: Arc<Pigment>, _: &Settings) -> Arc<dyn External> {
        unimplemented!("no scene here makes a function of a pigment")
    }
    fn pattern_function(&self, _: Arc<Pattern>, _: &Settings) -> Arc<dyn External> {
        unimplemented!("no scene here makes a function of a pattern")
    }
}

/// No files but the scene.
struct NoFiles;

impl Files for NoFiles {
    fn find(&self, _: &[String]) -> Option<(String, Vec<u8>)> {
        None
    }
    fn write(&self, _: &str, _: &[u8], _: bool) -> std::io::Result<()> {
        Err(std::io::Error::other("these scenes write nothing"))
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance/errors")
}

/// `error[code] line:column message`, as the first lines of the scenes have it.
fn first_error(name: &str, text: &str) -> Option<String> {
    let mut sources = Sources::default();
    let cancel = Arc::new(AtomicBool::new(false));
    let options = ParseOptions::default();
    let result = parse(
        &mut sources,
        name,
        text.as_bytes(),
        &Emptiness,
        &NoFiles,
        &options,
        &mut |_: &str| {},
        &cancel,
    );
    let error: Diagnostic = result.err()?.into_iter().find(|d| d.severity == Severity::Error)?;
    let (line, column) = error.span.map_or((0, 0), |span| sources.line_column(span));
    Some(format!("error[{}] {line}:{column} {}", error.code, error.message))
}

#[test]
fn every_broken_scene_brings_its_diagnostic() {
    let mut scenes: Vec<PathBuf> = std::fs::read_dir(folder())
        .expect("the folder of broken scenes")
        .flatten()
        .map(|e| e.path())
        .collect();
    scenes.sort();
    let mut faults = String::new();
    for path in &scenes {
        let name = path.file_name().expect("a file").to_string_lossy().into_owned();
        let text = std::fs::read_to_string(path).expect("readable");
        let expected = text.lines().next().and_then(|l| l.strip_prefix("// ")).unwrap_or_default();
        let actual = first_error(&name, &text).unwrap_or_else(|| "no error".into());
        // What is expected ends with a part of the message.
        let mut parts = expected.splitn(3, ' ');
        let (head, place, part) = (
            parts.next().unwrap_or_default(),
            parts.next().unwrap_or_default(),
            parts.next().unwrap_or_default(),
        );
        if !actual.starts_with(&format!("{head} {place} ")) || !actual.contains(part) {
            writeln!(faults, "{name}\n  expected {expected}\n  brought  {actual}").expect("a string grows");
        }
    }
    assert!(scenes.len() >= 60, "only {} broken scenes", scenes.len());
    assert!(faults.is_empty(), "\n{faults}");
}
