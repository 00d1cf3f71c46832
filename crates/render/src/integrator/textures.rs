//! From a texture at a place to its plain layers: placement, maps, uv, and the way of normals through them.
use raggio_geometry::{Interaction, Material};
use raggio_math::{Vec3, transform::normal_by_inverse};
use raggio_shading::{Context, Layer, Normal, Texture, TextureMap};

use crate::world::{Frame, WorldTexture};

/// The spaces that a normal goes through on its way from the world to a layer.
#[derive(Clone, Copy)]
pub struct NormalPath<'a> {
    outer: Option<&'a NormalPath<'a>>,
    step: Step<'a>,
}

#[derive(Clone, Copy)]
enum Step<'a> {
    Stay,
    Placed(&'a Frame),
    Map(&'a TextureMap),
}

impl NormalPath<'_> {
    /// The normal, of unit length in the world, that a layer makes of the surface's `n`. `p` is the layer's point.
    pub fn bend(&self, normal: &Normal, n: Vec3, p: Vec3, context: &Context) -> Vec3 {
        let lengths = normal.keeps_lengths();
        let bent = self.leave(normal.perturb(self.enter(n, lengths), p, context), lengths);
        // Every step but those that keep lengths leaves it of unit length.
        if lengths { unit(bent) } else { bent }
    }

    /// A point of the world in the layer's space, where no texture coordinates stand in its place.
    pub fn point(&self, p: Vec3) -> Vec3 {
        let p = self.outer.map_or(p, |outer| outer.point(p));
        match self.step {
            Step::Stay => p,
            Step::Placed(frame) => frame.texture_from_world.transform_point3(p),
            Step::Map(map) => map.point_in(p),
        }
    }

    /// A normal of the world in the layer's space. With `lengths`, places scale it.
    fn enter(&self, n: Vec3, lengths: bool) -> Vec3 {
        let n = self.outer.map_or(n, |outer| outer.enter(n, lengths));
        match self.step {
            Step::Stay => n,
            Step::Placed(frame) => unit_unless(lengths, normal_by_inverse(&frame.world_from_texture, n)),
            Step::Map(map) => map.normal_in(n),
        }
    }

    /// A normal of the layer's space in the world.
    fn leave(&self, n: Vec3, lengths: bool) -> Vec3 {
        let n = match self.step {
            Step::Stay => n,
            Step::Placed(frame) => unit_unless(lengths, normal_by_inverse(&frame.texture_from_world, n)),
            Step::Map(map) => map.normal_out(n),
        };
        self.outer.map_or(n, |outer| outer.leave(n, lengths))
    }
}

fn unit_unless(lengths: bool, n: Vec3) -> Vec3 {
    if lengths { n } else { unit(n) }
}

fn unit(n: Vec3) -> Vec3 {
    n.try_normalize().unwrap_or(n)
}

/// What a plain texture is asked with: its layers, the point, its weight, the way of normals.
type Visit<'v> = dyn FnMut(&[Layer], Vec3, f32, &NormalPath<'_>) + 'v;

/// A texture at its place on a surface: the path of its normals, and the point at which it is asked.
pub fn placed<'a>(
    texture: &'a WorldTexture,
    surface: &Interaction,
    material: &Material,
) -> (NormalPath<'a>, Vec3) {
    let step = texture.frame.as_deref().map_or(Step::Stay, Step::Placed);
    let p = if material.uv_mapping { surface.uv.extend(0.0) } else { surface.p };
    (NormalPath { outer: None, step }, texture.point(p))
}

/// Visits every plain texture that counts at a point.
pub fn for_each_plain(
    texture: &Texture,
    p: Vec3,
    weight: f32,
    path: &NormalPath<'_>,
    context: &Context,
    visit: &mut Visit<'_>,
) {
    match texture {
        Texture::Layers(layers) => visit(layers, p, weight, path),
        Texture::Uv(inner) => for_each_plain(inner, context.uv.extend(0.0), weight, path, context, visit),
        Texture::Map(map) => {
            let path = NormalPath { outer: Some(path), step: Step::Map(map) };
            map.select(p, context, &mut |inner, share, p| {
                for_each_plain(inner, p, weight * share, &path, context, visit);
            });
        }
    }
}
