//! Surfaces given by polynomials (shapes spec, section 2).
use std::sync::Arc;

use raggio_scene::{Object, Shape};

use super::object;
use super::util::{comma_float, comma_vec3, float, vec3};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// `quadric { <a,b,c>, <d,e,f>, <g,h,i>, j }`
pub fn quadric(p: &mut Parser) -> Result<Object> {
    object::shape(p, "quadric", |p| {
        let (squares, mixed, linear) = (vec3(p)?, comma_vec3(p)?, comma_vec3(p)?);
        let j = comma_float(p)?;
        let [[a, b, c], [d, e, f], [g, h, i]] = [squares, mixed, linear].map(|v| v.to_array());
        Ok(Shape::Quadric([a, b, c, d, e, f, g, h, i, j]))
    })
}

/// `cubic { <20 numbers> }`
pub fn cubic(p: &mut Parser) -> Result<Object> {
    object::shape(p, "cubic", |p| listed(p, 3))
}

/// `quartic { <35 numbers> }`
pub fn quartic(p: &mut Parser) -> Result<Object> {
    object::shape(p, "quartic", |p| listed(p, 4))
}

/// `poly { order, <numbers> }`
pub fn poly(p: &mut Parser) -> Result<Object> {
    object::shape(p, "poly", |p| {
        let order = p.int("order of poly", 2..=35)? as u8;
        p.comma()?;
        listed(p, order)
    })
}

/// How many terms a polynomial of this order in three variables has.
fn terms(order: usize) -> usize {
    (order + 1) * (order + 2) * (order + 3) / 6
}

/// `< number, ... >`, all terms in the language's order.
fn listed(p: &mut Parser, order: u8) -> Result<Shape> {
    p.expect('<')?;
    let mut coefficients = Vec::with_capacity(terms(order.into()));
    for _ in 0..terms(order.into()) {
        coefficients.push(float(p)?);
        p.comma()?;
    }
    p.expect('>')?;
    Ok(Shape::Poly { degree: order, coefficients: coefficients.into() })
}

/// `polynomial { order, xyz(i, j, k): number, ... }`; terms not named are 0.
pub fn polynomial(p: &mut Parser) -> Result<Object> {
    object::shape(p, "polynomial", |p| {
        let order = p.int("order of polynomial", 2..=35)? as u8;
        let mut coefficients = vec![0.0; terms(order.into())];
        p.comma()?;
        while p.accept(Kw::Xyz)? {
            let place = term(p, order.into())?;
            p.expect(':')?;
            coefficients[place] = float(p)?;
            p.comma()?;
        }
        Ok(Shape::Poly { degree: order, coefficients: Arc::from(coefficients) })
    })
}

/// `(i, j, k)`: the place of this term in the list, x exponents falling first, then y, then z.
fn term(p: &mut Parser, order: usize) -> Result<usize> {
    let span = p.span();
    p.expect('(')?;
    let mut exponents = [0; 3];
    for exponent in &mut exponents {
        *exponent = p.int("exponent", 0..=35)? as usize;
        p.comma()?;
    }
    p.expect(')')?;
    let [i, j, k] = exponents;
    if i + j + k > order {
        return p.error(
            "bad-term",
            "coefficient of polynomial is out of range: the exponents add to too much",
            span,
        );
    }
    let rest = order - i;
    let before_x: usize = (0..rest).map(|r| (r + 1) * (r + 2) / 2).sum();
    let before_y: usize = (0..rest - j).map(|r| r + 1).sum();
    Ok(before_x + before_y + (rest - j - k))
}
