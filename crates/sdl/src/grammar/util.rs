//! Small helpers that every block of the grammar uses: checked numbers, lists, identifiers.
use raggio_math::{Vec2, Vec3};
use raggio_scene::{Color, Rgb};

use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Takes the value of an identifier that `peek` has shown to be of this kind.
macro_rules! take {
    ($parser:expr, $kind:ident) => {
        match $parser.take_value()? {
            crate::value::Value::$kind(value) => value,
            _ => return $parser.expected(concat!("an identifier of kind ", stringify!($kind))),
        }
    };
}
pub(super) use take;

/// Stands for infinity, which divisions by zero give: farther away than anything that is looked at.
const FAR: f64 = 1e12;

/// Numbers that an engine can work with: what is infinite becomes far away. What is no number at all stays only in objects
/// that are left out for it, and is an error elsewhere.
fn tame<const N: usize>(p: &mut Parser, mut values: [f64; N]) -> Result<[f64; N]> {
    if values.iter().all(|v| v.is_finite()) {
        return Ok(values);
    }
    if values.iter().any(|v| v.is_nan()) {
        p.met_undefined("not a number")?;
        return Ok(values);
    }
    let span = p.span();
    p.warn("not-finite", "what stands before here is infinite, from a division by zero; 1e12 is taken", span);
    values.iter_mut().filter(|v| v.is_infinite()).for_each(|v| *v = FAR.copysign(*v));
    Ok(values)
}

/// A finite number.
pub fn float(p: &mut Parser) -> Result<f64> {
    let value = p.float()?;
    tame(p, [value]).map(|[v]| v)
}

/// A finite number in single precision.
pub fn float32(p: &mut Parser) -> Result<f32> {
    Ok(float(p)?.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32)
}

/// A finite number, with a comma before it if there is one.
pub fn comma_float(p: &mut Parser) -> Result<f64> {
    p.comma()?;
    float(p)
}

/// Another number, if one comes next; the comma before it may be missing.
pub fn optional_second(p: &mut Parser) -> Result<Option<f64>> {
    if p.accept_punct(',')? || p.at_expression()? { float(p).map(Some) } else { Ok(None) }
}

/// A finite vector of two.
pub fn vec2(p: &mut Parser) -> Result<Vec2> {
    let value = p.vec2()?;
    tame(p, value.to_array()).map(Vec2::from_array)
}

/// A finite vector of three.
pub fn vec3(p: &mut Parser) -> Result<Vec3> {
    let value = p.vec3()?;
    tame(p, value.to_array()).map(Vec3::from_array)
}

/// A finite vector of three, with a comma before it if there is one.
pub fn comma_vec3(p: &mut Parser) -> Result<Vec3> {
    p.comma()?;
    vec3(p)
}

/// A finite vector of four.
pub fn vec4(p: &mut Parser) -> Result<[f64; 4]> {
    let value = p.vec4()?;
    tame(p, value)
}

/// A colour with finite channels.
pub fn color(p: &mut Parser) -> Result<Color> {
    let Color { rgb, filter, transmit } = p.color()?;
    let channels = [rgb.x, rgb.y, rgb.z, filter, transmit].map(f64::from);
    let [r, g, b, filter, transmit] = tame(p, channels)?.map(|v| v as f32);
    Ok(Color { rgb: Rgb::new(r, g, b), filter, transmit })
}

/// A colour of which only the light counts.
pub fn rgb(p: &mut Parser) -> Result<Rgb> {
    Ok(color(p)?.rgb)
}

/// A number cut to a whole one and held within limits.
pub fn count(p: &mut Parser, least: u32, most: u32) -> Result<u32> {
    let value = float(p)? + raggio_math::EPS;
    Ok((value as i64).clamp(i64::from(least), i64::from(most)) as u32)
}

/// Does a colour come next, by a word that begins one or by a colour identifier?
pub fn at_color(p: &mut Parser) -> Result<bool> {
    Ok(match p.peek()? {
        Tok::Value(Kind::Color) => true,
        Tok::Kw(word) => is_color_word(word),
        _ => false,
    })
}

fn is_color_word(word: Kw) -> bool {
    matches!(
        word,
        Kw::Color
            | Kw::Colour
            | Kw::Rgb
            | Kw::Rgbf
            | Kw::Rgbt
            | Kw::Rgbft
            | Kw::Srgb
            | Kw::Srgbf
            | Kw::Srgbt
            | Kw::Srgbft
            | Kw::Red
            | Kw::Green
            | Kw::Blue
            | Kw::Filter
            | Kw::Transmit
            | Kw::Alpha
    )
}

/// Items up to a closing character that `block` does not know, such as `]`.
pub fn until(
    p: &mut Parser,
    close: char,
    what: &str,
    mut item: impl FnMut(&mut Parser) -> Result<bool>,
) -> Result<()> {
    while !p.accept_punct(close)? {
        if !item(p)? {
            return p.expected(&format!("an item of {what} or `{close}`"));
        }
    }
    Ok(())
}

/// The reserved word that comes next, if one does.
pub fn word(p: &mut Parser) -> Result<Option<Kw>> {
    Ok(match p.peek()? {
        Tok::Kw(word) => Some(word),
        _ => None,
    })
}

/// Consumes a word and reads a number into its place.
pub fn set(p: &mut Parser, place: &mut f64) -> Result<bool> {
    p.next()?;
    *place = float(p)?;
    Ok(true)
}

/// Consumes a word and reads a number in single precision into its place.
pub fn set32(p: &mut Parser, place: &mut f32) -> Result<bool> {
    p.next()?;
    *place = float32(p)?;
    Ok(true)
}

/// Consumes a word and reads a vector into its place.
pub fn set_vec3(p: &mut Parser, place: &mut Vec3) -> Result<bool> {
    p.next()?;
    *place = vec3(p)?;
    Ok(true)
}

/// Consumes a word and reads a flag into its place.
pub fn set_flag(p: &mut Parser, place: &mut bool) -> Result<bool> {
    p.next()?;
    *place = p.flag()?;
    Ok(true)
}

/// Consumes a word and reads the light of a colour into its place.
pub fn set_rgb(p: &mut Parser, place: &mut Rgb) -> Result<bool> {
    p.next()?;
    *place = rgb(p)?;
    Ok(true)
}

/// Consumes a word and reads a whole number within limits into its place.
pub fn set_count(p: &mut Parser, place: &mut u32, least: u32, most: u32) -> Result<bool> {
    p.next()?;
    *place = count(p, least, most)?;
    Ok(true)
}
