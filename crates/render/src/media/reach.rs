//! Where along a ray a density can be anything at all. Known for those that hang on the distance from a point, an axis or
//! a plane alone, as `spherical` does: what lies outside need not be looked at.
use raggio_image::{Color, Rgb};
use raggio_math::{Affine, Mat3, Ray, Vec3};
use raggio_scene::{self as scene, PatternKind, PigmentKind, Warp, Wave};

use super::lit::Range;

/// For rounding, in units of the pattern.
const MARGIN: f64 = 1e-7;
/// Farther out nothing is said.
const FARTHEST: f64 = 1e7;

/// The distances at which a density may be other than nothing.
#[derive(Debug)]
pub(super) struct Shell {
    /// From the world into the pattern's coordinates, of which those that do not count are 0.
    pattern_from_world: Affine,
    inner: f64,
    outer: f64,
}

/// Part of a ray, with a hole in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    whole: Range,
    hole: Range,
}

impl Shell {
    /// That of a pigment which says so, unless it says nothing about space.
    pub fn of(pigment: &scene::Pigment, pigment_from_world: &Affine) -> Option<Shell> {
        let PigmentKind::ColorMap { pattern, map } = &pigment.kind else { return None };
        let counts = match pattern.kind {
            PatternKind::Spherical => Vec3::ONE,
            PatternKind::Cylindrical => Vec3::new(1.0, 0.0, 1.0),
            PatternKind::Planar => Vec3::Y,
            _ => return None,
        };
        let even = pattern.frequency == 0.0 || (pattern.frequency == 1.0 && pattern.phase == 0.0);
        if pattern.wave != Wave::Ramp || !even {
            return None;
        }
        let mut way = *pigment_from_world;
        for warp in &pattern.warps {
            let Warp::Transform { inverse, .. } = warp else { return None };
            way = *inverse * way;
        }
        let (low, high) = values(map)?;
        // The value is 1 at distance 0 and falls to 0 at 1, where it stays.
        let inner = if high < 1.0 { 1.0 - high - MARGIN } else { 0.0 };
        let outer = if low >= 0.0 { 1.0 - low + MARGIN } else { f64::INFINITY };
        let tells = inner > 0.0 || outer < f64::INFINITY;
        let pattern_from_world = Affine { matrix3: Mat3::from_diagonal(counts), ..Affine::IDENTITY } * way;
        tells.then_some(Shell { pattern_from_world, inner, outer })
    }

    /// The part of a ray that lies in it, up to a distance.
    fn along(&self, ray: &Ray, depth: f64) -> Reach {
        let origin = self.pattern_from_world.transform_point3(ray.origin);
        let dir = self.pattern_from_world.transform_vector3(ray.dir);
        let square = dir.length_squared();
        let size = origin.abs() + dir.abs() * depth + self.pattern_from_world.translation.abs();
        if !(size.max_element() < FARTHEST && square > 1e-12) {
            return Reach::ALL;
        }
        // From where the line comes nearest, it is the same way to both sides.
        let nearest = -origin.dot(dir) / square;
        let least = (origin + dir * nearest).length_squared();
        let within = |radius: f64| {
            let half = ((radius * radius - least) / square).sqrt();
            if half >= 0.0 { (nearest - half, nearest + half) } else { NOWHERE }
        };
        let whole = if self.outer < f64::INFINITY { within(self.outer) } else { Reach::ALL.whole };
        Reach { whole, hole: if self.inner > 0.0 { within(self.inner) } else { NOWHERE } }
    }
}

/// No part of any ray.
const NOWHERE: Range = (f64::INFINITY, f64::NEG_INFINITY);

/// The values between which a map is not nothing. `None` where it is not in order.
fn values(map: &[(f32, Color)]) -> Option<Range> {
    let first = map.iter().position(|(_, color)| color.rgb != Rgb::ZERO);
    let last = map.iter().rposition(|(_, color)| color.rgb != Rgb::ZERO);
    let (Some(first), Some(last)) = (first, last) else { return None };
    let at = |i: usize| map.get(i).map(|(at, _)| f64::from(*at));
    let low = first.checked_sub(1).and_then(at).unwrap_or(f64::NEG_INFINITY);
    let high = at(last + 1).unwrap_or(f64::INFINITY);
    map.is_sorted_by(|a, b| a.0 <= b.0).then_some((low, high))
}

