//! Where a scene's files are looked for: beside the scene, in library folders, in the embedded library.
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use raggio_image::Curve;
use raggio_import::{Format, ImportError, Surroundings};
use raggio_scene::Mesh;
use raggio_sdl::Files;

use crate::{embedded, mapped};

/// The usual places of an installed POV-Ray library.
const INSTALLED: &[&str] = &[
    "/usr/share/povray-3.7/include",
    "/usr/local/share/povray-3.7/include",
    "/opt/homebrew/share/povray-3.7/include",
    "/opt/homebrew/opt/povray/share/povray-3.7/include",
    "/opt/local/share/povray-3.7/include",
    "/usr/share/povray-3.8/include",
    "/usr/local/share/povray-3.8/include",
    "/usr/share/povray/include",
    "/usr/local/share/povray/include",
];

/// The disk as a scene sees it.
///
/// A name is tried in the current folder, beside the scene, in the library folders in their order, in the library that
/// is embedded here, and before or after that in an installed POV-Ray's. Only then, because many scenes were written
/// where the case of letters does not matter, are the same places tried again ignoring case.
pub struct DiskFiles {
    /// Before the embedded library.
    folders: Vec<PathBuf>,
    /// After it.
    behind: Vec<PathBuf>,
    write_base: PathBuf,
}

/// Which part the include files of an installed POV-Ray play.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InstalledLibrary {
    /// They go before the given libraries and what is built in, as POV-Ray's own settings come before its switches.
    First,
    /// They are asked for what is not built in: fonts, pictures.
    #[default]
    Last,
    /// They are left alone.
    Never,
}

impl DiskFiles {
    /// `scene_folder` is where the scene lies; `None` for a scene that is no file.
    pub fn new(scene_folder: Option<&Path>, libraries: &[PathBuf], installed: InstalledLibrary) -> Self {
        let mut folders = vec![PathBuf::new()];
        folders.extend(scene_folder.map(Path::to_path_buf));
        let found: Vec<_> = INSTALLED.iter().map(PathBuf::from).filter(|p| p.is_dir()).collect();
        let (before, behind) = match installed {
            InstalledLibrary::First => (found, Vec::new()),
            InstalledLibrary::Last => (Vec::new(), found),
            InstalledLibrary::Never => Default::default(),
        };
        folders.extend(before);
        folders.extend(libraries.iter().cloned());
        DiskFiles { folders, behind, write_base: PathBuf::new() }
    }

    /// Reads a model whose bytes have been found; files that it names lie beside it, or where all files are.
    pub(crate) fn model(
        &self,
        found: &str,
        bytes: &[u8],
        working: Option<Curve>,
    ) -> Result<Mesh, ImportError> {
        let Some(format) = Format::from_name(found) else {
            let what = "its ending is no kind of model; .obj, .ply and .stl are read";
            return Err(ImportError::Whole(what.to_owned()));
        };
        let folder = Path::new(found).parent();
        let find = |name: &str| {
            let beside = folder.and_then(|folder| fs::read(folder.join(name)).ok());
            beside.or_else(|| self.find(&[name.to_owned()]).map(|(_, bytes)| bytes))
        };
        raggio_import::read(format, bytes, &Surroundings { find: &find, working })
    }

    fn locate(&self, names: &[String]) -> Option<(String, Place)> {
        names.iter().find_map(|name| self.exact(name)).or_else(|| {
            names
                .iter()
                .map(|name| mended(name))
                .find_map(|name| self.exact(&name).or_else(|| self.ignoring_case(&name)))
        })
    }

    fn exact(&self, name: &str) -> Option<(String, Place)> {
        let lies_in = |folder: &PathBuf| {
            let path = folder.join(name);
            path.is_file().then_some(path)
        };
        self.first(lies_in, name)
    }

    fn ignoring_case(&self, name: &str) -> Option<(String, Place)> {
        let lies_in = |folder: &PathBuf| resolve_ignoring_case(folder, Path::new(name));
        self.first(lies_in, &name.to_ascii_lowercase())
    }

    /// The first of all places that has a file; `embedded` is its name where it is built in.
    fn first(
        &self,
        lies_in: impl Fn(&PathBuf) -> Option<PathBuf>,
        embedded: &str,
    ) -> Option<(String, Place)> {
        let on_disk = |path: PathBuf| (path.to_string_lossy().into_owned(), Place::Disk(path));
        let built_in =
            || embedded::file(embedded).map(|text| (format!("<built in>/{embedded}"), Place::Embedded(text)));
        let before = self.folders.iter().find_map(&lies_in).map(on_disk);
        before.or_else(built_in).or_else(|| self.behind.iter().find_map(&lies_in).map(on_disk))
    }
}

