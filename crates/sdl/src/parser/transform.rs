//! Transforms as they are written.
use raggio_math::{Affine, Vec3, transform};

use super::{Parser, Result, Tok};
use crate::keyword::Kw;
use crate::value::{Kind, Value};

impl Parser<'_> {
    /// One of `translate rotate scale matrix transform` if it comes next.
    pub fn accept_transform(&mut self) -> Result<Option<Affine>> {
        let Tok::Kw(kw @ (Kw::Translate | Kw::Rotate | Kw::Scale | Kw::Matrix | Kw::Transform)) =
            self.peek()?
        else {
            return Ok(None);
        };
        self.next()?;
        Ok(Some(match kw {
            Kw::Translate => transform::translate(self.finite_vec3()?),
            Kw::Rotate => transform::rotate(self.finite_vec3()?),
            Kw::Scale => self.scale()?,
            Kw::Matrix => self.matrix()?,
            _ => self.transform()?,
        }))
    }

    fn finite_vec3(&mut self) -> Result<Vec3> {
        let v = self.vec3()?;
        if v.is_finite() {
            return Ok(v);
        }
        self.met_undefined("a transform that is not finite")?;
        Ok(Vec3::ONE)
    }

    /// A zero becomes one, as the transform could not be undone.
    fn scale(&mut self) -> Result<Affine> {
        let span = self.span();
        let mut by = self.finite_vec3()?;
        if by.to_array().contains(&0.0) {
            self.warn("zero-scale", "scale by zero; taken as 1", span);
            by = by.map(|c| if c == 0.0 { 1.0 } else { c });
        }
        Ok(transform::scale(by))
    }

    /// `matrix <12 numbers>`
    fn matrix(&mut self) -> Result<Affine> {
        let span = self.span();
        self.expect('<')?;
        let mut m = [0.0; 12];
        self.nested(|p| {
            for entry in &mut m {
                *entry = p.float()?;
                p.comma()?;
            }
            Ok(())
        })?;
        self.expect('>')?;
        self.invertible(transform::matrix(&m), span)
    }

    fn invertible(&self, t: Affine, span: raggio_diag::Span) -> Result<Affine> {
        let determinant = t.matrix3.determinant();
        if determinant != 0.0 && t.is_finite() && t.inverse().is_finite() {
            return Ok(t);
        }
        self.error("singular-matrix", "this transform can't be undone: it flattens space", span)
    }

    /// `transform T` or `transform { T translate ... inverse }`, the word already read; `inverse` acts on the whole.
    pub fn transform(&mut self) -> Result<Affine> {
        if let Some(t) = self.accept_transform_identifier()? {
            return Ok(t);
        }
        let span = self.span();
        let (mut total, mut inverse) = (Affine::IDENTITY, false);
        self.block("transform", |p| {
            if p.accept(Kw::Inverse)? {
                inverse = true;
            } else if let Some(t) = p.accept_transform_identifier()? {
                total = t * total;
            } else if let Some(t) = p.accept_transform()? {
                total = t * total;
            } else {
                return Ok(false);
            }
            Ok(true)
        })?;
        let total = self.invertible(total, span)?;
        Ok(if inverse { total.inverse() } else { total })
    }

    fn accept_transform_identifier(&mut self) -> Result<Option<Affine>> {
        if self.peek()? != Tok::Value(Kind::Transform) {
            return Ok(None);
        }
        match self.take_value()? {
            Value::Transform(t) => Ok(Some(*t)),
            _ => Ok(None),
        }
    }
}
