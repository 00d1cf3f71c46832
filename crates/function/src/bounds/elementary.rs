//! Arithmetic and elementary functions of bounds.
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use raggio_math::turns::{floor, trunc};

use super::{Bounds, Range, VARIABLES};
use crate::{BinaryOp, Builtin};

/// For each variable. Written out, for `from_fn` is not opened in place.
#[inline(always)]
pub(super) fn each(f: impl Fn(usize) -> Range) -> [Range; VARIABLES] {
    [f(0), f(1), f(2)]
}

impl Add for Bounds {
    type Output = Bounds;
    #[inline]
    fn add(self, o: Bounds) -> Bounds {
        let turns = match (self.turns, o.turns) {
            (t, 0.0) | (0.0, t) => t,
            (a, b) if a == b => a,
            _ => return Bounds::UNKNOWN,
        };
        Bounds { value: self.value + o.value, slopes: each(|k| self.slopes[k] + o.slopes[k]), turns }
    }
}

impl AddAssign for Bounds {
    #[inline]
    fn add_assign(&mut self, o: Bounds) {
        *self = *self + o;
    }
}

impl Neg for Bounds {
    type Output = Bounds;
    #[inline]
    fn neg(self) -> Bounds {
        Bounds { value: -self.value, slopes: each(|k| -self.slopes[k]), turns: self.turns }
    }
}

impl Sub for Bounds {
    type Output = Bounds;
    #[inline]
    fn sub(self, o: Bounds) -> Bounds {
        self + -o
    }
}

impl Mul for Bounds {
    type Output = Bounds;
    #[inline]
    fn mul(self, o: Bounds) -> Bounds {
        if self.is_vague() || o.is_vague() {
            return match (self.as_constant(), o.as_constant()) {
                (None, Some(k)) => self.turned(k),
                (Some(k), None) => o.turned(k),
                _ => Bounds::UNKNOWN,
            };
        }
        if let Some(scaled) = self.scaled(&o).or_else(|| o.scaled(&self)) {
            return scaled;
        }
        let slope = |k: usize| self.slopes[k] * o.value + o.slopes[k] * self.value;
        Bounds::new(self.value * o.value, each(slope))
    }
}

impl Div for Bounds {
    type Output = Bounds;
    fn div(self, o: Bounds) -> Bounds {
        if self.is_vague() || o.is_vague() || o.value.contains(0.0) {
            return Bounds::UNKNOWN;
        }
        let inverse = o.value.inverse();
        let value = self.value * inverse;
        let slope = |k: usize| (self.slopes[k] - o.slopes[k] * value) * inverse;
        Bounds::new(value, each(slope))
    }
}

/// Arithmetic with plain numbers on either side.
macro_rules! with_numbers {
    ($($op:ident $f:ident)*) => {$(
        impl $op<f64> for Bounds {
            type Output = Bounds;
            #[inline]
            fn $f(self, o: f64) -> Bounds {
                self.$f(Bounds::constant(o))
            }
        }
        impl $op<Bounds> for f64 {
            type Output = Bounds;
            #[inline]
            fn $f(self, o: Bounds) -> Bounds {
                Bounds::constant(self).$f(o)
            }
        }
    )*};
}
with_numbers! { Add add Sub sub Mul mul Div div }

impl Bounds {
    /// What is known, times a number other than zero; `None` if the factor is none.
    #[inline]
    fn scaled(&self, factor: &Bounds) -> Option<Bounds> {
        let k = factor.as_constant().filter(|&k| k != 0.0 && k.is_finite())?;
        Some(Bounds::new(self.value.scaled(k), each(|axis| self.slopes[axis].scaled(k))))
    }

    /// An angle that is known but for whole turns, times a whole number.
    fn turned(&self, k: f64) -> Bounds {
        if self.turns == 0.0 || self.value.is_all() || k != trunc(k) || k == 0.0 {
            return Bounds::UNKNOWN;
        }
        let through = self.through(self.value * k, Range::one(k));
        Bounds { turns: self.turns * k, ..through }
    }

    pub(crate) fn squared(&self) -> Bounds {
        if self.is_vague() {
            return Bounds::UNKNOWN;
        }
        self.through(self.value.squared(), self.value * 2.0)
    }

    pub(crate) fn powi(self, n: i32) -> Bounds {
        match n {
            0 => Bounds::constant(1.0),
            1 => self,
            n if n % 2 == 0 => self.powi(n / 2).squared(),
            n => self.powi(n - 1) * self,
        }
    }

    pub(crate) fn abs(self) -> Bounds {
        if self.is_vague() {
            Bounds::UNKNOWN
        } else if self.value.lo >= 0.0 {
            self
        } else if self.value.hi <= 0.0 {
            -self
        } else {
            let value = Range { lo: 0.0, hi: self.value.size() };
            Bounds::new(value, each(|k| self.slopes[k].hull(-self.slopes[k])))
        }
    }