/// Where a file has been found.
enum Place {
    Disk(PathBuf),
    Embedded(&'static [u8]),
}

impl Files for DiskFiles {
    fn find(&self, names: &[String]) -> Option<(String, Vec<u8>)> {
        let (name, place) = self.locate(names)?;
        match place {
            Place::Disk(path) => Some((name, fs::read(path).ok()?)),
            Place::Embedded(text) => Some((name, text.to_vec())),
        }
    }

    fn mesh(&self, name: &str, working: Option<Curve>) -> Option<Result<Mesh, String>> {
        let (found, place) = self.locate(&[name.to_owned()])?;
        let mesh = match place {
            Place::Disk(path) => self.model(&found, &mapped::open(&path).ok()?, working),
            Place::Embedded(text) => self.model(&found, text, working),
        };
        Some(mesh.map_err(|fault| fault.to_string()))
    }

    fn write(&self, name: &str, bytes: &[u8], append: bool) -> io::Result<()> {
        let path = self.write_base.join(name);
        let mut file =
            fs::OpenOptions::new().create(true).write(true).append(append).truncate(!append).open(path)?;
        file.write_all(bytes)
    }
}

/// Names as other systems write them: backslashes, a trailing dot.
fn mended(name: &str) -> String {
    name.replace('\\', "/").trim_end_matches('.').to_owned()
}

/// The file that `relative` names below `folder` when the case of letters does not count.
fn resolve_ignoring_case(folder: &Path, relative: &Path) -> Option<PathBuf> {
    let mut at = folder.to_path_buf();
    for part in relative.components() {
        let exact = at.join(part);
        if exact.exists() {
            at = exact;
            continue;
        }
        let wanted = part.as_os_str().to_string_lossy().to_lowercase();
        let here = if at.as_os_str().is_empty() { Path::new(".") } else { at.as_path() };
        let mut matches: Vec<_> = fs::read_dir(here)
            .ok()?
            .flatten()
            .map(|entry| entry.file_name())
            .filter(|name| name.to_string_lossy().to_lowercase() == wanted)
            .collect();
        // Several spellings side by side: the order of a folder is not stable, so choose by name.
        matches.sort();
        at.push(matches.into_iter().next()?);
    }
    at.is_file().then_some(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_beside_the_scene_then_in_libraries_then_ignoring_case() {
        let dir = tempfile::tempdir().unwrap();
        let (scene, library) = (dir.path().join("scene"), dir.path().join("lib"));
        fs::create_dir_all(&scene).unwrap();
        fs::create_dir_all(library.join("Sub")).unwrap();
        fs::write(scene.join("a.inc"), "scene").unwrap();
        fs::write(library.join("a.inc"), "library").unwrap();
        fs::write(library.join("Sub/Two.INC"), "case").unwrap();
        let files = DiskFiles::new(Some(&scene), std::slice::from_ref(&library), InstalledLibrary::Never);
        let text = |name: &str| files.find(&[name.to_owned()]).map(|(_, t)| String::from_utf8(t).unwrap());
        assert_eq!(text("a.inc").as_deref(), Some("scene"));
        assert_eq!(text("sub\\two.inc.").as_deref(), Some("case"));
        assert_eq!(text("nowhere.inc"), None);
    }

    #[test]
    fn candidates_are_tried_in_order_in_every_place() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("b"), "bare").unwrap();
        let files = DiskFiles::new(Some(dir.path()), &[], InstalledLibrary::Never);
        let found = files.find(&["b.inc".to_owned(), "b".to_owned()]).unwrap();
        assert_eq!(found.1, b"bare");
    }

    #[test]
    fn what_is_built_in_goes_before_what_is_only_asked_last() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("colors.inc"), "mine").unwrap();
        fs::write(dir.path().join("timrom.ttf"), "font").unwrap();
        let mut files = DiskFiles::new(None, &[], InstalledLibrary::Never);
        files.behind.push(dir.path().to_owned());
        let text = |files: &DiskFiles, name: &str| files.find(&[name.to_owned()]).unwrap().1;
        assert_ne!(text(&files, "colors.inc"), b"mine");
        assert_eq!(text(&files, "TimRom.ttf"), b"font");
        files.folders.append(&mut files.behind);
        assert_eq!(text(&files, "colors.inc"), b"mine");
    }
}
