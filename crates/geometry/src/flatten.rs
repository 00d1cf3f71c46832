//! From the scene's tree of objects to leaves and groups, all inheritance done.
use std::sync::Arc;

use raggio_math::{Aabb, Affine};
use raggio_scene::{Csg, Interior, Light, Object, ObjectKind, PhotonFlags, Placed, Shape};
use rustc_hash::FxHashMap;

use crate::index::Index;
use crate::leaf::{Leaf, Leaves};
use crate::materials::Materials;
use crate::shape_pool::{PlacedShape, ShapePool};
use crate::texturing::{Cutaway, Parts};
use crate::tree::{Group, Member, NodeRef, Op};
use crate::{BuildError, InteriorId, LightGroupId, Material, MaterialId, PlacedLight, RayClass, TextureId};

/// Everything that walking the objects yields.
pub(crate) struct Flat {
    pub(crate) leaves: Leaves,
    pub(crate) groups: Vec<Group>,
    /// The outermost union.
    pub(crate) world: Group,
    pub(crate) bounds: Aabb,
    pub(crate) materials: Materials,
    pub(crate) lights: Vec<PlacedLight>,
    pub(crate) parts: Parts,
}

/// What an object inherits.
#[derive(Clone)]
struct Context {
    world_from_here: Affine,
    inverted: bool,
    texture: Option<TextureId>,
    interior_texture: Option<TextureId>,
    /// `None` only above the top-level objects.
    interior: Option<InteriorId>,
    uv_mapping: bool,
    hollow: bool,
    /// Rays that do not see it, as bits of [`RayClass`].
    skip: u8,
    double_illuminate: bool,
    light_group: Option<LightGroupId>,
    global_lights: bool,
    photons: PhotonFlags,
    radiosity_importance: Option<f32>,
    /// Number of the top-level object.
    object: u32,
    /// The group whose `cutaway_textures` decide where a leaf has no texture of its own.
    cutaway: Option<Cutaway>,
    /// Inside a clip or bound: only its form matters.
    form_only: bool,
}

/// A member with its boxes.
struct Built {
    member: Member,
    surface: Aabb,
    /// Outside this box nothing is inside it.
    inside: Aabb,
    /// Outside this box everything is inside it.
    outside: Aabb,
}

struct Walk {
    leaves: Leaves,
    groups: Vec<Group>,
    materials: Materials,
    lights: Vec<PlacedLight>,
    parts: Parts,
    pool: ShapePool,
    light_groups: u32,
    default_interior: Placed<Interior>,
    keep_all_bounds: bool,
}

/// Compiles top-level objects. With `keep_all_bounds` even bounds that the scene's objects lose are kept, as for
/// objects that the language asks about while it runs.
pub(crate) fn flatten(objects: &[Arc<Object>], keep_all_bounds: bool) -> Result<Flat, BuildError> {
    let mut walk = Walk {
        leaves: Leaves::default(),
        groups: Vec::new(),
        materials: Materials::default(),
        lights: Vec::new(),
        parts: FxHashMap::default(),
        pool: ShapePool::default(),
        light_groups: 0,
        default_interior: Placed::new(Arc::new(Interior::default())),
        keep_all_bounds,
    };
    let mut members = Vec::with_capacity(objects.len());
    for (index, object) in objects.iter().enumerate() {
        walk.object(object, &Context::top_level(index as u32), Op::Union, &mut members)?;
    }
    let bounds =
        members.iter().filter(|m| m.surface.is_finite()).fold(Aabb::EMPTY, |all, m| all.union(&m.surface));
    let world = group(Op::Union, &members, Vec::new(), Vec::new());
    let Walk { leaves, groups, materials, lights, parts, .. } = walk;
    Ok(Flat { leaves, groups, world, bounds, materials, lights, parts })
}

impl Context {
    fn top_level(object: u32) -> Self {
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
            global_lights: true,
            photons: PhotonFlags::default(),
            radiosity_importance: None,
            object,
            cutaway: None,
            form_only: false,
        }
    }

    /// For clips and bounds, whose coordinates are those around the object.
    fn form_only(&self) -> Self {
        Context { form_only: true, inverted: false, skip: 0, cutaway: None, ..self.clone() }
    }
}

/// Flags that are tested only on top-level objects and on children of unions that were opened into the world.
const OUTERMOST_ONLY: u8 = RayClass::Shadow.bit();

