//! Scenes of one thing each against POV-Ray's pictures of them.
//!
//! A failure leaves expected | difference | actual in `conformance/out/`. Scenes that are known to differ stand in
//! `conformance/known.txt` with the reason; one that begins to match must leave the list.
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use raggio::image::{Bitmap, EncodeOptions, Picture};
use raggio::scene::GammaMode;
use raggio::{Antialias, AntialiasMethod, InstalledLibrary, RenderOptions, SceneOptions};

/// Mean FLIP up to which a picture matches.
const LIMIT: f32 = 0.03;
/// The same where the scene draws random numbers.
const NOISY_LIMIT: f32 = 0.06;
const NOISY: &[&str] = &["jitter", "aperture", "media", "radiosity", "crand", "+J1", "irid", "facets"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance")
}

/// All scenes with a reference, as `chapter/name`.
fn scenes() -> Vec<String> {
    let mut found = Vec::new();
    for chapter in std::fs::read_dir(root()).expect("the conformance folder").flatten() {
        let chapter = chapter.path();
        for path in std::fs::read_dir(&chapter).into_iter().flatten().flatten().map(|e| e.path()) {
            if path.extension().is_some_and(|e| e == "pov") && path.with_extension("png").exists() {
                let name = path.strip_prefix(root()).expect("below the root").with_extension("");
                found.push(name.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    found.sort();
    found
}

/// The switches of `// options: ...` on the first line.
fn options(text: &str, expected: &Bitmap) -> RenderOptions {
    let mut options =
        RenderOptions { width: expected.width, height: expected.height, ..RenderOptions::default() };
    let line = text.lines().next().and_then(|l| l.strip_prefix("// options: ")).unwrap_or_default();
    for word in line.split_whitespace() {
        let aa = options.antialias.unwrap_or(Antialias {
            method: AntialiasMethod::NonRecursive,
            threshold: 0.3,
            depth: 3,
            jitter: 1.0,
            gamma: 2.5,
        });
        let number = |prefix: &str| word.strip_prefix(prefix).and_then(|n| n.parse::<f64>().ok());
        if let Some(method) = number("+AM") {
            let recursive =
                if method > 1.5 { AntialiasMethod::Recursive } else { AntialiasMethod::NonRecursive };
            options.antialias = Some(Antialias { method: recursive, ..aa });
        } else if let Some(threshold) = number("+A") {
            options.antialias = Some(Antialias { threshold: threshold as f32, ..aa });
        } else if let Some(depth) = number("+R") {
            options.antialias = Some(Antialias { depth: depth as u32, ..aa });
        } else if word == "-J" {
            options.antialias = Some(Antialias { jitter: 0.0, ..aa });
        } else if let Some(jitter) = number("+J") {
            options.antialias = Some(Antialias { jitter, ..aa });
        } else if let Some(quality) = number("+Q") {
            options.quality = quality as u8;
        } else {
            panic!("no such switch here: {word}");
        }
    }
    options
}

/// Our picture, or why there is none.
fn render(path: &Path, options: &RenderOptions) -> Result<Bitmap, String> {
    let mut scene = SceneOptions { installed_library: InstalledLibrary::Never, ..SceneOptions::file(path) };
    scene.parse.image_width = options.width as u32;
    scene.parse.image_height = options.height as u32;
    let loaded = raggio::load(&scene).map_err(|f| f.render())?;
    let world = loaded.build().map_err(|f| f.render())?;
    let film = world.render(options, &AtomicBool::new(false), &|_, _| {});
    let working = match loaded.scene.settings.gamma {
        GammaMode::None => None,
        GammaMode::Working(curve) => Some(curve),
    };
    let encode = EncodeOptions { working, ..EncodeOptions::default() };
    let picture = Picture { width: film.width, height: film.height, pixels: film.pixels };
    Ok(raggio::image::develop(&picture, &encode))
}

/// `None` where the scene matches, otherwise what is wrong.
fn fault(name: &str) -> Option<String> {
    let path = root().join(format!("{name}.pov"));
    let text = String::from_utf8_lossy(&std::fs::read(&path).expect("readable")).into_owned();
    let reference = std::fs::read(path.with_extension("png")).expect("readable");
    let expected = raggio::image::decode(&reference, None).expect("a picture");
    let actual = match render(&path, &options(&text, &expected)) {
        Ok(actual) => actual,
        Err(why) => return Some(why.trim().to_string()),
    };
    let comparison = match raggio::image::compare(&expected, &actual) {
        Ok(comparison) => comparison,
        Err(mismatch) => return Some(mismatch.to_string()),
    };
    let limit = if NOISY.iter().any(|word| text.contains(word)) { NOISY_LIMIT } else { LIMIT };
    if comparison.mean_flip <= limit {
        return None;
    }
    let panel = root().join("out").join(format!("{}.png", name.replace('/', "-")));
    std::fs::create_dir_all(root().join("out")).expect("a folder");
    let mut bytes = Vec::new();
    raggio::image::write_png(&comparison.panel, 1, &mut bytes).expect("encoded");
    std::fs::write(&panel, bytes).expect("written");
    Some(format!("mean FLIP {:.4}, at most {limit}; see {}", comparison.mean_flip, panel.display()))
}

#[test]
fn every_scene_looks_as_it_should() {
    let known = std::fs::read_to_string(root().join("known.txt")).unwrap_or_default();
    let known: Vec<&str> =
        known.lines().filter(|l| !l.starts_with('#')).filter_map(|l| l.split_whitespace().next()).collect();
    let scenes = scenes();
    assert!(scenes.len() >= 120, "only {} scenes", scenes.len());
    let mut faults = String::new();
    for name in &scenes {
        match (fault(name), known.contains(&name.as_str())) {
            (Some(why), false) => writeln!(faults, "{name}: {why}"),
            (None, true) => writeln!(faults, "{name} matches now: take it out of conformance/known.txt"),
            _ => Ok(()),
        }
        .expect("a string grows");
    }
    assert!(faults.is_empty(), "\n{faults}");
}
