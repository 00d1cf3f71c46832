//! `normal { ... }` (textures spec, section 8).
use std::sync::Arc;

use raggio_math::Affine;
use raggio_scene::{ImageMap, Map, Normal, NormalKind, NormalPattern, PatternKind};

use super::image::{self, Usage};
use super::util::{set_flag, set32, take, until, word};
use super::{maps, pattern, pattern_kind, warp};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::{Kind, Value};

/// The bump size of normals that name none.
pub const BUMP_SIZE: f32 = 0.5;

/// A normal that is not complete yet.
#[derive(Clone, Debug)]
pub struct Draft {
    pattern: pattern::Draft,
    /// `bumps` shares its formula with `bozo`, but not its way to bend normals.
    bumps: bool,
    map: Option<Arc<Map<Normal>>>,
    slope_map: Option<Arc<maps::SlopeMap>>,
    image: Option<Arc<ImageMap>>,
    /// A finished normal on (u, v), which later modifiers do not reach.
    on_uv: Option<Arc<Normal>>,
    amount: f32,
    accuracy: f32,
    no_bump_scale: bool,
    uv: bool,
}

impl Draft {
    /// Begins with a finished normal, which is to be modified, or with none.
    pub fn new(base: Option<&Normal>) -> Self {
        let mut draft = Draft {
            pattern: pattern::Draft::default(),
            bumps: false,
            map: None,
            slope_map: None,
            image: None,
            on_uv: None,
            amount: BUMP_SIZE,
            accuracy: 0.02,
            no_bump_scale: false,
            uv: false,
        };
        let Some(base) = base else { return draft };
        match &base.kind {
            NormalKind::Special { pattern, settings } => {
                draft.pattern = settings.as_ref().into();
                draft.bumps = *pattern == NormalPattern::Bumps;
            }
            NormalKind::Slope { pattern, map } => {
                draft.pattern = pattern.as_ref().into();
                draft.slope_map = map.clone().map(Arc::new);
            }
            NormalKind::Map { pattern, map } => {
                draft.pattern = pattern.as_ref().into();
                draft.map = Some(Arc::new(map.clone()));
            }
            NormalKind::Bump { warps, image } => {
                draft.pattern = pattern::Draft::from_warps(warps);
                draft.image = Some(image.clone());
            }
            NormalKind::Uv(inner) => draft.on_uv = Some(inner.clone()),
        }
        Draft { amount: base.amount, accuracy: base.accuracy, no_bump_scale: base.no_bump_scale, ..draft }
    }

    /// How often its pattern repeats.
    pub fn set_frequency(&mut self, frequency: f32) {
        self.pattern.frequency = frequency;
    }

    /// How much it bends.
    pub fn bump_size(&self) -> f32 {
        self.amount
    }

    /// The finished normal; `None` if no pattern has been named.
    pub fn finish(self, p: &mut Parser) -> Result<Option<Arc<Normal>>> {
        let (amount, accuracy, no_bump_scale, uv) = (self.amount, self.accuracy, self.no_bump_scale, self.uv);
        let wrap = |kind| Arc::new(Normal { kind, amount, accuracy, no_bump_scale });
        let Some(kind) = self.finished_kind(p)? else { return Ok(None) };
        let uv = uv && !matches!(kind, NormalKind::Uv(_));
        Ok(Some(if uv { wrap(NormalKind::Uv(wrap(kind))) } else { wrap(kind) }))
    }

    fn finished_kind(mut self, p: &mut Parser) -> Result<Option<NormalKind>> {
        if let Some(image) = self.image {
            return Ok(Some(NormalKind::Bump { warps: self.pattern.warps, image }));
        }
        let Some(kind) = self.pattern.kind.take() else { return Ok(self.on_uv.map(NormalKind::Uv)) };
        let kind = pattern::checked(p, kind)?;
        if let Some(map) = self.map {
            let pattern = self.pattern.finish(kind);
            return Ok(Some(NormalKind::Map { pattern, map: Arc::unwrap_or_clone(map) }));
        }
        if let Some(pattern) = special(&kind, self.bumps) {
            return Ok(Some(NormalKind::Special { pattern, settings: self.pattern.finish(kind) }));
        }
        if matches!(kind, PatternKind::Average) {
            let span = p.span();
            return p.error("average-without-map", "`average` needs a normal_map of what it averages", span);
        }
        let map = self.slope_map.map(Arc::unwrap_or_clone);
        Ok(Some(NormalKind::Slope { pattern: self.pattern.finish(kind), map }))
    }
}

/// The patterns that bend normals by a rule of their own; slope maps have no meaning for them.
fn special(kind: &PatternKind, bumps: bool) -> Option<NormalPattern> {
    Some(match *kind {
        PatternKind::Bozo if bumps => NormalPattern::Bumps,
        PatternKind::Dents => NormalPattern::Dents,
        PatternKind::Wrinkles => NormalPattern::Wrinkles,
        PatternKind::Quilted { control0, control1 } => NormalPattern::Quilted { control0, control1 },
        PatternKind::Ripples => NormalPattern::Ripples,
        PatternKind::Waves => NormalPattern::Waves,
        PatternKind::Facets { size, coords, metric } => NormalPattern::Facets { size, coords, metric },
        _ => return None,
    })
}

/// `{ ... }` of a normal that begins as `base`; the word has been read.
pub fn block(p: &mut Parser, base: Option<&Normal>) -> Result<Option<Arc<Normal>>> {
    read(p, base)?.finish(p)
}

