//! A scene's objects, compiled: what rays are shot at.
use std::sync::{Arc, OnceLock};

use raggio_math::{Aabb, Affine, MAX_DISTANCE, MIN_HIT, Ray, Vec2, Vec3};
use raggio_scene::{Interior, Light, Object, PhotonFlags, Placed, Scene, Texture};
use smallvec::SmallVec;

use crate::borders::Borders;
use crate::flatten::{Flat, flatten};
use crate::outlook::Outlook;
use crate::probe::Probe;
use crate::shaft::Shaft;
use crate::shapes::ShapeKind;
use crate::standing::Standing;
use crate::texturing::{Parts, Texturing};
use crate::tree::{Group, Member, Node, NodeRef, Scratch, Tree};

/// Index of a [`Material`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MaterialId(pub u32);
/// Index of a [`PlacedTexture`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureId(pub u32);
/// Identity of an interior, as the list of section 3.3 of the light spec compares them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct InteriorId(pub u32);
/// Which light group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LightGroupId(pub u32);

/// Why a ray is shot; decides which objects it sees (light spec, section 3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayClass {
    /// From the camera, refracted or not: skips `no_image`.
    Camera,
    /// With a reflection in its history: skips `no_reflection`.
    Reflected,
    /// For radiosity: skips `no_radiosity`.
    Radiosity,
    /// Towards a light: skips `no_shadow`.
    Shadow,
    /// A photon that no surface has reflected: skips `no_shadow` and `no_image`.
    Photon,
    /// A photon with a reflection in its history: skips `no_shadow` and `no_reflection`.
    ReflectedPhoton,
    /// `trace` and inside questions: skips nothing.
    Any,
}

impl RayClass {
    /// The bit that stands for it in sets of classes.
    pub(crate) const fn bit(self) -> u8 {
        match self {
            RayClass::Camera => 1,
            RayClass::Reflected => 2,
            RayClass::Radiosity => 4,
            RayClass::Shadow => 8,
            RayClass::Photon => 8 | 1,
            RayClass::ReflectedPhoton => 8 | 2,
            RayClass::Any => 0,
        }
    }
}

/// A texture at its place in the world.
#[derive(Clone, Debug)]
pub struct PlacedTexture {
    /// Shared by pointer: compile each once.
    pub texture: Arc<Texture>,
    /// `None` is the identity.
    pub texture_from_world: Option<Box<Affine>>,
}

/// What hangs on a leaf of the object tree, all inheritance done.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// `None` only where cutaway textures decide.
    pub texture: Option<TextureId>,
    /// Used where the surface is hit from inside.
    pub interior_texture: Option<TextureId>,
    /// Always there: an object without one has a private default.
    pub interior: InteriorId,
    /// Lit from behind as well.
    pub double_illuminate: bool,
    /// Textures are asked at (u, v, 0).
    pub uv_mapping: bool,
    /// The innermost light group around it.
    pub light_group: Option<LightGroupId>,
    /// Do lights outside the group shine on it?
    pub global_lights: bool,
    /// Photon switches.
    pub photons: PhotonFlags,
    /// `radiosity { importance }`
    pub radiosity_importance: Option<f32>,
    /// Index of the top-level object it belongs to.
    pub object: u32,
}

/// An interior with its identity.
#[derive(Clone, Debug)]
pub struct InteriorInfo {
    /// What it is.
    pub interior: Arc<Interior>,
    /// Where its media are; `None` is the identity.
    pub world_from_interior: Option<Box<Affine>>,
    /// `hollow`, by the rules of section 8 of the shapes spec.
    pub hollow: bool,
}

/// A light found in the tree.
#[derive(Clone, Debug)]
pub struct PlacedLight {
    /// Already moved to the world.
    pub light: Arc<Light>,
    /// `None`: shines on everything that takes global lights.
    pub group: Option<LightGroupId>,
}

/// The nearest hit: enough to make the [`Interaction`].
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Distance along the world ray.
    pub t: f64,
    /// Which leaf of the compiled tree.
    pub leaf: u32,
    /// Was the leaf turned inside out on the way down?
    pub inverted: bool,
    /// The shape's own words.
    pub local: crate::LocalHit,
}

impl Hit {
    /// Stands where there is none yet.
    pub const NONE: Hit = Hit {
        t: f64::INFINITY,
        leaf: u32::MAX,
        inverted: false,
        local: crate::LocalHit { t: f64::INFINITY, part: 0, u: 0.0, v: 0.0 },
    };
}

/// A texture and how much it counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Which.
    pub texture: TextureId,
    /// 1 unless several meet (blobs, meshes with three textures, cutaway).
    pub weight: f32,
}

/// The textures that count at a point.
#[derive(Clone, Debug)]
pub enum TextureUses {
    /// Nearly always.
    One(TextureUse),
    /// None or several.
    Other(SmallVec<[TextureUse; 2]>),
}

