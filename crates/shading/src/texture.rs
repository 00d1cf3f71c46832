//! Textures: layers, and choices between textures (textures spec, section 9). Lighting them is not done here.
use std::sync::Arc;

use raggio_image::{Color, Rgb};
use raggio_math::Vec3;
use raggio_scene::{self as scene, PatternKind, TextureKind};

use crate::compiler::Compiler;
use crate::image::Image;
use crate::map::{Blend, Map};
use crate::warp::WarpList;
use crate::{Context, Noise, Normal, Pattern, Pigment};

/// A compiled texture.
#[derive(Debug)]
pub enum Texture {
    /// Plain layers, the bottom first.
    Layers(Vec<Layer>),
    /// A choice or mix: [`TextureMap::select`] says of what.
    Map(Box<TextureMap>),
    /// The inner texture at (u, v, 0).
    Uv(Arc<Texture>),
}

/// A compiled layer.
#[derive(Debug)]
pub struct Layer {
    /// Colour.
    pub pigment: Pigment,
    /// Bumps.
    pub normal: Option<Box<Normal>>,
    /// Answer to light.
    pub finish: scene::Finish,
    /// Does the finish reflect anything?
    pub mirrors: bool,
}

impl Layer {
    /// Its colour, if that is the same everywhere and nothing bends its normal.
    #[inline]
    pub fn plain_color(&self) -> Option<&Color> {
        if self.normal.is_none() { self.pigment.even_color() } else { None }
    }
}

/// A texture that chooses between others by a pattern.
#[derive(Debug)]
pub struct TextureMap {
    choice: Choice,
}

#[derive(Debug)]
enum Choice {
    Blend { pattern: Pattern, map: Map<Arc<Texture>> },
    Average { pattern: Pattern, map: Map<Arc<Texture>> },
    Material { warps: WarpList, image: Image, textures: Box<[Arc<Texture>]> },
}

impl Compiler {
    /// Compiles a texture with all its parts.
    pub(crate) fn texture(&mut self, texture: &scene::Texture) -> Texture {
        let choice = match &texture.kind {
            TextureKind::Layers(layers) => {
                return Texture::Layers(layers.iter().map(|layer| self.layer(layer)).collect());
            }
            TextureKind::Uv(inner) => {
                self.asks_uv = true;
                return Texture::Uv(self.shared_texture(inner));
            }
            TextureKind::Patterned { pattern, map } => {
                let map = Map::new(map.iter().map(|(at, entry)| (*at, self.shared_texture(entry))));
                let average = matches!(pattern.kind, PatternKind::Average);
                let pattern = self.pattern(pattern);
                if average { Choice::Average { pattern, map } } else { Choice::Blend { pattern, map } }
            }
            TextureKind::MaterialMap { warps, image, textures } => Choice::Material {
                warps: WarpList::compile(warps),
                image: Image::compile(image),
                textures: textures.iter().map(|texture| self.shared_texture(texture)).collect(),
            },
        };
        Texture::Map(Box::new(TextureMap { choice }))
    }

    fn layer(&mut self, layer: &scene::Layer) -> Layer {
        let reflection = &layer.finish.reflection;
        Layer {
            pigment: self.pigment(&layer.pigment),
            normal: layer.normal.as_ref().map(|normal| Box::new(self.normal(normal, false))),
            finish: layer.finish,
            mirrors: reflection.min != Rgb::ZERO || reflection.max != Rgb::ZERO,
        }
    }
}

impl Texture {
    /// Compiles a texture.
    pub fn compile(texture: &scene::Texture, noise: Noise) -> Self {
        Compiler::new(noise).texture(texture)
    }

