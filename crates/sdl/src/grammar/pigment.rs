//! `pigment { ... }`, and `density { ... }`, which is the same but for a few words.
use std::sync::Arc;

use raggio_math::Affine;
use raggio_scene::{
    Color, ColorMap, Density, ImageMap, Map, Pattern, PatternKind, Pigment, PigmentKind, Wave,
};

use super::image::{self, Usage};
use super::util::{at_color, color, take, until, word};
use super::{default_map, maps, pattern, pattern_kind, warp};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::{Kind, Value};

/// Whether a pigment or a density is being read: they differ in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flavour {
    /// `pigment { }`
    Pigment,
    /// `density { }`
    Density,
}

#[derive(Clone, Debug)]
enum Fill {
    Nothing,
    Solid(Color),
    Colors(Arc<ColorMap>),
    Pigments(Arc<Map<Pigment>>),
    Image(Arc<ImageMap>),
    /// A finished pigment on (u, v), which later modifiers do not reach.
    OnUv(Arc<Pigment>),
}

/// A pigment that is not complete yet.
#[derive(Clone, Debug)]
pub struct Draft {
    flavour: Flavour,
    pattern: pattern::Draft,
    fill: Fill,
    quick_color: Option<Color>,
    uv: bool,
    /// What it still is: a finished pigment that nothing has been added to.
    whole: Option<Arc<Pigment>>,
}

impl Draft {
    /// Begins with a finished pigment, which is to be modified.
    pub fn new(base: &Pigment, flavour: Flavour) -> Self {
        let (pattern, fill) = match &base.kind {
            PigmentKind::Solid { color, warps } => (pattern::Draft::from_warps(warps), Fill::Solid(*color)),
            PigmentKind::ColorMap { pattern, map } => {
                // Colours that a pattern without a list came with leave when it does.
                let own = pattern::block_size(&pattern.kind).is_none()
                    && **map == default_map::colors(&pattern.kind);
                (pattern.as_ref().into(), if own { Fill::Nothing } else { Fill::Colors(map.clone()) })
            }
            PigmentKind::PigmentMap { pattern, map } => {
                (pattern.as_ref().into(), Fill::Pigments(Arc::new(map.clone())))
            }
            PigmentKind::Image { warps, image } => {
                (pattern::Draft::from_warps(warps), Fill::Image(image.clone()))
            }
            PigmentKind::Uv(inner) => (pattern::Draft::default(), Fill::OnUv(inner.clone())),
        };
        Draft { flavour, pattern, fill, quick_color: base.quick_color, uv: false, whole: None }
    }

    /// Values run up and jump back, whatever the pattern's custom is.
    pub fn use_ramp(&mut self) {
        self.pattern.wave = Wave::Ramp;
        self.whole = None;
    }

    /// The finished pigment.
    pub fn finish(self, p: &mut Parser) -> Result<Arc<Pigment>> {
        if let (Some(whole), false) = (&self.whole, self.uv) {
            return Ok(whole.clone());
        }
        let (uv, quick_color) = (self.uv, self.quick_color);
        let kind = self.finished_kind(p)?;
        let uv = uv && !matches!(kind, PigmentKind::Uv(_));
        let pigment = Arc::new(Pigment { kind, quick_color });
        Ok(if uv { Arc::new(Pigment { kind: PigmentKind::Uv(pigment), quick_color }) } else { pigment })
    }

    fn finished_kind(mut self, p: &mut Parser) -> Result<PigmentKind> {
        if let Fill::Image(image) = self.fill {
            return Ok(PigmentKind::Image { warps: self.pattern.warps, image });
        }
        let Some(kind) = self.pattern.kind.take() else {
            return Ok(match self.fill {
                Fill::OnUv(inner) => PigmentKind::Uv(inner),
                Fill::Solid(color) => PigmentKind::Solid { color, warps: self.pattern.warps },
                _ => PigmentKind::Solid { color: Color::BLACK, warps: self.pattern.warps },
            });
        };
        let kind = pattern::checked(p, kind)?;
        let average = matches!(kind, PatternKind::Average);
        let map = match self.fill {
            Fill::Pigments(map) => {
                let pattern = self.pattern.finish(kind);
                return Ok(PigmentKind::PigmentMap { pattern, map: Arc::unwrap_or_clone(map) });
            }
            Fill::Colors(map) if average => return Ok(average_of_colors(self.pattern.finish(kind), &map)),
            Fill::Colors(map) => map,
            _ if average => {
                let span = p.span();
                return p.error("average-without-map", "`average` needs a map of what it averages", span);
            }
            _ => Arc::new(default_map::colors(&kind)),
        };
        Ok(PigmentKind::ColorMap { pattern: self.pattern.finish(kind), map })
    }
}

