//! How light thins out: cones, cylinders and distance (light spec, section 5.2).
use raggio_image::Rgb;
use raggio_math::turns::fraction;
use raggio_math::{EPS, Ray, Vec3};
use raggio_scene::{self as scene, LightKind};

use super::{LightSource, Path};

/// How a light narrows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cone {
    /// Not at all.
    None,
    /// A cone around the axis; cosines of the half angles.
    Spot {
        /// Full light inside.
        cos_radius: f64,
        /// None outside.
        cos_falloff: f64,
        /// Falls off even inside.
        tightness: f64,
    },
    /// A cylinder around the axis.
    Cylinder {
        /// Full light inside.
        radius: f64,
        /// None outside.
        falloff: f64,
        /// Falls off even inside.
        tightness: f64,
    },
}

impl Cone {
    /// The cone of a kind of light.
    pub fn new(kind: &LightKind) -> Cone {
        match *kind {
            LightKind::Point | LightKind::Shadowless => Cone::None,
            LightKind::Spot { radius, falloff, tightness } => Cone::Spot {
                cos_radius: radius.to_radians().cos(),
                cos_falloff: falloff.to_radians().cos(),
                tightness,
            },
            LightKind::Cylinder { radius, falloff, tightness } => {
                Cone::Cylinder { radius, falloff, tightness }
            }
        }
    }
}

/// `fade_distance` and `fade_power` where they have an effect.
pub(super) fn fade(light: &scene::Light) -> Option<(f64, f64)> {
    (light.fade_power > 0.0 && light.fade_distance.abs() > EPS)
        .then_some((light.fade_distance, light.fade_power))
}

/// The smooth step from 0 at `lo` to 1 at `hi`.
fn smooth(lo: f64, hi: f64, v: f64) -> f64 {
    if v < lo {
        return 0.0;
    }
    if v >= hi {
        return 1.0;
    }
    let w = (v - lo) / (hi - lo);
    (3.0 - 2.0 * w) * w * w
}

fn power(base: f64, exponent: f64) -> f64 {
    // Most are small whole numbers.
    if (0.0..64.0).contains(&exponent) && fraction(exponent) == 0.0 {
        base.powi(exponent as i32)
    } else {
        base.powf(exponent)
    }
}

impl LightSource {
    /// The light's colour as it arrives at the start of a way to it, before shadows, from the light's point `from`.
    pub fn arriving(&self, path: &Path, from: Vec3) -> Rgb {
        self.color * self.attenuation(path, from) as f32
    }

    /// The factor by which the light thins out on a way from its point `from`.
    pub fn attenuation(&self, path: &Path, from: Vec3) -> f64 {
        let narrowed = match self.cone {
            Cone::None => 1.0,
            Cone::Spot { cos_radius, cos_falloff, tightness } => {
                let cosine = match self.parallel {
                    true => 1f64.copysign(path.distance),
                    false => -path.ray.dir.dot(self.axis),
                };
                spot(cosine, cos_radius, cos_falloff, tightness)
            }
            Cone::Cylinder { radius, falloff, tightness } => {
                let offset = path.ray.origin - from;
                let along = offset.dot(self.axis);
                let away = (offset - self.axis * along).length();
                if along <= 0.0 { 0.0 } else { tube(away, radius, falloff, tightness) }
            }
        };
        if narrowed > 0.0 { narrowed * self.fading(path.distance) } else { narrowed }
    }

    /// How the light fades over a way.
    pub fn fading(&self, way: f64) -> f64 {
        match self.fade {
            Some((distance, exponent)) => {
                let way = (way / distance).abs();
                let power = if exponent == 2.0 { way * way } else { way.powf(exponent) };
                2.0 / (1.0 + power)
            }
            None => 1.0,
        }
    }

    /// The part of the light that leaves along a ray, by the light's cone alone.
    pub fn emission(&self, ray: &Ray, from: Vec3) -> f64 {
        match self.cone {
            Cone::None => 1.0,
            Cone::Spot { cos_radius, cos_falloff, tightness } => {
                let cosine = if self.parallel { 1.0 } else { ray.dir.dot(self.axis) };
                spot(cosine, cos_radius, cos_falloff, tightness)
            }
            Cone::Cylinder { radius, falloff, tightness } => {
                let offset = ray.origin - from;
                let away = (offset - self.axis * offset.dot(self.axis)).length();
                tube(away, radius, falloff, tightness)
            }
        }
    }
}

