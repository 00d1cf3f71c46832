//! `interior { ... }` and `material { ... }`.
use std::sync::Arc;

use raggio_scene::{Interior, LegacyInterior, Object, Placed, Texture, TextureKind};

use super::util::{count, float32, set_rgb, set32, take};
use super::{media, texture};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::{Kind, Material};

/// `{ ... }` of an interior; the word has been read.
pub fn block(p: &mut Parser) -> Result<Interior> {
    let mut interior = Interior::default();
    p.block("interior", |p| item(p, &mut interior))?;
    Ok(interior)
}

fn item(p: &mut Parser, i: &mut Interior) -> Result<bool> {
    let key = match p.peek()? {
        Tok::Value(Kind::Interior) => {
            *i = (*take!(p, Interior)).clone();
            return Ok(true);
        }
        Tok::Value(Kind::Media) => {
            i.media.push(Placed::new(take!(p, Media)));
            return Ok(true);
        }
        Tok::Kw(key) => key,
        _ => return Ok(false),
    };
    match key {
        Kw::Ior => set32(p, &mut i.ior),
        Kw::Dispersion => set32(p, &mut i.dispersion),
        Kw::Caustics => {
            p.next()?;
            i.caustics = CAUSTICS * f64::from(float32(p)?);
            Ok(true)
        }
        Kw::Fade_distance => set32(p, &mut i.fade_distance),
        Kw::Fade_power => set32(p, &mut i.fade_power),
        Kw::Fade_color | Kw::Fade_colour => set_rgb(p, &mut i.fade_color),
        Kw::Dispersion_samples => {
            p.next()?;
            i.dispersion_samples = count(p, 2, 1 << 16)?;
            Ok(true)
        }
        Kw::Media => {
            p.next()?;
            i.media.push(Placed::new(Arc::new(media::block(p)?)));
            Ok(true)
        }
        Kw::Refraction => {
            let span = p.span();
            p.next()?;
            super::util::float(p)?;
            p.warn("moved-word", "`refraction` has no meaning in an interior", span);
            Ok(true)
        }
        _ => Ok(false),
    }
}

/// What the interior's `caustics` are multiplied by before they are a power; those of a finish are one.
const CAUSTICS: f64 = 45.0;

/// Carries the interior words of an old finish to the interior, if the outermost layer has some.
pub fn adopt_legacy(texture: &Texture, interior: &mut Option<Placed<Interior>>) {
    let TextureKind::Layers(layers) = &texture.kind else { return };
    let Some(LegacyInterior { ior, caustics, refraction }) =
        layers.last().and_then(|l| l.finish.legacy_interior)
    else {
        return;
    };
    let made = || Arc::new(Interior { from_finish: true, ..Interior::default() });
    let placed = interior.get_or_insert_with(|| Placed::new(made()));
    let new = Arc::make_mut(&mut placed.item);
    new.ior = ior.unwrap_or(new.ior);
    new.caustics = caustics.map_or(new.caustics, f64::from);
    new.old_refraction = refraction.unwrap_or(new.old_refraction);
}

/// The interior that old finishes have given to members of a combination: the last one's, which becomes that of all
/// members that have none of their own.
pub fn take_legacy(members: &mut [Arc<Object>]) -> Option<Placed<Interior>> {
    let old = |member: &Object| member.interior.as_ref().is_some_and(|interior| interior.item.from_finish);
    let mut taken = None;
    for member in members.iter_mut().filter(|member| old(member)) {
        taken = Arc::make_mut(member).interior.take();
    }
    taken
}

/// `{ ... }` of a material; the word has been read.
pub fn material(p: &mut Parser) -> Result<Material> {
    let mut material = Material::default();
    p.block("material", |p| material_item(p, &mut material))?;
    Ok(material)
}

fn material_item(p: &mut Parser, m: &mut Material) -> Result<bool> {
    if let Some(t) = p.accept_transform()? {
        transform_material(m, &t);
        return Ok(true);
    }
    match p.peek()? {
        Tok::Value(Kind::Material) => *m = (*take!(p, Material)).clone(),
        Tok::Kw(Kw::Texture) => {
            p.next()?;
            let over = texture::block(p)?;
            add_texture(p, &mut m.texture, over)?;
        }
        Tok::Kw(Kw::Interior_texture) => {
            p.next()?;
            let over = texture::block(p)?;
            add_texture(p, &mut m.interior_texture, over)?;
        }
        Tok::Kw(Kw::Interior) => {
            p.next()?;
            m.interior = Some(Placed::new(Arc::new(block(p)?)));
        }
        _ => return Ok(false),
    }
    Ok(true)
}

fn transform_material(m: &mut Material, t: &raggio_math::Affine) {
    for texture in [&mut m.texture, &mut m.interior_texture].into_iter().flatten() {
        texture.transform(t);
    }
    if let Some(interior) = &mut m.interior {
        interior.transform(t);
    }
}

/// Lays a texture over what is there.
pub fn add_texture(p: &mut Parser, place: &mut Option<Placed<Texture>>, over: Texture) -> Result<()> {
    let new = match place.take() {
        Some(under) => texture::layered(p, settled(under), over)?,
        None => over,
    };
    *place = Some(Placed::new(Arc::new(new)));
    Ok(())
}

/// A placed texture as one that lies at the origin.
pub fn settled(placed: Placed<Texture>) -> Texture {
    let place = placed.parent_from_item();
    let mut texture = Arc::unwrap_or_clone(placed.item);
    if place != raggio_math::Affine::IDENTITY {
        texture::transform(&mut texture, &place);
    }
    texture
}
