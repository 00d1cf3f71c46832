//! TrueType fonts: finding their files, and their glyphs in units of one em.
use std::cell::RefCell;
use std::sync::Arc;

use raggio_math::Vec2;
use raggio_scene::{Contour, Curve2, CurveKind};
use rustc_hash::FxHashMap;
use ttf_parser::{Face, GlyphId, OutlineBuilder, PlatformId};

use super::kern::Kerning;
use super::spline;
use crate::parser::{Parser, Result};

/// Folders where systems keep fonts.
const FOLDERS: &[&str] = &[
    "/usr/share/fonts/truetype/",
    "/usr/share/fonts/truetype/liberation/",
    "/usr/share/fonts/truetype/liberation2/",
    "/usr/share/fonts/truetype/dejavu/",
    "/usr/share/fonts/truetype/msttcorefonts/",
    "/usr/share/fonts/truetype/freefont/",
    "/usr/share/fonts/liberation/",
    "/usr/share/fonts/TTF/",
    "/usr/local/share/fonts/",
    "/Library/Fonts/",
    "/System/Library/Fonts/",
    "/System/Library/Fonts/Supplemental/",
    "C:/Windows/Fonts/",
];

/// Fonts of the same widths that stand in for well-known ones: file names without their ending.
const TWINS: &[(&str, &str)] = &[
    ("arial", "LiberationSans-Regular"),
    ("arialbd", "LiberationSans-Bold"),
    ("ariali", "LiberationSans-Italic"),
    ("arialbi", "LiberationSans-BoldItalic"),
    ("times", "LiberationSerif-Regular"),
    ("timesbd", "LiberationSerif-Bold"),
    ("timesi", "LiberationSerif-Italic"),
    ("timesbi", "LiberationSerif-BoldItalic"),
    ("cour", "LiberationMono-Regular"),
    ("courbd", "LiberationMono-Bold"),
    ("verdana", "DejaVuSans"),
    ("verdanab", "DejaVuSans-Bold"),
];

/// The bytes of a font: a file of the scene or the library, a font of the system, or a twin of the same widths.
pub fn bytes(p: &mut Parser, name: &str) -> Result<Arc<[u8]>> {
    let span = p.span();
    let missing = match p.file(name, &[".ttf", ".ttc"]) {
        Ok(bytes) => return Ok(bytes),
        Err(missing) => missing,
    };
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let in_folders = |p: &mut Parser, stem: &str| {
        FOLDERS.iter().find_map(|folder| p.file(&format!("{folder}{stem}"), &[".ttf", ".ttc"]).ok())
    };
    if let Some(bytes) = in_folders(p, stem) {
        return Ok(bytes);
    }
    let lower = stem.to_ascii_lowercase();
    let twin =
        TWINS.iter().find(|(known, _)| *known == lower).map_or("LiberationSans-Regular", |(_, twin)| twin);
    match in_folders(p, twin).or_else(|| p.file("cyrvetic", &[".ttf"]).ok()) {
        Some(bytes) => {
            p.warn(
                "substituted-font",
                format!("the font \"{name}\" is not here; using {twin} instead"),
                span,
            );
            Ok(bytes)
        }
        None => Err(missing),
    }
}

/// A font that has been opened.
pub struct Font<'a> {
    face: Face<'a>,
    em: f64,
    kerning: Kerning<'a>,
    outlines: RefCell<FxHashMap<GlyphId, Outline>>,
}

/// What a glyph looks like.
#[derive(Clone)]
pub struct Outline {
    /// The contours, empty for blanks.
    pub contours: Arc<[Contour]>,
    /// The least x of all its points and of the box in its header; 0 for blanks.
    pub x_min: f64,
}

impl<'a> Font<'a> {
    /// Opens a font file; of a collection the first one.
    pub fn new(bytes: &'a [u8]) -> Option<Self> {
        let face = Face::parse(bytes, 0).ok()?;
        let em = f64::from(face.units_per_em());
        let kern = face.raw_face().table(ttf_parser::Tag::from_bytes(b"kern")).unwrap_or_default();
        Some(Font { em, kerning: Kerning::new(kern), outlines: RefCell::default(), face })
    }

