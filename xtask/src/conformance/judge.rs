//! One scene: both programs, and what comes of them.

use super::Settings;
use super::scene::Scene;
use crate::picture;
use crate::process;
use raggio_image::Bitmap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// What became of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// Within the limit; the mean FLIP error.
    Match(f32),
    /// Beyond the limit; the mean FLIP error.
    Differs(f32),
    /// We refused it, with this first message.
    Diagnostic(String),
    /// We crashed, with this message.
    Panic(String),
    /// We took longer than the limit.
    Timeout,
    /// POV-Ray does not render it, or not in this way: it does not count.
    Skipped(String),
}

/// The result for one scene.
pub struct Verdict {
    /// What became of it.
    pub status: Status,
    /// The picture to look at: expected, difference and actual side by side, or the expected one alone.
    pub panel: Option<PathBuf>,
}

/// Renders with both programs and compares.
pub fn judge(scene: &Scene, settings: &Settings) -> Result<Verdict, String> {
    if scene.needs_ini {
        return Ok(Verdict { status: Status::Skipped("rendered by its .ini only".into()), panel: None });
    }
    let (expected_path, peer_seconds) = match reference(scene, settings)? {
        Ok(found) => found,
        Err(why) => return Ok(Verdict { status: Status::Skipped(why), panel: None }),
    };
    let actual_path = settings.out.join("actual").join(format!("{}.png", scene.key));
    let limit = Duration::from_secs_f64((10.0 * peer_seconds).max(60.0));
    if let Some(status) = render(scene, settings, &actual_path, limit)? {
        return Ok(Verdict { status, panel: Some(expected_path) });
    }
    let expected = picture::read(&expected_path)?;
    match picture::read(&actual_path) {
        Err(message) => Ok(Verdict {
            status: Status::Panic(format!("no picture: {message}")),
            panel: Some(expected_path),
        }),
        Ok(actual) => compare(scene, settings, &expected, &actual),
    }
}

fn compare(
    scene: &Scene,
    settings: &Settings,
    expected: &Bitmap,
    actual: &Bitmap,
) -> Result<Verdict, String> {
    let comparison = match raggio_image::compare(expected, actual) {
        Ok(comparison) => comparison,
        Err(mismatch) => return Ok(Verdict { status: Status::Panic(mismatch.to_string()), panel: None }),
    };
    let panel = settings.out.join("panel").join(format!("{}.png", scene.key));
    picture::write(&panel, &comparison.panel)?;
    let error = comparison.mean_flip;
    let status = if error <= scene.limit { Status::Match(error) } else { Status::Differs(error) };
    Ok(Verdict { status, panel: Some(panel) })
}

/// Our own picture; `Some` if there is none.
fn render(scene: &Scene, settings: &Settings, out: &Path, limit: Duration) -> Result<Option<Status>, String> {
    make_folder_of(out)?;
    let _ = std::fs::remove_file(out);
    let mut command = Command::new(&settings.binary);
    command.current_dir(folder(scene)).arg("render").arg(file_name(scene));
    command.arg("--size").arg(format!("{}x{}", settings.size.0, settings.size.1)).arg("-o").arg(out);
    if let Some(library) = &settings.library {
        command.arg("--library").arg(library);
    }
    let done = process::run(&mut command, limit)?;
    Ok(match done.code {
        _ if done.timed_out => Some(Status::Timeout),
        Some(0) => None,
        Some(101) | None => Some(Status::Panic(first_message(&done.stderr, "panicked"))),
        Some(_) => Some(Status::Diagnostic(first_message(&done.stderr, "error"))),
    })
}

/// The first line that contains a word, or the first line at all.
fn first_message(stderr: &str, word: &str) -> String {
    let mut lines = stderr.lines().map(str::trim).filter(|l| !l.is_empty());
    let found = lines.clone().find(|l| l.contains(word)).or_else(|| lines.next());
    found.unwrap_or("(no message)").to_string()
}

/// POV-Ray's picture and its seconds: given, cached, or made now. The inner error says why there is none.
fn reference(scene: &Scene, settings: &Settings) -> Result<Result<(PathBuf, f64), String>, String> {
    if let Some(given) = &settings.references {
        let path = given.join(format!("{}.png", scene.key));
        return Ok(if path.exists() { Ok((path, 0.0)) } else { Err("no reference given".into()) });
    }
    let (w, h) = settings.size;
    let stem = settings.out.join("expected").join(format!("{}-{:016x}-{w}x{h}", scene.key, scene.hash));
    let (path, note) = (stem.with_extension("png"), stem.with_extension("txt"));
    if let Ok(text) = std::fs::read_to_string(&note) {
        return Ok(match text.trim().parse() {
            Ok(seconds) => Ok((path, seconds)),
            Err(_) => Err(text.trim().to_string()),
        });
    }
    if !settings.povray {
        return Ok(Err("no reference yet (--povray makes it)".into()));
    }
    make_folder_of(&path)?;
    let done = process::run(&mut peer(scene, settings, &path), Duration::from_secs(180))?;
    let found = if done.code == Some(0) && path.exists() {
        Ok((path, done.wall.as_secs_f64()))
    } else if done.timed_out {
        Err("POV-Ray takes more than 180 s".to_string())
    } else {
        Err(format!("POV-Ray: {}", first_message(&done.stderr, "Error")))
    };
    let text = found.as_ref().map_or_else(String::clone, |(_, seconds)| seconds.to_string());
    std::fs::write(&note, text).map_err(|e| format!("{}: {e}", note.display()))?;
    Ok(found)
}

/// POV-Ray splits arguments at blanks unless they carry quotes of their own.
fn peer(scene: &Scene, settings: &Settings, out: &Path) -> Command {
    let mut command = Command::new("povray");
    command.current_dir(folder(scene));
    command.arg(format!("+I\"{}\"", file_name(scene))).arg(format!("+O\"{}\"", out.display()));
    command.arg(format!("+W{}", settings.size.0)).arg(format!("+H{}", settings.size.1)).args(["-A", "-D"]);
    if let Some(library) = &settings.library {
        command.arg(format!("+L\"{}\"", library.display()));
    }
    command
}

fn folder(scene: &Scene) -> &Path {
    scene.path.parent().unwrap_or(Path::new("."))
}

fn file_name(scene: &Scene) -> String {
    scene.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn make_folder_of(path: &Path) -> Result<(), String> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))
}