impl TextureUses {
    /// All of them.
    #[inline]
    pub fn as_slice(&self) -> &[TextureUse] {
        match self {
            TextureUses::One(only) => std::slice::from_ref(only),
            TextureUses::Other(uses) => uses,
        }
    }
}

/// Everything about the winner's surface.
#[derive(Clone, Debug)]
pub struct Interaction {
    /// The point in the world.
    pub p: Vec3,
    /// Raw unit normal, negated where the leaf is inverted; not turned towards the viewer.
    pub n: Vec3,
    /// Texture coordinates.
    pub uv: Vec2,
    /// Was the inner side hit (`n . d > 0`)?
    pub from_inside: bool,
    /// What hangs on it.
    pub material: MaterialId,
    /// The textures that count here, interior textures already chosen; empty shades black.
    pub textures: TextureUses,
}

/// Why a scene's objects cannot be made ready.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// A kind of shape that is still to be built.
    #[error("{0} is not supported yet")]
    Unsupported(&'static str),
}

/// A scene's objects, ready for rays from any thread.
pub struct Geometry {
    /// Materials by id.
    pub materials: Vec<Material>,
    /// Textures by id.
    pub textures: Vec<PlacedTexture>,
    /// Interiors by id.
    pub interiors: Vec<InteriorInfo>,
    /// Lights found in the tree, global ones and those of groups, in the order of the scene.
    pub lights: Vec<PlacedLight>,
    /// Are the texture coordinates of interactions worked out? They are zero otherwise.
    pub asks_uv: bool,
    pub(crate) tree: Tree,
    /// The outermost union.
    pub(crate) world: Group,
    /// What of it are planes.
    pub(crate) borders: Borders,
    /// Where all the rest is, if it has an end; found when it is first asked for.
    pub(crate) outlook: OnceLock<Option<Outlook>>,
    /// All of the world, if it is a few simple leaves: asked without their boxes.
    pub(crate) few: Vec<Member>,
    /// Top-level members that contain points outside their boxes, sorted, with these.
    overreaching: Vec<(u32, Aabb)>,
    bounds: Aabb,
    parts: Parts,
}

impl Geometry {
    /// Compiles a scene's objects.
    ///
    /// # Errors
    /// If the scene has a kind of shape that is not supported.
    pub fn build(scene: &Scene) -> Result<Geometry, BuildError> {
        flatten(&scene.objects, false).map(Geometry::new)
    }

    /// Compiles one object on its own: for `trace`, `inside`, the object pattern, `projected_through`. It keeps all
    /// its bounds.
    ///
    /// # Errors
    /// If the object has a kind of shape that is not supported.
    pub fn of_object(object: &Arc<Object>) -> Result<Geometry, BuildError> {
        flatten(std::slice::from_ref(object), true).map(Geometry::new)
    }

    fn new(flat: Flat) -> Self {
        let Flat { leaves, groups, world, borders, few, overreaching, bounds, materials, lights, parts } =
            flat;
        Geometry {
            materials: materials.materials,
            textures: materials.textures,
            interiors: materials.interiors,
            lights,
            asks_uv: true,
            tree: Tree { leaves, groups },
            world,
            outlook: OnceLock::new(),
            borders,
            few,
            overreaching,
            bounds,
            parts,
        }
    }

    /// The nearest hit with `t_min < t < t_max` (world distance; `ray.dir` is of unit length). Nothing nearer than
    /// [`MIN_HIT`] or farther than [`MAX_DISTANCE`] is ever hit.
    pub fn closest(&self, ray: &Ray, range: (f64, f64), class: RayClass) -> Option<Hit> {
        let mut hit = Hit::NONE;
        self.closest_into(ray, range, class, &mut hit).then_some(hit)
    }

    /// Puts the hit that [`Geometry::closest`] finds where it is wanted, and says whether there is one.
    pub fn closest_into(&self, ray: &Ray, range: (f64, f64), class: RayClass, best: &mut Hit) -> bool {
        let range = (range.0.max(MIN_HIT), range.1.min(MAX_DISTANCE));
        let found = self.borders.closest(ray, range, class.bit(), best);
        let range = (range.0, if found { best.t } else { range.1 });
        if !self.few.is_empty() {
            return found | self.closest_of_few(ray, range, class, best);
        }
        let (probe, scratch) = (Probe::new(ray), &mut Scratch::default());
        let (world, others) = (&self.world, &self.borders.others);
        found | self.tree.closest_of_all(world, others, &probe, range, class.bit(), scratch, &|_| false, best)
    }

    /// [`Geometry::closest_into`] in a world of a few leaves, but for its planes.
    fn closest_of_few(&self, ray: &Ray, range: (f64, f64), class: RayClass, best: &mut Hit) -> bool {
        let mut found = false;
        let others = &self.few[self.borders.len()..];
        for member in others.iter().filter(|member| member.skip & class.bit() == 0) {
            let Node::Leaf(leaf) = member.node.node() else { continue };
            let far = if found { best.t } else { range.1 };
            found |= self.tree.leaves.closest_apart(leaf, ray, (range.0, far), &|_| false, best);
        }
        found
    }

