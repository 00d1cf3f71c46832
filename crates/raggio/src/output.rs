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

fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?.to_string_lossy();
    let temporary = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
    let written = std::fs::write(&temporary, bytes).and_then(|()| std::fs::rename(&temporary, path));
    if written.is_err() {
        // Nothing to be done when even the clean-up fails; the first error is the one to report.
        let _ = std::fs::remove_file(&temporary);
    }
    written
}