impl Walk {
    /// Compiles an object into members of the group around it, which combines by `around`. Groups that mean the same
    /// as their members in a row are opened; none is where `around` is a merge.
    fn object(
        &mut self,
        object: &Object,
        outer: &Context,
        around: Op,
        members: &mut Vec<Built>,
    ) -> Result<(), BuildError> {
        match &object.kind {
            ObjectKind::Shape(shape) => {
                let context = self.inherit(object, outer);
                let leaf = self.leaf(object, shape, &context)?;
                self.fence(object, outer, leaf, members)
            }
            ObjectKind::Light(light) => self.light(object, light, outer, around, members),
            ObjectKind::LightGroup { children, global_lights } => {
                let mut context = self.inherit(object, outer);
                context.light_group = Some(LightGroupId(self.light_groups));
                context.global_lights = *global_lights;
                self.light_groups += 1;
                self.combination(object, Csg::Union, children, &context, outer, around, members)
            }
            ObjectKind::Csg { op, children } => {
                let context = self.inherit(object, outer);
                self.combination(object, *op, children, &context, outer, around, members)
            }
        }
    }

    /// What the object's own parts inherit.
    fn inherit(&mut self, object: &Object, outer: &Context) -> Context {
        let mut c = outer.clone();
        c.world_from_here = outer.world_from_here * object.parent_from_object;
        c.inverted ^= object.inverse;
        if c.form_only {
            return c;
        }
        // Textures of an object with uv_mapping do not move with what is around it.
        let around = if object.uv_mapping { Affine::IDENTITY } else { outer.world_from_here };
        if let Some(texture) = &object.texture {
            c.texture = Some(self.materials.texture(&texture.item, &(around * texture.parent_from_item)));
            c.uv_mapping = false;
            c.cutaway = None;
        }
        if let Some(texture) = &object.interior_texture {
            c.interior_texture =
                Some(self.materials.texture(&texture.item, &(around * texture.parent_from_item)));
        }
        c.uv_mapping |= object.uv_mapping;
        // A top-level object without an interior has one of its own nevertheless, and its parts share it.
        if let Some(interior) = &object.interior {
            c.interior = Some(self.materials.interior(interior, &outer.world_from_here));
        } else if c.interior.is_none() {
            c.interior = Some(self.materials.interior(&self.default_interior.clone(), &Affine::IDENTITY));
        }
        c.hollow = object.hollow.unwrap_or(outer.hollow);
        c.skip |= skip_bits(object);
        c.double_illuminate |= object.double_illuminate;
        c.photons = inherit_photons(object.photons, outer.photons);
        c.radiosity_importance = object.radiosity_importance.or(outer.radiosity_importance);
        c
    }

    /// A shape becomes a leaf.
    fn leaf(&mut self, object: &Object, shape: &Arc<Shape>, c: &Context) -> Result<Built, BuildError> {
        let PlacedShape { prim, inverted, surface, inside, outside } =
            self.pool.place(&mut self.leaves, shape, &c.world_from_here, c.inverted)?;
        let index = self.leaves.leaves.len();
        let material = if c.form_only { MaterialId(u32::MAX) } else { self.material(c) };
        self.leaves.leaves.push(Leaf { prim, material, inverted });
        if !c.form_only {
            self.part_textures(object, shape, c, index as u32);
            if c.cutaway.is_some() {
                self.parts.entry(index as u32).or_default().cutaway = c.cutaway;
            }
        }
        Ok(Built { member: Member { node: NodeRef::leaf(index), skip: c.skip }, surface, inside, outside })
    }

    fn material(&mut self, c: &Context) -> MaterialId {
        let interior = c.interior.unwrap_or(InteriorId(0));
        // The member processed last decides for all that share the interior.
        self.materials.interiors[interior.0 as usize].hollow = c.hollow;
        self.materials.material(Material {
            texture: if c.cutaway.is_some() { None } else { c.texture },
            interior_texture: c.interior_texture,
            interior,
            double_illuminate: c.double_illuminate,
            uv_mapping: c.uv_mapping,
            light_group: c.light_group,
            global_lights: c.global_lights,
            photons: c.photons,
            radiosity_importance: c.radiosity_importance,
            object: c.object,
        })
    }

