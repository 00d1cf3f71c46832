//! Algebraic surfaces: polynomial fields of strength `p[1]`, kept within -10 and 10.
use std::f64::consts::SQRT_2;

use super::{Args, N};

pub fn bicorn(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let s2 = a.p[2] * a.p[2];
    let e = x2 + z2 + 2.0 * a.p[2] * a.y - s2;
    a.field(y2 * (s2 - x2 - z2) - e * e)
}

pub fn bifolia(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    let r2 = a.r2();
    a.field(-(r2 * r2 - a.p[2] * (x2 + z2) * a.y))
}

pub fn boy_surface(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let (q, h, z4) = (1.0 - a.z, x2 + y2, z2 * z2);
    let k = 64.0 * q * q * q * z2 * a.z - 48.0 * q * q * z2 * (3.0 * h + 2.0 * z2)
        + 12.0
            * q
            * a.z
            * (27.0 * h * h - 24.0 * z2 * h + 36.0 * SQRT_2 * a.y * a.z * (y2 - 3.0 * x2) + 4.0 * z4)
        + (9.0 * h - 2.0 * z2)
            * (-81.0 * h * h - 72.0 * z2 * h + 108.0 * SQRT_2 * a.x * a.z * (x2 - 3.0 * y2) + 4.0 * z4);
    a.field(a.p[2] * k)
}

pub fn crossed_trough(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    a.field(x2 * z2 - a.y)
}

pub fn cubic_saddle(a: &Args) -> N {
    a.field(-(a.x.powi(3) - a.y.powi(3) - a.z))
}

/// Also `f_odd`, which computes the same.
pub fn cushion(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let z = a.z;
    a.field(
        z2 * x2 - z2 * z2 - 2.0 * z * x2 + 2.0 * z2 * z + x2
            - z2
            - (x2 - z) * (x2 - z)
            - y2 * y2
            - 2.0 * x2 * y2
            - y2 * z2
            + 2.0 * y2 * z
            + y2,
    )
}

pub fn devils_curve(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(-(x2 * x2 + 2.0 * x2 * z2 - 0.36 * x2 - y2 * y2 + 0.25 * y2 + z2 * z2))
}

pub fn dupin_cyclid(a: &Args) -> N {
    let y2 = a.y * a.y;
    let r2 = a.r2();
    let [_, _, p2, p3, p4, p5, p6, ..] = a.p;
    let radius = p6 * p6;
    let outer = p3 * p3 - p5 * p5 - (p4 + p2) * (p4 + p2);
    let inner = p3 * p3 - p5 * p5 - (p4 - p2) * (p4 - p2);
    let dot = p4 * a.x + p5 * a.y;
    a.field(
        -(outer * inner * r2 * r2
            + 2.0
                * radius
                * ((p3 * p3 + p2 * p2 - p5 * p5 - p4 * p4) * (2.0 * dot - radius)
                    - 4.0 * p5 * p3 * p3 * a.y)
                * r2
            + 4.0 * radius * radius * dot * (dot - radius)
            + 4.0 * radius * radius * p2 * p2 * y2
            + radius.powi(4)),
    )
}

pub fn folium_surface(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field((y2 + z2) * (1.0 + (a.p[3] - 4.0 * a.p[2]) * a.x) + x2 * (1.0 + a.p[3]))
}

pub fn glob(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(0.5 * x2 * x2 * a.x + 0.5 * x2 * x2 - (y2 + z2))
}

pub fn heart(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let z3 = z2 * a.z;
    a.field(-((2.0 * x2 + y2 + z2 - 1.0).powi(3) - 0.1 * x2 * z3 - y2 * z3))
}

pub fn hunt_surface(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let e = 3.0 * x2 + y2 - 4.0 * z2 - 12.0;
    a.field(-(4.0 * (a.r2() - 13.0).powi(3) + 27.0 * e * e))
}

pub fn hyperbolic_torus(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let (s, d) = sum_and_difference(a);
    a.field(
        -(x2 * x2 + 2.0 * x2 * y2 - 2.0 * x2 * z2 - 2.0 * s * x2 + y2 * y2 - 2.0 * y2 * z2
            + 2.0 * d * y2
            + z2 * z2
            + 2.0 * s * z2
            + d * d),
    )
}

