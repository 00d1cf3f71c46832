//! `media { ... }` and the densities in it (spec on media, section 1.1).
use std::sync::Arc;

use raggio_scene::{Density, Media, Placed, Scattering};

use super::pigment;
use super::util::{count, float, optional_second, rgb, set_flag, set_rgb, set32, take, until, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Media as it begins; old scenes sample otherwise.
fn default_media(language: u16) -> Media {
    if language >= 350 {
        Media::default()
    } else {
        Media { method: 1, intervals: 10, samples: (1, 1), ..Media::default() }
    }
}

/// `{ ... }` of a media; the word has been read.
pub fn block(p: &mut Parser) -> Result<Media> {
    let mut media = default_media(p.settings.version.language);
    p.block("media", |p| item(p, &mut media))?;
    Ok(media)
}

fn item(p: &mut Parser, m: &mut Media) -> Result<bool> {
    if let Some(t) = p.accept_transform()? {
        m.densities.iter_mut().for_each(|density| density.transform(&t));
        return Ok(true);
    }
    let key = match p.peek()? {
        Tok::Value(Kind::Media) => {
            *m = (*take!(p, Media)).clone();
            return Ok(true);
        }
        Tok::Value(Kind::Density) => {
            m.densities.push(Placed::new(take!(p, Density)));
            return Ok(true);
        }
        Tok::Kw(key) => key,
        _ => return Ok(false),
    };
    match key {
        Kw::Absorption => set_rgb(p, &mut m.absorption),
        Kw::Emission => set_rgb(p, &mut m.emission),
        Kw::Confidence => set32(p, &mut m.confidence),
        Kw::Variance => set32(p, &mut m.variance),
        Kw::Ratio => set32(p, &mut m.ratio),
        Kw::Jitter => {
            p.next()?;
            m.jitter = p.optional_float(1.0)? as f32;
            Ok(true)
        }
        Kw::Aa_threshold => set32(p, &mut m.aa_threshold),
        Kw::Collect => set_flag(p, &mut m.collect),
        Kw::Density => {
            p.next()?;
            let density: Density = pigment::density(p)?;
            m.densities.push(Placed::new(Arc::new(density)));
            Ok(true)
        }
        _ => sampling_item(p, m, key),
    }
}

fn sampling_item(p: &mut Parser, m: &mut Media, key: Kw) -> Result<bool> {
    let span = p.span();
    match key {
        Kw::Method => {
            p.next()?;
            m.method = p.int("method", 1..=3)? as u8;
        }
        Kw::Intervals => {
            p.next()?;
            let intervals = float(p)?;
            if intervals < 1.0 {
                return p.error("bad-media", "media needs at least one interval", span);
            }
            m.intervals = intervals.min(1e6) as u32;
        }
        Kw::Samples => {
            p.next()?;
            let least = count(p, 1, 1 << 20)?;
            let most = optional_second(p)?.map_or(least, |n| n.clamp(1.0, f64::from(1u32 << 20)) as u32);
            m.samples = (least, most.max(least));
        }
        Kw::Aa_level => {
            p.next()?;
            m.aa_level = count(p, 0, 32)?;
        }
        Kw::Scattering => {
            p.next()?;
            m.scattering = Some(scattering(p)?);
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// `scattering { type, color [eccentricity e] [extinction x] }`
fn scattering(p: &mut Parser) -> Result<Scattering> {
    p.expect('{')?;
    let span = p.span();
    let mut kind = float(p)? as i64;
    if !(1..=5).contains(&kind) {
        p.warn("bad-scattering", "scattering types are 1 to 5; this is taken as 1", span);
        kind = 1;
    }
    p.comma()?;
    let color = rgb(p)?;
    let mut s = Scattering { kind: kind as u8, color, eccentricity: 0.0, extinction: 1.0 };
    until(p, '}', "scattering", |p| match word(p)? {
        Some(Kw::Eccentricity) => set32(p, &mut s.eccentricity),
        Some(Kw::Extinction) => set32(p, &mut s.extinction),
        _ => p.accept_punct(','),
    })?;
    Ok(s)
}