    /// Textures that a mesh's faces or a blob's components bring along.
    fn part_textures(&mut self, object: &Object, shape: &Shape, c: &Context, leaf: u32) {
        let place = if object.uv_mapping { Affine::IDENTITY } else { c.world_from_here };
        let textures: Vec<Option<TextureId>> = match shape {
            Shape::Mesh(mesh) => {
                mesh.textures.iter().map(|t| Some(self.materials.texture(t, &place))).collect()
            }
            Shape::Blob(blob) => {
                let mut own = |t: &Placed<_>| self.materials.texture(&t.item, &(place * t.parent_from_item));
                blob.components.iter().map(|part| part.texture.as_ref().map(&mut own)).collect()
            }
            _ => return,
        };
        if textures.iter().any(Option::is_some) {
            self.parts.entry(leaf).or_default().textures = textures;
        }
    }

    /// Several objects become one group, or more members of the group around them where that means the same.
    fn combination(
        &mut self,
        object: &Object,
        csg: Csg,
        children: &[Arc<Object>],
        context: &Context,
        outer: &Context,
        around: Op,
        members: &mut Vec<Built>,
    ) -> Result<(), BuildError> {
        let op = effective(csg, context.inverted);
        let cutaway = matches!(csg, Csg::CutawayIntersection | Csg::Difference { cutaway_textures: true });
        let fenced = !object.clips.is_empty() || self.keeps_bounds(object, outer);
        let opened = !fenced && !cutaway && around == op && op != Op::Merge;
        let mut inner = context.clone();
        let reserved = (!opened).then(|| self.reserve());
        if cutaway && !inner.form_only {
            let difference = matches!(csg, Csg::Difference { .. });
            inner.cutaway = reserved.map(|group| Cutaway { group, difference, otherwise: context.texture });
        }
        if !opened && op == Op::Union && all_shadowless(children) {
            inner.skip |= OUTERMOST_ONLY;
        }
        let skip = inner.skip;
        let mut own = Vec::new();
        let target = if opened { &mut *members } else { &mut own };
        for (i, child) in children.iter().enumerate() {
            inner.inverted = context.inverted != (i > 0 && matches!(csg, Csg::Difference { .. }));
            self.object(child, &inner, op, target)?;
        }
        let Some(reserved) = reserved else { return Ok(()) };
        own.iter_mut().for_each(|m| {
            m.member.skip &= if op == Op::Intersection { 0 } else { !OUTERMOST_ONLY };
        });
        let built = self.group(op, own, skip, reserved, object, outer)?;
        members.push(built);
        Ok(())
    }

    fn reserve(&mut self) -> u32 {
        self.groups.push(group(Op::Union, &[], Vec::new(), Vec::new()));
        self.groups.len() as u32 - 1
    }

    fn group(
        &mut self,
        op: Op,
        own: Vec<Built>,
        skip: u8,
        at: u32,
        object: &Object,
        outer: &Context,
    ) -> Result<Built, BuildError> {
        let (clips, clip_box) = self.fences(&object.clips, outer)?;
        let (bounds, bound_box) = match self.keeps_bounds(object, outer) {
            true => self.fences(&object.bounds, outer)?,
            false => (Vec::new(), Aabb::INFINITE),
        };
        let boxes = combined_boxes(op, &own);
        let mut surface = boxes.0.intersection(&clip_box);
        if !surface.is_finite() {
            // A bound that is too small still shows what lies outside it where a ray touches both; but for unbounded
            // things it is all there is.
            surface = surface.intersection(&bound_box);
        }
        self.groups[at as usize] = group(op, &own, clips, bounds);
        Ok(Built {
            member: Member { node: NodeRef::group(at as usize), skip },
            surface,
            inside: boxes.1.intersection(&clip_box),
            outside: if object.clips.is_empty() { boxes.2 } else { Aabb::INFINITE },
        })
    }

    /// Puts the clips and bounds around a single member.
    fn fence(
        &mut self,
        object: &Object,
        outer: &Context,
        built: Built,
        members: &mut Vec<Built>,
    ) -> Result<(), BuildError> {
        // Patches do not obey their own clips (shapes spec, section 1.4).
        let patch = matches!(&object.kind, ObjectKind::Shape(s) if matches!(**s, Shape::BicubicPatch { .. }));
        if (object.clips.is_empty() || patch) && !self.keeps_bounds(object, outer) {
            members.push(built);
            return Ok(());
        }
        let skip = built.member.skip;
        let at = self.reserve();
        let built = self.group(Op::Union, vec![built], skip, at, object, outer)?;
        members.push(built);
        Ok(())
    }