/// `average color_map { ... }` as a map of plain pigments.
fn average_of_colors(pattern: Arc<Pattern>, colors: &ColorMap) -> PigmentKind {
    let map = colors.iter().map(|&(weight, color)| (weight, Arc::new(Pigment::solid(color)))).collect();
    PigmentKind::PigmentMap { pattern, map }
}

/// `{ ... }` of a pigment that begins as `base`; the word has been read.
pub fn block(p: &mut Parser, base: &Pigment) -> Result<Arc<Pigment>> {
    let mut draft = Draft::new(base, Flavour::Pigment);
    p.block("pigment", |p| item(p, &mut draft))?;
    draft.finish(p)
}

/// `{ ... }` of a density; the word has been read.
pub fn density(p: &mut Parser) -> Result<Density> {
    let mut draft = Draft::new(&Pigment::solid(Color::BLACK), Flavour::Density);
    p.block("density", |p| item(p, &mut draft))?;
    draft.finish(p).map(Density)
}

/// One item of a pigment.
pub fn item(p: &mut Parser, draft: &mut Draft) -> Result<bool> {
    draft.whole = None;
    if at_color(p)? {
        draft.fill = Fill::Solid(color(p)?);
        draft.pattern.kind = None;
        return Ok(true);
    }
    match p.peek()? {
        Tok::Value(Kind::Pigment) if draft.flavour == Flavour::Pigment => {
            let base = take!(p, Pigment);
            *draft = Draft { uv: draft.uv, ..Draft::new(&base, draft.flavour) };
            draft.whole = Some(base);
            return Ok(true);
        }
        Tok::Value(Kind::Density) if draft.flavour == Flavour::Density => {
            *draft = Draft::new(&take!(p, Density).0, draft.flavour);
            return Ok(true);
        }
        Tok::Kw(word) if map_or_image(p, draft, word)? => return Ok(true),
        _ => {}
    }
    if let Some(kind) = named_pattern(p, draft)? {
        if matches!(kind, PatternKind::Facets { .. }) {
            let span = p.span();
            return p.error("facets-outside-normal", "`facets` only works in normals", span);
        }
        draft.pattern.set_kind(kind);
        return Ok(true);
    }
    pattern::modifier(p, &mut draft.pattern)
}

