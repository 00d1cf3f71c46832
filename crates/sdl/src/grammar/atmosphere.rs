//! What fills empty space: `background`, `fog`, `sky_sphere`, `rainbow`, `media` at top level.
use std::sync::Arc;

use raggio_math::Vec3;
use raggio_scene::{
    Background, Color, Fog, FogKind, PatternKind, Pigment, PigmentKind, Placed, Rainbow, Rgb, SkySphere,
};

use super::util::{at_color, color, float, set, set_rgb, set_vec3, take, word};
use super::{maps, media, pattern, pigment, warp};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// A block that fills empty space, if one comes next.
pub fn statement(p: &mut Parser) -> Result<bool> {
    let Some(key) = word(p)? else { return Ok(false) };
    if !matches!(key, Kw::Background | Kw::Fog | Kw::Sky_sphere | Kw::Rainbow | Kw::Media) {
        return Ok(false);
    }
    let span = p.span();
    p.next()?;
    match key {
        Kw::Background => p.scene.atmosphere.background = Some(background(p)?),
        Kw::Fog => {
            let fog = fog(p)?;
            p.scene.atmosphere.fogs.push(fog);
        }
        Kw::Sky_sphere => {
            if p.scene.atmosphere.sky_sphere.is_some() {
                p.warn(
                    "second-sky-sphere",
                    "only one sky_sphere counts; this one replaces the one before",
                    span,
                );
            }
            p.scene.atmosphere.sky_sphere = Some(sky_sphere(p)?);
        }
        Kw::Rainbow => {
            let rainbow = rainbow(p)?;
            p.scene.atmosphere.rainbows.push(rainbow);
        }
        _ => {
            let media = Placed::new(Arc::new(media::block(p)?));
            p.scene.atmosphere.media.push(media);
        }
    }
    Ok(true)
}

fn background(p: &mut Parser) -> Result<Background> {
    let mut background = Background { color: Color::BLACK };
    p.block("background", |p| {
        if !at_color(p)? && !p.at_expression()? {
            return Ok(false);
        }
        background.color = color(p)?;
        Ok(true)
    })?;
    Ok(background)
}

/// A fog in the making: the parts of both kinds together.
struct FogDraft {
    fog: Fog,
    ground: bool,
    offset: f64,
    alt: f64,
    up: Vec3,
}

/// `{ ... }` of a fog; the word has been read.
pub fn fog(p: &mut Parser) -> Result<Fog> {
    let fog = Fog {
        kind: FogKind::Constant,
        color: Color::BLACK,
        distance: 0.0,
        turbulence: None,
        turb_depth: 0.5,
    };
    let mut draft = FogDraft { fog, ground: false, offset: 0.0, alt: 0.0, up: Vec3::Y };
    p.block("fog", |p| fog_item(p, &mut draft))?;
    let FogDraft { mut fog, ground, offset, alt, up } = draft;
    let up = up.try_normalize().unwrap_or(Vec3::Y);
    fog.kind = if ground { FogKind::Ground { offset, alt, up } } else { FogKind::Constant };
    Ok(fog)
}

fn fog_item(p: &mut Parser, draft: &mut FogDraft) -> Result<bool> {
    let span = p.span();
    if let Some(t) = p.accept_transform()? {
        if t.translation != Vec3::ZERO {
            p.warn("moved-fog", "a fog cannot be translated; only its up vector turns", span);
        }
        draft.up = t.transform_vector3(draft.up);
        return Ok(true);
    }
    if at_color(p)? {
        draft.fog.color = color(p)?;
        return Ok(true);
    }
    match p.peek()? {
        Tok::Value(Kind::Fog) => {
            let fog = take!(p, Fog);
            draft.fog = (*fog).clone();
            draft.ground = false;
            if let FogKind::Ground { offset, alt, up } = fog.kind {
                (draft.ground, draft.offset, draft.alt, draft.up) = (true, offset, alt, up);
            }
            Ok(true)
        }
        Tok::Kw(key) => fog_word(p, draft, key),
        // Old scenes write the distance without its word.
        Tok::Number(_) => {
            draft.fog.distance = float(p)?;
            Ok(true)
        }
        _ => p.accept_punct(','),
    }
}

