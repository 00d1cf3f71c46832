//! `light_source { ... }` and `light_group { ... }` (light spec, section 5).
use std::sync::Arc;

use raggio_math::{Vec3, transform};
use raggio_scene::{AreaLight, Light, LightKind, Object, ObjectKind, PhotonFlags, Rgb};

use super::util::{
    at_color, color, comma_vec3, count, float, rgb, set, set_flag, set_vec3, take, vec3, word,
};
use super::{maps, modifiers, object};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// `adaptive`, `jitter` and so on count even before `area_light` is read.
#[derive(Default)]
struct Draft {
    photons_area: bool,
}

/// `light_source { location, color modifiers }`; the name of any object may stand there, and then its modifiers.
pub fn light_source(p: &mut Parser) -> Result<Object> {
    let (mut object, mut draft) = (None, Draft::default());
    let span = p.span();
    p.block("light_source", |p| {
        let Some(light) = &mut object else {
            object = Some(head(p)?);
            return Ok(true);
        };
        item(p, light, &mut draft)
    })?;
    let Some(mut object) = object else {
        return p.error("empty-object", "this light source is empty", span);
    };
    if let (ObjectKind::Light(light), true) = (&mut object.kind, draft.photons_area)
        && let Some(area) = &mut Arc::make_mut(light).area
    {
        area.photons_area = true;
    }
    Ok(object::finished(object))
}

fn head(p: &mut Parser) -> Result<Object> {
    if p.peek()? == Tok::Value(Kind::Object) {
        return Ok(Arc::unwrap_or_clone(take!(p, Object)));
    }
    let location = vec3(p)?;
    p.comma()?;
    Ok(Object::new(ObjectKind::Light(Arc::new(Light::new(location, light_color(p)?)))))
}

/// A colour, or the sum of a colour map weighted by its positions, or nothing, which makes a black light.
fn light_color(p: &mut Parser) -> Result<Rgb> {
    if matches!(word(p)?, Some(Kw::Color_map | Kw::Colour_map)) {
        p.next()?;
        let map = maps::color_map(p)?;
        return Ok(map.iter().map(|(position, color)| color.rgb * *position).sum());
    }
    match p.peek()? {
        Tok::Kw(_) | Tok::Punct('}') if !at_color(p)? && !p.at_expression()? => {
            Ok(p.missing_color(Rgb::ZERO))
        }
        _ => rgb(p),
    }
}

fn item(p: &mut Parser, object: &mut Object, draft: &mut Draft) -> Result<bool> {
    let ObjectKind::Light(light) = &mut object.kind else { return modifiers::modifier(p, object) };
    if let Some(t) = p.accept_transform()? {
        Arc::make_mut(light).transform(&t);
        return Ok(true);
    }
    if at_color(p)? {
        Arc::make_mut(light).color = color(p)?.rgb;
        return Ok(true);
    }
    let Some(key) = word(p)? else { return p.accept_punct(',') };
    let light = Arc::make_mut(light);
    if kind_item(p, light, key)? || area_item(p, light, key)? {
        return Ok(true);
    }
    match key {
        Kw::Fade_distance => set(p, &mut light.fade_distance),
        Kw::Fade_power => set(p, &mut light.fade_power),
        Kw::Media_interaction => set_flag(p, &mut light.media_interaction),
        Kw::Media_attenuation => set_flag(p, &mut light.media_attenuation),
        Kw::Looks_like => looks_like(p, light),
        Kw::Projected_through => projected_through(p, light),
        Kw::Photons => {
            p.next()?;
            p.block("photons", |p| photon_item(p, &mut light.photons, draft))?;
            Ok(true)
        }
        _ => Ok(false),
    }
}

/// The words that say how the light spreads.
fn kind_item(p: &mut Parser, light: &mut Light, key: Kw) -> Result<bool> {
    let kind = match key {
        Kw::Spotlight => LightKind::Spot { radius: 30.0, falloff: 45.0, tightness: 0.0 },
        Kw::Cylinder => LightKind::Cylinder { radius: 0.75, falloff: 1.0, tightness: 0.0 },
        Kw::Shadowless => LightKind::Shadowless,
        Kw::Parallel => light.kind,
        Kw::Point_at | Kw::Radius | Kw::Falloff | Kw::Tightness => return cone_item(p, light, key),
        _ => return Ok(false),
    };
    p.next()?;
    light.kind = kind;
    light.parallel |= matches!(key, Kw::Parallel | Kw::Cylinder);
    Ok(true)
}

fn cone_item(p: &mut Parser, light: &mut Light, key: Kw) -> Result<bool> {
    let parallel = light.parallel;
    match (&mut light.kind, key) {
        (LightKind::Spot { .. } | LightKind::Cylinder { .. }, Kw::Point_at) => {
            set_vec3(p, &mut light.point_at)
        }
        (_, Kw::Point_at) if parallel => set_vec3(p, &mut light.point_at),
        (LightKind::Spot { radius, .. } | LightKind::Cylinder { radius, .. }, Kw::Radius) => set(p, radius),
        (LightKind::Spot { falloff, .. } | LightKind::Cylinder { falloff, .. }, Kw::Falloff) => {
            set(p, falloff)
        }
        (LightKind::Spot { tightness, .. } | LightKind::Cylinder { tightness, .. }, Kw::Tightness) => {
            set(p, tightness)
        }
        _ => {
            let span = p.span();
            let message = format!("`{}` must follow `spotlight`, `cylinder` or `parallel`", key.word());
            p.error("misplaced-word", message, span)
        }
    }
}

