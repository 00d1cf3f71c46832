//! Functions whose value is a vector, and those that ask the engine (language spec, section 2.4).
use std::sync::Arc;

use raggio_math::{Aabb, Vec3, transform};
use raggio_scene::{Object, PigmentKind};

use super::num::Num;
use super::{Parser, Result, Tok};
use crate::keyword::Kw;
use crate::value::{Kind, Value};

fn num(v: Vec3) -> Num {
    Num::vector(&v.to_array())
}

/// Corners are in single precision, and infinite boxes end here.
const HUGE: f64 = 1e10;

impl Parser<'_> {
    pub(super) fn vector_function(&mut self, kw: Kw) -> Result<Num> {
        self.in_parentheses(|p| match kw {
            Kw::Vcross => {
                let a = p.vec3()?;
                Ok(num(a.cross(p.next_vec3()?)))
            }
            Kw::Vnormalize => p.vnormalize(),
            Kw::Vrotate => {
                let v = p.vec3()?;
                Ok(num(transform::rotate(p.next_vec3()?).transform_vector3(v)))
            }
            Kw::Vaxis_rotate => {
                let v = p.vec3()?;
                let axis = p.next_vec3()?;
                Ok(num(transform::rotate_about(axis, p.next_float()?).transform_vector3(v)))
            }
            Kw::Vturbulence => {
                let (lambda, omega, octaves) = (p.float()?, p.next_float()?, p.next_float()?);
                let point = p.next_vec3()?;
                let octaves = octaves.clamp(1.0, 10.0) as u32;
                Ok(num(raggio_math::noise::dturbulence(point, octaves, omega as f32, lambda as f32)))
            }
            Kw::Trace => p.trace(),
            _ => p.extent(kw == Kw::Max_extent),
        })
    }

    fn next_vec3(&mut self) -> Result<Vec3> {
        self.comma()?;
        self.vec3()
    }

    fn vnormalize(&mut self) -> Result<Num> {
        let v = self.vec3()?;
        Ok(num(v.try_normalize().unwrap_or(Vec3::ZERO)))
    }

    /// The object that an identifier names.
    fn object_argument(&mut self) -> Result<Arc<Object>> {
        if self.peek()? == Tok::Unknown {
            return self.undeclared("is no object");
        }
        match self.peek()? {
            Tok::Value(Kind::Object) => match self.take_value()? {
                Value::Object(object) => Ok(object),
                _ => self.expected("the name of an object"),
            },
            _ => self.expected("the name of an object"),
        }
    }

    pub(super) fn inside(&mut self) -> Result<f64> {
        let span = self.span();
        let object = self.object_argument()?;
        let point = self.next_vec3()?;
        match self.engine.inside(&object, point) {
            Some(inside) => Ok(f64::from(u8::from(inside))),
            None => self.error("no-inside", "this object has no inside", span),
        }
    }

    /// `trace(object, origin, direction [, N])`; N must exist and receives the normal.
    fn trace(&mut self) -> Result<Num> {
        let object = self.object_argument()?;
        let origin = self.next_vec3()?;
        let dir = self.next_vec3()?;
        let target = if self.accept_punct(',')? { Some(self.trace_target()?) } else { None };
        let hit = match dir.try_normalize() {
            Some(dir) => self.engine.trace(&object, origin, dir),
            None => None,
        };
        let (point, normal) = hit.unwrap_or((Vec3::ZERO, Vec3::ZERO));
        if let Some((place, span)) = target {
            let Num { v, len } = num(normal);
            self.store(&place, Value::Vector { v, len }, span)?;
        }
        Ok(num(point))
    }

    fn trace_target(&mut self) -> Result<(super::scope::Place, raggio_diag::Span)> {
        if self.peek()? == Tok::Unknown {
            return self.undeclared("must be declared as a vector before trace can write to it");
        }
        if self.peek()? != Tok::Value(Kind::Vector) {
            return self.expected("the name of a vector for the normal");
        }
        let target = (self.cursor.place.clone(), self.here());
        self.next()?;
        Ok(target)
    }

    /// The box around an object.
    pub(crate) fn bounds(&self, object: &Arc<Object>) -> Aabb {
        self.engine.bounds(object)
    }

    fn extent(&mut self, max: bool) -> Result<Num> {
        if self.peek()? == Tok::Value(Kind::Pigment) {
            return self.image_extent();
        }
        let object = self.object_argument()?;
        let bounds = self.bounds(&object);
        let corner = if max { bounds.max } else { bounds.min };
        let limit = |x: f64| f64::from(x.clamp(-HUGE, HUGE) as f32);
        let corner = corner.to_array().map(|x| if x.is_nan() { 0.0 } else { limit(x) });
        Ok(Num::vector(&corner))
    }

    /// The size in pixels of an image map.
    fn image_extent(&mut self) -> Result<Num> {
        let span = self.here();
        if let Value::Pigment(pigment) = self.take_value()?
            && let PigmentKind::Image { image, .. } = &pigment.kind
        {
            let mosaic = &image.source.mosaic;
            return Ok(Num::vector(&[mosaic.width() as f64, mosaic.height() as f64, 0.0]));
        }
        self.error("no-image", "only a pigment that is an image_map has an extent", span)
    }

    /// The value of a function or spline for the arguments that follow in parentheses.
    pub(super) fn call_value(&mut self, value: &Value) -> Result<Num> {
        match value {
            Value::Spline(spline) => self.call_spline(spline),
            Value::Function(function) => self.call_function(function),
            _ => self.expected("a function"),
        }
    }
}