fn spot(cosine: f64, cos_radius: f64, cos_falloff: f64, tightness: f64) -> f64 {
    if cosine <= 0.0 {
        return 0.0;
    }
    let edge =
        if cos_radius > 0.0 && cosine < cos_radius { smooth(cos_falloff, cos_radius, cosine) } else { 1.0 };
    edge * power(cosine, tightness)
}

fn tube(away: f64, radius: f64, falloff: f64, tightness: f64) -> f64 {
    if away >= falloff {
        return 0.0;
    }
    let depth = 1.0 - away / falloff;
    let edge = if radius > 0.0 && away > radius { smooth(0.0, 1.0 - radius / falloff, depth) } else { 1.0 };
    edge * power(depth, tightness)
}

#[cfg(test)]
mod tests {
    use super::*;
    use raggio_geometry::Geometry;
    use raggio_scene::{Csg, Object, ObjectKind};
    use std::sync::Arc;

    pub(crate) fn light(kind: LightKind) -> scene::Light {
        scene::Light { kind, point_at: Vec3::ZERO, ..scene::Light::new(Vec3::new(0.0, 10.0, 0.0), Rgb::ONE) }
    }

    fn built(light: &scene::Light) -> LightSource {
        let kind = ObjectKind::Csg { op: Csg::Union, children: Arc::default() };
        let nothing = Geometry::of_object(&Arc::new(Object::new(kind))).unwrap();
        LightSource::build(0, light, &nothing).unwrap()
    }

    fn at(light: &scene::Light, p: Vec3) -> f32 {
        let light = built(light);
        light.arriving(&light.path(p), light.position).x
    }

    #[test]
    fn spotlights_fall_off_between_their_angles() {
        let spot = light(LightKind::Spot { radius: 30.0, falloff: 45.0, tightness: 0.0 });
        let out = |degrees: f64| at(&spot, Vec3::new(10.0 * degrees.to_radians().tan(), 0.0, 0.0));
        assert_eq!(out(29.0), 1.0);
        assert_eq!(out(46.0), 0.0);
        let (lo, hi, v) = (45f64.to_radians().cos(), 30f64.to_radians().cos(), 38f64.to_radians().cos());
        let w = (v - lo) / (hi - lo);
        assert!((f64::from(out(38.0)) - (3.0 - 2.0 * w) * w * w).abs() < 1e-6);
        assert_eq!(at(&spot, Vec3::new(0.0, 11.0, 0.0)), 0.0);
    }

    #[test]
    fn tightness_narrows_inside_the_radius() {
        let spot = light(LightKind::Spot { radius: 30.0, falloff: 45.0, tightness: 2.0 });
        let cosine = 20f64.to_radians().cos();
        let got = at(&spot, Vec3::new(10.0 * 20f64.to_radians().tan(), 0.0, 0.0));
        assert!((f64::from(got) - cosine * cosine).abs() < 1e-6);
    }

    #[test]
    fn cylinders_are_measured_across_the_axis() {
        let tube = light(LightKind::Cylinder { radius: 1.0, falloff: 2.0, tightness: 1.0 });
        assert!((at(&tube, Vec3::new(0.5, 3.0, 0.0)) - 0.75).abs() < 1e-6);
        // z = 0.25 of 1 - 1/2: the step is half way; times z itself.
        assert!((at(&tube, Vec3::new(1.5, 3.0, 0.0)) - 0.125).abs() < 1e-6);
        assert_eq!(at(&tube, Vec3::new(2.0, 3.0, 0.0)), 0.0);
        assert_eq!(at(&tube, Vec3::new(0.0, 10.5, 0.0)), 0.0);
    }

    #[test]
    fn fading_halves_twice_the_light_at_its_distance() {
        let mut point = light(LightKind::Point);
        (point.fade_distance, point.fade_power) = (5.0, 2.0);
        assert!((at(&point, Vec3::new(0.0, 5.0, 0.0)) - 1.0).abs() < 1e-6);
        assert!((at(&point, Vec3::ZERO) - 0.4).abs() < 1e-6);
    }

    #[test]
    fn parallel_lights_shine_one_way_and_count_distance_along_it() {
        let mut sun = light(LightKind::Point);
        sun.parallel = true;
        let sun = built(&sun);
        let path = sun.path(Vec3::new(7.0, 12.0, 3.0));
        assert!((path.ray.dir - Vec3::Y).length() < 1e-12);
        assert!((path.distance + 2.0).abs() < 1e-12);
    }
}
