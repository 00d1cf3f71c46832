//! Which textures count at a hit.
use raggio_math::Vec3;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

use crate::tree::{Node, NodeRef, Tree};
use crate::{Hit, Material, TextureId, TextureUse, TextureUses};

/// What leaves with textures in parts have beyond their material, by leaf.
pub(crate) type Parts = FxHashMap<u32, LeafParts>;

/// Textures of a leaf's parts.
#[derive(Default)]
pub(crate) struct LeafParts {
    /// Of a mesh's texture list or of a blob's components.
    pub(crate) textures: Vec<Option<TextureId>>,
    /// `cutaway_textures` of a group around it decide.
    pub(crate) cutaway: Option<Cutaway>,
}

/// A group with `cutaway_textures`.
#[derive(Clone, Copy)]
pub(crate) struct Cutaway {
    pub(crate) group: u32,
    /// The first member's texture goes before those of the others.
    pub(crate) difference: bool,
}

/// The textures of a shape's part, by the shape's own numbering, and their shares.
pub(crate) type PartUses = SmallVec<[(u32, f32); 4]>;

/// A list of textures with their weights.
type Uses = SmallVec<[TextureUse; 2]>;

/// What is needed to tell.
pub(crate) struct Texturing<'a> {
    pub(crate) tree: &'a Tree,
    pub(crate) materials: &'a [Material],
    pub(crate) parts: &'a Parts,
}

impl Texturing<'_> {
    /// The textures at a hit, at a point in the world.
    pub(crate) fn at(&self, hit: &Hit, p: Vec3, from_inside: bool) -> TextureUses {
        let material = self.material(hit.leaf);
        if let (true, Some(texture)) = (from_inside, material.interior_texture) {
            return TextureUses::One(whole(texture));
        }
        match self.tree.leaves.leaves[hit.leaf as usize].has_parts {
            true => TextureUses::Other(self.of_leaf(hit, p, material)),
            false => match material.texture {
                Some(texture) => TextureUses::One(whole(texture)),
                None => TextureUses::Other(Uses::new()),
            },
        }
    }

    /// The textures of a leaf that has more than its material's.
    #[inline(never)]
    fn of_leaf(&self, hit: &Hit, p: Vec3, material: &Material) -> Uses {
        let Some(parts) = self.parts.get(&hit.leaf) else { return alone(material.texture) };
        let object = match parts.cutaway {
            Some(cutaway) => self.cut(&cutaway, p),
            None => alone(material.texture),
        };
        match parts.textures.is_empty() {
            true => object,
            false => self.of_parts(&parts.textures, object, hit, self.tree.leaves.local_point(hit.leaf, p)),
        }
    }

    fn material(&self, leaf: u32) -> &Material {
        &self.materials[self.tree.leaves.leaves[leaf as usize].material.0 as usize]
    }

    /// Textures of a mesh's face or of a blob's components; where one has none, the object's count.
    fn of_parts(&self, textures: &[Option<TextureId>], object: Uses, hit: &Hit, local: Vec3) -> Uses {
        let mut shares = PartUses::new();
        if let Some(shape) = self.tree.leaves.shape(hit.leaf) {
            shape.part_uses(local, &hit.local, &mut shares);
        }
        if shares.is_empty() {
            return object;
        }
        let mut uses = Uses::new();
        for (part, share) in shares {
            match textures.get(part as usize).copied().flatten() {
                Some(texture) => add(&mut uses, texture, share),
                None => object.iter().for_each(|u| add(&mut uses, u.texture, u.weight * share)),
            }
        }
        uses
    }

    /// `cutaway_textures`: in a difference the first member's texture where it contains the point (none, where it has
    /// none); else the average over all members that contain it (shapes spec, section 8).
    fn cut(&self, cutaway: &Cutaway, p: Vec3) -> Uses {
        let members = &self.tree.groups[cutaway.group as usize].members;
        let mut found = Uses::new();
        match members.first() {
            Some(first) if cutaway.difference && self.tree.inside(first.node, p) => {
                self.gather(first.node, p, &mut found);
            }
            _ => members.iter().for_each(|m| self.gather(m.node, p, &mut found)),
        }
        let total: f32 = found.iter().map(|u| u.weight).sum();
        found.iter_mut().for_each(|u| u.weight /= total);
        found
    }

    /// The textures of all leaves under a node that contain the point.
    fn gather(&self, node: NodeRef, p: Vec3, found: &mut Uses) {
        match node.node() {
            Node::Leaf(leaf) => {
                if let Some(texture) = self.material(leaf).texture
                    && self.tree.leaves.inside(leaf, p)
                {
                    add(found, texture, 1.0);
                }
            }
            Node::Group(group) => {
                let group = &self.tree.groups[group as usize];
                if self.tree.within_clips(group, p) {
                    group.members.iter().for_each(|m| self.gather(m.node, p, found));
                }
            }
        }
    }
}

/// The object's texture, if it has one.
#[inline]
fn alone(texture: Option<TextureId>) -> Uses {
    let mut uses = Uses::new();
    if let Some(texture) = texture {
        uses.push(whole(texture));
    }
    uses
}

fn whole(texture: TextureId) -> TextureUse {
    TextureUse { texture, weight: 1.0 }
}

/// Adds to a texture that is there already, so that none is shaded twice.
fn add(uses: &mut Uses, texture: TextureId, weight: f32) {
    match uses.iter_mut().find(|u| u.texture == texture) {
        Some(u) => u.weight += weight,
        None => uses.push(TextureUse { texture, weight }),
    }
}
