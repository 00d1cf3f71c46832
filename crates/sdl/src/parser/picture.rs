//! Pictures that a scene names.
use raggio_image::Format;
use raggio_scene::Bitmap;

use super::{Parser, Result};
use crate::keyword::Kw;

/// Endings that are tried, in their order.
const ENDINGS: &[&str] =
    &["tga", "png", "ppm", "pgm", "gif", "iff", "jpg", "jpeg", "tif", "tiff", "bmp", "exr", "hdr"];

/// Format and endings of a type word; `sys` is the machine's own, BMP.
fn of_word(word: Kw) -> Option<(Format, &'static [&'static str])> {
    Some(match word {
        Kw::Tga => (Format::Tga, &["tga"]),
        Kw::Png => (Format::Png, &["png"]),
        Kw::Ppm => (Format::Pnm, &["ppm"]),
        Kw::Pgm => (Format::Pnm, &["pgm"]),
        Kw::Gif => (Format::Gif, &["gif"]),
        Kw::Pot => (Format::Pot, &["pot"]),
        Kw::Iff => (Format::Iff, &["iff"]),
        Kw::Jpeg => (Format::Jpeg, &["jpg", "jpeg"]),
        Kw::Tiff => (Format::Tiff, &["tif", "tiff"]),
        Kw::Bmp | Kw::Sys => (Format::Bmp, &["bmp"]),
        Kw::Exr => (Format::Exr, &["exr"]),
        Kw::Hdr => (Format::Hdr, &["hdr"]),
        _ => return None,
    })
}

impl Parser<'_> {
    /// Finds and decodes an image by the rules of section 1.6; the type word has been read already (`None`: by name).
    pub fn image(&mut self, name: &str, format: Option<Kw>) -> Result<Bitmap> {
        let span = self.here();
        let (format, endings) = match format.and_then(of_word) {
            Some((format, endings)) => (Some(format), endings),
            None => (None, ENDINGS),
        };
        let (found, bytes) = self.find(name, endings, span)?;
        raggio_image::decode(&bytes, format.or_else(|| Format::from_name(&found)))
            .or_else(|fault| self.error("bad-image", format!("\"{found}\": {fault}"), span))
    }
}