    pub(crate) fn sqrt(self) -> Bounds {
        if self.is_vague() || self.value.lo < 0.0 {
            return Bounds::UNKNOWN;
        }
        let root = self.value.rising(f64::sqrt);
        self.through(root, root.inverse() * 0.5)
    }

    pub(crate) fn min(self, o: impl Into<Bounds>) -> Bounds {
        let o = o.into();
        if self.is_vague() || o.is_vague() {
            Bounds::UNKNOWN
        } else if self.value.hi < o.value.lo {
            self
        } else if o.value.hi < self.value.lo {
            o
        } else {
            let (a, b) = (self.value, o.value);
            let value = Range { lo: a.lo.min(b.lo), hi: a.hi.min(b.hi) };
            Bounds::new(value, each(|k| self.slopes[k].hull(o.slopes[k])))
        }
    }

    pub(crate) fn max(self, o: impl Into<Bounds>) -> Bounds {
        -(-self).min(-o.into())
    }

    /// Within two numbers.
    pub fn clamp(self, low: f64, high: f64) -> Bounds {
        self.max(low).min(high)
    }

    pub(crate) fn sin(self) -> Bounds {
        if self.value.is_all() || self.turns != trunc(self.turns) {
            return Bounds::UNKNOWN;
        }
        self.through(self.value.sin(), self.value.cos())
    }

    pub(crate) fn cos(self) -> Bounds {
        let quarter = Bounds { value: self.value + Range::one(FRAC_PI_2), ..self };
        quarter.sin()
    }

    /// The length of a vector. Its slope along a component is the component's share of it, within -1 and 1: it rises
    /// with the component and is the flatter the longer the others are.
    pub(crate) fn length(v: [Bounds; 3]) -> Bounds {
        if v.iter().any(Bounds::is_vague) {
            return Bounds::UNKNOWN;
        }
        let [x, y, z] = [v[0].value, v[1].value, v[2].value];
        let squares = [x.squared(), y.squared(), z.squared()];
        let square = squares[0] + squares[1] + squares[2];
        if square.hi == f64::INFINITY {
            return Bounds::UNKNOWN;
        }
        let share = |own: f64, rest: f64| {
            let length = (own * own + rest).sqrt();
            if length > 0.0 { own / length } else { 0.0 }
        };
        let gradient = each(|k| {
            let (own, rest) = (v[k].value, squares[(k + 1) % 3] + squares[(k + 2) % 3]);
            Range {
                lo: share(own.lo, if own.lo > 0.0 { rest.hi } else { rest.lo }),
                hi: share(own.hi, if own.hi > 0.0 { rest.lo } else { rest.hi }),
            }
        });
        let value = square.rising(f64::sqrt);
        Bounds::of_point(value, gradient, &v)
    }

    pub(crate) fn exp(self) -> Bounds {
        if self.is_vague() {
            return Bounds::UNKNOWN;
        }
        let value = self.value.rising(f64::exp);
        self.through(value, value)
    }

    pub(crate) fn ln(self) -> Bounds {
        if self.is_vague() || self.value.lo <= 0.0 {
            return Bounds::UNKNOWN;
        }
        self.through(self.value.rising(f64::ln), self.value.inverse())
    }

    /// A power with a constant exponent; nothing is known of powers of negative numbers.
    pub(crate) fn powf(self, exponent: f64) -> Bounds {
        if self.is_vague() || self.value.lo < 0.0 || (self.value.lo == 0.0 && exponent < 0.0) {
            return Bounds::UNKNOWN;
        }
        let power = |e: f64| Range::new(self.value.lo.powf(e), self.value.hi.powf(e));
        self.through(power(exponent), power(exponent - 1.0) * exponent)
    }

    /// The azimuth of the point (`x`, this).
    pub(crate) fn atan2(self, x: Bounds) -> Bounds {
        if self.is_vague() || x.is_vague() {
            return Bounds::UNKNOWN;
        }
        let Some((value, seam)) = Range::azimuth(self.value, x.value) else {
            return Bounds::jumping(Range::within(PI));
        };
        let inverse = (self.value.squared() + x.value.squared()).inverse();
        let slope = |k: usize| (x.value * self.slopes[k] - self.value * x.slopes[k]) * inverse;
        Bounds { value, slopes: each(slope), turns: f64::from(u8::from(seam)) }
    }

    fn tan(self) -> Bounds {
        let half_turns = |v: f64| floor((v + FRAC_PI_2) / PI);
        if self.is_vague() || half_turns(self.value.lo) != half_turns(self.value.hi) {
            return Bounds::UNKNOWN;
        }
        let value = self.value.rising(f64::tan);
        self.through(value, value.squared() + Range::one(1.0))
    }

