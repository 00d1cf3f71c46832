//! `texture { ... }`: layers, patterned textures, `tiles`, `material_map`.
use std::sync::Arc;

use raggio_math::Affine;
use raggio_scene::{
    Layer, Map, Normal, NormalKind, PatternKind, Pigment, PigmentKind, Texture, TextureKind, Warp,
};

use super::image::{self, Usage};
use super::util::{set_flag, take, until, word};
use super::{finish, loose, maps, normal, old_layers, pattern, pattern_kind, pigment, warp};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::{Kind, Value};

/// A texture that is not complete yet.
struct Draft {
    texture: Texture,
    /// Set once a pattern has been named: then the texture chooses among those of `map`.
    pattern: Option<pattern::Draft>,
    map: Option<Arc<Map<Texture>>>,
    no_bump_scale: bool,
    uv: bool,
}

impl Draft {
    fn new(base: Texture) -> Self {
        Draft { texture: base, pattern: None, map: None, no_bump_scale: false, uv: false }
    }

    fn finish(self, p: &mut Parser) -> Result<Texture> {
        let mut texture = match self.pattern {
            Some(draft) => patterned(p, draft, self.map)?,
            None => self.texture,
        };
        if self.no_bump_scale {
            set_no_bump_scale(&mut texture);
        }
        Ok(if self.uv { on_uv(texture) } else { texture })
    }
}

fn patterned(p: &mut Parser, mut draft: pattern::Draft, map: Option<Arc<Map<Texture>>>) -> Result<Texture> {
    let span = p.span();
    let Some(kind) = draft.kind.take() else { return p.expected("a pattern") };
    let kind = pattern::checked(p, kind)?;
    match map {
        Some(map) => Ok(Texture {
            kind: TextureKind::Patterned { pattern: draft.finish(kind), map: Arc::unwrap_or_clone(map) },
        }),
        None => p.error("texture-without-map", "a texture with a pattern needs a texture_map", span),
    }
}

/// `uv_mapping` of a whole texture: for layers it is that of their pigments and normals.
fn on_uv(mut texture: Texture) -> Texture {
    let TextureKind::Layers(layers) = &mut texture.kind else {
        return Texture { kind: TextureKind::Uv(Arc::new(texture)) };
    };
    for layer in layers {
        if !matches!(layer.pigment.kind, PigmentKind::Uv(_)) {
            let (kind, quick_color) = (PigmentKind::Uv(layer.pigment.clone()), layer.pigment.quick_color);
            layer.pigment = Arc::new(Pigment { kind, quick_color });
        }
        if let Some(normal) = &mut layer.normal
            && !matches!(normal.kind, NormalKind::Uv(_))
        {
            *normal = Arc::new(Normal { kind: NormalKind::Uv(normal.clone()), ..(**normal).clone() });
        }
    }
    texture
}

/// The word counts for every normal inside.
fn set_no_bump_scale(texture: &mut Texture) {
    match &mut texture.kind {
        TextureKind::Layers(layers) => {
            for normal in layers.iter_mut().filter_map(|layer| layer.normal.as_mut()) {
                Arc::make_mut(normal).no_bump_scale = true;
            }
        }
        TextureKind::Patterned { map, .. } => {
            map.iter_mut().for_each(|(_, texture)| set_no_bump_scale(Arc::make_mut(texture)));
        }
        TextureKind::MaterialMap { textures, .. } => {
            textures.iter_mut().for_each(|texture| set_no_bump_scale(Arc::make_mut(texture)));
        }
        TextureKind::Uv(inner) => set_no_bump_scale(Arc::make_mut(inner)),
    }
}

/// `{ ... }` of a texture; the word has been read.
pub fn block(p: &mut Parser) -> Result<Texture> {
    let mut draft = Draft::new((*p.defaults.texture).clone());
    p.block("texture", |p| item(p, &mut draft))?;
    draft.finish(p)
}

/// `texture { } texture { } ...`: all layers; the first word has not been read. A macro call behind a layer is left
/// alone: it may want the very texture that is being declared.
pub fn layers(p: &mut Parser) -> Result<Option<Texture>> {
    let mut texture: Option<Texture> = None;
    while (texture.is_none() || !p.next_is_name()) && word(p)? == Some(Kw::Texture) {
        p.next()?;
        let over = block(p)?;
        texture = Some(match texture {
            Some(under) => layered(p, under, over)?,
            None => over,
        });
    }
    Ok(texture)
}

