//! Patterns while they are being read: the formula, its own parameters, and the modifiers that all patterns share.
use std::sync::Arc;

use raggio_scene::{FractalSettings, Pattern, PatternKind, Warp, Wave};

use super::util::{count, float, float32, optional_second, set, set_vec3, set32, word};
use super::warp;
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// A pattern that is not complete yet. Without a kind it only gathers modifiers.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The formula.
    pub kind: Option<PatternKind>,
    /// What acts on the point, first to act first.
    pub warps: Vec<Warp>,
    /// What the values of the formula become.
    pub wave: Wave,
    /// How often it repeats.
    pub frequency: f32,
    phase: f32,
    noise_generator: u8,
}

impl Default for Draft {
    fn default() -> Self {
        Draft {
            kind: None,
            warps: Vec::new(),
            wave: Wave::Ramp,
            frequency: 1.0,
            phase: 0.0,
            noise_generator: 0,
        }
    }
}

impl From<&Pattern> for Draft {
    fn from(pattern: &Pattern) -> Self {
        Draft {
            kind: Some(pattern.kind.clone()),
            warps: pattern.warps.clone(),
            wave: pattern.wave,
            frequency: pattern.frequency,
            phase: pattern.phase,
            noise_generator: pattern.noise_generator,
        }
    }
}

impl Draft {
    /// A draft that has nothing but warps.
    pub fn from_warps(warps: &[Warp]) -> Self {
        Draft { warps: warps.to_vec(), ..Draft::default() }
    }

    /// Sets the formula, with the wave and the frequency that are its custom; in place of another formula only with
    /// those that are not everybody's.
    pub fn set_kind(&mut self, kind: PatternKind) {
        let (wave, frequency) = (default_wave(&kind), default_frequency(&kind));
        if self.kind.is_none() || wave != Wave::Ramp {
            self.wave = wave;
        }
        if self.kind.is_none() || frequency == 0.0 || self.frequency == 0.0 {
            self.frequency = frequency;
        }
        self.kind = Some(kind);
    }

    /// The finished pattern of the given kind.
    pub fn finish(self, kind: PatternKind) -> Arc<Pattern> {
        Arc::new(Pattern {
            kind,
            warps: self.warps,
            wave: self.wave,
            frequency: self.frequency,
            phase: self.phase,
            noise_generator: self.noise_generator,
        })
    }
}

fn default_wave(kind: &PatternKind) -> Wave {
    match kind {
        PatternKind::Marble | PatternKind::Wood | PatternKind::Spiral1(_) | PatternKind::Spiral2(_) => {
            Wave::Triangle
        }
        _ => Wave::Ramp,
    }
}

/// Patterns whose values are indices or colours are not wrapped into 0..1.
fn default_frequency(kind: &PatternKind) -> f32 {
    match kind {
        PatternKind::Checker
        | PatternKind::Object(_)
        | PatternKind::Brick { .. }
        | PatternKind::Hexagon
        | PatternKind::Square
        | PatternKind::Triangular
        | PatternKind::Cubic
        | PatternKind::Quilted { .. }
        | PatternKind::Image(_) => 0.0,
        _ => 1.0,
    }
}

/// How many items the list of a block pattern holds; `None` for the others.
pub fn block_size(kind: &PatternKind) -> Option<usize> {
    Some(match kind {
        PatternKind::Checker | PatternKind::Brick { .. } | PatternKind::Object(_) => 2,
        PatternKind::Hexagon => 3,
        PatternKind::Square => 4,
        PatternKind::Triangular | PatternKind::Cubic => 6,
        _ => return None,
    })
}

/// A pattern modifier: warps and transforms, wave forms, or a parameter of the draft's own formula.
pub fn modifier(p: &mut Parser, draft: &mut Draft) -> Result<bool> {
    if warp::item(p, &mut draft.warps)? {
        return Ok(true);
    }
    let Some(key) = word(p)? else { return Ok(false) };
    match key {
        Kw::Frequency => return set32(p, &mut draft.frequency),
        Kw::Phase => return set32(p, &mut draft.phase),
        Kw::Noise_generator => {
            p.next()?;
            draft.noise_generator = p.int("noise_generator", 0..=3)? as u8;
            return Ok(true);
        }
        _ => {}
    }
    if let Some(wave) = wave(p, key)? {
        draft.wave = wave;
        return Ok(true);
    }
    match &mut draft.kind {
        Some(kind) => parameter(p, kind, key),
        None => Ok(false),
    }
}

fn wave(p: &mut Parser, key: Kw) -> Result<Option<Wave>> {
    let wave = match key {
        Kw::Ramp_wave => Wave::Ramp,
        Kw::Triangle_wave => Wave::Triangle,
        Kw::Sine_wave => Wave::Sine,
        Kw::Scallop_wave => Wave::Scallop,
        Kw::Cubic_wave => Wave::Cubic,
        Kw::Poly_wave => Wave::Poly(1.0),
        _ => return Ok(None),
    };
    p.next()?;
    if matches!(wave, Wave::Poly(_)) {
        return Ok(Some(Wave::Poly(p.optional_float(1.0)? as f32)));
    }
    Ok(Some(wave))
}

