//! The names of the patterns with the arguments that follow them at once.
use std::sync::Arc;

use raggio_math::{Vec2, Vec3};
use raggio_scene::{
    CrackleSettings, DensityFile, FractalKind, FractalSettings, Object, PatternKind, Pigment, SlopeSettings,
};

use super::image::{self, Usage};
use super::util::{comma_float, count, float, take, vec2, vec3, word};
use super::{function, object, pigment};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Reads the list of a block pattern; says whether there was one.
pub type ReadList<'a> = &'a mut dyn FnMut(&mut Parser, usize) -> Result<bool>;

/// The pattern whose name comes next, with its arguments; `list` reads the items of a block pattern.
pub fn kind(p: &mut Parser, list: ReadList) -> Result<Option<PatternKind>> {
    let Some(name) = word(p)? else { return Ok(None) };
    if let Some(kind) = plain(name) {
        p.next()?;
        if let Some(size) = super::pattern::block_size(&kind) {
            list(p, size)?;
        }
        return Ok(Some(kind));
    }
    with_arguments(p, name, list)
}

/// Patterns that are a mere word.
fn plain(name: Kw) -> Option<PatternKind> {
    Some(match name {
        Kw::Agate => PatternKind::Agate { turbulence: 1.0 },
        Kw::Aoi => PatternKind::Aoi,
        Kw::Average => PatternKind::Average,
        Kw::Boxed => PatternKind::Boxed,
        Kw::Bozo | Kw::Spotted | Kw::Bumps => PatternKind::Bozo,
        Kw::Brick => PatternKind::Brick { size: Vec3::new(8.0, 3.0, 4.5), mortar: 0.5 },
        Kw::Cells => PatternKind::Cells,
        Kw::Checker => PatternKind::Checker,
        Kw::Crackle => PatternKind::Crackle(CrackleSettings::default()),
        Kw::Cubic => PatternKind::Cubic,
        Kw::Cylindrical => PatternKind::Cylindrical,
        Kw::Dents => PatternKind::Dents,
        Kw::Facets => PatternKind::Facets { size: 0.1, coords: 0.0, metric: 2.0 },
        Kw::Granite => PatternKind::Granite,
        Kw::Hexagon => PatternKind::Hexagon,
        Kw::Leopard => PatternKind::Leopard,
        Kw::Marble => PatternKind::Marble,
        Kw::Onion => PatternKind::Onion,
        Kw::Pavement => {
            PatternKind::Pavement { sides: 3, tiles: 1, pattern: 1, exterior: 0, interior: 0, form: 0 }
        }
        Kw::Planar => PatternKind::Planar,
        Kw::Quilted => PatternKind::Quilted { control0: 1.0, control1: 1.0 },
        Kw::Radial => PatternKind::Radial,
        Kw::Ripples => PatternKind::Ripples,
        Kw::Spherical => PatternKind::Spherical,
        Kw::Square => PatternKind::Square,
        Kw::Triangular => PatternKind::Triangular,
        Kw::Waves => PatternKind::Waves,
        Kw::Wood => PatternKind::Wood,
        Kw::Wrinkles => PatternKind::Wrinkles,
        _ => return None,
    })
}

fn with_arguments(p: &mut Parser, name: Kw, list: ReadList) -> Result<Option<PatternKind>> {
    let read = match name {
        Kw::Density_file => density_file,
        Kw::Function => function_pattern,
        Kw::Gradient => gradient,
        Kw::Image_pattern => image_pattern,
        Kw::Julia | Kw::Mandel | Kw::Magnet => fractal,
        Kw::Pigment_pattern => pigment_pattern,
        Kw::Slope => slope,
        Kw::Spiral1 => spiral1,
        Kw::Spiral2 => spiral2,
        Kw::Tiling => tiling,
        Kw::Object => return object_pattern(p, list).map(Some),
        _ => return Ok(None),
    };
    if !matches!(name, Kw::Julia | Kw::Mandel | Kw::Magnet) {
        p.next()?;
    }
    read(p).map(Some)
}

/// A zero direction gives a pattern that is 0 everywhere.
fn gradient(p: &mut Parser) -> Result<PatternKind> {
    Ok(PatternKind::Gradient(vec3(p)?.normalize_or_zero()))
}

fn function_pattern(p: &mut Parser) -> Result<PatternKind> {
    Ok(PatternKind::Function(function::float_function(p)?))
}

fn image_pattern(p: &mut Parser) -> Result<PatternKind> {
    Ok(PatternKind::Image(image::block(p, Usage::Pattern)?))
}

fn pigment_pattern(p: &mut Parser) -> Result<PatternKind> {
    let base = Arc::new(Pigment::solid(raggio_scene::Color::BLACK));
    Ok(PatternKind::Pigment(pigment::block(p, &base)?))
}

/// The number of arms of a spiral, which must fit an `i32` in the waist.
fn arms(p: &mut Parser) -> Result<i32> {
    Ok(float(p)? as i32)
}

fn spiral1(p: &mut Parser) -> Result<PatternKind> {
    Ok(PatternKind::Spiral1(arms(p)?))
}

