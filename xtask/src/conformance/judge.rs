//! One scene: both programs, and what comes of them.

use super::scene::Scene;
use super::{Settings, frames};
use crate::picture;
use crate::process;
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

/// The least that an animation may take, whose peer's time is often not known.
const ANIMATION_LIMIT: Duration = Duration::from_secs(1200);

/// Renders with both programs and compares. An animation matches if all its frames do; its worst is shown.
pub fn judge(scene: &Scene, settings: &Settings) -> Result<Verdict, String> {
    let (expected, peer_seconds) = match reference(scene, settings)? {
        Ok(found) => found,
        Err(why) => return Ok(Verdict { status: Status::Skipped(why), panel: None }),
    };
    let expected = frames::of(scene, &expected);
    let Some((first, _)) = expected.first() else {
        return Ok(Verdict { status: Status::Skipped("no reference given".into()), panel: None });
    };
    let actual = settings.out.join("actual").join(format!("{}.png", scene.key));
    let limit = Duration::from_secs_f64((10.0 * peer_seconds).max(60.0));
    let limit = if scene.ini.is_some() { limit.max(ANIMATION_LIMIT) } else { limit };
    if let Some(status) = render(scene, settings, &actual, limit)? {
        return Ok(Verdict { status, panel: Some(first.clone()) });
    }
    let (mut worst, mut panel) = (0.0f32, None);
    for (path, number) in &expected {
        let shown = settings.out.join("panel").join(format!("{}{number}.png", scene.key));
        match compare(path, &frames::numbered(&actual, number), &shown)? {
            Err(message) => {
                return Ok(Verdict { status: Status::Panic(message), panel: Some(path.clone()) });
            }
            Ok(error) if panel.is_none() || error > worst => (worst, panel) = (error, Some(shown)),
            Ok(_) => {}
        }
    }
    let status = if worst <= scene.limit { Status::Match(worst) } else { Status::Differs(worst) };
    Ok(Verdict { status, panel })
}

/// The mean FLIP error of two pictures, whose panel is written; the inner error says why they can't be compared.
fn compare(expected: &Path, actual: &Path, panel: &Path) -> Result<Result<f32, String>, String> {
    let expected = picture::read(expected)?;
    let actual = match picture::read(actual) {
        Ok(actual) => actual,
        Err(message) => return Ok(Err(format!("no picture: {message}"))),
    };
    match raggio_image::compare(&expected, &actual) {
        Ok(comparison) => {
            picture::write(panel, &comparison.panel)?;
            Ok(Ok(comparison.mean_flip))
        }
        Err(mismatch) => Ok(Err(mismatch.to_string())),
    }
}

/// Our own picture; `Some` if there is none.
fn render(scene: &Scene, settings: &Settings, out: &Path, limit: Duration) -> Result<Option<Status>, String> {
    make_folder_of(out)?;
    for (old, _) in frames::of(scene, out) {
        let _ = std::fs::remove_file(old);
    }
    let mut command = Command::new(&settings.binary);
    command.current_dir(folder(scene));
    if scene.ini.is_some() {
        command.arg("povray");
        povray_arguments(&mut command, scene, settings, out);
    } else {
        command.arg("render").arg(file_name(scene)).arg("-o").arg(out);
        command.arg("--size").arg(format!("{}x{}", settings.size.0, settings.size.1));
        if let Some(library) = &settings.library {
            command.arg("--library").arg(library);
        }
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
        let given = frames::of(scene, &path).iter().any(|(frame, _)| frame.exists());
        return Ok(if given { Ok((path, 0.0)) } else { Err("no reference given".into()) });
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
    let limit = if scene.ini.is_some() { ANIMATION_LIMIT } else { Duration::from_secs(180) };
    let done = process::run(&mut peer(scene, settings, &path), limit)?;
    let made = frames::of(scene, &path).iter().any(|(frame, _)| frame.exists());
    let found = if done.code == Some(0) && made {
        Ok((path, done.wall.as_secs_f64()))
    } else if done.timed_out {
        Err(format!("POV-Ray takes more than {} s", limit.as_secs()))
    } else {
        Err(format!("POV-Ray: {}", first_message(&done.stderr, "Error")))
    };
    let text = found.as_ref().map_or_else(String::clone, |(_, seconds)| seconds.to_string());
    std::fs::write(&note, text).map_err(|e| format!("{}: {e}", note.display()))?;
    Ok(found)
}

fn peer(scene: &Scene, settings: &Settings, out: &Path) -> Command {
    let mut command = Command::new("povray");
    command.current_dir(folder(scene));
    povray_arguments(&mut command, scene, settings, out);
    command
}

/// POV-Ray splits arguments at blanks unless they carry quotes of their own.
fn povray_arguments(command: &mut Command, scene: &Scene, settings: &Settings, out: &Path) {
    if let Some(name) = scene.ini.as_ref().and_then(|ini| ini.file_name()) {
        command.arg(name);
    }
    command.arg(format!("+I\"{}\"", file_name(scene))).arg(format!("+O\"{}\"", out.display()));
    command.arg(format!("+W{}", settings.size.0)).arg(format!("+H{}", settings.size.1)).args(["-A", "-D"]);
    if let Some(library) = &settings.library {
        command.arg(format!("+L\"{}\"", library.display()));
    }
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
