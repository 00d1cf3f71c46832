//! `finish { ... }` (language spec, section 4.4; light spec, sections 3.4 and 4).
use raggio_scene::{Finish, Irid, LegacyInterior, Reflection, Rgb, Subsurface};

use super::util::{float, float32, optional_second, rgb, set_flag, set_rgb, set32, take, until, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Which of the numbers `albedo` has marked for scaling when the block ends.
#[derive(Clone, Copy, Debug, Default)]
struct Albedo {
    diffuse: bool,
    phong: bool,
    specular: bool,
}

/// A finish that is not complete yet.
#[derive(Clone, Copy, Debug)]
pub struct Draft {
    finish: Finish,
    albedo: Albedo,
}

impl Draft {
    /// Begins with a finish that is to be modified.
    pub fn new(base: Finish) -> Self {
        Draft { finish: base, albedo: Albedo::default() }
    }

    /// The finished finish.
    pub fn finish(self) -> Finish {
        let Draft { finish: mut f, albedo } = self;
        if albedo.diffuse {
            f.diffuse *= (f.brilliance + 1.0) / 2.0;
            f.diffuse_back *= (f.brilliance + 1.0) / 2.0;
        }
        if albedo.phong {
            f.phong *= (f.phong_size + 1.0) / 2.0;
        }
        if albedo.specular {
            let q = 1.0 / f.roughness;
            f.specular *= (q + 2.0) / (4.0 * (2.0 - (-q / 2.0).exp2()));
        }
        f
    }
}

/// `{ ... }` of a finish that begins as `base`; the word has been read.
pub fn block(p: &mut Parser, base: Finish) -> Result<Finish> {
    let mut draft = Draft::new(base);
    p.block("finish", |p| item(p, &mut draft))?;
    Ok(draft.finish())
}

/// One item of a finish.
pub fn item(p: &mut Parser, draft: &mut Draft) -> Result<bool> {
    let f = &mut draft.finish;
    let key = match p.peek()? {
        Tok::Value(Kind::Finish) => {
            *draft = Draft::new(*take!(p, Finish));
            return Ok(true);
        }
        Tok::Kw(key) => key,
        _ => return Ok(false),
    };
    match key {
        Kw::Ambient => set_rgb(p, &mut f.ambient),
        Kw::Emission => set_rgb(p, &mut f.emission),
        Kw::Brilliance => set32(p, &mut f.brilliance),
        Kw::Crand => set32(p, &mut f.crand),
        Kw::Phong_size => set32(p, &mut f.phong_size),
        Kw::Conserve_energy => set_flag(p, &mut f.conserve_energy),
        Kw::Reflection_exponent => set32(p, &mut f.reflection.exponent),
        Kw::Diffuse | Kw::Phong | Kw::Specular => {
            p.next()?;
            scaled(p, draft, key)
        }
        Kw::Roughness => roughness(p, f),
        Kw::Metallic => {
            p.next()?;
            f.metallic = p.optional_float(1.0)? as f32;
            Ok(true)
        }
        Kw::Reflection => {
            p.next()?;
            reflection(p, f)
        }
        Kw::Irid => {
            p.next()?;
            f.irid = Some(irid(p)?);
            Ok(true)
        }
        Kw::Subsurface => {
            p.next()?;
            f.subsurface = Some(subsurface(p)?);
            Ok(true)
        }
        Kw::Ior | Kw::Caustics | Kw::Refraction => legacy(p, f, key),
        Kw::Fade_distance | Kw::Fade_power => {
            let span = p.span();
            p.error("moved-word", "fade_distance and fade_power belong in the interior of the object", span)
        }
        _ => Ok(false),
    }
}

/// `diffuse`, `phong`, `specular`, each with an optional `albedo`.
fn scaled(p: &mut Parser, draft: &mut Draft, key: Kw) -> Result<bool> {
    let albedo = p.accept(Kw::Albedo)?;
    let amount = float32(p)?;
    let f = &mut draft.finish;
    match key {
        Kw::Phong => (f.phong, draft.albedo.phong) = (amount, albedo),
        Kw::Specular => (f.specular, draft.albedo.specular) = (amount, albedo),
        _ => {
            (f.diffuse, f.diffuse_raw, draft.albedo.diffuse) = (amount, amount, albedo);
            if let Some(back) = optional_second(p)? {
                (f.diffuse_back, f.diffuse_back_raw) = (back as f32, back as f32);
            }
        }
    }
    Ok(true)
}

fn roughness(p: &mut Parser, f: &mut Finish) -> Result<bool> {
    p.next()?;
    let span = p.span();
    f.roughness = float32(p)?;
    if f.roughness == 0.0 {
        p.warn("zero-roughness", "a roughness of 0 is taken as 0.00001", span);
        f.roughness = 1e-5;
    }
    Ok(true)
}

/// `reflection c` or `reflection { min [, max] items }`.
fn reflection(p: &mut Parser, f: &mut Finish) -> Result<bool> {
    if p.peek()? != Tok::Punct('{') {
        let color = rgb(p)?;
        f.reflection = Reflection { min: color, max: color, falloff: 1.0, fresnel: false, ..f.reflection };
        return Ok(true);
    }
    let r = &mut f.reflection;
    let (mut min, mut max) = (None, None);
    r.falloff = 1.0;
    r.fresnel = false;
    p.block("reflection", |p| {
        if p.accept_punct(',')? {
            return Ok(true);
        }
        match word(p)? {
            Some(Kw::Fresnel) => set_flag(p, &mut r.fresnel),
            Some(Kw::Falloff) => set32(p, &mut r.falloff),
            Some(Kw::Exponent | Kw::Reflection_exponent) => set32(p, &mut r.exponent),
            Some(Kw::Metallic) => {
                p.next()?;
                r.metallic = p.optional_float(1.0)? as f32;
                Ok(true)
            }
            _ if min.is_none() => {
                min = Some(rgb(p)?);
                Ok(true)
            }
            _ if max.is_none() => {
                max = Some(rgb(p)?);
                Ok(true)
            }
            _ => Ok(false),
        }
    })?;
    (r.min, r.max) = match (min, max) {
        (Some(min), Some(max)) => (min, max),
        (Some(only), None) if r.fresnel => (Rgb::ZERO, only),
        (Some(only), None) => (only, only),
        _ => return p.expected("a colour in `reflection`"),
    };
    Ok(true)
}

/// `irid { amount [thickness t] [turbulence k] }`
fn irid(p: &mut Parser) -> Result<Irid> {
    let mut irid = Irid { amount: 0.0, thickness: 0.0, turbulence: 0.0 };
    p.expect('{')?;
    irid.amount = float32(p)?;
    until(p, '}', "irid", |p| match word(p)? {
        Some(Kw::Thickness) => set32(p, &mut irid.thickness),
        Some(Kw::Turbulence) => {
            p.next()?;
            irid.turbulence = super::util::vec3(p)?.x as f32;
            Ok(true)
        }
        _ => Ok(false),
    })?;
    Ok(irid)
}

/// `subsurface { translucency c [anisotropy a] }`
fn subsurface(p: &mut Parser) -> Result<Subsurface> {
    let mut subsurface = Subsurface { translucency: Rgb::ZERO, anisotropy: Rgb::ZERO };
    p.block("subsurface", |p| match word(p)? {
        Some(Kw::Translucency) => set_rgb(p, &mut subsurface.translucency),
        _ if p.text() == "anisotropy" => set_rgb(p, &mut subsurface.anisotropy),
        _ => Ok(false),
    })?;
    Ok(subsurface)
}

/// Words that moved to the interior; they still act on objects whose texture has this finish.
fn legacy(p: &mut Parser, f: &mut Finish, key: Kw) -> Result<bool> {
    let span = p.span();
    p.next()?;
    let value = float(p)? as f32;
    let legacy = f.legacy_interior.get_or_insert_with(LegacyInterior::default);
    match key {
        Kw::Ior => legacy.ior = Some(value),
        Kw::Caustics => legacy.caustics = Some(value),
        _ => legacy.refraction = Some(if value == 0.0 { 0.0 } else { value }),
    }
    let message = format!("`{}` in a finish is old; it belongs in the interior", key.word());
    p.warn("moved-word", message, span);
    Ok(true)
}
