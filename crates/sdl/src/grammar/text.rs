//! `text { ... }`: where each glyph of a string stands (shapes spec, section 6).
use std::sync::Arc;

use raggio_math::{Vec2, Vec3, transform};
use raggio_scene::{Glyph, Object, Shape};

use super::font::{Font, bytes};
use super::object::{self, of_shape};
use super::util::{comma_float, comma_vec3};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `text { ttf "file" "string" depth, offset }` or `text { internal n "string" depth, offset }`
pub fn text(p: &mut Parser) -> Result<Object> {
    object::build(p, "text", |p| {
        let span = p.span();
        let name: Arc<str> = if p.accept(Kw::Internal)? {
            built_in(super::util::float(p)? as i64).into()
        } else if p.accept(Kw::Ttf)? {
            p.path()?
        } else {
            return p.expected("`ttf` or `internal`");
        };
        let data = bytes(p, &name)?;
        let Some(font) = Font::new(&data) else {
            return p.error("bad-font", format!("\"{name}\" is not a TrueType font"), span);
        };
        p.comma()?;
        let string = p.string()?;
        let depth = comma_float(p)?;
        let offset = comma_vec3(p)?.truncate();
        let glyphs = layout(&font, &string, offset).into();
        let mut object = of_shape(Shape::Text { glyphs, depth });
        // The language turns every text by this trifle, which can be seen in its normals.
        object.transform(&transform::rotate(Vec3::splat(0.001)));
        Ok(object)
    })
}

/// The file of one of the language's own fonts.
fn built_in(number: i64) -> &'static str {
    match number {
        1 => "timrom.ttf",
        2 => "cyrvetic.ttf",
        3 => "crystal.ttf",
        _ => "povlogo.ttf",
    }
}

/// The glyphs that can be seen, at their places.
fn layout(font: &Font, string: &str, offset: Vec2) -> Vec<Glyph> {
    let mut glyphs = Vec::new();
    let (mut pen, mut before) = (Vec2::ZERO, None);
    for c in string.chars() {
        let id = font.glyph(c);
        let outline = font.outline(id);
        let (advance, lsb) = (font.advance(id), font.side_bearing(id));
        let place = match before {
            None => {
                pen.x = advance - lsb;
                Vec2::new(-outline.x_min, 0.0)
            }
            Some(before) => {
                let kern = font.kerning(before, id);
                let place = pen + Vec2::new(lsb - outline.x_min, 0.0) + kern;
                pen.x += advance + kern.x;
                place
            }
        };
        pen += offset;
        before = Some(id);
        if !outline.contours.is_empty() {
            glyphs.push(Glyph { offset: place, contours: outline.contours });
        }
    }
    glyphs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn be(words: &[i16]) -> Vec<u8> {
        words.iter().flat_map(|w| w.to_be_bytes()).collect()
    }

    /// One contour, a rectangle from (x, 0) to (x + 200, 500), whose header tells of `x_min`.
    fn rectangle(x: i16, x_min: i16) -> Vec<u8> {
        let mut glyph = be(&[1, x_min, 0, x + 200, 500, 3, 0]);
        glyph.extend([1u8; 4]);
        glyph.extend(be(&[x, 200, 0, -200, 0, 0, 500, 0]));
        glyph
    }

    /// A font of 1000 units an em: glyph 1 for `A`, glyph 2 for `j`, glyph 3 for the blank.
    fn font() -> Vec<u8> {
        let (a, j) = (rectangle(50, 50), rectangle(-60, -60));
        let mut head = vec![0; 54];
        head[18..20].copy_from_slice(&1000u16.to_be_bytes());
        let mut hhea = vec![0; 36];
        hhea[34..36].copy_from_slice(&4u16.to_be_bytes());
        let mut maxp = be(&[1, 0, 4]);
        maxp.resize(32, 0);
        let hmtx = be(&[0, 0, 400, 50, 300, -60, 250, 0]);
        let half = |n: usize| (n / 2) as i16;
        let loca = be(&[0, 0, half(a.len()), half(a.len() + j.len()), half(a.len() + j.len())]);
        let mut map = [0u8; 256];
        (map[usize::from(b'A')], map[usize::from(b'j')], map[usize::from(b' ')]) = (1, 2, 3);
        let cmap = [be(&[0, 1, 1, 0, 0, 12, 0, 262, 0]), map.to_vec()].concat();
        // The pairs stand in no order.
        let kern = be(&[0, 1, 0, 26, 1, 2, 0, 0, 0, 2, 1, -30, 1, 2, -20]);
        let tables: [(&[u8; 4], Vec<u8>); 8] = [
            (b"cmap", cmap),
            (b"glyf", [a, j].concat()),
            (b"head", head),
            (b"hhea", hhea),
            (b"hmtx", hmtx),
            (b"kern", kern),
            (b"loca", loca),
            (b"maxp", maxp),
        ];
        let (mut file, mut data) = (be(&[1, 0, 8, 0, 0, 0]), Vec::new());
        for (tag, table) in &tables {
            file.extend_from_slice(*tag);
            file.extend([0; 4]);
            file.extend((12 + 16 * 8 + data.len() as u32).to_be_bytes());
            file.extend((table.len() as u32).to_be_bytes());
            data.extend_from_slice(table);
            data.resize(data.len().next_multiple_of(4), 0);
        }
        [file, data].concat()
    }

    #[track_caller]
    fn check(string: &str, offset: Vec2, expected: &[(f64, f64)]) {
        let bytes = font();
        let glyphs = layout(&Font::new(&bytes).expect("a font"), string, offset);
        assert_eq!(glyphs.len(), expected.len(), "{string}");
        for (glyph, &(x, y)) in glyphs.iter().zip(expected) {
            assert!((glyph.offset - Vec2::new(x, y)).length() < 1e-9, "{string}: {}", glyph.offset);
        }
    }

    #[test]
    fn the_first_glyph_begins_at_zero_and_pairs_move_together() {
        check("A", Vec2::ZERO, &[(-0.05, 0.0)]);
        check("AA", Vec2::ZERO, &[(-0.05, 0.0), (0.35, 0.0)]);
        check("Aj", Vec2::ZERO, &[(-0.05, 0.0), (0.33, 0.0)]);
        check("jA", Vec2::ZERO, &[(0.06, 0.0), (0.33, 0.0)]);
    }

    #[test]
    fn blanks_advance_and_offsets_add_up() {
        check("A A", Vec2::ZERO, &[(-0.05, 0.0), (0.6, 0.0)]);
        check("AAA", Vec2::new(0.1, 0.2), &[(-0.05, 0.0), (0.45, 0.2), (0.95, 0.4)]);
        check("", Vec2::ONE, &[]);
    }

    #[test]
    fn outlines_are_in_units_of_an_em() {
        let bytes = font();
        let glyphs = layout(&Font::new(&bytes).expect("a font"), "A", Vec2::ZERO);
        let [contour] = &*glyphs[0].contours else { panic!("{glyphs:?}") };
        assert_eq!(contour.curves.len(), 4);
        assert_eq!(contour.curves[0].d, Vec2::new(0.05, 0.0));
    }
}
