//! Background and sky sphere, with the rules for pictures with alpha (light spec, section 6.1).
use raggio_image::{Color, Rgb, grey};
use raggio_math::{Affine, Vec3};
use raggio_scene::Scene;
use raggio_shading::{Context, Noise, Pigment};

use crate::integrator::Seen;

/// What lies behind everything.
pub struct Dome {
    /// From the last written, which lies on top.
    layers: Vec<(Pigment, Affine)>,
    emission: Rgb,
    background: Option<Color>,
    modern: bool,
    /// What is seen of it without transparency, where that is the same everywhere.
    plain: Option<Seen>,
}

impl Dome {
    /// Makes the dome of a scene ready.
    pub fn new(scene: &Scene, noise: Noise) -> Dome {
        let dome = Dome::layers(scene, noise);
        let plain = dome.layers.is_empty().then(|| dome.miss(Vec3::Y, false));
        Dome { plain, ..dome }
    }

    fn layers(scene: &Scene, noise: Noise) -> Dome {
        let sphere = scene.atmosphere.sky_sphere.as_ref();
        let layers = sphere.iter().flat_map(|s| s.pigments.iter().rev());
        Dome {
            layers: layers
                .map(|p| (Pigment::compile(&p.item, noise), p.parent_from_item().inverse()))
                .collect(),
            emission: sphere.map_or(Rgb::ONE, |s| s.emission),
            background: scene.atmosphere.background.map(|b| b.color),
            modern: scene.settings.version.effective >= 370,
            plain: None,
        }
    }

    /// What is seen in a direction. `alpha`: transparency is kept.
    #[inline]
    pub fn miss(&self, dir: Vec3, alpha: bool) -> Seen {
        match self.plain {
            Some(seen) if !alpha => seen,
            _ => self.look(dir, alpha),
        }
    }

    #[inline(never)]
    fn look(&self, dir: Vec3, alpha: bool) -> Seen {
        if self.modern { self.layered(dir, alpha) } else { self.classic(dir, alpha) }
    }

    fn pigments(&self, dir: Vec3) -> impl Iterator<Item = Color> {
        let context = Context { ray_dir: dir, ..Context::NONE };
        self.layers.iter().map(move |(pigment, sky_from_world)| {
            pigment.eval(sky_from_world.transform_point3(dir), &context).unwrap_or_default()
        })
    }

    /// The rules of 3.7: layers from the top, then the background as one more.
    fn layered(&self, dir: Vec3, alpha: bool) -> Seen {
        let (mut rgb, mut filter) = (Rgb::ZERO, Rgb::ONE);
        for p in self.pigments(dir) {
            rgb += p.rgb * p.opacity() * filter * self.emission;
            filter *= p.transmission();
            if filter == Rgb::ZERO {
                break;
            }
        }
        if !alpha {
            let ground = self.background.map_or(Rgb::ZERO, |b| b.rgb * (1.0 - b.transmit));
            return Seen::opaque(rgb + ground * filter);
        }
        let clear = Color { rgb: Rgb::ZERO, filter: 0.0, transmit: 1.0 };
        let ground = self.background.unwrap_or(clear);
        rgb += ground.rgb * ground.opacity() * filter;
        filter *= ground.transmission();
        Seen::new(rgb, grey(filter).abs().min(1.0))
    }

    /// The rules before 3.7: no sky at all in pictures with alpha.
    fn classic(&self, dir: Vec3, alpha: bool) -> Seen {
        if alpha {
            return Seen::new(Rgb::ZERO, 1.0);
        }
        let ground = self.background.map_or(Rgb::ZERO, |b| b.rgb);
        let mut sky = Rgb::ZERO;
        let (mut product, mut through) = (Color { rgb: Rgb::ONE, filter: 1.0, transmit: 1.0 }, 1.0);
        for p in self.pigments(dir) {
            sky += p.rgb * (through * p.opacity());
            product = Color {
                rgb: product.rgb * p.rgb,
                filter: product.filter * p.filter,
                transmit: product.transmit * p.transmit,
            };
            through = product.filter.abs() + product.transmit.abs();
        }
        let behind = if self.layers.is_empty() { Rgb::ONE } else { product.transmission() };
        Seen::opaque(sky * self.emission + ground * behind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dome(background: Option<[f64; 5]>, modern: bool) -> Dome {
        let background = background.map(Color::from_array);
        Dome { layers: Vec::new(), emission: Rgb::ONE, background, modern, plain: None }
    }

    #[test]
    fn backgrounds_with_and_without_alpha() {
        let half = Some([0.5, 0.5, 0.5, 0.0, 0.25]);
        let near = |s: Seen, v: f32, t: f32| {
            assert!((s.rgb() - Rgb::splat(v)).length() < 1e-6 && (s.transmit() - t).abs() < 1e-6, "{s:?}");
        };
        near(dome(half, true).miss(Vec3::Z, false), 0.375, 0.0);
        near(dome(half, true).miss(Vec3::Z, true), 0.375, 0.25);
        near(dome(None, true).miss(Vec3::Z, true), 0.0, 1.0);
        near(dome(None, true).miss(Vec3::Z, false), 0.0, 0.0);
        near(dome(half, false).miss(Vec3::Z, false), 0.5, 0.0);
        near(dome(half, false).miss(Vec3::Z, true), 0.0, 1.0);
    }
}
