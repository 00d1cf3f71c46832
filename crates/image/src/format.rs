//! Picture formats and how to tell them apart.

/// A picture format that this crate has heard of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Format {
    Png,
    Jpeg,
    Gif,
    /// Fractint's continuous potential: a GIF whose right half holds the low bytes of the left half's values.
    Pot,
    Tga,
    /// PBM, PGM and PPM, plain or raw.
    Pnm,
    Bmp,
    Tiff,
    Hdr,
    Exr,
    /// ILBM and PBM, the Amiga's pictures: read, not written.
    Iff,
}

impl Format {
    /// By the end of a file's name, in any case.
    pub fn from_name(name: &str) -> Option<Format> {
        let extension = name.rsplit_once('.')?.1.to_ascii_lowercase();
        Some(match extension.as_str() {
            "png" => Format::Png,
            "jpg" | "jpeg" => Format::Jpeg,
            "gif" => Format::Gif,
            "pot" => Format::Pot,
            "tga" => Format::Tga,
            "ppm" | "pgm" | "pbm" | "pnm" => Format::Pnm,
            "bmp" => Format::Bmp,
            "tif" | "tiff" => Format::Tiff,
            "hdr" => Format::Hdr,
            "exr" => Format::Exr,
            "iff" | "ilbm" | "lbm" => Format::Iff,
            _ => return None,
        })
    }

    /// By the first bytes of a file. TGA has no mark of its own and is never found.
    pub fn from_bytes(bytes: &[u8]) -> Option<Format> {
        const MARKS: &[(&[u8], Format)] = &[
            (b"\x89PNG\r\n\x1a\n", Format::Png),
            (b"\xff\xd8\xff", Format::Jpeg),
            (b"GIF8", Format::Gif),
            (b"BM", Format::Bmp),
            (b"II*\0", Format::Tiff),
            (b"MM\0*", Format::Tiff),
            (b"#?RADIANCE", Format::Hdr),
            (b"#?RGBE", Format::Hdr),
            (b"\x76\x2f\x31\x01", Format::Exr),
            (b"FORM", Format::Iff),
        ];
        if let [b'P', b'1'..=b'6', b' ' | b'\t' | b'\r' | b'\n' | b'#', ..] = bytes {
            return Some(Format::Pnm);
        }
        MARKS.iter().find(|(mark, _)| bytes.starts_with(mark)).map(|&(_, format)| format)
    }

    /// The usual end of a file's name, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Png => "png",
            Format::Jpeg => "jpg",
            Format::Gif => "gif",
            Format::Pot => "pot",
            Format::Tga => "tga",
            Format::Pnm => "ppm",
            Format::Bmp => "bmp",
            Format::Tiff => "tif",
            Format::Hdr => "hdr",
            Format::Exr => "exr",
            Format::Iff => "iff",
        }
    }
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.extension().to_ascii_uppercase())
    }
}
