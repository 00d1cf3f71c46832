//! Maps: `[value item]` entries between braces (textures spec, section 9.1).
use std::sync::Arc;

use raggio_scene::{Color, ColorMap};

use super::util::{at_color, color, float32, vec2};
use crate::parser::{Parser, Result, Tok};
use crate::value::{Kind, Value};

/// The most entries that a map may have.
const MOST_ENTRIES: usize = 65_536;

/// The entries of a slope map: position, height, slope.
pub type SlopeMap = Vec<(f32, f32, f32)>;

/// Reads `{ IDENTIFIER }` or `{ [value item] ... }`. `shared` opens the value of an identifier of the given kind; `entry`
/// reads what follows `[value` up to and with `]`, and adds to the list.
pub fn map<E>(
    p: &mut Parser,
    what: &str,
    kind: Kind,
    shared: impl Fn(Value) -> Option<Arc<Vec<E>>>,
    mut entry: impl FnMut(&mut Parser, f32, &mut Vec<E>) -> Result<()>,
) -> Result<Arc<Vec<E>>> {
    let span = p.span();
    let mut copied = None;
    let mut entries = Vec::new();
    p.block(what, |p| {
        if copied.is_none() && entries.is_empty() && p.peek()? == Tok::Value(kind) {
            copied = shared(p.take_value()?);
            return Ok(true);
        }
        if !p.accept_punct('[')? {
            return p.accept_punct(',');
        }
        // In an average the number is a weight, which may be left out.
        let value = if p.at_expression()? { float32(p)? } else { 1.0 };
        p.comma()?;
        entry(p, value, &mut entries)?;
        Ok(true)
    })?;
    if let Some(map) = copied {
        return Ok(map);
    }
    if entries.is_empty() || entries.len() > MOST_ENTRIES {
        let message = format!("{what} needs at least one entry and takes at most {MOST_ENTRIES}");
        return p.error("bad-map", message, span);
    }
    Ok(Arc::new(entries))
}

/// `color_map { ... }`; the word has been read.
pub fn color_map(p: &mut Parser) -> Result<Arc<ColorMap>> {
    let shared = |value| match value {
        Value::ColorMap(map) => Some(map),
        _ => None,
    };
    map(p, "color_map", Kind::ColorMap, shared, |p, position, entries| {
        color_entry(p, position, entries)?;
        p.expect(']')
    })
}

/// `color`, or the old `second_position color color`.
fn color_entry(p: &mut Parser, position: f32, entries: &mut ColorMap) -> Result<()> {
    if at_color(p)? {
        push_color(entries, position, color(p)?);
        return Ok(());
    }
    let (numbers, size) = p.tuple()?;
    p.comma()?;
    if size > 1 || !at_color(p)? {
        push_color(entries, position, Color::from_array(numbers));
        return Ok(());
    }
    push_color(entries, position, color(p)?);
    p.comma()?;
    push_color(entries, numbers[0] as f32, color(p)?);
    Ok(())
}

/// Adds an entry unless it repeats the one before.
fn push_color(entries: &mut ColorMap, position: f32, color: Color) {
    if entries.last() != Some(&(position, color)) {
        entries.push((position, color));
    }
}

/// `slope_map { [position <height, slope>] ... }`; the word has been read.
pub fn slope_map(p: &mut Parser) -> Result<Arc<SlopeMap>> {
    let shared = |value| match value {
        Value::SlopeMap(map) => Some(map),
        _ => None,
    };
    map(p, "slope_map", Kind::SlopeMap, shared, |p, position, entries| {
        let v = vec2(p)?;
        entries.push((position, v.x as f32, v.y as f32));
        p.expect(']')
    })
}