    /// A function that is flat but for jumps, and never falls.
    fn stepped(self, f: impl Fn(f64) -> f64) -> Bounds {
        let value = self.value.rising(f);
        if self.is_vague() {
            Bounds::UNKNOWN
        } else if value.lo == value.hi {
            Bounds::constant(value.lo)
        } else {
            Bounds::jumping(value)
        }
    }

    /// A built-in function of one or two arguments.
    pub(super) fn builtin(f: Builtin, a: Bounds, b: Bounds) -> Bounds {
        match f {
            Builtin::Abs => a.abs(),
            Builtin::Sqrt => a.sqrt(),
            Builtin::Sqr => a.squared(),
            Builtin::Min => a.min(b),
            Builtin::Max => a.max(b),
            Builtin::Sin => a.sin(),
            Builtin::Cos => a.cos(),
            Builtin::Tan => a.tan(),
            Builtin::Exp => a.exp(),
            Builtin::Ln => a.ln(),
            Builtin::Atan2 => a.atan2(b),
            Builtin::Floor => a.stepped(f64::floor),
            Builtin::Ceil => a.stepped(f64::ceil),
            Builtin::Radians => a * (PI / 180.0),
            Builtin::Degrees => a * (180.0 / PI),
            Builtin::Mod => a.remainder(b),
            Builtin::Pow => match b.as_constant() {
                Some(exponent) => a.powf(exponent),
                None if a.value.lo > 0.0 => (a.ln() * b).exp(),
                None => Bounds::UNKNOWN,
            },
            _ if a.is_vague() => Bounds::UNKNOWN,
            Builtin::Atan => {
                a.through(a.value.rising(f64::atan), (a.value.squared() + Range::one(1.0)).inverse())
            }
            Builtin::Tanh => {
                let value = a.value.rising(f64::tanh);
                a.through(value, Range::one(1.0) - value.squared())
            }
            Builtin::Sinh => {
                let value = a.value.rising(f64::sinh);
                a.through(value, (value.squared() + Range::one(1.0)).rising(f64::sqrt))
            }
            _ => Bounds::UNKNOWN,
        }
    }

    /// The remainder of a division by a constant, with the dividend's sign.
    fn remainder(self, by: Bounds) -> Bounds {
        let Some(by) = by.as_constant().filter(|by| *by != 0.0) else { return Bounds::UNKNOWN };
        if self.is_vague() {
            return Bounds::UNKNOWN;
        }
        let turns = self.value.rising(|v| (v / by.abs()).trunc());
        if turns.lo == turns.hi {
            return self - turns.lo * by.abs();
        }
        let (below, above) = (self.value.lo.min(0.0), self.value.hi.max(0.0));
        Bounds::jumping(Range { lo: below.max(-by.abs()), hi: above.min(by.abs()) })
    }

    /// The remainder of a division by a whole turn, never negative.
    pub(crate) fn rem_euclid(self, by: f64) -> Bounds {
        if by == TAU && self.turns == trunc(self.turns) && self.turns != 0.0 && !self.value.is_all() {
            return Bounds { turns: 0.0, ..self }.rem_euclid(by);
        }
        if self.is_vague() || by.is_nan() || by <= 0.0 {
            return Bounds::UNKNOWN;
        }
        let turns = self.value.rising(|v| (v / by).floor());
        if turns.lo == turns.hi {
            return self - turns.lo * by;
        }
        Bounds::jumping(Range { lo: 0.0, hi: by })
    }

    /// Comparison and logic: 1, 0, or undecided.
    pub(super) fn compared(op: BinaryOp, a: Bounds, b: Bounds) -> Bounds {
        if a.is_vague() || b.is_vague() {
            return Bounds::UNKNOWN;
        }
        let at = |x: f64, y: f64| op.apply(x, y);
        let decided = match op {
            BinaryOp::Lt | BinaryOp::Le | BinaryOp::Gt | BinaryOp::Ge => {
                at(a.value.lo, b.value.hi) == at(a.value.hi, b.value.lo)
            }
            BinaryOp::Eq | BinaryOp::Ne => {
                a.value.hi < b.value.lo || b.value.hi < a.value.lo || (a.is_point() && b.is_point())
            }
            _ => {
                let known = |v: Bounds| v.is_point() || !v.value.contains(0.0);
                known(a) && known(b)
            }
        };
        if decided {
            Bounds::constant(at(a.value.lo, b.value.lo))
        } else {
            Bounds::jumping(Range { lo: 0.0, hi: 1.0 })
        }
    }

    fn is_point(&self) -> bool {
        self.value.lo == self.value.hi
    }
}

impl From<f64> for Bounds {
    fn from(v: f64) -> Bounds {
        Bounds::constant(v)
    }
}
