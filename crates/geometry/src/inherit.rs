//! What objects inherit from those around them (shapes spec, section 8).
use std::sync::Arc;

use raggio_math::Affine;
use raggio_scene::{Csg, Object, ObjectKind, PhotonFlags};

use crate::materials::Materials;
use crate::texturing::Cutaway;
use crate::tree::Op;
use crate::{InteriorId, LightGroupId, Material, MaterialId, RayClass, TextureId};

/// What an object inherits.
#[derive(Clone)]
pub(crate) struct Context {
    pub(crate) world_from_here: Affine,
    pub(crate) inverted: bool,
    pub(crate) texture: Option<TextureId>,
    pub(crate) interior_texture: Option<TextureId>,
    /// `None` only above the top-level objects.
    pub(crate) interior: Option<InteriorId>,
    pub(crate) uv_mapping: bool,
    pub(crate) hollow: bool,
    /// Rays that do not see it, as bits of [`RayClass`].
    pub(crate) skip: u8,
    pub(crate) double_illuminate: bool,
    pub(crate) light_group: Option<LightGroupId>,
    /// The same for what stands in the group itself: lights in a union there shine on the whole scene.
    pub(crate) member_of: Option<LightGroupId>,
    pub(crate) global_lights: bool,
    pub(crate) photons: PhotonFlags,
    pub(crate) radiosity_importance: Option<f32>,
    /// Number of the top-level object.
    pub(crate) object: u32,
    /// The group whose `cutaway_textures` decide where a leaf has no texture of its own.
    pub(crate) cutaway: Option<Cutaway>,
    /// Inside a clip or bound: only its form matters.
    pub(crate) form_only: bool,
}

/// Flags that are tested only on top-level objects and on children of unions that were opened into the world.
pub(crate) const OUTERMOST_ONLY: u8 = RayClass::Shadow.bit();

impl Context {
    pub(crate) fn top_level(object: u32) -> Self {
        Context {
            world_from_here: Affine::IDENTITY,
            inverted: false,
            texture: None,
            interior_texture: None,
            interior: None,
            uv_mapping: false,
            hollow: false,
            skip: 0,
            double_illuminate: false,
            light_group: None,
            member_of: None,
            global_lights: true,
            photons: PhotonFlags::default(),
            radiosity_importance: None,
            object,
            cutaway: None,
            form_only: false,
        }
    }

    /// For clips and bounds, whose coordinates are those around the object.
    pub(crate) fn form_only(&self) -> Self {
        Context { form_only: true, inverted: false, skip: 0, cutaway: None, ..self.clone() }
    }

    /// What the object's own parts inherit.
    pub(crate) fn inherited(&self, object: &Object, materials: &mut Materials) -> Context {
        let mut c = self.clone();
        c.world_from_here = self.world_from_here * object.parent_from_object;
        c.inverted ^= object.inverse;
        if c.form_only {
            return c;
        }
        // Textures of an object with uv_mapping do not move with what is around it.
        let around = if object.uv_mapping { Affine::IDENTITY } else { self.world_from_here };
        if let Some(texture) = &object.texture {
            c.texture = Some(materials.texture(&texture.item, &(around * texture.parent_from_item())));
            c.uv_mapping = false;
            c.cutaway = None;
        }
        if let Some(texture) = &object.interior_texture {
            c.interior_texture =
                Some(materials.texture(&texture.item, &(around * texture.parent_from_item())));
        }
        c.uv_mapping |= object.uv_mapping;
        // A top-level object without an interior has one of its own nevertheless, and its parts share it.
        if let Some(interior) = &object.interior {
            c.interior = Some(materials.interior(interior, &self.world_from_here));
        } else if c.interior.is_none() {
            c.interior = Some(materials.private_interior());
        }
        c.hollow = object.hollow.unwrap_or(self.hollow);
        c.skip |= skip_bits(object);
        c.double_illuminate |= object.double_illuminate;
        c.photons = inherit_photons(object.photons, self.photons);
        c.radiosity_importance = object.radiosity_importance.or(self.radiosity_importance);
        c
    }

    /// The material of a leaf.
    pub(crate) fn material(&self, materials: &mut Materials) -> MaterialId {
        let interior = self.interior.unwrap_or(InteriorId(0));
        // The member processed last decides for all that share the interior.
        materials.interiors[interior.0 as usize].hollow = self.hollow;
        materials.material(Material {
            texture: self.texture,
            interior_texture: self.interior_texture,
            interior,
            double_illuminate: self.double_illuminate,
            uv_mapping: self.uv_mapping,
            light_group: self.light_group,
            global_lights: self.global_lights,
            photons: self.photons,
            radiosity_importance: self.radiosity_importance,
            object: self.object,
        })
    }
}

/// What is left of an operation once inversion has gone down to the members.
pub(crate) fn effective(csg: Csg, inverted: bool) -> Op {
    match (csg, inverted) {
        (Csg::Union, false) => Op::Union,
        (Csg::Merge, false) => Op::Merge,
        (Csg::Union | Csg::Merge, true) => Op::Intersection,
        (_, false) => Op::Intersection,
        (_, true) => Op::Merge,
    }
}

fn skip_bits(object: &Object) -> u8 {
    let bit = |on: bool, class: RayClass| if on { class.bit() } else { 0 };
    bit(object.no_shadow, RayClass::Shadow)
        | bit(object.no_image, RayClass::Camera)
        | bit(object.no_reflection, RayClass::Reflected)
        | bit(object.no_radiosity, RayClass::Radiosity)
}

/// A union all of whose members cast no shadow casts none itself.
pub(crate) fn all_shadowless(children: &[Arc<Object>]) -> bool {
    let mut objects = children.iter().filter(|c| !matches!(c.kind, ObjectKind::Light(_))).peekable();
    objects.peek().is_some()
        && objects.all(|c| {
            c.no_shadow
                || match &c.kind {
                    ObjectKind::Csg { op: Csg::Union, children }
                    | ObjectKind::LightGroup { children, .. } => all_shadowless(children),
                    _ => false,
                }
        })
}

/// Photon switches go down to every descendant and cannot be taken back.
fn inherit_photons(own: PhotonFlags, outer: PhotonFlags) -> PhotonFlags {
    PhotonFlags {
        target: outer.target.or(own.target),
        reflection: outer.reflection.or(own.reflection),
        refraction: outer.refraction.or(own.refraction),
        pass_through: outer.pass_through || own.pass_through,
        collect: outer.collect.or(own.collect),
    }
}
