//! Pictures as the comparison needs them: read from files, and the panel written to one.

use raggio_image::Bitmap;
use std::path::Path;

/// Reads a picture of any kind that the image room knows.
pub fn read(path: &Path) -> Result<Bitmap, String> {
    let bytes = std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
    raggio_image::decode(&bytes, None).map_err(|e| format!("{}: {e}", path.display()))
}

/// Writes a PNG, with its folder where that is missing.
pub fn write(path: &Path, picture: &Bitmap) -> Result<(), String> {
    let said = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| said(&e))?;
    }
    let mut bytes = Vec::new();
    raggio_image::write_png(picture, 1, &mut bytes).map_err(|e| said(&e))?;
    std::fs::write(path, bytes).map_err(|e| said(&e))
}
