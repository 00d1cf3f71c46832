//! Orbits of quaternions under squares and cubes, for Julia fractals.
use raggio_math::{Vec3, Vec4};

use super::julia::proved::{HUGE, Proof};
use super::julia::together::{Ends, LANES, Lanes, Orbits, choose};

/// What the map does before it adds the parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Power {
    Square,
    Cube,
}

impl Power {
    /// The power of `q`; x is the real part.
    #[inline(always)]
    fn of(self, q: Vec4) -> Vec4 {
        let imaginary = q.y * q.y + q.z * q.z + q.w * q.w;
        let (real, factor) = match self {
            Power::Square => (q.x * q.x - imaginary, 2.0 * q.x),
            Power::Cube => (q.x * (q.x * q.x - 3.0 * imaginary), 3.0 * q.x * q.x - imaginary),
        };
        Vec4::new(real, factor * q.y, factor * q.z, factor * q.w)
    }

    /// The change of the power of `q` where `q` changes by `dq`.
    #[inline(always)]
    fn change(self, q: Vec4, dq: Vec4) -> Vec4 {
        let imaginary = q.y * q.y + q.z * q.z + q.w * q.w;
        let d_imaginary = 2.0 * (q.y * dq.y + q.z * dq.z + q.w * dq.w);
        let (real, factor, d_factor) = match self {
            Power::Square => (2.0 * q.x * dq.x - d_imaginary, 2.0 * q.x, 2.0 * dq.x),
            Power::Cube => (
                dq.x * (q.x * q.x - 3.0 * imaginary) + q.x * (2.0 * q.x * dq.x - 3.0 * d_imaginary),
                3.0 * q.x * q.x - imaginary,
                6.0 * q.x * dq.x - d_imaginary,
            ),
        };
        let part = |v: f64, dv: f64| factor * dv + d_factor * v;
        Vec4::new(real, part(q.y, dq.y), part(q.z, dq.z), part(q.w, dq.w))
    }

    /// By how much at most the powers of numbers differ from that of one of size `n`, where the numbers differ by `r`.
    fn spread(self, n: f64, r: f64) -> f64 {
        match self {
            Power::Square => r * (2.0 * n + r),
            Power::Cube => r * (3.0 * n * (n + r) + r * r),
        }
    }

    #[inline(always)]
    pub(crate) fn degree(self) -> f64 {
        match self {
            Power::Square => 2.0,
            Power::Cube => 3.0,
        }
    }
}

/// [`last_size`] of some orbits together, with the squares of the sizes of the derivatives.
#[inline(always)]
pub(crate) fn follow_all(power: Power, orbits: &Orbits, t: Lanes) -> Ends {
    let Orbits { line: [from, along], parameter: c, steps, escape, .. } = *orbits;
    let [mut x, mut y, mut z, mut w] = [[0.0; LANES]; 4];
    for k in 0..LANES {
        let q = from + along * t[k];
        (x[k], y[k], z[k], w[k]) = (q.x, q.y, q.z, q.w);
    }
    let mut ends = Ends::NONE;
    ends.slope = [1.0; LANES];
    // All bits of those that have not escaped.
    let mut bound = [u64::MAX; LANES];
    for _ in 0..steps {
        for k in 0..LANES {
            let size2 = x[k] * x[k] + y[k] * y[k] + z[k] * z[k] + w[k] * w[k];
            ends.look(k, &mut bound, size2, escape);
            ends.slope[k] *= choose(bound[k], power.degree() * power.degree() * size2, 1.0);
        }
        if bound == [0; LANES] {
            break;
        }
        for k in 0..LANES {
            let q = power.of(Vec4::new(x[k], y[k], z[k], w[k])) + c;
            (x[k], y[k], z[k], w[k]) = (q.x, q.y, q.z, q.w);
        }
    }
    ends
}

/// A lower estimate of the distance to the set from where an orbit that escapes started (Hart, Sandin and Kauffman,
/// 1989), if that is more than `least`, from the squares of its size and of that of its derivative.
#[inline(always)]
pub(crate) fn distance(size2: f64, slope2: f64, least: f64) -> f64 {
    // The logarithm is less than the square root.
    if size2 * size2 < 16.0 * least * least * slope2 {
        return least;
    }
    let distance = 0.25 * (size2 / slope2).sqrt() * size2.ln();
    if distance > least { distance } else { least }
}

/// The step at which the orbit escapes, or `steps`, and the squared size of the last number that was looked at.
pub(crate) fn last_size(power: Power, q: Vec4, c: Vec4, steps: u32, escape: f64) -> (u32, f64) {
    match power {
        Power::Square => follow(Power::Square, q, c, (steps, escape)),
        Power::Cube => follow(Power::Cube, q, c, (steps, escape)),
    }
}

/// [`last_size`] of one power.
#[inline(always)]
fn follow(power: Power, mut q: Vec4, c: Vec4, (steps, escape): (u32, f64)) -> (u32, f64) {
    let mut size2 = 0.0;
    for k in 0..steps {
        size2 = q.length_squared();
        if size2.is_nan() || size2 > escape {
            return (k, size2);
        }
        q = power.of(q) + c;
    }
    (steps, size2)
}

/// Do the orbits of all numbers in a ball (middle and radius) escape, or none?
pub(crate) fn proof(
    power: Power,
    (mut q, mut radius): (Vec4, f64),
    c: Vec4,
    (steps, escape): (u32, f64),
) -> Proof {
    let limit = escape.sqrt();
    let mut none = true;
    for _ in 0..steps {
        let size = q.length();
        if size - radius > limit {
            return Proof::Outside;
        }
        if (size + radius).is_nan() || size + radius > HUGE {
            return Proof::Open;
        }
        none &= size + radius < limit;
        radius = power.spread(size, radius);
        q = power.of(q) + c;
    }
    if none { Proof::Inside } else { Proof::Open }
}

/// Half the gradient in x, y and z of the squared size after `steps` steps. The fourth coordinate is held fast, as in
/// POV-Ray, though the slice makes it depend on the other three.
pub(crate) fn gradient(power: Power, mut q: Vec4, c: Vec4, steps: u32) -> Vec3 {
    let [mut x, mut y, mut z] = [Vec4::X, Vec4::Y, Vec4::Z];
    for _ in 0..steps {
        (x, y, z) = (power.change(q, x), power.change(q, y), power.change(q, z));
        q = power.of(q) + c;
    }
    Vec3::new(q.dot(x), q.dot(y), q.dot(z))
}
