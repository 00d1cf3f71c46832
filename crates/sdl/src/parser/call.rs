//! Calls of user functions and splines from scene text.
use std::sync::Arc;

use raggio_function::Function;
use smallvec::SmallVec;

use super::num::Num;
use super::spline::{Spline, SplineKind};
use super::{Parser, Result, Tok};
use crate::keyword::Kw;

impl Parser<'_> {
    /// `( a, b ... )` after a function's name.
    pub(super) fn call_function(&mut self, function: &Arc<Function>) -> Result<Num> {
        let span = self.here();
        let args = self.in_parentheses(|p| {
            let mut args: SmallVec<[f64; 8]> = SmallVec::new();
            while p.peek()? != Tok::Punct(')') {
                args.push(p.float()?);
                if !p.accept_punct(',')? {
                    break;
                }
            }
            Ok(args)
        })?;
        if args.len() != function.params() {
            let message = format!("this function takes {} arguments, not {}", function.params(), args.len());
            return self.error("argument-count", message, span);
        }
        Ok(match function.components() {
            1 => Num::float(function.eval(&args)),
            n => Num { v: function.eval5(&args), len: n as u8 },
        })
    }

    /// `( t [, type] )` after a spline's name.
    pub(super) fn call_spline(&mut self, spline: &Spline) -> Result<Num> {
        self.in_parentheses(|p| {
            let t = p.float()?;
            let mut kind = spline.kind();
            if p.accept_punct(',')? {
                kind = match p.accept_spline_kind()? {
                    Some(kind) => kind,
                    None => return p.expected("a type of spline"),
                };
            }
            Ok(Num { v: spline.value(t, kind), len: spline.size() })
        })
    }

    /// A word that names a type of spline, if one comes next.
    pub(super) fn accept_spline_kind(&mut self) -> Result<Option<SplineKind>> {
        let kind = match self.peek()? {
            Tok::Kw(Kw::Linear_spline) => SplineKind::Linear,
            Tok::Kw(Kw::Quadratic_spline) => SplineKind::Quadratic,
            Tok::Kw(Kw::Cubic_spline) => SplineKind::Cubic,
            Tok::Kw(Kw::Natural_spline) => SplineKind::Natural,
            _ => return Ok(None),
        };
        self.next()?;
        Ok(Some(kind))
    }
}
