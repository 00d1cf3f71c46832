//! The pictures of a scene: one, or where an .ini file asks for an animation one for each frame.

use super::scene::Scene;
use std::path::{Path, PathBuf};

/// The pictures that a scene has left where `picture` was asked for, each with what its name adds to the stem: nothing
/// for a still, the number for a frame. In the order of the frames.
pub fn of(scene: &Scene, picture: &Path) -> Vec<(PathBuf, String)> {
    if scene.ini.is_none() || picture.exists() {
        return vec![(picture.to_path_buf(), String::new())];
    }
    let stem = stem(picture);
    let entries = picture.parent().and_then(|folder| std::fs::read_dir(folder).ok());
    let numbered = |path: PathBuf| {
        let name = path.file_name()?.to_str()?;
        let number = name.strip_prefix(&stem)?.strip_suffix(".png")?.to_string();
        let digits = !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit());
        digits.then_some((path, number))
    };
    let mut frames: Vec<_> =
        entries.into_iter().flatten().flatten().filter_map(|entry| numbered(entry.path())).collect();
    frames.sort();
    frames
}

/// Where the frame of this number lies beside `picture`.
pub fn numbered(picture: &Path, number: &str) -> PathBuf {
    picture.with_file_name(format!("{}{number}.png", stem(picture)))
}

fn stem(picture: &Path) -> String {
    picture.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
