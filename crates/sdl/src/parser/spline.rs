//! Splines (language spec, section 2.7).
use std::any::Any;
use std::sync::Arc;

use raggio_function::External;

use super::{Parser, Result, Tok};
use crate::value::{Kind, Value};

/// How points make a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplineKind {
    /// Straight pieces.
    Linear,
    /// Parabolas through three neighbours.
    Quadratic,
    /// Catmull-Rom.
    Cubic,
    /// Natural cubic.
    Natural,
}

type Point = [f64; 5];

/// A curve through points, each at its parameter.
#[derive(Clone, Debug)]
pub struct Spline {
    kind: SplineKind,
    size: u8,
    t: Vec<f64>,
    p: Vec<Point>,
    /// Second derivatives of the natural spline at the points.
    bend: Vec<Point>,
}

impl Spline {
    fn new(kind: SplineKind) -> Self {
        Spline { kind, size: 2, t: Vec::new(), p: Vec::new(), bend: Vec::new() }
    }

    /// Its own type.
    pub fn kind(&self) -> SplineKind {
        self.kind
    }

    /// How many components its values have.
    pub fn size(&self) -> u8 {
        self.size
    }

    /// Adds a point. One at a known parameter replaces that point, except at the largest, where the old one stays.
    fn add(&mut self, t: f64, p: Point, size: u8) {
        self.size = self.size.max(size);
        let at = self.t.partition_point(|&other| other < t);
        if self.t.get(at) == Some(&t) {
            if at + 1 < self.t.len() || at == 0 {
                self.p[at] = p;
            }
            return;
        }
        self.t.insert(at, t);
        self.p.insert(at, p);
    }

    /// The value at `t`, as if it were of type `kind`.
    pub fn value(&self, t: f64, kind: SplineKind) -> Point {
        let last = self.t.len() - 1;
        if last == 0 {
            return self.p[0];
        }
        if kind == SplineKind::Cubic {
            return self.catmull_rom(t);
        }
        if t <= self.t[0] || t.is_nan() {
            return self.p[0];
        }
        if t >= self.t[last] {
            return self.p[last];
        }
        let i = self.t.partition_point(|&other| other < t) - 1;
        match kind {
            SplineKind::Quadratic if last >= 2 => self.parabola(t, i.max(1)),
            SplineKind::Natural if last >= 2 => self.natural(t, i),
            _ => {
                let u = (t - self.t[i]) / (self.t[i + 1] - self.t[i]);
                each(|k| self.p[i][k] + (self.p[i + 1][k] - self.p[i][k]) * u)
            }
        }
    }

    /// The parabola through points `i - 1`, `i` and `i + 1`.
    fn parabola(&self, t: f64, i: usize) -> Point {
        let (a, b, c) = (self.t[i - 1], self.t[i], self.t[i + 1]);
        let wa = (t - b) * (t - c) / ((a - b) * (a - c));
        let wb = (t - a) * (t - c) / ((b - a) * (b - c));
        let wc = (t - a) * (t - b) / ((c - a) * (c - b));
        each(|k| self.p[i - 1][k] * wa + self.p[i][k] * wb + self.p[i + 1][k] * wc)
    }

    fn natural(&self, t: f64, i: usize) -> Point {
        let d = self.t[i + 1] - self.t[i];
        let (a, b) = ((self.t[i + 1] - t) / d, (t - self.t[i]) / d);
        let (ca, cb) = ((a * a * a - a) * d * d / 6.0, (b * b * b - b) * d * d / 6.0);
        each(|k| a * self.p[i][k] + b * self.p[i + 1][k] + ca * self.bend[i][k] + cb * self.bend[i + 1][k])
    }

    /// Cubic Hermite pieces between the second and the last but one point.
    fn catmull_rom(&self, t: f64) -> Point {
        let last = self.t.len() - 1;
        if last == 1 {
            return each(|k| (self.p[0][k] + self.p[1][k]) * 0.5);
        }
        if t <= self.t[1] || t.is_nan() {
            return self.p[1];
        }
        if t >= self.t[last - 1] {
            return self.p[last - 1];
        }
        let i = self.t.partition_point(|&other| other <= t) - 1;
        let d = self.t[i + 1] - self.t[i];
        let u = (t - self.t[i]) / d;
        let (u2, u3) = (u * u, u * u * u);
        each(|k| {
            let slope = |j: usize| (self.p[j + 1][k] - self.p[j][k]) / (self.t[j + 1] - self.t[j]);
            let m0 = d * (slope(i - 1) + slope(i)) / 2.0;
            let m1 = d * (slope(i) + slope(i + 1)) / 2.0;
            self.p[i][k] * (2.0 * u3 - 3.0 * u2 + 1.0)
                + m0 * (u3 - 2.0 * u2 + u)
                + self.p[i + 1][k] * (3.0 * u2 - 2.0 * u3)
                + m1 * (u3 - u2)
        })
    }

    /// Solves for the second derivatives of the natural spline (a tridiagonal system, by elimination).
    fn finish(&mut self) {
        let n = self.t.len();
        self.bend = vec![[0.0; 5]; n];
        if n < 3 {
            return;
        }
        let mut above = vec![0.0; n];
        for i in 1..n - 1 {
            let (before, after) = (self.t[i] - self.t[i - 1], self.t[i + 1] - self.t[i]);
            let pivot = 2.0 * (before + after) - before * above[i - 1];
            above[i] = after / pivot;
            self.bend[i] = each(|k| {
                let turn =
                    (self.p[i + 1][k] - self.p[i][k]) / after - (self.p[i][k] - self.p[i - 1][k]) / before;
                (6.0 * turn - before * self.bend[i - 1][k]) / pivot
            });
        }
        for i in (1..n - 1).rev() {
            self.bend[i] = each(|k| self.bend[i][k] - above[i] * self.bend[i + 1][k]);
        }
    }
}

fn each(component: impl Fn(usize) -> f64) -> Point {
    [0, 1, 2, 3, 4].map(component)
}

impl External for Spline {
    fn eval(&self, args: &[f64]) -> [f64; 5] {
        self.value(args.first().copied().unwrap_or(0.0), self.kind)
    }

    fn components(&self) -> usize {
        self.size as usize
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

impl Parser<'_> {
    /// `spline { ... }`, the word already read.
    pub fn spline(&mut self) -> Result<Arc<Spline>> {
        let mut spline = Spline::new(SplineKind::Linear);
        let start = self.here();
        self.block("spline", |p| {
            if p.peek()? == Tok::Value(Kind::Spline) && spline.t.is_empty() {
                if let Value::Spline(other) = p.take_value()? {
                    spline = (*other).clone();
                }
                return Ok(true);
            }
            if let Some(kind) = p.accept_spline_kind()? {
                spline.kind = kind;
                return Ok(true);
            }
            if !p.at_expression()? {
                return Ok(false);
            }
            let t = p.float()?;
            p.comma()?;
            let (point, size) = if p.at_color_word()? { (p.channels()?, 5) } else { p.spline_point()? };
            p.comma()?;
            spline.add(t, point, size);
            Ok(true)
        })?;
        if spline.t.is_empty() {
            return self.error("empty-spline", "a spline needs at least one point", start);
        }
        spline.finish();
        Ok(Arc::new(spline))
    }

    fn spline_point(&mut self) -> Result<(Point, u8)> {
        let value = self.full()?;
        let value = value.padded(2);
        Ok((value.v, value.len))
    }
}