/// The words that say what a pattern's values become.
fn map_or_image(p: &mut Parser, draft: &mut Draft, word: Kw) -> Result<bool> {
    match (word, draft.flavour) {
        (Kw::Color_map | Kw::Colour_map, _) => {
            p.next()?;
            draft.fill = Fill::Colors(maps::color_map(p)?);
        }
        (Kw::Pigment_map, Flavour::Pigment) => {
            p.next()?;
            draft.fill = Fill::Pigments(pigment_map(p)?);
        }
        (Kw::Density_map, Flavour::Density) => {
            p.next()?;
            let map = density_map(p)?;
            draft.fill = Fill::Pigments(Arc::new(map.iter().map(|(v, d)| (*v, d.0.clone())).collect()));
        }
        (Kw::Quick_color | Kw::Quick_colour, _) => {
            p.next()?;
            draft.quick_color = Some(color(p)?).filter(|c| c.rgb.min_element() != -1.0);
        }
        (Kw::Image_map, _) => {
            p.next()?;
            draft.fill = Fill::Image(image::block(p, Usage::Colors)?);
            draft.pattern.kind = None;
        }
        (Kw::Uv_mapping, _) => {
            p.next()?;
            draft.uv = p.flag()?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// A pattern's name, with the list of colours or pigments that a block pattern may have.
fn named_pattern(p: &mut Parser, draft: &mut Draft) -> Result<Option<PatternKind>> {
    let (flavour, mut items) = (draft.flavour, None);
    let grey = matches!(word(p)?, Some(Kw::Spotted | Kw::Bumps));
    let mut list = |p: &mut Parser, size: usize| {
        items = list_items(p, flavour, size)?;
        Ok(items.is_some())
    };
    let Some(kind) = pattern_kind::kind(p, &mut list)? else { return Ok(None) };
    match items {
        Some(Fill::Colors(mut map)) => {
            let defaults = default_map::colors(&kind);
            let missing = map.len()..defaults.len().max(map.len());
            Arc::make_mut(&mut map).extend(&defaults[missing]);
            draft.fill = Fill::Colors(map);
        }
        Some(fill) => draft.fill = fill,
        None if matches!(draft.fill, Fill::Colors(_) | Fill::Pigments(_)) => {}
        None => draft.fill = Fill::Nothing,
    }
    if grey && matches!(draft.fill, Fill::Nothing) {
        draft.fill = Fill::Colors(Arc::new(default_map::grey()));
    }
    Ok(Some(kind))
}

/// The colours or pigments after a block pattern's name.
fn list_items(p: &mut Parser, flavour: Flavour, size: usize) -> Result<Option<Fill>> {
    let word = if flavour == Flavour::Pigment { Kw::Pigment } else { Kw::Density };
    // Here pigments take colours without any of their words: `checker 1, 0`.
    let at_color = |p: &mut Parser| -> Result<bool> {
        Ok(at_color(p)? || (flavour == Flavour::Pigment && p.at_expression()?))
    };
    if at_color(p)? {
        let mut map = ColorMap::new();
        while map.len() < size && at_color(p)? {
            map.push((map.len() as f32, color(p)?));
            p.comma()?;
        }
        return Ok(Some(Fill::Colors(Arc::new(map))));
    }
    let mut map = Map::<Pigment>::new();
    while map.len() < size && p.accept(word)? {
        let pigment = match flavour {
            Flavour::Pigment => {
                let base = p.defaults.pigment();
                block(p, &base)?
            }
            Flavour::Density => density(p)?.0,
        };
        map.push((map.len() as f32, pigment));
        p.comma()?;
    }
    if map.is_empty() {
        return Ok(None);
    }
    let default = p.defaults.pigment();
    map.extend((map.len()..size).map(|i| (i as f32, default.clone())));
    Ok(Some(Fill::Pigments(Arc::new(map))))
}

/// `pigment_map { ... }`; the word has been read.
pub fn pigment_map(p: &mut Parser) -> Result<Arc<Map<Pigment>>> {
    let shared = |value| match value {
        Value::PigmentMap(map) => Some(map),
        _ => None,
    };
    maps::map(p, "pigment_map", Kind::PigmentMap, shared, |p, position, entries| {
        let base = p.defaults.pigment();
        let mut draft = Draft::new(&base, Flavour::Pigment);
        until(p, ']', "pigment_map", |p| match p.accept(Kw::Pigment)? {
            true => {
                draft = Draft::new(&*block(p, &base)?, Flavour::Pigment);
                Ok(true)
            }
            false => item(p, &mut draft),
        })?;
        entries.push((position, draft.finish(p)?));
        Ok(())
    })
}

/// `density_map { ... }`; the word has been read.
pub fn density_map(p: &mut Parser) -> Result<Arc<Map<Density>>> {
    let shared = |value| match value {
        Value::DensityMap(map) => Some(map),
        _ => None,
    };
    maps::map(p, "density_map", Kind::DensityMap, shared, |p, position, entries| {
        let mut draft = Draft::new(&Pigment::solid(Color::BLACK), Flavour::Density);
        until(p, ']', "density_map", |p| match p.accept(Kw::Density)? {
            true => {
                draft = Draft::new(&density(p)?.0, Flavour::Density);
                Ok(true)
            }
            false => item(p, &mut draft),
        })?;
        entries.push((position, Arc::new(Density(draft.finish(p)?))));
        Ok(())
    })
}

/// Moves a pigment. One that lies on (u, v) stays as it is.
pub fn transform(pigment: &mut Arc<Pigment>, t: &Affine) {
    if matches!(pigment.kind, PigmentKind::Uv(_)) {
        return;
    }
    match &mut Arc::make_mut(pigment).kind {
        PigmentKind::Uv(_) => {}
        PigmentKind::ColorMap { pattern, .. } | PigmentKind::PigmentMap { pattern, .. } => {
            warp::transform(&mut Arc::make_mut(pattern).warps, t);
        }
        PigmentKind::Solid { warps, .. } | PigmentKind::Image { warps, .. } => warp::transform(warps, t),
    }
}