impl Reach {
    /// All of every ray.
    pub const ALL: Reach = Reach { whole: (f64::NEG_INFINITY, f64::INFINITY), hole: NOWHERE };

    /// What lies in all shells, up to a distance.
    pub fn of(shells: &[Shell], ray: &Ray, depth: f64) -> Reach {
        shells.iter().fold(Reach::ALL, |all, shell| {
            let Reach { whole, hole } = shell.along(ray, depth);
            let longer = |a: Range, b: Range| if b.1 - b.0 > a.1 - a.0 { b } else { a };
            Reach {
                whole: (all.whole.0.max(whole.0), all.whole.1.min(whole.1)),
                hole: longer(all.hole, hole),
            }
        })
    }

    /// Is a distance in it?
    #[inline]
    pub fn contains(&self, t: f64) -> bool {
        t >= self.whole.0 && t <= self.whole.1 && !(t > self.hole.0 && t < self.hole.1)
    }
}

#[cfg(test)]
mod tests {
    use raggio_scene::{Pattern, Pigment};
    use raggio_shading::{Context, Noise};

    use super::*;

    fn density(kind: PatternKind, greys: &[(f32, f32)]) -> Pigment {
        let color = |&(at, grey): &(f32, f32)| (at, Color { rgb: Rgb::splat(grey), ..Color::default() });
        let pattern = Pattern {
            kind,
            warps: Vec::new(),
            wave: Wave::Ramp,
            frequency: 1.0,
            phase: 0.0,
            noise_generator: 0,
        };
        let map: Vec<_> = greys.iter().map(color).collect();
        Pigment {
            kind: PigmentKind::ColorMap { pattern: pattern.into(), map: map.into() },
            quick_color: None,
        }
    }

    /// Along several rays nothing lies outside what is said to be reached; gives the share of the way that is.
    fn share(pigment: &Pigment, way: Affine) -> f64 {
        let shells: Vec<Shell> = Shell::of(pigment, &way).into_iter().collect();
        let compiled = raggio_shading::Pigment::compile(pigment, Noise::default());
        let mut reached = 0;
        for i in 0..10 {
            let height = 0.15 * f64::from(i) - 0.7;
            let ray = Ray::new(Vec3::new(-2.0, height, 0.1), Vec3::new(1.0, 0.1, -0.07).normalize());
            let reach = Reach::of(&shells, &ray, 4.0);
            for j in 0..400 {
                let t = f64::from(j) * 0.01;
                let found = compiled.rgb(way.transform_point3(ray.at(t)), &Context::NONE);
                assert!(reach.contains(t) || found == Rgb::ZERO, "{i} {j} {found}");
                reached += u32::from(reach.contains(t));
            }
        }
        f64::from(reached) / 4000.0
    }

    #[test]
    fn nothing_is_left_out_and_much_is() {
        let solid = [(0.0, 0.0), (0.3, 1.0), (1.0, 1.0)];
        let hollow = [(0.0, 0.0), (0.1, 1.0), (0.2, 0.0), (1.0, 0.0)];
        let everywhere = [(0.0, 0.5), (1.0, 1.0)];
        for kind in [PatternKind::Spherical, PatternKind::Cylindrical, PatternKind::Planar] {
            let turn = Mat3::from_rotation_z(0.4) * Mat3::from_diagonal(Vec3::new(0.8, 1.5, 1.1));
            let way = Affine::from_mat3_translation(turn, Vec3::new(0.1, -0.2, 0.0));
            let share = |map: &[(f32, f32)]| share(&density(kind.clone(), map), way);
            let (full, shell) = (share(&solid), share(&hollow));
            assert!(full < 0.8 && shell < 0.6 * full, "{kind:?} {full} {shell}");
            assert_eq!(share(&everywhere), 1.0);
        }
    }
}
