//! What hangs on leaves, each different thing once: materials, placed textures, interiors.
use std::sync::Arc;

use raggio_math::Affine;
use raggio_scene::{Interior, PigmentKind, Placed, Texture, TextureKind};
use rustc_hash::FxHashMap;

use crate::{InteriorId, InteriorInfo, Material, MaterialId, PlacedTexture, TextureId};

/// Collects materials while the tree is walked.
#[derive(Default)]
pub(crate) struct Materials {
    pub(crate) materials: Vec<Material>,
    pub(crate) textures: Vec<PlacedTexture>,
    pub(crate) interiors: Vec<InteriorInfo>,
    default_interior: Arc<Interior>,
    material_ids: FxHashMap<MaterialKey, MaterialId>,
    texture_ids: FxHashMap<TextureKey, TextureId>,
    /// By address: those that are the same wherever they are.
    uniform_ids: FxHashMap<usize, TextureId>,
}

/// What tells most materials apart.
type MaterialKey = (u32, Option<TextureId>, Option<TextureId>, InteriorId);
/// The texture's address and the bits of its place.
type TextureKey = (usize, [u64; 12]);

impl Materials {
    /// The id of a texture at its place in the world.
    pub(crate) fn texture(&mut self, texture: &Arc<Texture>, world_from_texture: &Affine) -> TextureId {
        let address = Arc::as_ptr(texture) as usize;
        let textures = &mut self.textures;
        let mut add = |place: &Affine| {
            let identity = *place == Affine::IDENTITY;
            textures.push(PlacedTexture {
                texture: texture.clone(),
                texture_from_world: (!identity).then(|| Box::new(place.inverse())),
            });
            TextureId(textures.len() as u32 - 1)
        };
        // Copies of an object of one colour share one texture wherever they are.
        if is_uniform(texture) {
            return *self.uniform_ids.entry(address).or_insert_with(|| add(&Affine::IDENTITY));
        }
        let key = (address, world_from_texture.to_cols_array().map(f64::to_bits));
        *self.texture_ids.entry(key).or_insert_with(|| add(world_from_texture))
    }

    /// A new interior: each has an identity of its own.
    pub(crate) fn interior(&mut self, interior: &Placed<Interior>, world_from_parent: &Affine) -> InteriorId {
        let world_from_interior = *world_from_parent * interior.parent_from_item();
        let moved = world_from_interior != Affine::IDENTITY;
        self.interiors.push(InteriorInfo {
            interior: interior.item.clone(),
            world_from_interior: moved.then(|| Box::new(world_from_interior)),
            hollow: false,
        });
        InteriorId(self.interiors.len() as u32 - 1)
    }

    /// A new interior of an object that names none.
    pub(crate) fn private_interior(&mut self) -> InteriorId {
        let interior = Placed::new(self.default_interior.clone());
        self.interior(&interior, &Affine::IDENTITY)
    }

    /// The id of a material; equal ones share it.
    pub(crate) fn material(&mut self, material: Material) -> MaterialId {
        let key = (material.object, material.texture, material.interior_texture, material.interior);
        if let Some(&id) = self.material_ids.get(&key)
            && self.materials[id.0 as usize] == material
        {
            return id;
        }
        self.materials.push(material);
        let id = MaterialId(self.materials.len() as u32 - 1);
        self.material_ids.insert(key, id);
        id
    }
}

/// Is the texture the same at every point?
fn is_uniform(texture: &Texture) -> bool {
    let TextureKind::Layers(layers) = &texture.kind else { return false };
    layers.iter().all(|layer| {
        matches!(layer.pigment.kind, PigmentKind::Solid { .. })
            && layer.normal.is_none()
            && layer.finish.irid.is_none()
    })
}