    /// The glyph of a character; unknown ones have glyph 0.
    pub fn glyph(&self, c: char) -> GlyphId {
        let order = if c.is_ascii() {
            [PlatformId::Macintosh, PlatformId::Windows, PlatformId::Unicode]
        } else {
            [PlatformId::Unicode, PlatformId::Windows, PlatformId::Macintosh]
        };
        let code = u32::from(c);
        let symbol = (code < 0x100).then_some(code + 0xF000);
        let subtables = self.face.tables().cmap.map(|cmap| cmap.subtables);
        let of =
            |platform| subtables.into_iter().flatten().filter(move |table| table.platform_id == platform);
        order
            .into_iter()
            .flat_map(of)
            .find_map(|table| {
                let glyph = table.glyph_index(code).filter(|glyph| glyph.0 != 0);
                glyph.or_else(|| table.glyph_index(symbol?)).filter(|glyph| glyph.0 != 0)
            })
            .unwrap_or(GlyphId(0))
    }

    /// How far the pen moves.
    pub fn advance(&self, glyph: GlyphId) -> f64 {
        f64::from(self.face.glyph_hor_advance(glyph).unwrap_or(0)) / self.em
    }

    /// The blank to the left of a glyph.
    pub fn side_bearing(&self, glyph: GlyphId) -> f64 {
        f64::from(self.face.glyph_hor_side_bearing(glyph).unwrap_or(0)) / self.em
    }

    /// How a pair of glyphs moves together.
    pub fn kerning(&self, left: GlyphId, right: GlyphId) -> Vec2 {
        self.kerning.of(left.0, right.0) / self.em
    }

    /// What a glyph looks like; each is made once.
    pub fn outline(&self, glyph: GlyphId) -> Outline {
        if let Some(outline) = self.outlines.borrow().get(&glyph) {
            return outline.clone();
        }
        let mut pen = Pen { scale: 1.0 / self.em, ..Pen::default() };
        self.face.outline_glyph(glyph, &mut pen);
        let header = self.header_x_min(glyph).map_or(f64::INFINITY, |x| x / self.em);
        let x_min = if pen.contours.is_empty() { 0.0 } else { pen.x_min.min(header) };
        let outline = Outline { contours: pen.contours.into(), x_min };
        self.outlines.borrow_mut().insert(glyph, outline.clone());
        outline
    }

    /// The least x that the glyph's own header states, in font units.
    fn header_x_min(&self, glyph: GlyphId) -> Option<f64> {
        let raw = self.face.raw_face();
        let table = |tag: &[u8; 4]| raw.table(ttf_parser::Tag::from_bytes(tag));
        let (head, loca, glyf) = (table(b"head")?, table(b"loca")?, table(b"glyf")?);
        let long = *head.get(51)? != 0;
        let i = usize::from(glyph.0);
        let start = match long {
            true => u32::from_be_bytes(loca.get(4 * i..4 * i + 4)?.try_into().ok()?) as usize,
            false => 2 * usize::from(u16::from_be_bytes(loca.get(2 * i..2 * i + 2)?.try_into().ok()?)),
        };
        let x_min = glyf.get(start + 2..start + 4)?;
        Some(f64::from(i16::from_be_bytes(x_min.try_into().ok()?)))
    }
}

/// Collects the pieces of an outline.
struct Pen {
    scale: f64,
    x_min: f64,
    start: Vec2,
    at: Vec2,
    contours: Vec<Contour>,
}

impl Default for Pen {
    fn default() -> Self {
        Pen { scale: 1.0, x_min: f64::INFINITY, start: Vec2::ZERO, at: Vec2::ZERO, contours: Vec::new() }
    }
}

impl Pen {
    fn point(&mut self, x: f32, y: f32) -> Vec2 {
        let point = Vec2::new(x.into(), y.into()) * self.scale;
        self.x_min = self.x_min.min(point.x);
        point
    }

    fn push(&mut self, curve: Curve2, end: Vec2) {
        self.at = end;
        if let Some(contour) = self.contours.last_mut() {
            contour.curves.push(curve);
        }
    }

    fn line(&mut self, end: Vec2) {
        if end != self.at {
            self.push(spline::line(self.at, end), end);
        }
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.start = self.point(x, y);
        self.at = self.start;
        self.contours.push(Contour { curves: Vec::new() });
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let end = self.point(x, y);
        self.line(end);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (p0, p1, p2) = (self.at, self.point(x1, y1), self.point(x, y));
        let (b, c) = (p0 - 2.0 * p1 + p2, 2.0 * (p1 - p0));
        self.push(Curve2 { a: Vec2::ZERO, b, c, d: p0, kind: CurveKind::Quadratic }, p2);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (p1, p2, p3) = (self.point(x1, y1), self.point(x2, y2), self.point(x, y));
        self.push(spline::bezier(self.at, p1, p2, p3), p3);
    }

    fn close(&mut self) {
        let start = self.start;
        self.line(start);
    }
}