    /// Clips or bounds as nodes, and a box around what all of them hold.
    fn fences(
        &mut self,
        objects: &[Arc<Object>],
        outer: &Context,
    ) -> Result<(Vec<NodeRef>, Aabb), BuildError> {
        let context = outer.form_only();
        let (mut nodes, mut inside) = (Vec::new(), Aabb::INFINITE);
        for object in objects {
            // Under a merge nothing is opened, so each comes as one node.
            let mut built = Vec::new();
            self.object(object, &context, Op::Merge, &mut built)?;
            for b in built {
                inside = inside.intersection(&b.inside);
                nodes.push(b.member.node);
            }
        }
        Ok((nodes, inside))
    }

    /// Bounds that the language removes would cut nothing here: those of top-level objects that are neither
    /// combinations nor unbounded by nature (shapes spec, section 1.4).
    fn keeps_bounds(&self, object: &Object, outer: &Context) -> bool {
        let top_level = outer.interior.is_none() && !outer.form_only;
        let needed = match &object.kind {
            ObjectKind::Shape(shape) => matches!(**shape, Shape::Poly { .. } | Shape::Quadric(_)),
            _ => true,
        };
        !object.bounds.is_empty() && (needed || !top_level || self.keep_all_bounds)
    }

    /// A light is moved to the world; the object that shows it is an ordinary one.
    fn light(
        &mut self,
        object: &Object,
        light: &Light,
        outer: &Context,
        around: Op,
        members: &mut Vec<Built>,
    ) -> Result<(), BuildError> {
        let mut context = outer.clone();
        context.world_from_here = outer.world_from_here * object.parent_from_object;
        if !outer.form_only {
            let mut placed = Light { looks_like: None, ..light.clone() };
            placed.transform(&context.world_from_here);
            self.lights.push(PlacedLight { light: Arc::new(placed), group: outer.light_group });
        }
        match &light.looks_like {
            Some(shown) => {
                context.skip |= RayClass::Shadow.bit();
                self.object(shown, &context, around, members)
            }
            None => Ok(()),
        }
    }
}

/// What is left of an operation once inversion has gone down to the members.
fn effective(csg: Csg, inverted: bool) -> Op {
    match (csg, inverted) {
        (Csg::Union, false) => Op::Union,
        (Csg::Merge, false) => Op::Merge,
        (Csg::Union | Csg::Merge, true) => Op::Intersection,
        (_, false) => Op::Intersection,
        (_, true) => Op::Merge,
    }
}

/// Boxes of the surface, of the inside and of the outside of a group.
fn combined_boxes(op: Op, members: &[Built]) -> (Aabb, Aabb, Aabb) {
    let any = |pick: fn(&Built) -> Aabb| members.iter().fold(Aabb::EMPTY, |all, m| all.union(&pick(m)));
    let all = |pick: fn(&Built) -> Aabb| {
        members.iter().fold(Aabb::INFINITE, |common, m| common.intersection(&pick(m)))
    };
    let surface = any(|m| m.surface);
    match op {
        Op::Union | Op::Merge => (surface, any(|m| m.inside), all(|m| m.outside)),
        Op::Intersection => {
            let inside = all(|m| m.inside);
            (surface.intersection(&inside), inside, any(|m| m.outside))
        }
    }
}

fn group(op: Op, built: &[Built], clips: Vec<NodeRef>, bounds: Vec<NodeRef>) -> Group {
    let deciding: fn(&Built) -> Aabb = match op {
        Op::Union | Op::Merge => |b| b.inside,
        Op::Intersection => |b| b.outside,
    };
    // An intersection has no surface outside what its members hold, however far theirs reach.
    let limit = combined_boxes(op, built).0;
    let surfaces: Vec<Aabb> = built.iter().map(|b| b.surface.intersection(&limit)).collect();
    let decisions: Vec<Aabb> = built.iter().map(deciding).collect();
    Group {
        op,
        members: built.iter().map(|b| b.member).collect(),
        deciding: (surfaces != decisions).then(|| Index::new(&decisions)),
        surfaces: Index::new(&surfaces),
        clips,
        bounds,
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
fn all_shadowless(children: &[Arc<Object>]) -> bool {
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
