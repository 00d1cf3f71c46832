//! Which scenes there are, and how strictly each can be judged.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// Match limit for scenes that always come out the same.
const EXACT_LIMIT: f32 = 0.03;
/// Match limit for scenes that draw random numbers or use cached estimates.
const NOISY_LIMIT: f32 = 0.06;

/// Words that announce random numbers or cached estimates.
const NOISY_WORDS: &[&str] =
    &["radiosity", "photons", "media", "subsurface", "jitter", "crand", "aperture", "blur_samples"];

/// One scene file.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The file.
    pub path: PathBuf,
    /// Folder, relative to where the search began; the unit of the report.
    pub group: String,
    /// Relative path with `__` for the slashes and no extension: the name of its pictures.
    pub key: String,
    /// The largest mean FLIP error that counts as a match.
    pub limit: f32,
    /// Changes with the scene's text.
    pub hash: u64,
    /// The file of options that renders all its frames, where the scene means nothing without one.
    pub ini: Option<PathBuf>,
}

/// All scenes below a folder, in a fixed order; `filter` must occur in the relative path.
pub fn find(root: &Path, filter: &str) -> Result<Vec<Scene>, String> {
    let mut scenes = Vec::new();
    let mut open = vec![root.to_path_buf()];
    while let Some(folder) = open.pop() {
        let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        for entry in entries.flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("pov"))
                && relative(root, &path).contains(filter)
            {
                scenes.push(describe(root, path)?);
            }
        }
    }
    scenes.sort_by(|a, b| a.key.cmp(&b.key));
    Ok(scenes)
}

fn relative(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/")
}

fn describe(root: &Path, path: PathBuf) -> Result<Scene, String> {
    let bytes = std::fs::read(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    let name = relative(root, &path);
    let mut hasher = DefaultHasher::new();
    bytes.hash(&mut hasher);
    Ok(Scene {
        group: name.split_once('/').map_or(".", |(folder, _)| folder).to_string(),
        key: Path::new(&name).with_extension("").to_string_lossy().replace('/', "__"),
        limit: limit(&with_includes(&path, &bytes, 0)),
        hash: hasher.finish(),
        ini: Some(path.with_extension("ini")).filter(|ini| name.starts_with("portfolio/") && ini.exists()),
        path,
    })
}

/// The scene's text and that of the files beside it that it includes; not of those of a library, most of which is not
/// used.
fn with_includes(path: &Path, bytes: &[u8], depth: u32) -> String {
    let mut text = String::from_utf8_lossy(bytes).into_owned();
    let folder = path.parent().unwrap_or(Path::new("."));
    let names: Vec<String> = text
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("#include")?.split('"').nth(1).map(String::from))
        .collect();
    for name in names.iter().filter(|_| depth < MOST_INCLUDES) {
        let included = folder.join(name);
        if let Ok(bytes) = std::fs::read(&included) {
            text.push('\n');
            text += &with_includes(&included, &bytes, depth + 1);
        }
    }
    text
}

/// Files that include one another are followed so far.
const MOST_INCLUDES: u32 = 4;

/// Looks for the noisy words outside line comments; `camera{aperture 0}` and the like are judged mildly too.
fn limit(text: &str) -> f32 {
    let noisy = text.lines().any(|line| {
        let code = line.split("//").next().unwrap_or_default();
        code.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').any(|word| NOISY_WORDS.contains(&word))
    });
    if noisy { NOISY_LIMIT } else { EXACT_LIMIT }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_beside_a_scene_count() {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("globals.inc"), "global_settings { radiosity { } }")
            .expect("written");
        let scene = folder.path().join("scene.pov");
        let text =
            with_includes(&scene, b"#include \"colors.inc\"\n  #include \"globals.inc\"\nsphere{0,1}", 0);
        assert_eq!(limit(&text), NOISY_LIMIT);
        assert_eq!(limit(&with_includes(&scene, b"// #include \"globals.inc\"", 0)), EXACT_LIMIT);
    }

    #[test]
    fn noisy_scenes_get_the_wider_limit() {
        assert_eq!(limit("sphere{0,1}"), EXACT_LIMIT);
        assert_eq!(limit("// radiosity later\nsphere{0,1}"), EXACT_LIMIT);
        assert_eq!(limit("#declare my_photons_on = 1;"), EXACT_LIMIT);
        assert_eq!(limit("light_source{0,1 area_light x,y,4,4 jitter}"), NOISY_LIMIT);
    }
}
