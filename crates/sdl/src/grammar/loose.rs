//! Words of pigments, normals and finishes that stand directly in a texture, as they did before version 1.5.
use raggio_scene::Texture;

use super::texture::top_layer;
use super::util::{at_color, float32, word};
use super::{finish, normal, pigment};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// All such words that come next; those of the pigment belong together, in whatever order they come. Is there one?
pub fn items(p: &mut Parser, texture: &mut Texture) -> Result<bool> {
    let (mut loose, mut any) = (Loose::default(), false);
    while item(p, texture, &mut loose)? {
        any = true;
    }
    if let Some(draft) = loose.pigment {
        top_layer(p, texture)?.pigment = draft.finish(p)?;
    }
    if let Some(mut draft) = loose.normal {
        loose.frequency.into_iter().for_each(|frequency| draft.set_frequency(frequency));
        let normal = draft.finish(p)?;
        top_layer(p, texture)?.normal = normal;
    }
    Ok(any)
}

/// What stands directly in a texture, as far as it has been read.
#[derive(Default)]
struct Loose {
    pigment: Option<pigment::Draft>,
    normal: Option<normal::Draft>,
    /// The normal's, even if it comes before what is to have it.
    frequency: Option<f32>,
}

fn item(p: &mut Parser, texture: &mut Texture, loose: &mut Loose) -> Result<bool> {
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
        let base = || normal::Draft::new(layer.normal.as_deref());
        let draft = loose.normal.get_or_insert_with(base);
        if p.accept(Kw::Frequency)? {
            loose.frequency = Some(float32(p)?);
        } else {
            normal::item(p, draft)?;
        }
        p.warn("loose-normal", "this word belongs in a `normal` block", span);
        return Ok(true);
    }
    let color = at_color(p)?;
    if !color && (!old || word.is_none_or(is_transform)) {
        return Ok(false);
    }
    let begun = loose.pigment.is_some();
    let new = || pigment::Draft::new(&layer.pigment, pigment::Flavour::Pigment);
    let draft = loose.pigment.get_or_insert_with(new);
    let found = pigment::item(p, draft)?;
    if found {
        p.warn("loose-pigment", "this word belongs in a `pigment` block", span);
        if matches!(word, Some(Kw::Marble | Kw::Wood)) {
            draft.use_ramp();
        }
    } else if !begun {
        loose.pigment = None;
    }
    Ok(found)
}

/// These are the whole texture's.
fn is_transform(word: Kw) -> bool {
    matches!(word, Kw::Translate | Kw::Rotate | Kw::Scale | Kw::Matrix | Kw::Transform)
}

/// `frequency` and `phase` were those of ripples and waves, wherever in the texture they stood.
fn is_old_normal(word: Option<Kw>) -> bool {
    let Some(word) = word else { return false };
    let pattern = matches!(word, Kw::Bumps | Kw::Dents | Kw::Ripples | Kw::Waves | Kw::Wrinkles);
    pattern || matches!(word, Kw::Bump_map | Kw::Bump_size | Kw::Frequency | Kw::Phase)
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
