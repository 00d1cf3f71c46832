//! Plane curves, drawn along z or swept around the y axis.
use super::{Args, N};

/// The field of an algebraic cylinder: strength `p[1]`, limited to `p[2]` either way.
fn limited(a: &Args, e: N) -> N {
    (a.p[1] * e).max(-a.p[2]).min(a.p[2])
}

pub fn algbr_cyl1(a: &Args) -> N {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    -limited(&a, -(x2 * a.x.abs() - x2 + y2))
}

pub fn algbr_cyl2(a: &Args) -> N {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    limited(&a, -(2.0 * x2 * x2 - 3.0 * x2 * a.y + y2 - 2.0 * y2 * a.y + y2 * y2))
}

pub fn algbr_cyl3(a: &Args) -> N {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    limited(&a, -(x2 * x2 + x2 * y2 - 2.0 * x2 * a.y - a.x * y2 + y2))
}

pub fn algbr_cyl4(a: &Args) -> N {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    limited(&a, -(x2 * x2 + y2 * y2 + 2.0 * x2 * y2 + 3.0 * x2 * a.y - y2 * a.y))
}

pub fn devils_curve_2d(a: &Args) -> N {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    a.field(-(x2 * (x2 - a.p[2] * a.p[2]) - y2 * (y2 - a.p[3] * a.p[3])))
}

pub fn folium_surface_2d(a: &Args) -> N {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    a.field(-(y2 * (1.0 + (a.p[3] - 4.0 * a.p[2]) * a.x) + x2 * (1.0 + a.p[3])))
}

/// The last power is a cube where the solid has a square; that is how the program computes it.
pub fn kampyle_of_eudoxus_2d(a: &Args) -> N {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    let c2 = a.p[3] * a.p[3];
    a.field(-(y2 - c2 * x2 * x2 + c2 * a.p[3] * a.p[2] * x2))
}

pub fn lemniscate_of_gerono_2d(a: &Args) -> N {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    let c2 = a.p[3] * a.p[3];
    a.field(-(y2 - c2 * a.p[2] * a.p[2] * x2 + c2 * x2 * x2))
}

pub fn piriform_2d(a: &Args) -> N {
    let a = a.swept(5);
    let (x2, y2, _) = a.squares();
    let d2 = a.p[4] * a.p[4];
    a.field(-(y2 - a.p[2] * d2 * x2 * a.x - a.p[3] * d2 * x2 * x2))
}

pub fn strophoid_2d(a: &Args) -> N {
    let a = a.swept(5);
    let (x2, y2, _) = a.squares();
    let d2 = a.p[4] * a.p[4];
    a.field(-((a.p[3] - a.x) * y2 - d2 * a.p[2] * x2 - d2 * x2 * a.x))
}

pub fn witch_of_agnesi_2d(a: &Args) -> N {
    let a = a.swept(4);
    let (x2, _, _) = a.squares();
    a.field(-(a.p[2] * a.p[2] * a.y + x2 * a.y - a.p[3]))
}