/// Puts one texture over another; patterned ones cannot be layered.
pub fn layered(p: &mut Parser, mut under: Texture, mut over: Texture) -> Result<Texture> {
    old_layers::settle(p, &mut over, 0);
    match (&mut under.kind, over.kind) {
        (TextureKind::Layers(layers), TextureKind::Layers(more)) => layers.extend(more),
        _ => {
            let span = p.span();
            return p.error("layered-pattern", "patterned textures cannot be layered", span);
        }
    }
    Ok(under)
}

fn item(p: &mut Parser, draft: &mut Draft) -> Result<bool> {
    if let Some(pattern) = &mut draft.pattern {
        return patterned_item(p, pattern, &mut draft.map);
    }
    if let Some(t) = p.accept_transform()? {
        transform(&mut draft.texture, &t);
        return Ok(true);
    }
    match p.peek()? {
        Tok::Value(Kind::Texture) => {
            draft.texture = Arc::unwrap_or_clone(take!(p, Texture));
            old_layers::settle(p, &mut draft.texture, 1);
            Ok(true)
        }
        Tok::Value(Kind::Pigment) => {
            let pigment = take!(p, Pigment);
            top_layer(p, &mut draft.texture)?.pigment = pigment;
            Ok(true)
        }
        Tok::Value(Kind::Normal) => {
            let normal = take!(p, Normal);
            top_layer(p, &mut draft.texture)?.normal = Some(normal);
            Ok(true)
        }
        Tok::Value(Kind::Finish) => {
            let finish = take!(p, Finish);
            top_layer(p, &mut draft.texture)?.finish = *finish;
            Ok(true)
        }
        Tok::Value(Kind::Color) => loose::items(p, &mut draft.texture),
        Tok::Kw(word) => keyword(p, draft, word),
        _ => loose::crand(p, &mut draft.texture),
    }
}

fn keyword(p: &mut Parser, draft: &mut Draft, word: Kw) -> Result<bool> {
    match word {
        Kw::Pigment | Kw::Normal | Kw::Finish => layer_part(p, &mut draft.texture, word),
        Kw::Uv_mapping => set_flag(p, &mut draft.uv),
        Kw::No_bump_scale => set_flag(p, &mut draft.no_bump_scale),
        Kw::Tiles => {
            draft.texture = tiles(p)?;
            Ok(true)
        }
        Kw::Material_map => {
            p.next()?;
            draft.texture = material_map(p)?;
            Ok(true)
        }
        _ if p.settings.version.language < 150 => loose::items(p, &mut draft.texture),
        _ => {
            let mut map = None;
            let mut list = |p: &mut Parser, size: usize| {
                map = list_items(p, size)?;
                Ok(map.is_some())
            };
            let Some(kind) = pattern_kind::kind(p, &mut list)? else {
                return loose::items(p, &mut draft.texture);
            };
            let mut pattern = pattern::Draft::default();
            pattern.set_kind(kind);
            (draft.pattern, draft.map) = (Some(pattern), map.map(Arc::new));
            Ok(true)
        }
    }
}

/// What may follow a texture's pattern.
fn patterned_item(
    p: &mut Parser,
    pattern: &mut pattern::Draft,
    map: &mut Option<Arc<Map<Texture>>>,
) -> Result<bool> {
    if p.accept(Kw::Texture_map)? {
        *map = Some(texture_map(p)?);
        return Ok(true);
    }
    pattern::modifier(p, pattern)
}

/// `pigment`, `normal` or `finish`, which modifies that of the top layer.
pub fn layer_part(p: &mut Parser, texture: &mut Texture, word: Kw) -> Result<bool> {
    p.next()?;
    let layer = top_layer(p, texture)?;
    match word {
        Kw::Pigment => layer.pigment = pigment::block(p, &layer.pigment)?,
        Kw::Normal => layer.normal = normal::block(p, layer.normal.as_deref())?,
        _ => layer.finish = finish::block(p, layer.finish)?,
    }
    Ok(true)
}

