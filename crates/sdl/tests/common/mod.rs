//! Runs scene texts and collects what they say.
#![allow(dead_code, clippy::unwrap_used)]
use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use raggio_diag::{Diagnostic, Severity, Sources};
use raggio_function::External;
use raggio_math::{Aabb, Vec3};
use raggio_scene::{Object, Pattern, Pigment, Settings};
use raggio_sdl::{Engine, Files, ParseOptions, Parsed, parse};

/// An engine for which every object is the unit sphere.
struct UnitSphere;

impl Engine for UnitSphere {
    fn trace(&self, _: &Arc<Object>, origin: Vec3, dir: Vec3) -> Option<(Vec3, Vec3)> {
        let b = origin.dot(dir);
        let discriminant = b * b - origin.length_squared() + 1.0;
        let hit = origin + dir * (-b - discriminant.sqrt());
        (discriminant >= 0.0).then_some((hit, hit))
    }
    fn inside(&self, _: &Arc<Object>, point: Vec3) -> Option<bool> {
        Some(point.length() < 1.0)
    }
    fn bounds(&self, _: &Arc<Object>) -> Aabb {
        Aabb::new(Vec3::splat(-1.0), Vec3::splat(1.0))
    }
    fn pigment_function(&self, _: Arc<Pigment>, _: &Settings) -> Arc<dyn External> {
        unimplemented!("no pigments in these tests")
    }
    fn pattern_function(&self, _: Arc<Pattern>, _: &Settings) -> Arc<dyn External> {
        unimplemented!("no patterns in these tests")
    }
}

/// Files in memory.
#[derive(Default)]
pub struct Memory(Mutex<BTreeMap<String, Vec<u8>>>);

impl Memory {
    pub fn with(files: &[(&str, &str)]) -> Self {
        let files = files.iter().map(|(name, text)| (name.to_string(), text.as_bytes().to_vec()));
        Memory(Mutex::new(files.collect()))
    }
    pub fn bytes(&self, name: &str) -> Vec<u8> {
        self.0.lock().unwrap().get(name).cloned().unwrap_or_default()
    }
    pub fn text(&self, name: &str) -> String {
        String::from_utf8(self.bytes(name)).unwrap()
    }
}

impl Files for Memory {
    fn find(&self, names: &[String]) -> Option<(String, Vec<u8>)> {
        let files = self.0.lock().unwrap();
        names.iter().find_map(|name| files.get(name).map(|bytes| (name.clone(), bytes.clone())))
    }
    fn write(&self, name: &str, bytes: &[u8], append: bool) -> std::io::Result<()> {
        let mut files = self.0.lock().unwrap();
        let file = files.entry(name.to_owned()).or_default();
        if !append {
            file.clear();
        }
        file.extend(bytes);
        Ok(())
    }
}

/// What a run said.
pub struct Run {
    pub debug: String,
    pub scene: Option<Parsed>,
    pub diagnostics: Vec<Diagnostic>,
    pub sources: Sources,
}

impl Run {
    /// The code of the error, `""` without one.
    pub fn error(&self) -> &'static str {
        self.diagnostics.iter().find(|d| d.severity == Severity::Error).map_or("", |d| d.code)
    }
    pub fn message(&self) -> String {
        self.diagnostics
            .iter()
            .find(|d| d.severity == Severity::Error)
            .map_or(String::new(), |d| d.message.clone())
    }
    /// Line and column of the error.
    pub fn place(&self) -> (usize, usize) {
        let fault = self.diagnostics.iter().find(|d| d.severity == Severity::Error).expect("an error");
        self.sources.line_column(fault.span.expect("a place"))
    }
    pub fn warned(&self, code: &str) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Warning && d.code == code)
    }
}

pub fn run_with(text: &[u8], files: &Memory, options: &ParseOptions, cancel: &Arc<AtomicBool>) -> Run {
    let mut sources = Sources::default();
    let mut debug = String::new();
    let mut sink = |text: &str| debug.push_str(text);
    let result = parse(&mut sources, "main.pov", text, &UnitSphere, files, options, &mut sink, cancel);
    let (scene, diagnostics) = match result {
        Ok(mut parsed) => {
            let warnings = std::mem::take(&mut parsed.warnings);
            (Some(parsed), warnings)
        }
        Err(diagnostics) => (None, diagnostics),
    };
    Run { debug, scene, diagnostics, sources }
}

pub fn run(text: &str) -> Run {
    run_with(text.as_bytes(), &Memory::default(), &ParseOptions::default(), &Arc::default())
}

/// The `#debug` text of a scene that must run.
#[track_caller]
pub fn debug(text: &str) -> String {
    debug_files(text, &Memory::default())
}

#[track_caller]
pub fn debug_files(text: &str, files: &Memory) -> String {
    let run = run_with(text.as_bytes(), files, &ParseOptions::default(), &Arc::default());
    assert!(run.scene.is_some(), "{text}\n{:#?}", run.diagnostics);
    run.debug
}

/// The value of a float expression in parentheses.
#[track_caller]
pub fn eval(expression: &str) -> f64 {
    let text = debug(&format!("#debug str(({expression}), 0, 15)"));
    text.parse().unwrap_or_else(|_| panic!("{expression} gives {text}"))
}

/// The components of an additive expression.
#[track_caller]
pub fn vector(count: usize, expression: &str) -> Vec<f64> {
    let text = debug(&format!("#debug vstr({count}, {expression}, \" \", 0, 12)"));
    text.split(' ').map(|c| c.parse().unwrap_or_else(|_| panic!("{expression} gives {text}"))).collect()
}
