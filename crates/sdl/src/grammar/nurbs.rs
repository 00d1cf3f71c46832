//! `nurbs_patch { ... }`, an addition to the language: rational B-spline surfaces with trimming curves.
//!
//! Its words are words of the language in its block only; a scene that declares `nurbs_patch` itself has it for itself.
use std::sync::Arc;

use raggio_diag::Span;
use raggio_math::{Vec2, Vec3};
use raggio_scene::{Knots, Nurbs, Object, Shape, Trim};

use super::object;
use super::util::{comma_float, count, vec2, vec3};
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

const MOST_DEGREE: u32 = 9;
/// Points along one direction.
const MOST_POINTS: u32 = 100_000;

/// Does the block come next?
pub fn comes_next(p: &mut Parser) -> Result<bool> {
    Ok(p.peek()? == Tok::Unknown && p.text() == "nurbs_patch")
}

/// `nurbs_patch { u_degree d v_degree d u_knots { } v_knots { } points { nu, nv, ... } weights { } trim { } ... }`
pub fn nurbs_patch(p: &mut Parser) -> Result<Object> {
    p.next()?;
    object::shape(p, "nurbs_patch", |p| {
        let mut surface = Draft::default();
        let (mut v_degree, mut v_knots, mut trims) = (None, None, Vec::new());
        while let Some(word) = next_word(p)? {
            match word.as_str() {
                "u_degree" => surface.degree = Some(degree(p)?),
                "v_degree" => v_degree = Some(degree(p)?),
                "u_knots" => surface.knots = Some(numbers(p, "u_knots")?),
                "v_knots" => v_knots = Some(numbers(p, "v_knots")?),
                "points" => surface.points = Some(net(p)?),
                "weights" => surface.weights = Some(numbers(p, "weights")?),
                "trim" => trims.push(trim(p)?),
                _ => return p.expected("a word of nurbs_patch"),
            }
            p.comma()?;
        }
        let Some((columns, points)) = surface.points else {
            return p.expected("`points { nu, nv, ... }` of nurbs_patch");
        };
        let rows = points.len() / columns;
        let u = knots(p, "u", surface.degree.unwrap_or(3), surface.knots, rows)?;
        let v = knots(p, "v", v_degree.unwrap_or(3), v_knots, columns)?;
        let points = weighted(p, points, surface.weights)?;
        Ok(Shape::Nurbs(Arc::new(Nurbs { u, v, points, trims })))
    })
}

/// What a spline's block has said so far; points with the number of them in a row.
struct Draft<T> {
    degree: Option<usize>,
    knots: Option<List>,
    points: Option<(usize, Vec<T>)>,
    weights: Option<List>,
}

impl<T> Default for Draft<T> {
    fn default() -> Self {
        Draft { degree: None, knots: None, points: None, weights: None }
    }
}

/// Consumes one of the block's own words.
fn next_word(p: &mut Parser) -> Result<Option<String>> {
    const WORDS: [&str; 9] =
        ["u_degree", "v_degree", "u_knots", "v_knots", "points", "weights", "trim", "degree", "knots"];
    // An object's name would be a block to copy; any other name that is declared gives way.
    let may_be = match p.peek()? {
        Tok::Unknown => true,
        Tok::Value(kind) => kind != Kind::Object,
        _ => false,
    };
    if !may_be || !WORDS.contains(&p.text().as_str()) {
        return Ok(None);
    }
    let word = p.text().to_string();
    p.next()?;
    Ok(Some(word))
}

fn degree(p: &mut Parser) -> Result<usize> {
    let span = p.span();
    let degree = count(p, 0, u32::MAX)?;
    if !(1..=MOST_DEGREE).contains(&degree) {
        return p.error("bad-nurbs", format!("a degree must be 1 to {MOST_DEGREE}, not {degree}"), span);
    }
    Ok(degree as usize)
}

/// Numbers, and where their block begins.
struct List {
    values: Vec<f64>,
    span: Span,
}

fn numbers(p: &mut Parser, what: &str) -> Result<List> {
    let (mut values, span) = (Vec::new(), p.span());
    p.block(what, |p| {
        values.push(comma_float(p)?);
        p.comma()?;
        Ok(true)
    })?;
    Ok(List { values, span })
}