/// `p2^2 + p3^2` and `p2^2 - p3^2`: of the radii of a torus.
fn sum_and_difference(a: &Args) -> (f64, f64) {
    let (major, minor) = (a.p[2] * a.p[2], a.p[3] * a.p[3]);
    (major + minor, major - minor)
}

pub fn kampyle_of_eudoxus(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let c2 = a.p[3] * a.p[3];
    a.field(-(y2 + z2 - c2 * x2 * x2 + c2 * a.p[2] * a.p[2] * x2))
}

pub fn klein_bottle(a: &Args) -> N {
    let (r2, z2) = (a.r2(), a.z * a.z);
    let (plus, minus) = (r2 + 2.0 * a.y - 1.0, r2 - 2.0 * a.y - 1.0);
    a.field(-(plus * (minus * minus - 8.0 * z2) + 16.0 * a.x * a.z * minus))
}

pub fn kummer_surface_v1(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(-(x2 * x2 + y2 * y2 + z2 * z2 - a.r2() - x2 * y2 - x2 * z2 - y2 * z2 + 1.0))
}

pub fn kummer_surface_v2(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let [_, _, p2, p3, p4, ..] = a.p;
    a.field(
        -(x2 * x2
            + y2 * y2
            + z2 * z2
            + p2 * a.r2()
            + p3 * (x2 * y2 + x2 * z2 + y2 * z2)
            + p4 * a.x * a.y * a.z
            - 1.0),
    )
}

pub fn lemniscate_of_gerono(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(-(x2 * x2 - x2 + y2 + z2))
}

pub fn mitre(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(-(4.0 * x2 * a.r2() - y2 * (1.0 - y2 - z2)))
}

pub fn nodal_cubic(a: &Args) -> N {
    a.field(-(a.y.powi(3) + a.z.powi(3) - 6.0 * a.y * a.z))
}

pub fn ovals_of_cassini(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    let [_, _, p2, p3, p4, ..] = a.p;
    let e = a.r2() + p2 * p2;
    a.field(-(e * e - p4 * p2 * p2 * (x2 + z2) - p3 * p3))
}

pub fn paraboloid(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    a.field(-(x2 - a.y + z2))
}

pub fn parabolic_torus(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let (s, d) = sum_and_difference(a);
    a.field(
        -(x2 * x2 + 2.0 * x2 * y2 - 2.0 * x2 * a.z - s * x2 + y2 * y2 - 2.0 * y2 * a.z
            + d * y2
            + z2
            + s * a.z
            + d * d),
    )
}

pub fn pillow(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(x2 * x2 + y2 * y2 + z2 * z2 - a.r2())
}

pub fn piriform(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    -a.field(-(x2 * x2 - x2 * a.x + y2 + z2))
}

pub fn quartic_paraboloid(a: &Args) -> N {
    a.field(-(a.x.powi(4) + a.z.powi(4) - a.y))
}

pub fn quartic_saddle(a: &Args) -> N {
    a.field(-(a.x.powi(4) - a.z.powi(4) - a.y))
}

pub fn quartic_cylinder(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let c2 = a.p[3] * a.p[3];
    a.field(-((x2 + z2) * (y2 + c2) - c2 * a.p[2] * a.p[2]))
}

pub fn steiners_roman(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    a.field(-(x2 * y2 + x2 * z2 + y2 * z2 + a.x * a.y * a.z))
}

pub fn strophoid(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let d2 = a.p[4] * a.p[4];
    a.field(-((a.p[3] - a.x) * (y2 + z2) - d2 * a.p[2] * x2 - d2 * x2 * a.x))
}

pub fn torus2(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let (s, d) = sum_and_difference(a);
    let r2 = a.r2();
    a.field(-(r2 * r2 - 2.0 * s * (x2 + z2) + 2.0 * d * y2 + d * d))
}

pub fn torus_gumdrop(a: &Args) -> N {
    let (x2, y2, z2) = a.squares();
    let h = y2 + z2;
    a.field(-(4.0 * (x2 * x2 + h * h) + 17.0 * x2 * h - 20.0 * a.r2() + 17.0))
}

pub fn umbrella(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    a.field(-(x2 - a.y * z2))
}

pub fn witch_of_agnesi(a: &Args) -> N {
    let (x2, _, z2) = a.squares();
    a.field(-(a.p[2] * (a.y - 1.0) + (x2 + z2) * a.y))
}
