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