fn area_item(p: &mut Parser, light: &mut Light, key: Kw) -> Result<bool> {
    if key == Kw::Area_light {
        p.next()?;
        let (axis1, axis2) = (vec3(p)?, comma_vec3(p)?);
        p.comma()?;
        let size1 = count(p, 1, 1 << 14)?;
        p.comma()?;
        let size2 = count(p, 1, 1 << 14)?;
        let fresh = no_area();
        light.area = Some(AreaLight { axis1, axis2, size1, size2, ..light.area.unwrap_or(fresh) });
        return Ok(true);
    }
    if !matches!(key, Kw::Adaptive | Kw::Jitter | Kw::Circular | Kw::Orient | Kw::Area_illumination) {
        return Ok(false);
    }
    let span = p.span();
    p.next()?;
    let number = match key {
        Kw::Adaptive => float(p)?,
        Kw::Area_illumination => f64::from(u8::from(p.flag()?)),
        _ => 1.0,
    };
    let Some(area) = &mut light.area else {
        let message = format!("`{}` has no effect before `area_light`", key.word());
        p.warn("misplaced-word", message, span);
        return Ok(true);
    };
    match key {
        Kw::Adaptive => area.adaptive = Some(number.clamp(0.0, 100.0) as u32),
        Kw::Jitter => area.jitter = true,
        Kw::Circular => area.circular = true,
        Kw::Orient => (area.orient, area.circular) = (true, true),
        _ => area.area_illumination = number != 0.0,
    }
    Ok(true)
}

fn no_area() -> AreaLight {
    AreaLight {
        axis1: Vec3::ZERO,
        axis2: Vec3::ZERO,
        size1: 1,
        size2: 1,
        adaptive: None,
        jitter: false,
        circular: false,
        orient: false,
        area_illumination: false,
        photons_area: false,
    }
}

/// `looks_like { object modifiers }`: moved to the light first, without a shadow.
fn looks_like(p: &mut Parser, light: &mut Light) -> Result<bool> {
    let span = p.span();
    p.next()?;
    if light.looks_like.is_some() {
        return p.error("second-looks-like", "only one looks_like is allowed per light source", span);
    }
    let mut looks =
        inner_object(p, "looks_like", |looks| looks.transform(&transform::translate(light.location)))?;
    looks.no_shadow = true;
    let default = p.defaults.texture.clone();
    object::apply_default_texture(&mut looks, &default);
    light.looks_like = Some(Arc::new(looks));
    Ok(true)
}

/// `projected_through { object modifiers }`; neither texture nor interior of it count.
fn projected_through(p: &mut Parser, light: &mut Light) -> Result<bool> {
    p.next()?;
    let mut screen = inner_object(p, "projected_through", |_| {})?;
    (screen.texture, screen.interior, screen.interior_texture) = (None, None, None);
    light.projected_through = Some(Arc::new(screen));
    Ok(true)
}

/// `{ object modifiers }`; `prepare` acts before the modifiers.
fn inner_object(p: &mut Parser, what: &str, prepare: impl Fn(&mut Object)) -> Result<Object> {
    let mut inner = None;
    let span = p.span();
    p.block(what, |p| {
        if let Some(inner) = &mut inner {
            return modifiers::modifier(p, inner);
        }
        let object = match p.peek()? {
            Tok::Value(Kind::Object) => Some(Arc::unwrap_or_clone(take!(p, Object))),
            _ => object::any(p)?,
        };
        inner = object.map(|mut object| {
            prepare(&mut object);
            object
        });
        Ok(inner.is_some())
    })?;
    match inner {
        Some(inner) => Ok(object::finished(inner)),
        None => p.error("empty-object", format!("`{what}` needs an object"), span),
    }
}

fn photon_item(p: &mut Parser, flags: &mut PhotonFlags, draft: &mut Draft) -> Result<bool> {
    match word(p)? {
        Some(Kw::Reflection) => {
            p.next()?;
            flags.reflection = Some(p.flag()?);
        }
        Some(Kw::Refraction) => {
            p.next()?;
            flags.refraction = Some(p.flag()?);
        }
        Some(Kw::Area_light) => {
            p.next()?;
            draft.photons_area = p.flag()?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// `light_group { lights objects [global_lights b] modifiers }`
pub fn light_group(p: &mut Parser) -> Result<Object> {
    let (mut members, mut global, mut group) = (Vec::new(), false, None);
    p.block("light_group", |p| {
        if word(p)? == Some(Kw::Global_lights) {
            return set_flag(p, &mut global);
        }
        if group.is_none()
            && let Some(member) = object::any_or_identifier(p)?
        {
            members.push(Arc::new(member));
            return Ok(true);
        }
        let group = group.get_or_insert_with(|| grouped(std::mem::take(&mut members)));
        modifiers::modifier(p, group)
    })?;
    let mut group = group.unwrap_or_else(|| grouped(members));
    if let ObjectKind::LightGroup { global_lights, .. } = &mut group.kind {
        *global_lights = global;
    }
    Ok(object::finished(group))
}

fn grouped(members: Vec<Arc<Object>>) -> Object {
    Object::new(ObjectKind::LightGroup { children: Arc::new(members), global_lights: false })
}
