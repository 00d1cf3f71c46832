//! Numbers of one to five components and the operators on them (language spec, section 2.2).
use raggio_math::EPS;

/// What an expression evaluates to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Num {
    /// The components; those from `len` on are 0.
    pub v: [f64; 5],
    /// How many there are, 1 to 5.
    pub len: u8,
}

impl Num {
    /// One number.
    #[inline]
    pub fn float(x: f64) -> Self {
        Num { v: [x, 0.0, 0.0, 0.0, 0.0], len: 1 }
    }

    /// A vector of 2 to 5 components.
    pub fn vector(components: &[f64]) -> Self {
        let mut v = [0.0; 5];
        v[..components.len()].copy_from_slice(components);
        Num { v, len: components.len() as u8 }
    }

    /// With `len` components at least: one number is repeated, anything else filled up with zeros.
    #[inline]
    pub fn padded(self, len: u8) -> Self {
        if self.len >= len {
            return self;
        }
        let mut v = self.v;
        if self.len == 1 {
            v[..len as usize].fill(self.v[0]);
        }
        Num { v, len }
    }

    /// An operator component by component, both sides made equally long.
    #[inline]
    pub fn zip(self, other: Num, op: impl Fn(f64, f64) -> f64) -> Num {
        if self.len == 1 && other.len == 1 {
            return Num::float(op(self.v[0], other.v[0]));
        }
        let len = self.len.max(other.len);
        self.padded(len).zip_components(other.padded(len), len, op)
    }

    /// A comparison or logical operator: only the left side is made longer.
    pub fn compare(self, other: Num, op: impl Fn(f64, f64) -> bool) -> Num {
        let len = self.len.max(other.len);
        self.padded(len).zip_components(other, len, |a, b| f64::from(u8::from(op(a, b))))
    }

    fn zip_components(self, other: Num, len: u8, op: impl Fn(f64, f64) -> f64) -> Num {
        let mut v = [0.0; 5];
        for (out, (&a, &b)) in v.iter_mut().zip(self.v.iter().zip(&other.v)).take(len as usize) {
            *out = op(a, b);
        }
        Num { v, len }
    }

    /// A function of each component.
    pub fn map(mut self, op: impl Fn(f64) -> f64) -> Num {
        for x in &mut self.v[..self.len as usize] {
            *x = op(*x);
        }
        self
    }

    /// Brightness, as the language weighs it.
    pub fn gray(self) -> f64 {
        0.297 * self.v[0] + 0.589 * self.v[1] + 0.114 * self.v[2]
    }
}

/// Is it true?
pub fn truth(x: f64) -> bool {
    x.abs() > EPS
}

/// `=`
pub fn equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= EPS
}