/// A parameter that only some formulas have.
fn parameter(p: &mut Parser, kind: &mut PatternKind, key: Kw) -> Result<bool> {
    match (kind, key) {
        (PatternKind::Agate { turbulence }, Kw::Agate_turb) => set32(p, turbulence),
        (PatternKind::Brick { size, .. }, Kw::Brick_size) => set_vec3(p, size),
        (PatternKind::Brick { mortar, .. }, Kw::Mortar) => set32(p, mortar),
        (PatternKind::Crackle(c), Kw::Form) => set_vec3(p, &mut c.form),
        (PatternKind::Crackle(c), Kw::Metric) => set(p, &mut c.metric),
        (PatternKind::Crackle(c), Kw::Offset) => set(p, &mut c.offset),
        (PatternKind::Crackle(c), Kw::Solid) => {
            p.next()?;
            c.solid = p.flag()?;
            Ok(true)
        }
        (PatternKind::DensityFile(file), Kw::Interpolate) => {
            p.next()?;
            Arc::make_mut(file).interpolation = count(p, 0, 9)?.min(2) as u8;
            Ok(true)
        }
        (PatternKind::Facets { size, .. }, Kw::Size) => set(p, size),
        (PatternKind::Facets { coords, .. }, Kw::Coords) => set(p, coords),
        (PatternKind::Facets { metric, .. }, Kw::Metric) => set(p, metric),
        (PatternKind::Fractal(f), key) => fractal_parameter(p, f, key),
        (PatternKind::Quilted { control0, .. }, Kw::Control0) => set32(p, control0),
        (PatternKind::Quilted { control1, .. }, Kw::Control1) => set32(p, control1),
        (kind @ PatternKind::Pavement { .. }, key) => pavement_parameter(p, kind, key),
        _ => Ok(false),
    }
}

fn fractal_parameter(p: &mut Parser, f: &mut FractalSettings, key: Kw) -> Result<bool> {
    match key {
        Kw::Exponent => {
            p.next()?;
            let exponent = float(p)?;
            if let raggio_scene::FractalKind::Power(e) = &mut f.kind {
                *e = if (2.0..34.0).contains(&exponent) { exponent as u8 } else { 2 };
            }
        }
        Kw::Exterior => {
            p.next()?;
            f.exterior_type = p.int("exterior type", 0..=8)? as u8;
            f.exterior_factor = optional_second(p)?.unwrap_or(f.exterior_factor);
        }
        Kw::Interior => {
            p.next()?;
            f.interior_type = p.int("interior type", 0..=6)? as u8;
            f.interior_factor = optional_second(p)?.unwrap_or(f.interior_factor);
        }
        _ => return Ok(false),
    }
    Ok(true)
}

fn pavement_parameter(p: &mut Parser, kind: &mut PatternKind, key: Kw) -> Result<bool> {
    let PatternKind::Pavement { sides, tiles, pattern, exterior, interior, form } = kind else {
        return Ok(false);
    };
    let place = match key {
        Kw::Number_of_sides => sides,
        Kw::Number_of_tiles => tiles,
        Kw::Pattern => pattern,
        Kw::Exterior => exterior,
        Kw::Interior => interior,
        Kw::Form => form,
        _ => return Ok(false),
    };
    p.next()?;
    *place = p.int(key.word(), 0..=255)? as u8;
    Ok(true)
}

/// Checks what can only be judged when all parameters are there.
pub fn checked(p: &mut Parser, kind: PatternKind) -> Result<PatternKind> {
    let PatternKind::Pavement { sides, tiles, pattern, exterior, interior, form } = kind else {
        return Ok(kind);
    };
    let patterns: &[u8] = match sides {
        3 => &[1, 1, 1, 3, 4, 12],
        4 => &[1, 1, 2, 5, 12, 35],
        6 => &[1, 1, 3, 7, 22],
        _ => return pavement_error(p, "number_of_sides of pavement must be 3, 4 or 6".into()),
    };
    let Some(&most) = patterns.get(usize::from(tiles).wrapping_sub(1)) else {
        let message = format!("number_of_tiles of pavement must be between 1 and {}", patterns.len());
        return pavement_error(p, message);
    };
    if !(1..=most).contains(&pattern) {
        return pavement_error(p, format!("pattern of pavement must be between 1 and {most} here"));
    }
    let (exterior, interior, form) = (exterior % 3, interior % 3, form % if sides == 4 { 4 } else { 3 });
    Ok(PatternKind::Pavement { sides, tiles, pattern, exterior, interior, form })
}

fn pavement_error<T>(p: &mut Parser, message: String) -> Result<T> {
    let span = p.span();
    p.error("bad-pavement", message, span)
}

/// Reads a number in single precision that may follow a comma, as the amount of a normal does.
pub fn amount(p: &mut Parser) -> Result<Option<f32>> {
    p.comma()?;
    Ok(if p.at_expression()? { Some(float32(p)?) } else { None })
}
