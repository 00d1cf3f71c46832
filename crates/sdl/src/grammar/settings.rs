//! `global_settings { ... }` (language spec, section 4.1).
use raggio_diag::Span;
use raggio_scene::{Curve, Photons, RadiositySettings, SubsurfaceSettings};

use super::util::{comma_float, count, float, float32, optional_second, set_count, set_flag, set32, word};
use crate::keyword::Kw;
use crate::parser::{Charset, Parser, Result};

/// `{ ... }`; the word has been read.
pub fn block(p: &mut Parser) -> Result<()> {
    p.block("global_settings", |p| match word(p)? {
        Some(key) => item(p, key),
        None => p.accept_punct(','),
    })
}

/// Settings that old scenes write outside the block.
pub fn loose(p: &mut Parser) -> Result<bool> {
    let old =
        [Kw::Max_trace_level, Kw::Max_intersections, Kw::Adc_bailout, Kw::Number_of_waves, Kw::Hf_gray_16];
    let span = p.span();
    match word(p)? {
        Some(key) if old.contains(&key) => {
            p.warn("loose-setting", format!("`{}` belongs in global_settings", key.word()), span);
            item(p, key)
        }
        _ => Ok(false),
    }
}

fn item(p: &mut Parser, key: Kw) -> Result<bool> {
    let span = p.span();
    p.next()?;
    match key {
        Kw::Adc_bailout => p.settings.adc_bailout = float32(p)?,
        Kw::Ambient_light => p.settings.ambient_light = super::util::rgb(p)?,
        Kw::Irid_wavelength => p.settings.irid_wavelength = super::util::rgb(p)?,
        Kw::Max_trace_level => p.settings.max_trace_level = count(p, 1, 256)? as u16,
        Kw::Mm_per_unit => p.settings.mm_per_unit = float32(p)?,
        Kw::Number_of_waves => p.settings.number_of_waves = count(p, 1, 1 << 16)?,
        Kw::Noise_generator => {
            let n = p.int("noise_generator", 1..=3)? as u8;
            p.set_noise_generator(n);
        }
        Kw::Assumed_gamma => assumed_gamma(p, span)?,
        Kw::Charset => charset(p)?,
        Kw::Radiosity => p.settings.radiosity = Some(radiosity(p, span)?),
        Kw::Photons => p.settings.photons = photons(p)?,
        Kw::Subsurface => p.settings.subsurface = Some(subsurface(p)?),
        Kw::Hf_gray_16 => {
            p.optional_float(1.0)?;
            p.warn("no-effect", "`hf_gray_16` has no effect any more", span);
        }
        Kw::Max_intersections => {
            float(p)?;
            p.warn("no-effect", "`max_intersections` has no effect any more", span);
        }
        _ => {
            return p.error(
                "unknown-setting",
                format!("global_settings does not take `{}`", key.word()),
                span,
            );
        }
    }
    Ok(true)
}

/// The first one counts.
fn assumed_gamma(p: &mut Parser, span: Span) -> Result<()> {
    let curve = if p.accept(Kw::Srgb)? {
        Curve::Srgb
    } else {
        let gamma = float(p)?;
        if gamma <= 0.0 {
            return p.error("bad-gamma", "assumed_gamma must be greater than 0", span);
        }
        Curve::power(gamma as f32)
    };
    if !p.set_assumed_gamma(curve) {
        p.warn("second-gamma", "assumed_gamma has been given before; the first one counts", span);
    }
    Ok(())
}

fn charset(p: &mut Parser) -> Result<()> {
    p.charset = match word(p)? {
        Some(Kw::Ascii) => Charset::Ascii,
        // Systems of today speak UTF-8.
        Some(Kw::Utf8 | Kw::Sys) => Charset::Utf8,
        _ => return p.expected("`ascii`, `utf8` or `sys`"),
    };
    p.next().map(|_| ())
}

fn subsurface(p: &mut Parser) -> Result<SubsurfaceSettings> {
    let mut s = SubsurfaceSettings { diffuse_samples: 50, single_samples: 50, radiosity: false };
    p.block("subsurface", |p| match word(p)? {
        Some(Kw::Samples) => {
            p.next()?;
            s.diffuse_samples = count(p, 1, 1 << 20)?;
            p.comma()?;
            s.single_samples = count(p, 1, 1 << 20)?;
            Ok(true)
        }
        Some(Kw::Radiosity) => set_flag(p, &mut s.radiosity),
        _ => Ok(false),
    })?;
    Ok(s)
}