fn spiral2(p: &mut Parser) -> Result<PatternKind> {
    Ok(PatternKind::Spiral2(arms(p)?))
}

fn tiling(p: &mut Parser) -> Result<PatternKind> {
    Ok(PatternKind::Tiling(p.int("tiling", 1..=27)? as u8))
}

/// `density_file df3 "name"`
fn density_file(p: &mut Parser) -> Result<PatternKind> {
    if !p.accept(Kw::Df3)? {
        return p.expected("`df3`");
    }
    let span = p.span();
    let name = p.path()?;
    let bytes = p.file(&name, &[".df3", ".DF3"])?;
    match decode_df3(&bytes) {
        Some((size, samples)) => {
            Ok(PatternKind::DensityFile(Arc::new(DensityFile { size, samples, interpolation: 0 })))
        }
        None => p.error("bad-df3", format!("\"{name}\" is not a df3 file, or it is cut short"), span),
    }
}

/// Sizes and samples of a df3 file: big-endian sizes of 16 bits, then samples of 1, 2 or 4 bytes by the file's length.
fn decode_df3(bytes: &[u8]) -> Option<([usize; 3], Vec<f32>)> {
    let (header, data) = bytes.split_at_checked(6)?;
    let size = [0, 2, 4].map(|i| usize::from(u16::from_be_bytes([header[i], header[i + 1]])));
    let cells = size.iter().product::<usize>();
    if cells == 0 {
        return None;
    }
    let width = [4, 2, 1].into_iter().find(|w| data.len() >= cells.saturating_mul(*w))?;
    let most = (256f64.powi(width as i32) - 1.0) as f32;
    let number = |b: &[u8]| b.iter().fold(0u32, |n, &byte| n << 8 | u32::from(byte));
    let samples =
        data.chunks_exact(width).take(cells).map(|b| (f64::from(number(b)) / f64::from(most)) as f32);
    Some((size, samples.collect()))
}

/// `mandel n`, `julia <c>, n`, each also after `magnet k`.
fn fractal(p: &mut Parser) -> Result<PatternKind> {
    let mut kind = FractalKind::Power(2);
    if p.accept(Kw::Magnet)? {
        kind = match p.int("magnet", 1..=2)? {
            1 => FractalKind::Magnet1,
            _ => FractalKind::Magnet2,
        };
    }
    let julia: Option<Vec2> = if p.accept(Kw::Julia)? {
        let c = vec2(p)?;
        p.comma()?;
        Some(c)
    } else if p.accept(Kw::Mandel)? {
        None
    } else {
        return p.expected("`mandel` or `julia`");
    };
    Ok(PatternKind::Fractal(FractalSettings {
        kind,
        julia,
        iterations: count(p, 1, 1 << 24)?,
        exterior_type: 1,
        exterior_factor: 1.0,
        interior_type: 0,
        interior_factor: 1.0,
    }))
}

/// `slope { direction [, lo, hi] [altitude direction [, lo, hi]] }`; old scenes leave out the braces.
fn slope(p: &mut Parser) -> Result<PatternKind> {
    let braces = p.accept_punct('{')?;
    let point_at = braces && p.accept(Kw::Point_at)?;
    let direction = vec3(p)?;
    let mut settings = SlopeSettings {
        direction,
        point_at,
        slope_range: (0.0, 0.0),
        altitude: None,
        altitude_range: (0.0, 0.0),
    };
    if braces {
        settings.slope_range = range(p)?;
        if !point_at && p.accept(Kw::Altitude)? {
            settings.altitude = Some(vec3(p)?);
            settings.altitude_range = range(p)?;
        }
        p.expect('}')?;
    }
    Ok(PatternKind::Slope(settings))
}

/// `, lo, hi` if it comes next, else (0, 0). Equal limits are ignored, as a range of nothing.
fn range(p: &mut Parser) -> Result<(f64, f64)> {
    if !p.accept_punct(',')? {
        return Ok((0.0, 0.0));
    }
    let span = p.span();
    let lo = float(p)?;
    let hi = comma_float(p)?;
    if lo == hi && lo != 0.0 {
        p.warn("empty-range", "both ends of this range are equal; the range is ignored", span);
        return Ok((0.0, 0.0));
    }
    Ok((lo, hi))
}

/// `object { OBJECT transforms items }`, with the items inside or after the braces.
fn object_pattern(p: &mut Parser, list: ReadList) -> Result<PatternKind> {
    p.next()?;
    p.expect('{')?;
    let mut object: Arc<Object> = match p.peek()? {
        Tok::Value(Kind::Object) => take!(p, Object),
        _ => match object::any(p)? {
            Some(object) => Arc::new(object),
            None => return p.expected("an object"),
        },
    };
    while let Some(transform) = p.accept_transform()? {
        Arc::make_mut(&mut object).transform(&transform);
    }
    object::refuse_patch(p, &object)?;
    let found = list(p, 2)?;
    p.expect('}')?;
    if !found {
        list(p, 2)?;
    }
    Ok(PatternKind::Object(object))
}