/// `{ nu, nv, <x, y, z>, ... }`, v fastest; answers with nv and the points.
fn net(p: &mut Parser) -> Result<(usize, Vec<Vec3>)> {
    p.expect('{')?;
    let rows = count(p, 2, MOST_POINTS)? as usize;
    p.comma()?;
    let columns = count(p, 2, MOST_POINTS)? as usize;
    let points = points(p, rows * columns, "points", vec3)?;
    Ok((columns, points))
}

/// As many points as promised and a closing brace.
fn points<T>(
    p: &mut Parser,
    expected: usize,
    what: &str,
    read: impl Fn(&mut Parser) -> Result<T>,
) -> Result<Vec<T>> {
    let mut list = Vec::new();
    p.comma()?;
    while !p.accept_punct('}')? {
        let span = p.span();
        if list.len() == expected {
            return p.error("bad-nurbs", format!("`{what}` promises {expected} points and has more"), span);
        }
        list.push(read(p)?);
        p.comma()?;
    }
    if list.len() < expected {
        let span = p.span();
        let message = format!("`{what}` promises {expected} points and has {}", list.len());
        return p.error("bad-nurbs", message, span);
    }
    Ok(list)
}

/// `trim { degree d knots { } points { n, <u, v>, ... } weights { } }`; without a degree a polygon.
fn trim(p: &mut Parser) -> Result<Trim> {
    let mut curve = Draft::default();
    p.block("trim", |p| {
        let Some(word) = next_word(p)? else { return Ok(false) };
        match word.as_str() {
            "degree" => curve.degree = Some(degree(p)?),
            "knots" => curve.knots = Some(numbers(p, "knots")?),
            "points" => {
                p.expect('{')?;
                let expected = count(p, 2, MOST_POINTS)? as usize;
                curve.points = Some((expected, points(p, expected, "points", vec2)?));
            }
            "weights" => curve.weights = Some(numbers(p, "weights")?),
            _ => return p.expected("`degree`, `knots`, `points` or `weights` of a trim"),
        }
        p.comma()?;
        Ok(true)
    })?;
    let Some((count, points)) = curve.points else { return p.expected("`points { n, ... }` of a trim") };
    let knots = knots(p, "the curve", curve.degree.unwrap_or(1), curve.knots, count)?;
    let points: Vec<(Vec2, f64)> = weighted(p, points, curve.weights)?;
    Ok(Trim { knots, points })
}

/// The knots along a direction, checked; without any they are evenly spaced from 0 to 1, and the spline begins and
/// ends in its first and last points.
fn knots(p: &mut Parser, along: &str, degree: usize, knots: Option<List>, points: usize) -> Result<Knots> {
    let span = knots.as_ref().map_or_else(|| p.span(), |list| list.span);
    if points <= degree {
        let message = format!(
            "{points} points along {along} are too few for degree {degree}, which needs {}",
            degree + 1
        );
        return p.error("bad-nurbs", message, span);
    }
    let spaced = || {
        let pieces = points - degree;
        (0..points + degree + 1).map(|k| (k.saturating_sub(degree) as f64 / pieces as f64).min(1.0)).collect()
    };
    let knots = Knots { degree, knots: knots.map_or_else(spaced, |list| list.values) };
    let needed = points + degree + 1;
    if knots.knots.len() != needed {
        let found = knots.knots.len();
        let message = format!(
            "{points} points of degree {degree} along {along} need {needed} knots, and there are {found}"
        );
        return p.error("bad-nurbs", message, span);
    }
    if let Some(k) = knots.knots.windows(2).position(|w| w[1] < w[0]) {
        let (a, b) = (knots.knots[k], knots.knots[k + 1]);
        return p.error("bad-nurbs", format!("knots along {along} must not fall, as from {a} to {b}"), span);
    }
    let (from, to) = knots.domain();
    if from >= to {
        return p.error("bad-nurbs", format!("all knots that count along {along} are {from}"), span);
    }
    Ok(knots)
}

/// Points with their weights, or with 1.
fn weighted<T>(p: &mut Parser, points: Vec<T>, weights: Option<List>) -> Result<Vec<(T, f64)>> {
    let Some(List { values: weights, span }) = weights else {
        return Ok(points.into_iter().map(|p| (p, 1.0)).collect());
    };
    if weights.len() != points.len() {
        let message =
            format!("{} points need as many weights, and there are {}", points.len(), weights.len());
        return p.error("bad-nurbs", message, span);
    }
    if let Some(w) = weights.iter().find(|w| **w <= 0.0) {
        return p.error("bad-nurbs", format!("weights must be positive, and one is {w}"), span);
    }
    Ok(points.into_iter().zip(weights).collect())
}
