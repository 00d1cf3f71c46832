//! From the film to a finished file: encoded in memory, written under a temporary name, then renamed.
use std::io::{self, Write};
use std::path::Path;

use raggio_image::{EncodeError, EncodeOptions, Picture};

/// Why a picture could not be written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The picture cannot be stored in that format.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// The disk said no.
    #[error("cannot write {path}: {source}")]
    Io {
        /// Where.
        path: String,
        /// What it said.
        source: io::Error,
    },
}

/// Writes a picture to `path`; `-` is standard output. A file appears whole or not at all.
pub fn write_picture(picture: &Picture, options: &EncodeOptions, path: &Path) -> Result<(), OutputError> {
    let mut bytes = Vec::new();
    raggio_image::encode(picture, options, &mut bytes)?;
    let failed = |source| OutputError::Io { path: path.display().to_string(), source };
    if path == Path::new("-") {
        let mut out = io::stdout().lock();
        return out.write_all(&bytes).and_then(|()| out.flush()).map_err(failed);
    }
    write_whole(path, &bytes).map_err(failed)
}

/// Writes a file that appears whole or not at all. What is no ordinary file (a device, a pipe) is written to as it is.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if std::fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        return std::fs::write(path, bytes);
    }
    let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?.to_string_lossy();
    let temporary = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
    let written = std::fs::write(&temporary, bytes).and_then(|()| std::fs::rename(&temporary, path));
    if written.is_err() {
        // Nothing to be done when even the clean-up fails; the first error is the one to report.
        let _ = std::fs::remove_file(&temporary);
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_replaced_and_nothing_is_left_beside_them() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        write_whole(&path, b"one").expect("written");
        write_whole(&path, b"two").expect("written again");
        assert_eq!(std::fs::read(&path).expect("there"), b"two");
        assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 1);
        assert!(write_whole(&folder.path().join("none/a.txt"), b"x").is_err());
    }

    #[cfg(unix)]
    #[test]
    fn devices_stay_devices() {
        use std::os::unix::fs::FileTypeExt;
        write_whole(Path::new("/dev/null"), b"gone").expect("written");
        assert!(std::fs::metadata("/dev/null").expect("there").file_type().is_char_device());
    }
}