fn fog_word(p: &mut Parser, draft: &mut FogDraft, key: Kw) -> Result<bool> {
    match key {
        Kw::Distance => set(p, &mut draft.fog.distance),
        Kw::Fog_type => {
            p.next()?;
            draft.ground = p.int("fog_type", 1..=2)? == 2;
            Ok(true)
        }
        Kw::Fog_offset => set(p, &mut draft.offset),
        Kw::Fog_alt => set(p, &mut draft.alt),
        Kw::Up => set_vec3(p, &mut draft.up),
        Kw::Turb_depth => set(p, &mut draft.fog.turb_depth),
        _ => {
            let mut turbulence = draft.fog.turbulence.unwrap_or_default();
            let known = warp::turbulence_item(p, &mut turbulence)?;
            if known {
                draft.fog.turbulence = Some(turbulence);
            }
            Ok(known)
        }
    }
}

/// `{ ... }` of a sky sphere; the word has been read.
pub fn sky_sphere(p: &mut Parser) -> Result<SkySphere> {
    let mut sky = SkySphere { pigments: Vec::new(), emission: Rgb::ONE };
    p.block("sky_sphere", |p| {
        if let Some(t) = p.accept_transform()? {
            sky.pigments.iter_mut().for_each(|pigment| pigment.transform(&t));
            return Ok(true);
        }
        match p.peek()? {
            Tok::Value(Kind::SkySphere) => sky = (*take!(p, SkySphere)).clone(),
            Tok::Value(Kind::Pigment) => sky.pigments.push(Placed::new(take!(p, Pigment))),
            Tok::Kw(Kw::Pigment) => {
                p.next()?;
                let base = p.defaults.pigment();
                sky.pigments.push(Placed::new(pigment::block(p, &base)?));
            }
            Tok::Kw(Kw::Emission) => return set_rgb(p, &mut sky.emission),
            _ => return Ok(false),
        }
        Ok(true)
    })?;
    Ok(sky)
}

/// `{ ... }` of a rainbow; the word has been read.
pub fn rainbow(p: &mut Parser) -> Result<Rainbow> {
    let span = p.span();
    let mut rainbow = Rainbow {
        direction: Vec3::ZERO,
        up: Vec3::Y,
        angle: 0.0,
        width: 0.0,
        distance: 1e7,
        jitter: 0.0,
        arc_angle: None,
        falloff_angle: None,
        pigment: Arc::new(Pigment::solid(Color::BLACK)),
    };
    p.block("rainbow", |p| rainbow_item(p, &mut rainbow))?;
    if rainbow.direction == Vec3::ZERO {
        return p.error("bad-rainbow", "the direction of a rainbow must be given and cannot be zero", span);
    }
    if rainbow.angle == 0.0 || rainbow.width == 0.0 {
        return p.error("bad-rainbow", "the angle and the width of a rainbow must be given", span);
    }
    Ok(rainbow)
}

fn rainbow_item(p: &mut Parser, r: &mut Rainbow) -> Result<bool> {
    if let Some(t) = p.accept_transform()? {
        r.direction = t.transform_vector3(r.direction);
        r.up = t.transform_vector3(r.up);
        return Ok(true);
    }
    if p.peek()? == Tok::Value(Kind::Rainbow) {
        *r = (*take!(p, Rainbow)).clone();
        return Ok(true);
    }
    match word(p)? {
        Some(Kw::Direction) => set_vec3(p, &mut r.direction),
        Some(Kw::Up) => set_vec3(p, &mut r.up),
        Some(Kw::Angle) => set(p, &mut r.angle),
        Some(Kw::Width) => set(p, &mut r.width),
        Some(Kw::Distance) => set(p, &mut r.distance),
        Some(Kw::Jitter) => set(p, &mut r.jitter),
        Some(Kw::Arc_angle) => set(p, r.arc_angle.insert(0.0)),
        Some(Kw::Falloff_angle) => set(p, r.falloff_angle.insert(0.0)),
        Some(Kw::Color_map | Kw::Colour_map) => {
            p.next()?;
            let map = maps::color_map(p)?;
            let pattern = pattern::Draft::default().finish(PatternKind::Gradient(Vec3::X));
            r.pigment = Arc::new(Pigment { kind: PigmentKind::ColorMap { pattern, map }, quick_color: None });
            Ok(true)
        }
        _ => p.accept_punct(','),
    }
}
