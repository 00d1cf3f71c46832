//! Warps and what else moves the point before a pattern looks at it (textures spec, section 5).
use raggio_math::{Affine, EPS, Vec3};
use raggio_scene::{Turbulence, Warp};

use super::util::{comma_float, count, float, float32, set, set_vec3, vec3, word};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// Puts a transform at the head of the list, or composes it with the one that is there.
pub fn transform(warps: &mut Vec<Warp>, t: &Affine) {
    if let Some(Warp::Transform { forward, inverse }) = warps.first_mut() {
        *forward = *t * *forward;
        *inverse = forward.inverse();
        return;
    }
    warps.insert(0, Warp::Transform { forward: *t, inverse: t.inverse() });
}

/// Reads one word of classic turbulence into the list's last member, which is made if it is not there.
fn classic_turbulence(p: &mut Parser, warps: &mut Vec<Warp>) -> Result<bool> {
    let mut turbulence = match warps.pop() {
        Some(Warp::ClassicTurbulence(turbulence)) => turbulence,
        other => {
            warps.extend(other);
            Turbulence::default()
        }
    };
    turbulence_item(p, &mut turbulence)?;
    warps.push(Warp::ClassicTurbulence(turbulence));
    Ok(true)
}

/// A transform, `warp { }`, or one of the words of classic turbulence.
pub fn item(p: &mut Parser, warps: &mut Vec<Warp>) -> Result<bool> {
    if let Some(t) = p.accept_transform()? {
        transform(warps, &t);
        return Ok(true);
    }
    if p.accept(Kw::Warp)? {
        warps.insert(0, block(p)?);
        return Ok(true);
    }
    if !matches!(word(p)?, Some(Kw::Turbulence | Kw::Octaves | Kw::Omega | Kw::Lambda)) {
        return Ok(false);
    }
    classic_turbulence(p, warps)
}

