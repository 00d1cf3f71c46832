//! Which parts of a ray lights reach (media spec, section 1.3).
use raggio_math::{Ray, Vec3};
use smallvec::SmallVec;

use crate::lights::{Cone, LightSource};
use crate::world::World;

/// Part of a ray.
pub type Range = (f64, f64);
/// Lights by number with the part of the ray that each may reach.
pub type LitRanges = SmallVec<[(u32, Range); 4]>;

/// Of these lights, those that reach media on the way to `depth`.
pub fn ranges(world: &World, ray: &Ray, depth: f64, lights: &[u32]) -> LitRanges {
    let reach = |&i: &u32| {
        let light = &world.lights[i as usize];
        if !light.media_interaction || light.shadowless {
            return None;
        }
        let (t0, t1) = reach(light, ray)?;
        let clipped = (t0.max(0.0), t1.min(depth));
        (t0 < depth && t1 > 0.001 && clipped.0 < clipped.1).then_some((i, clipped))
    };
    lights.iter().filter_map(reach).collect()
}

/// The part of a line that a light may reach.
fn reach(light: &LightSource, ray: &Ray) -> Option<Range> {
    let (w, a) = (ray.origin - light.position, ray.dir.dot(light.axis));
    let b = w.dot(light.axis);
    match light.cone {
        Cone::None => Some((f64::NEG_INFINITY, f64::INFINITY)),
        Cone::Spot { cos_falloff, .. } if cos_falloff > 0.0 => cone(w, ray.dir, a, b, cos_falloff),
        Cone::Spot { .. } => before(a, b),
        Cone::Cylinder { falloff, .. } => {
            let (w, d) = (w - light.axis * b, ray.dir - light.axis * a);
            let round = between_roots(d.dot(d), w.dot(d), w.dot(w) - falloff * falloff)?;
            let front = before(a, b)?;
            let both = (round.0.max(front.0), round.1.min(front.1));
            (both.0 < both.1).then_some(both)
        }
    }
}

/// Where `b + a t >= 0`.
fn before(a: f64, b: f64) -> Option<Range> {
    if a == 0.0 {
        return (b >= 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let t = -b / a;
    Some(if a > 0.0 { (t, f64::INFINITY) } else { (f64::NEG_INFINITY, t) })
}

/// Where `q t^2 + 2 h t + c <= 0` for `q >= 0`.
fn between_roots(q: f64, h: f64, c: f64) -> Option<Range> {
    if q < 1e-14 {
        return (c <= 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let root = (h * h - q * c).sqrt();
    (root > 0.0).then(|| ((-h - root) / q, (-h + root) / q))
}

/// The part of a line inside a one-sided cone. `w` leads from the apex to the line's origin, `a` and `b` are the
/// parts of the direction and of `w` along the axis.
fn cone(w: Vec3, d: Vec3, a: f64, b: f64, cosine: f64) -> Option<Range> {
    let square = cosine * cosine;
    let (q, h, c) = (a * a - square, a * b - square * w.dot(d), b * b - square * w.dot(w));
    if q.abs() < 1e-14 {
        return open_end(-c / (2.0 * h), a);
    }
    let square_root = h * h - q * c;
    if q > 0.0 {
        // The line runs out of the open end.
        let root = square_root.max(0.0).sqrt();
        return open_end(if a > 0.0 { (-h + root) / q } else { (-h - root) / q }, a);
    }
    let root = square_root.sqrt();
    let (t0, t1) = ((-h + root) / q, (-h - root) / q);
    (t0 < t1 && b + a * (t0 + t1) / 2.0 >= 0.0).then_some((t0, t1))
}

/// From `t` on in the sense in which the line goes along the axis.
fn open_end(t: f64, a: f64) -> Option<Range> {
    t.is_finite().then_some(if a > 0.0 { (t, f64::INFINITY) } else { (f64::NEG_INFINITY, t) })
}

/// The way from 0 to `depth` cut into pieces that some light reaches, and pieces that none does.
pub fn pieces(lights: &LitRanges, depth: f64) -> SmallVec<[(Range, bool); 8]> {
    let mut lit: SmallVec<[Range; 4]> = lights.iter().map(|l| l.1).collect();
    lit.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut pieces: SmallVec<[(Range, bool); 8]> = SmallVec::new();
    let mut at = 0.0;
    for (t0, t1) in lit {
        if t1 <= at {
            continue;
        }
        match pieces.last_mut() {
            Some((range, true)) if t0 <= at => range.1 = t1,
            _ => {
                if t0 > at {
                    pieces.push(((at, t0), false));
                }
                pieces.push(((t0.max(at), t1), true));
            }
        }
        at = t1;
    }
    if at < depth {
        pieces.push(((at, depth), false));
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(got: Option<Range>, expected: Range) {
        let got = got.expect("a range");
        assert!((got.0 - expected.0).abs() < 1e-9 && (got.1 - expected.1).abs() < 1e-9, "{got:?}");
    }

    fn through_cone(origin: Vec3, dir: Vec3, degrees: f64) -> Option<Range> {
        // Apex at the origin, axis down.
        let axis = -Vec3::Y;
        cone(origin, dir, dir.dot(axis), origin.dot(axis), degrees.to_radians().cos())
    }

    #[test]
    fn cones_are_crossed_sideways_and_left_through_the_open_end() {
        near(through_cone(Vec3::new(-5.0, -2.0, 0.0), Vec3::X, 45.0), (3.0, 7.0));
        let inside = through_cone(Vec3::new(0.0, -1.0, 0.0), -Vec3::Y, 30.0);
        assert_eq!(inside.map(|r| r.1), Some(f64::INFINITY));
        assert!(through_cone(Vec3::new(-5.0, 2.0, 0.0), Vec3::X, 45.0).is_none());
        near(between_roots(1.0, 0.0, -4.0), (-2.0, 2.0));
        assert!(between_roots(1.0, 0.0, 4.0).is_none());
    }

    #[test]
    fn pieces_cover_the_way() {
        let lights: LitRanges = [(0, (2.0, 4.0)), (1, (3.0, 5.0)), (2, (7.0, 8.0))].into_iter().collect();
        let got = pieces(&lights, 10.0);
        let expected = [
            ((0.0, 2.0), false),
            ((2.0, 5.0), true),
            ((5.0, 7.0), false),
            ((7.0, 8.0), true),
            ((8.0, 10.0), false),
        ];
        assert_eq!(got[..], expected);
        assert_eq!(pieces(&LitRanges::new(), 3.0)[..], [((0.0, 3.0), false)]);
    }
}