/// `radiosity { ... }`; the word has been read.
fn radiosity(p: &mut Parser, span: Span) -> Result<RadiositySettings> {
    let mut r = RadiositySettings::default();
    let (mut pool, mut minimum, mut maximum) = (None, None, None);
    p.block("radiosity", |p| match word(p)? {
        Some(Kw::Count) => {
            p.next()?;
            r.count = count(p, 1, 1 << 20)?;
            pool = optional_second(p)?.map(|n| n.clamp(1.0, 1e6) as u32);
            Ok(true)
        }
        Some(Kw::Minimum_reuse) => set32(p, minimum.insert(0.0)),
        Some(Kw::Maximum_reuse) => set32(p, maximum.insert(0.0)),
        Some(key) => radiosity_item(p, &mut r, key),
        None => p.accept_punct(','),
    })?;
    r.count_pool = pool.unwrap_or(1600).max(r.count);
    (r.minimum_reuse, r.maximum_reuse) = match (minimum, maximum) {
        (Some(min), Some(max)) if min >= max => {
            return p.error("bad-radiosity", "minimum_reuse must be less than maximum_reuse", span);
        }
        (Some(min), Some(max)) => (min, max),
        (Some(min), None) => (min, r.maximum_reuse.max(2.0 * min)),
        (None, Some(max)) => (r.minimum_reuse.min(max / 2.0), max),
        (None, None) => (r.minimum_reuse, r.maximum_reuse),
    };
    if r.pretrace_end > r.pretrace_start {
        return p.error("bad-radiosity", "pretrace_end must not be greater than pretrace_start", span);
    }
    Ok(r)
}

fn radiosity_item(p: &mut Parser, r: &mut RadiositySettings, key: Kw) -> Result<bool> {
    match key {
        Kw::Adc_bailout => set32(p, &mut r.adc_bailout),
        Kw::Always_sample => set_flag(p, &mut r.always_sample),
        Kw::Brightness => set32(p, &mut r.brightness),
        Kw::Error_bound => set32(p, &mut r.error_bound),
        Kw::Gray_threshold => set32(p, &mut r.gray_threshold),
        Kw::Low_error_factor => set32(p, &mut r.low_error_factor),
        Kw::Max_sample => set32(p, &mut r.max_sample),
        Kw::Media => set_flag(p, &mut r.media),
        Kw::Normal => set_flag(p, &mut r.normal),
        Kw::Subsurface => set_flag(p, &mut r.subsurface),
        Kw::Pretrace_start => set32(p, &mut r.pretrace_start),
        Kw::Pretrace_end => set32(p, &mut r.pretrace_end),
        Kw::Recursion_limit => set_count(p, &mut r.recursion_limit, 1, 20),
        Kw::Nearest_count => {
            p.next()?;
            r.nearest_count = count(p, 1, 20)?;
            r.nearest_count_adaptive = optional_second(p)?.map_or(0, |n| n.clamp(0.0, 20.0) as u32);
            Ok(true)
        }
        Kw::Load_file | Kw::Save_file => {
            let span = p.span();
            p.next()?;
            p.path()?;
            p.warn("no-effect", format!("`{}` has no effect in radiosity any more", key.word()), span);
            Ok(true)
        }
        _ => Ok(false),
    }
}

/// `photons { ... }`; the word has been read. Gathering none switches photons off.
fn photons(p: &mut Parser) -> Result<Option<Photons>> {
    let mut f = Photons::default();
    p.block("photons", |p| match word(p)? {
        Some(key) => photon_item(p, &mut f, key),
        None => p.accept_punct(','),
    })?;
    Ok((f.gather_max > 0).then_some(f))
}

fn photon_item(p: &mut Parser, f: &mut Photons, key: Kw) -> Result<bool> {
    match key {
        Kw::Spacing => return set32(p, &mut f.spacing),
        Kw::Jitter => return set32(p, &mut f.jitter),
        Kw::Autostop => return set32(p, &mut f.autostop),
        Kw::Count => return set_count(p, &mut f.count, 0, 1 << 30),
        _ => {}
    }
    if !matches!(
        key,
        Kw::Gather
            | Kw::Max_trace_level
            | Kw::Adc_bailout
            | Kw::Expand_thresholds
            | Kw::Radius
            | Kw::Media
            | Kw::Save_file
            | Kw::Load_file
    ) {
        return Ok(false);
    }
    p.next()?;
    match key {
        Kw::Gather => {
            f.gather_min = count(p, 0, 1 << 20)?;
            p.comma()?;
            f.gather_max = count(p, 0, 1 << 20)?;
        }
        Kw::Max_trace_level => f.max_trace_level = Some(float(p)?).filter(|&n| n >= 0.0).map(|n| n as u16),
        Kw::Adc_bailout => f.adc_bailout = Some(float32(p)?).filter(|&n| n >= 0.0),
        Kw::Expand_thresholds => {
            f.expand_increase = float32(p)?;
            f.expand_min = comma_float(p)?.max(0.0) as u32;
        }
        Kw::Radius => radius(p, &mut f.radius)?,
        Kw::Media => {
            f.media_max_steps = count(p, 0, 1 << 30)?;
            f.media_factor = optional_second(p)?.map_or(f.media_factor, |n| n as f32);
        }
        Kw::Save_file => f.save_file = Some(p.path()?.to_string()),
        _ => f.load_file = Some(p.path()?.to_string()),
    }
    Ok(true)
}

/// `radius [r1 [, m1 [, r2 [, m2]]]]`
fn radius(p: &mut Parser, numbers: &mut [f32; 4]) -> Result<()> {
    if !p.at_expression()? {
        return Ok(());
    }
    numbers[0] = float32(p)?;
    for number in &mut numbers[1..] {
        match optional_second(p)? {
            Some(n) => *number = n as f32,
            None => break,
        }
    }
    Ok(())
}
