//! The compiled forms of textures, and what they are asked.
use std::sync::Arc;

use raggio_image::Color;
use raggio_math::{Vec2, Vec3};
use raggio_scene as scene;

/// What the scene says to all noise: default generator, number of waves.
#[derive(Clone, Copy, Debug)]
pub struct Noise {
    /// 1, 2 or 3.
    pub generator: u8,
    /// Sources of `ripples` and `waves`.
    pub waves: u32,
}

/// What is known at a surface beyond the point; patterns like `slope` and `aoi` ask for it.
#[derive(Clone, Copy, Debug)]
pub struct Context {
    /// The normal so far, unit, facing the viewer; `None` where there is no surface (sky, media, functions).
    pub normal: Option<Vec3>,
    /// The ray's unit direction.
    pub ray_dir: Vec3,
    /// Texture coordinates.
    pub uv: Vec2,
}

/// A compiled pattern.
#[derive(Debug)]
pub struct Pattern;
/// A compiled pigment.
#[derive(Debug)]
pub struct Pigment;
/// A compiled normal.
#[derive(Debug)]
pub struct Normal;

#[allow(unused_variables, clippy::todo)]
impl Pattern {
    pub fn compile(pattern: &scene::Pattern, noise: Noise) -> Self {
        todo!()
    }
    /// The value at a point, waves applied (textures spec, section 2).
    pub fn eval(&self, p: Vec3, context: &Context) -> f64 {
        todo!()
    }
}

#[allow(unused_variables, clippy::todo)]
impl Pigment {
    pub fn compile(pigment: &scene::Pigment, noise: Noise) -> Self {
        todo!()
    }
    /// The colour at a point; `None` where an image used `once` has none.
    pub fn eval(&self, p: Vec3, context: &Context) -> Option<Color> {
        todo!()
    }
    /// Does no part of it ever let light through?
    pub fn is_opaque(&self) -> bool {
        todo!()
    }
    /// The colour for low quality.
    pub fn quick_color(&self) -> Option<Color> {
        todo!()
    }
}

#[allow(unused_variables, clippy::todo)]
impl Normal {
    pub fn compile(normal: &scene::Normal, noise: Noise) -> Self {
        todo!()
    }
    /// The bent normal, unit length.
    pub fn perturb(&self, n: Vec3, p: Vec3, context: &Context) -> Vec3 {
        todo!()
    }
}

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
    pub pigment: Pigment,
    pub normal: Option<Normal>,
    pub finish: scene::Finish,
}

/// A texture that chooses between others by a pattern.
#[derive(Debug)]
pub struct TextureMap;

#[allow(unused_variables, clippy::todo)]
impl TextureMap {
    /// The textures that count at a point, by weight (one or two; all for an average), the point to ask them at (moved
    /// by the map's warps), and the same for normals.
    pub fn select(&self, p: Vec3, context: &Context, out: &mut dyn FnMut(&Texture, f32, Vec3)) {
        todo!()
    }
    /// A normal on its way into the map's space.
    pub fn normal_in(&self, n: Vec3) -> Vec3 {
        todo!()
    }
    /// And back.
    pub fn normal_out(&self, n: Vec3) -> Vec3 {
        todo!()
    }
}

#[allow(unused_variables, clippy::todo)]
impl Texture {
    pub fn compile(texture: &scene::Texture, noise: Noise) -> Self {
        todo!()
    }
    /// Does every part of it stop all light?
    pub fn is_opaque(&self) -> bool {
        todo!()
    }
}