/// The layer that `pigment`, `normal` and `finish` change.
pub fn top_layer<'t>(p: &mut Parser, texture: &'t mut Texture) -> Result<&'t mut Layer> {
    let span = p.span();
    if let TextureKind::Layers(layers) = &mut texture.kind
        && let Some(layer) = layers.last_mut()
    {
        return Ok(layer);
    }
    p.error(
        "patterned-texture",
        "a patterned texture has no pigment, normal or finish of its own to change",
        span,
    )
}

/// The textures after a block pattern's name; missing ones are the default texture.
fn list_items(p: &mut Parser, size: usize) -> Result<Option<Map<Texture>>> {
    let mut map = Map::<Texture>::new();
    while map.len() < size && p.accept(Kw::Texture)? {
        let texture = Arc::new(block(p)?);
        map.push((map.len() as f32, texture));
        p.comma()?;
    }
    if map.is_empty() {
        return Ok(None);
    }
    let default = p.defaults.texture.clone();
    map.extend((map.len()..size).map(|i| (i as f32, default.clone())));
    Ok(Some(map))
}

/// `tiles { texture { } tile2 texture { } }`: a checker of two textures, the second where the checker has its first.
fn tiles(p: &mut Parser) -> Result<Texture> {
    p.next()?;
    let (mut both, mut current) = ([None, None], 0);
    p.block("tiles", |p| {
        if p.accept(Kw::Tile2)? {
            current = 1;
            return Ok(true);
        }
        match layers(p)? {
            Some(texture) => both[current] = Some(Arc::new(texture)),
            None => return Ok(false),
        }
        Ok(true)
    })?;
    let default = &p.defaults.texture;
    let [first, second] = both.map(|t| t.unwrap_or_else(|| default.clone()));
    let mut pattern = pattern::Draft::default();
    pattern.set_kind(PatternKind::Checker);
    let pattern = pattern.finish(PatternKind::Checker);
    Ok(Texture { kind: TextureKind::Patterned { pattern, map: vec![(0.0, second), (1.0, first)] } })
}

/// `material_map { image texture { } ... }`; the word has been read.
fn material_map(p: &mut Parser) -> Result<Texture> {
    let mut textures = Vec::new();
    let mut warps: Vec<Warp> = Vec::new();
    let mut extra = |p: &mut Parser| {
        if warp::item(p, &mut warps)? {
            return Ok(true);
        }
        if !p.accept(Kw::Texture)? {
            return Ok(false);
        }
        textures.push(Arc::new(block(p)?));
        Ok(true)
    };
    let span = p.span();
    let image = image::block_with(p, Usage::Material, &mut extra)?;
    if textures.is_empty() {
        return p.error("empty-material-map", "a material_map needs at least one texture", span);
    }
    Ok(Texture { kind: TextureKind::MaterialMap { warps, image, textures } })
}

/// `texture_map { ... }`; the word has been read.
pub fn texture_map(p: &mut Parser) -> Result<Arc<Map<Texture>>> {
    let shared = |value| match value {
        Value::TextureMap(map) => Some(map),
        _ => None,
    };
    maps::map(p, "texture_map", Kind::TextureMap, shared, |p, position, entries| {
        let mut draft = Draft::new((*p.defaults.texture).clone());
        until(p, ']', "texture_map", |p| match layers(p)? {
            Some(texture) => {
                draft = Draft::new(texture);
                Ok(true)
            }
            None => item(p, &mut draft),
        })?;
        entries.push((position, Arc::new(draft.finish(p)?)));
        Ok(())
    })
}

/// Moves a texture: the pigments and normals of its layers, or the pattern that chooses. One on (u, v) stays.
pub fn transform(texture: &mut Texture, t: &Affine) {
    match &mut texture.kind {
        TextureKind::Layers(layers) => {
            for layer in layers {
                pigment::transform(&mut layer.pigment, t);
                if let Some(normal) = &mut layer.normal {
                    normal::transform(normal, t);
                }
            }
        }
        TextureKind::Patterned { pattern, .. } => warp::transform(&mut Arc::make_mut(pattern).warps, t),
        TextureKind::MaterialMap { warps, .. } => warp::transform(warps, t),
        TextureKind::Uv(_) => {}
    }
}
