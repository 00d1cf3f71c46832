//! `function { ... }`: expressions and the bodies that are pigments, patterns, transforms, splines or built-in
//! functions (language spec, section 3).
use std::any::Any;
use std::sync::Arc;

use raggio_function::{Expr, External, Internal};
use raggio_math::{Affine, Vec3};
use raggio_scene::{Color, Function, PatternKind, Pigment};

use super::function_expr::Body;
use super::util::take;
use super::{pattern, pattern_kind, pigment};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// Most parameters of a function.
const MOST_PARAMETERS: usize = 56;

/// `function [(parameters)] { ... }`; the word has been read.
pub fn function_value(p: &mut Parser) -> Result<Arc<Function>> {
    let parameters = parameters(p)?;
    body(p, &parameters, parameters.is_empty())
}

/// The same where a number is wanted: patterns and surfaces.
pub fn float_function(p: &mut Parser) -> Result<Arc<Function>> {
    let span = p.span();
    let function = function_value(p)?;
    if function.components() != 1 {
        return p.error(
            "bad-function",
            "this function gives a vector or colour; a number is wanted here",
            span,
        );
    }
    Ok(function)
}

/// `(a, b, ...)`, or nothing for x, y, z.
fn parameters(p: &mut Parser) -> Result<Vec<String>> {
    let mut names = Vec::new();
    if !p.accept_punct('(')? {
        return Ok(names);
    }
    let span = p.span();
    while !p.accept_punct(')')? {
        if !matches!(p.peek()?, Tok::Kw(_) | Tok::Value(_) | Tok::Unknown) {
            return p.expected("the name of a parameter");
        }
        names.push(p.text());
        p.next()?;
        p.comma()?;
    }
    if names.len() > MOST_PARAMETERS {
        return p.error(
            "too-many-parameters",
            format!("a function has at most {MOST_PARAMETERS} parameters"),
            span,
        );
    }
    Ok(names)
}

/// `{ ... }`; without parameters the body may be one of the special ones.
pub fn body(p: &mut Parser, parameters: &[String], special: bool) -> Result<Arc<Function>> {
    p.expect('{')?;
    p.nested(|p| {
        let function = match special_body(p, special)? {
            Some(function) => function,
            None => {
                let expr = Body::new(parameters).expression(p)?;
                let count = if parameters.is_empty() { 3 } else { parameters.len() };
                Function::with_noise_generator(count, expr, p.settings.noise_generator)
            }
        };
        p.expect('}')?;
        Ok(Arc::new(function))
    })
}

fn special_body(p: &mut Parser, special: bool) -> Result<Option<Function>> {
    let key = match p.peek()? {
        Tok::Kw(key @ (Kw::Internal | Kw::Pigment | Kw::Pattern | Kw::Transform | Kw::Spline)) if special => {
            key
        }
        _ => return Ok(None),
    };
    Ok(Some(match key {
        Kw::Internal => internal(p)?,
        Kw::Pigment => {
            p.next()?;
            let pigment = pigment::block(p, &Pigment::solid(Color::BLACK))?;
            Function::external(3, p.engine().pigment_function(pigment, &p.settings))
        }
        Kw::Pattern => {
            p.next()?;
            pattern_body(p)?
        }
        Kw::Transform => match p.accept_transform()? {
            Some(t) => Function::external(3, Arc::new(TransformFunction(t))),
            None => return p.expected("a transform"),
        },
        _ => {
            p.next()?;
            Function::external(1, p.spline()?)
        }
    }))
}

/// `internal(n)`: x, y, z and the function's own parameters.
fn internal(p: &mut Parser) -> Result<Function> {
    p.next()?;
    p.expect('(')?;
    let n = p.int("number of internal function", 0..=78)? as usize;
    p.expect(')')?;
    let count = 3 + INTERNAL_PARAMETERS[n];
    let arguments = (0..count).map(Expr::Slot).collect();
    let body = Expr::Internal(Internal(n as u8), arguments);
    Ok(Function::with_noise_generator(count, body, p.settings.noise_generator))
}

/// How many parameters beyond x, y, z each internal function takes (table in section 3.4).
const INTERNAL_PARAMETERS: [usize; 79] = [
    5, 5, 5, 5, 2, 2, 5, 4, 2, 1, 4, 1, 1, 1, 1, 6, 6, 3, 1, 4, 3, 6, 1, 1, 10, 7, 7, 1, 1, 6, 1, 3, 4, 3, 6,
    1, 1, 4, 1, 6, 5, 1, 1, 1, 4, 1, 3, 0, 1, 1, 7, 5, 6, 1, 1, 1, 3, 0, 6, 6, 4, 1, 5, 4, 6, 1, 4, 7, 2, 0,
    2, 3, 1, 1, 2, 6, 0, 0, 1,
];

/// `pattern { name modifiers }`
fn pattern_body(p: &mut Parser) -> Result<Function> {
    let mut draft = pattern::Draft::default();
    p.block("pattern", |p| {
        match pattern_kind::kind(p, &mut |_, _| Ok(false))? {
            Some(kind) => draft.set_kind(kind),
            None => return pattern::modifier(p, &mut draft),
        }
        Ok(true)
    })?;
    let span = p.span();
    let kind = match draft.kind.take() {
        None => return p.expected("the name of a pattern before"),
        Some(
            PatternKind::Square
            | PatternKind::Triangular
            | PatternKind::Tiling(_)
            | PatternKind::Pavement { .. }
            | PatternKind::Slope(_)
            | PatternKind::Aoi
            | PatternKind::Facets { .. }
            | PatternKind::Average,
        ) => return p.error("bad-pattern", "this pattern cannot be used as a function", span),
        Some(kind) => kind,
    };
    let pattern = draft.finish(kind);
    Ok(Function::external(3, p.engine().pattern_function(pattern, &p.settings)))
}

/// `function { transform { ... } }`: where a point goes.
#[derive(Debug)]
struct TransformFunction(Affine);

impl External for TransformFunction {
    fn eval(&self, args: &[f64]) -> [f64; 5] {
        let c = |i: usize| args.get(i).copied().unwrap_or(0.0);
        let v = self.0.transform_point3(Vec3::new(c(0), c(1), c(2)));
        [v.x, v.y, v.z, 0.0, 0.0]
    }

    fn components(&self) -> usize {
        3
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// The function of an identifier, or one written in full; the word `function` comes next or has an identifier's place.
pub fn after_word_or_identifier(p: &mut Parser) -> Result<Option<Arc<Function>>> {
    if p.peek()? == Tok::Value(Kind::Function) {
        return Ok(Some(take!(p, Function)));
    }
    match p.accept(Kw::Function)? {
        true => float_function(p).map(Some),
        false => Ok(None),
    }
}