    /// The maximal gradients of isosurfaces that are too low for what rays have met so far, each with the steeper one
    /// that was found; in the order of the scene, copies once.
    pub fn steep_isosurfaces(&self) -> Vec<(f64, f64)> {
        let mut seen = Vec::new();
        let isosurfaces = self.tree.leaves.shapes.iter().filter_map(|shape| match shape {
            ShapeKind::Isosurface(iso) => iso.too_steep(),
            _ => None,
        });
        let first = |&(_, _, field): &(f64, f64, usize)| {
            !seen.contains(&field) && {
                seen.push(field);
                true
            }
        };
        isosurfaces.filter(first).map(|(set, found, _)| (set, found)).collect()
    }

    /// The material of a leaf.
    pub fn material_at(&self, leaf: u32) -> MaterialId {
        self.tree.leaves.leaves[leaf as usize].material
    }

    /// The material of a leaf whose textures are that material's alone; `None` where parts of the leaf have their own.
    #[inline]
    pub fn plain_material(&self, leaf: u32) -> Option<MaterialId> {
        let leaf = &self.tree.leaves.leaves[leaf as usize];
        (!leaf.has_parts).then_some(leaf.material)
    }

    /// Can a leaf stand in its own light nowhere on the side that light comes from?
    #[inline]
    pub fn is_convex(&self, leaf: u32) -> bool {
        self.tree.leaves.leaves[leaf as usize].convex
    }

    /// What is known about the surface at a hit.
    pub fn interaction(&self, ray: &Ray, hit: &Hit) -> Interaction {
        let leaves = &self.tree.leaves;
        let p = ray.at(hit.t);
        let n = leaves.normal(hit, p);
        let from_inside = n.dot(ray.dir) > 0.0;
        let texturing = Texturing { tree: &self.tree, materials: &self.materials, parts: &self.parts };
        Interaction {
            p,
            n,
            uv: if self.asks_uv { leaves.uv(hit, p) } else { Vec2::ZERO },
            from_inside,
            material: leaves.leaves[hit.leaf as usize].material,
            textures: texturing.at(hit, p, from_inside),
        }
    }

    /// Is the point inside any top-level object?
    pub fn inside(&self, p: Vec3) -> bool {
        match self.world.members[..] {
            [only] => self.tree.inside(only.node, p),
            _ => self.tree.group_inside(&self.world, p),
        }
    }

    /// The interiors of all objects that contain the point, in the order of the scene (the start of a ray's list).
    /// Outside the box of an object nothing counts, and its clips do not.
    pub fn interiors_at(&self, p: Vec3) -> SmallVec<[InteriorId; 8]> {
        let mut around: SmallVec<[u32; 8]> = SmallVec::new();
        self.world.deciders.any(p, |m, known| {
            if known.unwrap_or_else(|| self.tree.inside_unclipped(self.world.members[m as usize].node, p)) {
                around.push(m);
            }
            false
        });
        around.retain(|m| match self.overreaching.binary_search_by_key(m, |&(member, _)| member) {
            Ok(at) => self.overreaching[at].1.contains(p),
            Err(_) => true,
        });
        around.sort_unstable();
        let mut found = SmallVec::new();
        for m in around {
            self.interiors_of(self.world.members[m as usize].node, p, true, &mut found);
        }
        found
    }

    /// The interiors of all objects that contain the points of a box, if they are plainly the same for all.
    pub fn interiors_within(&self, b: &Aabb) -> Option<SmallVec<[InteriorId; 8]>> {
        match self.standing_in(&Shaft::of_box(b), RayClass::Any) {
            Standing::Listed(list) if list.is_empty() => Some(self.interiors_at(b.centre())),
            _ => None,
        }
    }

    /// The interiors of a node that contains the point: those of its leaves that contain it. What merely cuts has no
    /// say.
    fn interiors_of(&self, node: NodeRef, p: Vec3, outermost: bool, found: &mut SmallVec<[InteriorId; 8]>) {
        match node.node() {
            Node::Leaf(index) => {
                let leaf = &self.tree.leaves.leaves[index as usize];
                let interior = self.materials[leaf.material.0 as usize].interior;
                let counts = (outermost || !leaf.inverted) && self.tree.leaves.inside(index, p);
                if counts && !found.contains(&interior) {
                    found.push(interior);
                }
            }
            Node::Group(index) => {
                for member in &self.tree.groups[index as usize].members {
                    self.interiors_of(member.node, p, false, found);
                }
            }
        }
    }

    /// A box around everything bounded.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Media of an interior at their place: re-exported for shading's sake.
    pub fn media(&self, id: InteriorId) -> &[Placed<raggio_scene::Media>] {
        &self.interiors[id.0 as usize].interior.media
    }
}