/// The same, not finished.
pub fn read(p: &mut Parser, base: Option<&Normal>) -> Result<Draft> {
    let mut draft = begin(p, base);
    p.block("normal", |p| item(p, &mut draft))?;
    Ok(draft)
}

/// A draft with the default bump size where nothing else gives one.
fn begin(p: &Parser, base: Option<&Normal>) -> Draft {
    let draft = Draft::new(base);
    if base.is_some() { draft } else { Draft { amount: p.defaults.bump_size, ..draft } }
}

/// One item of a normal.
pub fn item(p: &mut Parser, draft: &mut Draft) -> Result<bool> {
    match p.peek()? {
        Tok::Value(Kind::Normal) => {
            let base = take!(p, Normal);
            *draft = Draft { uv: draft.uv, ..Draft::new(Some(&base)) };
            return Ok(true);
        }
        Tok::Kw(word) if own_word(p, draft, word)? => return Ok(true),
        _ => {}
    }
    let bumps = word(p)? == Some(Kw::Bumps);
    let mut items = None;
    let mut list = |p: &mut Parser, size: usize| {
        items = list_items(p, size)?;
        Ok(items.is_some())
    };
    if let Some(kind) = pattern_kind::kind(p, &mut list)? {
        draft.pattern.set_kind(kind);
        draft.bumps = bumps;
        draft.image = None;
        match items {
            Some(map) => draft.map = Some(Arc::new(map)),
            None => draft.amount = pattern::amount(p)?.unwrap_or(draft.amount),
        }
        return Ok(true);
    }
    pattern::modifier(p, &mut draft.pattern)
}

/// The words that only normals know.
fn own_word(p: &mut Parser, draft: &mut Draft, word: Kw) -> Result<bool> {
    match word {
        Kw::Normal_map => {
            p.next()?;
            draft.map = Some(normal_map(p)?);
        }
        Kw::Slope_map => {
            p.next()?;
            draft.slope_map = Some(maps::slope_map(p)?);
        }
        Kw::Bump_map => {
            p.next()?;
            let mut size = draft.amount;
            let mut bump_size = |p: &mut Parser| match p.accept(Kw::Bump_size)? {
                true => super::util::float32(p).map(|n| {
                    size = n;
                    true
                }),
                false => Ok(false),
            };
            draft.image = Some(image::block_with(p, Usage::Bump, &mut bump_size)?);
            draft.amount = size;
            draft.pattern.kind = None;
        }
        Kw::Bump_size => return set32(p, &mut draft.amount),
        Kw::Accuracy => return set32(p, &mut draft.accuracy),
        Kw::No_bump_scale => return set_flag(p, &mut draft.no_bump_scale),
        Kw::Uv_mapping => return set_flag(p, &mut draft.uv),
        _ => return Ok(false),
    }
    Ok(true)
}

/// The normals after a block pattern's name; missing ones are the default texture's.
fn list_items(p: &mut Parser, size: usize) -> Result<Option<Map<Normal>>> {
    p.comma()?;
    let default = p.defaults.normal();
    let mut map = Map::<Normal>::new();
    while map.len() < size && p.accept(Kw::Normal)? {
        let normal = block(p, default.as_deref())?.unwrap_or_else(flat);
        map.push((map.len() as f32, normal));
        p.comma()?;
    }
    if map.is_empty() {
        return Ok(None);
    }
    let filler = default.unwrap_or_else(flat);
    map.extend((map.len()..size).map(|i| (i as f32, filler.clone())));
    Ok(Some(map))
}

/// A normal that bends nothing, for entries without a pattern.
pub fn flat() -> Arc<Normal> {
    let settings = pattern::Draft::default().finish(PatternKind::Bozo);
    let kind = NormalKind::Special { pattern: NormalPattern::Bumps, settings };
    Arc::new(Normal { kind, amount: 0.0, accuracy: 0.02, no_bump_scale: false })
}

/// `normal_map { ... }`; the word has been read.
pub fn normal_map(p: &mut Parser) -> Result<Arc<Map<Normal>>> {
    let shared = |value| match value {
        Value::NormalMap(map) => Some(map),
        _ => None,
    };
    maps::map(p, "normal_map", Kind::NormalMap, shared, |p, position, entries| {
        let base = p.defaults.normal();
        let mut draft = begin(p, base.as_deref());
        until(p, ']', "normal_map", |p| match p.accept(Kw::Normal)? {
            true => {
                draft = read(p, base.as_deref())?;
                Ok(true)
            }
            false => item(p, &mut draft),
        })?;
        entries.push((position, draft.finish(p)?.unwrap_or_else(flat)));
        Ok(())
    })
}

/// Moves a normal. One that lies on (u, v) stays as it is.
pub fn transform(normal: &mut Arc<Normal>, t: &Affine) {
    if matches!(normal.kind, NormalKind::Uv(_)) {
        return;
    }
    match &mut Arc::make_mut(normal).kind {
        NormalKind::Special { settings: pattern, .. }
        | NormalKind::Slope { pattern, .. }
        | NormalKind::Map { pattern, .. } => warp::transform(&mut Arc::make_mut(pattern).warps, t),
        NormalKind::Bump { warps, .. } => warp::transform(warps, t),
        NormalKind::Uv(_) => {}
    }
}