    /// Compiles all textures of a scene, what they have in common once, and tells whether any part of any looks at
    /// texture coordinates.
    pub fn compile_all<'a>(
        textures: impl Iterator<Item = &'a Arc<scene::Texture>>,
        noise: Noise,
    ) -> (Vec<Arc<Self>>, bool) {
        let mut compiler = Compiler::new(noise);
        let compiled = textures.map(|texture| compiler.shared_texture(texture)).collect();
        (compiled, compiler.asks_uv)
    }

    /// The light that it lets through, where that is the same everywhere.
    pub fn even_transmission(&self) -> Option<Rgb> {
        let Texture::Layers(layers) = self else { return None };
        layers.iter().map(|layer| Some(layer.pigment.even_color()?.transmission())).product()
    }

    /// Does every part of it stop all light?
    pub fn is_opaque(&self) -> bool {
        match self {
            Texture::Layers(layers) => layers.iter().any(|layer| layer.pigment.is_opaque()),
            Texture::Map(map) => map.is_opaque(),
            Texture::Uv(inner) => inner.is_opaque(),
        }
    }
}

impl TextureMap {
    /// The textures that count at a point, by weight (one or two; all for an average), and the point to ask them at
    /// (moved by the map's warps). Normals move by [`TextureMap::normal_in`] and [`TextureMap::normal_out`].
    pub fn select(&self, p: Vec3, context: &Context, out: &mut dyn FnMut(&Texture, f32, Vec3)) {
        match &self.choice {
            Choice::Blend { pattern, map } => {
                let p = pattern.warp(p);
                match map.at(pattern.eval_warped(p, context)) {
                    Blend::One(Some(texture)) => out(texture, 1.0, p),
                    Blend::One(None) => {}
                    Blend::Two(low, high, t) => {
                        out(low, (1.0 - t) as f32, p);
                        out(high, t as f32, p);
                    }
                }
            }
            Choice::Average { pattern, map } => {
                let (p, total) = (pattern.warp(p), map.total_weight());
                for (weight, texture) in map.weighted() {
                    out(texture, (f64::from(weight) / total) as f32, p);
                }
            }
            Choice::Material { warps, image, textures } => {
                let p = warps.apply(p);
                if let Some(texture) = material(textures, image.material_index(p)) {
                    out(texture, 1.0, p);
                }
            }
        }
    }

    /// A point on its way into the map's space.
    pub fn point_in(&self, p: Vec3) -> Vec3 {
        self.warps().apply(p)
    }

    /// A normal on its way into the map's space.
    pub fn normal_in(&self, n: Vec3) -> Vec3 {
        self.warps().normal_in(n, false)
    }

    /// And back.
    pub fn normal_out(&self, n: Vec3) -> Vec3 {
        self.warps().normal_out(n, false)
    }

    fn warps(&self) -> &WarpList {
        match &self.choice {
            Choice::Blend { pattern, .. } | Choice::Average { pattern, .. } => pattern.warps(),
            Choice::Material { warps, .. } => warps,
        }
    }

    fn is_opaque(&self) -> bool {
        match &self.choice {
            Choice::Blend { map, .. } | Choice::Average { map, .. } => map.items().all(|t| t.is_opaque()),
            Choice::Material { textures, .. } => textures.iter().all(|t| t.is_opaque()),
        }
    }
}

/// The texture of an index: indices beyond the number of textures start again, but one, which takes the last.
fn material(textures: &[Arc<Texture>], index: usize) -> Option<&Arc<Texture>> {
    let count = textures.len();
    let index = if index > count { index.checked_rem(count)? } else { index };
    textures.get(index).or(textures.last())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn material_indices_wrap_with_the_languages_off_by_one() {
        let textures: Vec<Arc<Texture>> = (0..3).map(|_| Arc::new(Texture::Layers(Vec::new()))).collect();
        let which = |index| {
            let chosen = material(&textures, index).expect("a texture");
            textures.iter().position(|t| Arc::ptr_eq(t, chosen))
        };
        assert_eq!(
            (which(0), which(2), which(3), which(4), which(6)),
            (Some(0), Some(2), Some(2), Some(1), Some(0))
        );
        assert!(material(&[], 5).is_none());
    }
}