/// One of `turbulence octaves omega lambda` with its number.
pub fn turbulence_item(p: &mut Parser, turbulence: &mut Turbulence) -> Result<bool> {
    match word(p)? {
        Some(Kw::Turbulence) => return set_vec3(p, &mut turbulence.amount),
        Some(Kw::Octaves) => {
            p.next()?;
            turbulence.octaves = count(p, 1, 10)?;
        }
        Some(Kw::Omega) => {
            p.next()?;
            turbulence.omega = float32(p)?;
        }
        Some(Kw::Lambda) => {
            p.next()?;
            turbulence.lambda = float32(p)?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// `warp { ... }` after the word.
fn block(p: &mut Parser) -> Result<Warp> {
    let span = p.span();
    let mut warp = None;
    p.block("warp", |p| {
        match &mut warp {
            None => warp = head(p)?,
            Some(warp) => return modifier(p, warp),
        }
        Ok(warp.is_some())
    })?;
    match warp {
        Some(Warp::BlackHole { center, radius, strength, falloff, inverse, repeat, turbulence }) => {
            let (center, repeat) = fitted_black_hole(center, radius, repeat, turbulence);
            Ok(Warp::BlackHole { center, radius, strength, falloff, inverse, repeat, turbulence })
        }
        Some(warp) => Ok(warp),
        None => p.error("empty-warp", "a warp needs a kind, such as `repeat` or `turbulence`", span),
    }
}

/// The word that says which warp, with its own arguments.
fn head(p: &mut Parser) -> Result<Option<Warp>> {
    let Some(kind) = word(p)? else { return Ok(None) };
    Ok(Some(match kind {
        Kw::Repeat => repeat(p)?,
        Kw::Black_hole => {
            p.next()?;
            let center = vec3(p)?;
            let radius = comma_float(p)?;
            let (strength, falloff) = (1.0, 2.0);
            Warp::BlackHole {
                center,
                radius,
                strength,
                falloff,
                inverse: false,
                repeat: None,
                turbulence: None,
            }
        }
        Kw::Turbulence => {
            p.next()?;
            Warp::Turbulence(Turbulence { amount: vec3(p)?, ..Turbulence::default() })
        }
        Kw::Cylindrical => {
            p.next()?;
            Warp::Cylindrical { orientation: Vec3::Z, dist_exp: 0.0 }
        }
        Kw::Spherical => {
            p.next()?;
            Warp::Spherical { orientation: Vec3::Z, dist_exp: 0.0 }
        }
        Kw::Toroidal => {
            p.next()?;
            Warp::Toroidal { orientation: Vec3::Z, dist_exp: 0.0, major_radius: 1.0 }
        }
        Kw::Planar => planar(p)?,
        Kw::Cubic => {
            p.next()?;
            Warp::Cubic
        }
        _ => return Ok(None),
    }))
}

/// `repeat <w, 0, 0>`: the one axis that is not zero.
fn repeat(p: &mut Parser) -> Result<Warp> {
    p.next()?;
    let span = p.span();
    let v = vec3(p)?;
    let axes: Vec<usize> = (0..3).filter(|&k| v[k].abs() > EPS).collect();
    match axes[..] {
        [axis] => {
            Ok(Warp::Repeat { axis: axis as u8, width: v[axis] as f32, flip: Vec3::ZERO, offset: Vec3::ZERO })
        }
        _ => p.error("bad-warp", "a repeat warp needs exactly one axis with a width other than 0", span),
    }
}

/// `planar [normal, distance]`
fn planar(p: &mut Parser) -> Result<Warp> {
    p.next()?;
    let (mut orientation, mut distance) = (Vec3::Z, 0.0);
    if p.at_expression()? {
        orientation = direction(p)?;
        distance = comma_float(p)?;
    }
    Ok(Warp::Planar { orientation, distance })
}

/// A vector made of unit length; zero is refused.
fn direction(p: &mut Parser) -> Result<Vec3> {
    let span = p.span();
    let v = vec3(p)?;
    match v.try_normalize() {
        Some(v) => Ok(v),
        None => p.error("zero-vector", "a direction cannot be the zero vector", span),
    }
}

/// What may follow the head of a warp.
fn modifier(p: &mut Parser, warp: &mut Warp) -> Result<bool> {
    if p.accept_punct(',')? {
        return Ok(true);
    }
    let Some(key) = word(p)? else { return Ok(false) };
    match (warp, key) {
        (Warp::Repeat { flip, .. }, Kw::Flip) => set_vec3(p, flip),
        (Warp::Repeat { offset, .. }, Kw::Offset) => set_vec3(p, offset),
        (Warp::Turbulence(turbulence), _) => turbulence_item(p, turbulence),
        (Warp::Cylindrical { dist_exp, .. }, Kw::Dist_exp)
        | (Warp::Spherical { dist_exp, .. }, Kw::Dist_exp)
        | (Warp::Toroidal { dist_exp, .. }, Kw::Dist_exp) => set(p, dist_exp),
        (Warp::Toroidal { major_radius, .. }, Kw::Major_radius) => set(p, major_radius),
        (Warp::Cylindrical { orientation, .. }, Kw::Orientation)
        | (Warp::Spherical { orientation, .. }, Kw::Orientation)
        | (Warp::Toroidal { orientation, .. }, Kw::Orientation)
        | (Warp::Planar { orientation, .. }, Kw::Orientation) => {
            p.next()?;
            *orientation = direction(p)?;
            Ok(true)
        }
        (warp @ Warp::BlackHole { .. }, key) => black_hole_modifier(p, warp, key),
        _ => Ok(false),
    }
}

fn black_hole_modifier(p: &mut Parser, warp: &mut Warp, key: Kw) -> Result<bool> {
    let Warp::BlackHole { strength, falloff, inverse, repeat, turbulence, .. } = warp else {
        return Ok(false);
    };
    match key {
        Kw::Strength => set(p, strength),
        Kw::Falloff => set(p, falloff),
        Kw::Inverse => {
            p.next()?;
            *inverse = true;
            Ok(true)
        }
        Kw::Repeat => set_vec3(p, repeat.insert(Vec3::ZERO)),
        Kw::Turbulence => set_vec3(p, turbulence.insert(Vec3::ZERO)),
        Kw::Type => {
            p.next()?;
            float(p).map(|_| true)
        }
        _ => Ok(false),
    }
}

/// A repeated black hole must lie within its block: the centre and the block grow to fit.
fn fitted_black_hole(
    mut center: Vec3,
    radius: f64,
    repeat: Option<Vec3>,
    turbulence: Option<Vec3>,
) -> (Vec3, Option<Vec3>) {
    let Some(mut repeat) = repeat else { return (center, None) };
    for k in 0..3 {
        if repeat[k] > 0.0 {
            center[k] = center[k].max(radius);
            repeat[k] = repeat[k].max(center[k] + radius + turbulence.map_or(0.0, |u| u[k]));
        }
    }
    (center, Some(repeat))
}
