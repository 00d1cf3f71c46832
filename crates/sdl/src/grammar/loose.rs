//! Words of pigments, normals and finishes that stand directly in a texture, as they did before version 1.5.
use raggio_scene::Texture;

use super::texture::top_layer;
use super::util::{at_color, float32, word};
use super::{finish, normal, pigment};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// All such words that come next; those of the pigment belong together, in whatever order they come. Is there one?
pub fn items(p: &mut Parser, texture: &mut Texture) -> Result<bool> {
    let (mut loose, mut any) = (None, false);
    while item(p, texture, &mut loose)? {
        any = true;
    }
    if let Some(draft) = loose {
        top_layer(p, texture)?.pigment = draft.finish(p)?;
    }
    Ok(any)
}

fn item(p: &mut Parser, texture: &mut Texture, loose: &mut Option<pigment::Draft>) -> Result<bool> {
    let (span, word) = (p.span(), word(p)?);
    let layer = top_layer(p, texture)?;
    let mut new_finish = finish::Draft::new(layer.finish);
    if finish::item(p, &mut new_finish)? {
        layer.finish = new_finish.finish();
        p.warn("loose-finish", "this word belongs in a `finish` block", span);
        return Ok(true);
    }
    let old = p.settings.version.language < 150;
    if old && is_old_normal(word) {
        let mut new_normal = normal::Draft::new(layer.normal.as_deref());
        normal::item(p, &mut new_normal)?;
        layer.normal = new_normal.finish(p)?;
        p.warn("loose-normal", "this word belongs in a `normal` block", span);
        return Ok(true);
    }
    let color = at_color(p)?;
    if !color && (!old || word.is_none_or(is_transform)) {
        return Ok(false);
    }
    let begun = loose.is_some();
    let new = || pigment::Draft::new(&layer.pigment, pigment::Flavour::Pigment);
    let draft = loose.get_or_insert_with(new);
    let found = pigment::item(p, draft)?;
    if found {
        p.warn("loose-pigment", "this word belongs in a `pigment` block", span);
        if matches!(word, Some(Kw::Marble | Kw::Wood)) {
            draft.use_ramp();
        }
    } else if !begun {
        *loose = None;
    }
    Ok(found)
}

/// These are the whole texture's.
fn is_transform(word: Kw) -> bool {
    matches!(word, Kw::Translate | Kw::Rotate | Kw::Scale | Kw::Matrix | Kw::Transform)
}

fn is_old_normal(word: Option<Kw>) -> bool {
    matches!(
        word,
        Some(Kw::Bumps | Kw::Dents | Kw::Ripples | Kw::Waves | Kw::Wrinkles | Kw::Bump_map | Kw::Bump_size)
    )
}

/// A number alone, which before version 3.0 was the grain of the finish.
pub fn crand(p: &mut Parser, texture: &mut Texture) -> Result<bool> {
    if p.settings.version.language >= 300 || !p.at_expression()? {
        return Ok(false);
    }
    let span = p.span();
    let grain = float32(p)?;
    top_layer(p, texture)?.finish.crand = grain;
    p.warn("loose-crand", "a number alone in a texture is `crand`, which belongs in a `finish` block", span);
    Ok(true)
}
