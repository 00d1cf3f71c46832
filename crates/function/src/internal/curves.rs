//! Plane curves, drawn along z or swept around the y axis.
use super::Args;

/// The field of an algebraic cylinder: strength `p[1]`, limited to `p[2]` either way.
fn limited(a: &Args, e: f64) -> f64 {
    (a.p[1] * e).max(-a.p[2]).min(a.p[2])
}

pub(super) fn algbr_cyl1(a: &Args) -> f64 {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    -limited(&a, -(x2 * a.x.abs() - x2 + y2))
}

pub(super) fn algbr_cyl2(a: &Args) -> f64 {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    limited(&a, -(2.0 * x2 * x2 - 3.0 * x2 * a.y + y2 - 2.0 * y2 * a.y + y2 * y2))
}

pub(super) fn algbr_cyl3(a: &Args) -> f64 {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    limited(&a, -(x2 * x2 + x2 * y2 - 2.0 * x2 * a.y - a.x * y2 + y2))
}

pub(super) fn algbr_cyl4(a: &Args) -> f64 {
    let a = a.swept(3);
    let (x2, y2, _) = a.squares();
    limited(&a, -(x2 * x2 + y2 * y2 + 2.0 * x2 * y2 + 3.0 * x2 * a.y - y2 * a.y))
}

pub(super) fn devils_curve_2d(a: &Args) -> f64 {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    a.field(-(x2 * (x2 - a.p[2] * a.p[2]) - y2 * (y2 - a.p[3] * a.p[3])))
}

pub(super) fn folium_surface_2d(a: &Args) -> f64 {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    a.field(-(y2 * (1.0 + (a.p[3] - 4.0 * a.p[2]) * a.x) + x2 * (1.0 + a.p[3])))
}

/// The last power is a cube where the solid has a square; that is how the program computes it.
pub(super) fn kampyle_of_eudoxus_2d(a: &Args) -> f64 {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    let c2 = a.p[3] * a.p[3];
    a.field(-(y2 - c2 * x2 * x2 + c2 * a.p[3] * a.p[2] * x2))
}

pub(super) fn lemniscate_of_gerono_2d(a: &Args) -> f64 {
    let a = a.swept(4);
    let (x2, y2, _) = a.squares();
    let c2 = a.p[3] * a.p[3];
    a.field(-(y2 - c2 * a.p[2] * a.p[2] * x2 + c2 * x2 * x2))
}

pub(super) fn piriform_2d(a: &Args) -> f64 {
    let a = a.swept(5);
    let (x2, y2, _) = a.squares();
    let d2 = a.p[4] * a.p[4];
    a.field(-(y2 - a.p[2] * d2 * x2 * a.x - a.p[3] * d2 * x2 * x2))
}

pub(super) fn strophoid_2d(a: &Args) -> f64 {
    let a = a.swept(5);
    let (x2, y2, _) = a.squares();
    let d2 = a.p[4] * a.p[4];
    a.field(-((a.p[3] - a.x) * y2 - d2 * a.p[2] * x2 - d2 * x2 * a.x))
}

pub(super) fn witch_of_agnesi_2d(a: &Args) -> f64 {
    let a = a.swept(4);
    let (x2, _, _) = a.squares();
    a.field(-(a.p[2] * a.p[2] * a.y + x2 * a.y - a.p[3]))
}
