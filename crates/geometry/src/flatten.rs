//! From the scene's tree of objects to leaves and groups, all inheritance done.
use std::sync::Arc;

use raggio_math::{Aabb, Affine};
use raggio_scene::{Csg, Light, Object, ObjectKind, Placed, Shape};
use rustc_hash::FxHashMap;

use crate::borders::Borders;
use crate::convex::Convex;
use crate::index::{Decider, indices, padded};
use crate::inherit::{Context, OUTERMOST_ONLY, all_shadowless, effective};
use crate::leaf::{Leaf, Leaves};
use crate::materials::Materials;
use crate::shape_pool::{PlacedShape, ShapePool};
use crate::solid::Solid;
use crate::texturing::{Cutaway, LeafParts, Parts};
use crate::tree::{Group, Member, Node, NodeRef, Op};
use crate::{BuildError, LightGroupId, MaterialId, PlacedLight, RayClass, TextureId};

/// Everything that walking the objects yields.
pub(crate) struct Flat {
    pub(crate) leaves: Leaves,
    pub(crate) groups: Vec<Group>,
    /// The outermost union.
    pub(crate) world: Group,
    /// What of it are planes.
    pub(crate) borders: Borders,
    /// All of it, if it is a few simple leaves.
    pub(crate) few: Vec<Member>,
    /// Members of it whose inside reaches beyond their boxes, and these.
    pub(crate) overreaching: Vec<(u32, Aabb)>,
    pub(crate) bounds: Aabb,
    pub(crate) materials: Materials,
    pub(crate) lights: Vec<PlacedLight>,
    pub(crate) parts: Parts,
}

/// A member with its boxes. Scenes of millions of objects have as many of these at once.
struct Built {
    member: Member,
    surface: Aabb,
    volume: Volume,
}

/// Which space a member fills, as far as boxes tell.
enum Volume {
    /// What the box of its surface holds.
    Solid,
    /// None: it is but a surface.
    Patch,
    /// Any other.
    Other(Box<Boxes>),
}

struct Walk {
    leaves: Leaves,
    groups: Vec<Group>,
    materials: Materials,
    lights: Vec<PlacedLight>,
    parts: Parts,
    pool: ShapePool,
    light_groups: u32,
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
        keep_all_bounds,
    };
    let mut members = Vec::with_capacity(objects.len());
    for (index, object) in objects.iter().enumerate() {
        walk.object(object, &Context::top_level(index as u32), Op::Union, &mut members)?;
    }
    let bounds =
        members.iter().filter(|m| m.surface.is_finite()).fold(Aabb::EMPTY, |all, m| all.union(&m.surface));
    let overreaching = members.iter().enumerate().filter(|(_, m)| overreaches(m));
    let overreaching = overreaching.map(|(i, m)| (i as u32, padded(&m.surface))).collect();
    let mut world = group(Op::Union, &members, &walk.leaves, Vec::new(), Vec::new());
    // Among top-level objects, what POV-Ray shows depends on how its tree of boxes came out.
    world.ranked = false;
    let borders = Borders::of(&world, &walk.leaves);
    let few = few(&members, &walk.leaves);
    let Walk { leaves, groups, materials, lights, parts, .. } = walk;
    Ok(Flat { leaves, groups, world, borders, few, overreaching, bounds, materials, lights, parts })
}

/// The members of a world of so few and so simple leaves that boxes are not worth asking, planes first, then others
/// without bounds; nothing for other worlds.
fn few(members: &[Built], leaves: &Leaves) -> Vec<Member> {
    const MOST: usize = 3;
    const MOST_COST: u32 = 2;
    let simple = |m: &Built| m.member.node.is_leaf() && leaves.cost(m.member.node) <= MOST_COST;
    if members.len() > MOST || !members.iter().all(simple) {
        return Vec::new();
    }
    let mut order: Vec<&Built> = members.iter().collect();
    order.sort_by_key(|m| (!leaves.is_plane(m.member.node), m.surface.is_finite()));
    order.into_iter().map(|m| m.member).collect()
}

/// Does its inside reach beyond its box, as that of a height field, of a disc, or of what is turned inside out?
fn overreaches(built: &Built) -> bool {
    built.surface.is_finite() && built.surface.union(&built.boxes().inside) != built.surface
}

impl Walk {
    /// Where sweeps tell all but what rounding hides, other short ways need no room.
    fn drop_what_sweeps_spare(&mut self, group: &mut Group) {
        group.convex = None;
        for member in &group.members {
            if let Node::Group(inner) = member.node.node() {
                self.groups[inner as usize].solid = None;
            }
        }
    }

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
                let context = outer.inherited(object, &mut self.materials);
                let leaf = self.leaf(object, shape, &context)?;
                self.fence(object, outer, leaf, members)
            }
            ObjectKind::Light(light) => self.light(object, light, outer, around, members),
            ObjectKind::LightGroup { children, global_lights } => {
                let mut context = outer.inherited(object, &mut self.materials);
                // Whether the scene's lights shine within is said by the outermost group.
                context.global_lights =
                    if outer.light_group.is_some() { outer.global_lights } else { *global_lights };
                context.light_group = Some(LightGroupId(self.light_groups));
                context.member_of = context.light_group;
                self.light_groups += 1;
                self.combination(object, Csg::Union, children, &context, outer, around, members)
            }
            ObjectKind::Csg { op, children } => {
                let mut context = outer.inherited(object, &mut self.materials);
                context.member_of = None;
                self.combination(object, *op, children, &context, outer, around, members)
            }
        }
    }

    /// A shape becomes a leaf.
    fn leaf(&mut self, object: &Object, shape: &Arc<Shape>, c: &Context) -> Result<Built, BuildError> {
        let PlacedShape { prim, inverted, surface, inside, outside } =
            self.pool.place(&mut self.leaves, shape, &c.world_from_here, c.inverted)?;
        let index = self.leaves.leaves.len();
        let material = if c.form_only { MaterialId(u32::MAX) } else { c.material(&mut self.materials) };
        let convex = !inverted && self.leaves.is_convex(&prim);
        let rank = index as u32;
        let first_only =
            matches!(&**shape, Shape::Mesh(mesh) if object.hierarchy && mesh.inside_vector.is_none());
        let leaf = Leaf { prim, material, inverted, has_parts: false, convex, first_only, rank };
        self.leaves.leaves.push(leaf);
        if !c.form_only {
            self.part_textures(object, shape, c, index as u32);
            if c.cutaway.is_some() {
                self.parts_of(index as u32).cutaway = c.cutaway;
            }
        }
        let reach = if inside.is_empty() { surface } else { inside };
        Ok(Built::new(
            Member { node: NodeRef::leaf(index), skip: c.skip },
            Boxes { surface, inside, outside, reach },
        ))
    }

    /// Textures that a mesh's faces or a blob's components bring along.
    fn part_textures(&mut self, object: &Object, shape: &Shape, c: &Context, leaf: u32) {
        let place = if object.uv_mapping { Affine::IDENTITY } else { c.world_from_here };
        let textures: Vec<Option<TextureId>> = match shape {
            Shape::Mesh(mesh) => {
                mesh.textures.iter().map(|t| Some(self.materials.texture(t, &place))).collect()
            }
            Shape::Blob(blob) => {
                let mut own =
                    |t: &Placed<_>| self.materials.texture(&t.item, &(place * t.parent_from_item()));
                blob.components.iter().map(|part| part.texture.as_ref().map(&mut own)).collect()
            }
            _ => return,
        };
        if textures.iter().any(Option::is_some) {
            self.parts_of(leaf).textures = textures;
        }
    }

    fn parts_of(&mut self, leaf: u32) -> &mut LeafParts {
        self.leaves.leaves[leaf as usize].has_parts = true;
        self.parts.entry(leaf).or_default()
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
        // Whether a union of the top level stays together is seen where its surfaces coincide.
        let kept = !object.split_union && outer.interior.is_none();
        let opened = !fenced && !cutaway && !kept && around == op && op != Op::Merge;
        let mut inner = context.clone();
        let reserved = cutaway.then(|| self.reserve());
        // A texture on the group itself, or around it, is inherited as ever.
        if cutaway && !inner.form_only && inner.texture.is_none() {
            let difference = matches!(csg, Csg::Difference { .. });
            inner.cutaway = reserved.map(|group| Cutaway { group, difference });
        }
        if !opened && op == Op::Union && all_shadowless(children) {
            inner.skip |= OUTERMOST_ONLY;
        }
        let skip = inner.skip;
        let mut own = Vec::new();
        let target = if opened { &mut *members } else { &mut own };
        for (i, child) in children.iter().enumerate() {
            inner.inverted = context.inverted != (i > 0 && matches!(csg, Csg::Difference { .. }));
            let first = self.leaves.leaves.len();
            self.object(child, &inner, op, target)?;
            if op != Op::Union {
                self.turn_ranks(first);
            }
        }
        if opened {
            return Ok(());
        }
        own.iter_mut().for_each(|m| {
            m.member.skip &= if op == Op::Intersection { 0 } else { !OUTERMOST_ONLY };
        });
        if let ([only], false) = (&mut own[..], fenced || cutaway) {
            // Combined with nothing it is what it is alone.
            only.member.skip |= skip;
            members.append(&mut own);
            return Ok(());
        }
        let at = reserved.unwrap_or_else(|| self.reserve());
        let built = self.group(op, own, skip, at, object, outer)?;
        members.push(built);
        Ok(())
    }

    /// Turns the order of ranks of all leaves from this one on. A hit of a union goes on a pile, of which the topmost
    /// of equals is taken; all other combinations turn each member's pile over while they look through it.
    fn turn_ranks(&mut self, first: usize) {
        let leaves = &mut self.leaves.leaves;
        let sum = (first + leaves.len() - 1) as u32;
        leaves[first..].iter_mut().for_each(|leaf| leaf.rank = sum - leaf.rank);
    }

    fn reserve(&mut self) -> u32 {
        self.groups.push(group(Op::Union, &[], &self.leaves, Vec::new(), Vec::new()));
        self.groups.len() as u32 - 1
    }

    fn group(
        &mut self,
        op: Op,
        mut own: Vec<Built>,
        skip: u8,
        at: u32,
        object: &Object,
        outer: &Context,
    ) -> Result<Built, BuildError> {
        let own_clips: &[Arc<Object>] = if is_patch(object) { &[] } else { &object.clips };
        let (clips, clip_box) = self.fences(own_clips, outer)?;
        let clip_box = self.held_by(&clips, clip_box);
        let (bounds, bound_box) = match self.keeps_bounds(object, outer) {
            true => self.fences(&object.bounds, outer)?,
            false => (Vec::new(), Aabb::INFINITE),
        };
        self.tighten(op, &mut own, &clips, &clip_box);
        let boxes = combined_boxes(op, &own);
        let mut surface = boxes.surface.intersection(&clip_box);
        if !surface.is_finite() {
            // A bound that is too small still shows what lies outside it where a ray touches both; but for unbounded
            // things it is all there is.
            surface = surface.intersection(&bound_box);
        }
        let mut made = group(op, &own, &self.leaves, clips, bounds);
        made.solid = Solid::new(&made, &self.leaves, &self.groups).map(Box::new);
        if made.solid.is_some() {
            self.drop_what_sweeps_spare(&mut made);
        }
        self.groups[at as usize] = made;
        Ok(Built::new(
            Member { node: NodeRef::group(at as usize), skip },
            Boxes {
                surface,
                inside: boxes.inside.intersection(&clip_box),
                outside: if object.clips.is_empty() { boxes.outside } else { Aabb::INFINITE },
                reach: boxes.reach.intersection(&clip_box),
            },
        ))
    }

    /// The part of a box that clips let count, where those without bounds of their own bound each other.
    fn held_by(&self, clips: &[NodeRef], within: Aabb) -> Aabb {
        let convex = Convex::of(clips.iter().copied(), &self.leaves);
        let behind_planes = convex.as_ref().map_or(within, |convex| convex.bounds_within(&within));
        clips.iter().filter(|_| !within.is_finite()).fold(behind_planes, |held, &clip| {
            match self.leaves.bounds_within(clip, &held, convex.as_ref()) {
                Some((part, turned)) if !turned => held.intersection(&part),
                _ => held,
            }
        })
    }

    /// Cuts the boxes of unbounded members to what the group lets count of them.
    fn tighten(&self, op: Op, own: &mut [Built], clips: &[NodeRef], clip_box: &Aabb) {
        let limit = match op {
            Op::Intersection => own.iter().fold(*clip_box, |limit, m| limit.intersection(&m.boxes().reach)),
            Op::Union | Op::Merge => *clip_box,
        };
        let limiting = if op == Op::Intersection { &*own } else { &[] };
        let nodes = limiting.iter().map(|m| m.member.node).chain(clips.iter().copied());
        let convex = Convex::of(nodes, &self.leaves);
        if op == Op::Intersection {
            // What the language is told of objects follows from simpler rules.
            let held =
                convex.as_ref().map_or(limit, |convex| match limit.is_finite() && !self.keep_all_bounds {
                    true => convex.slanted_bounds_within(&limit),
                    false => convex.bounds_within(&limit),
                });
            for m in own.iter_mut().filter(|m| self.leaves.is_plane(m.member.node)) {
                m.change(|boxes| boxes.hold(&held));
            }
        }
        for m in own.iter_mut().filter(|m| !m.surface.is_finite()) {
            if let Some((part, turned)) = self.leaves.bounds_within(m.member.node, &limit, convex.as_ref()) {
                m.change(|boxes| {
                    boxes.surface = boxes.surface.intersection(&part);
                    // What is turned inside out reaches on beyond its surface.
                    if !turned {
                        boxes.hold(&part);
                    }
                });
            }
        }
    }

    /// Puts the clips and bounds around a single member.
    fn fence(
        &mut self,
        object: &Object,
        outer: &Context,
        built: Built,
        members: &mut Vec<Built>,
    ) -> Result<(), BuildError> {
        let clipped = !object.clips.is_empty() && !is_patch(object);
        if !clipped && !self.keeps_bounds(object, outer) {
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
                inside = inside.intersection(&b.boxes().inside);
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
            self.lights.push(PlacedLight { light: Arc::new(placed), group: outer.member_of });
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

/// The boxes of a shape or group.
#[derive(Clone, Copy, PartialEq)]
struct Boxes {
    surface: Aabb,
    /// Outside this box nothing is inside it.
    inside: Aabb,
    /// Outside this box everything is inside it.
    outside: Aabb,
    /// What it leaves of others in an intersection lies in this box: its inside, and the surface of patches in it, which
    /// have no inside.
    reach: Aabb,
}

impl Boxes {
    fn solid(surface: Aabb) -> Self {
        Boxes { surface, inside: surface, outside: Aabb::INFINITE, reach: surface }
    }

    fn patch(surface: Aabb) -> Self {
        Boxes { inside: Aabb::EMPTY, ..Boxes::solid(surface) }
    }

    /// Nothing is inside beyond a box.
    fn hold(&mut self, within: &Aabb) {
        self.inside = self.inside.intersection(within);
        self.reach = self.reach.intersection(within);
    }
}

impl Built {
    fn new(member: Member, boxes: Boxes) -> Self {
        let volume = match boxes {
            _ if boxes == Boxes::solid(boxes.surface) => Volume::Solid,
            _ if boxes == Boxes::patch(boxes.surface) => Volume::Patch,
            _ => Volume::Other(Box::new(boxes)),
        };
        Built { member, surface: boxes.surface, volume }
    }

    fn boxes(&self) -> Boxes {
        match &self.volume {
            Volume::Solid => Boxes::solid(self.surface),
            Volume::Patch => Boxes::patch(self.surface),
            Volume::Other(boxes) => **boxes,
        }
    }

    fn change(&mut self, change: impl FnOnce(&mut Boxes)) {
        let mut boxes = self.boxes();
        change(&mut boxes);
        *self = Built::new(self.member, boxes);
    }
}

fn combined_boxes(op: Op, members: &[Built]) -> Boxes {
    let any =
        |pick: fn(&Boxes) -> Aabb| members.iter().fold(Aabb::EMPTY, |all, m| all.union(&pick(&m.boxes())));
    let all = |pick: fn(&Boxes) -> Aabb| {
        members.iter().fold(Aabb::INFINITE, |common, m| common.intersection(&pick(&m.boxes())))
    };
    let surface = any(|m| m.surface);
    match op {
        Op::Union | Op::Merge => {
            Boxes { surface, inside: any(|m| m.inside), outside: all(|m| m.outside), reach: any(|m| m.reach) }
        }
        Op::Intersection => {
            let reach = all(|m| m.reach);
            Boxes {
                surface: surface.intersection(&reach),
                inside: all(|m| m.inside),
                outside: any(|m| m.outside),
                reach,
            }
        }
    }
}

fn group(op: Op, built: &[Built], leaves: &Leaves, clips: Vec<NodeRef>, bounds: Vec<NodeRef>) -> Group {
    let deciding: fn(&Boxes) -> Aabb = match op {
        Op::Union | Op::Merge => |b| b.inside,
        Op::Intersection => |b| b.outside,
    };
    // An intersection has no surface outside what its members hold, however far theirs reach.
    let limit = combined_boxes(op, built).surface;
    let surface = |i: usize| built[i].surface.intersection(&limit);
    let decision = |i: usize| deciding(&built[i].boxes());
    let cost = |m: &Built| leaves.cost(m.member.node);
    // Costly members have a box of their own even where there are a great many.
    let cheap = built.len() > 1024 && built.iter().all(|m| cost(m) == 0);
    let (surfaces, deciders) =
        indices(built.len(), surface, decision, |all| deciders(built, leaves, all), 1 + usize::from(cheap));
    let members: Vec<_> = built.iter().map(|b| b.member).collect();
    let limiting = if op == Op::Intersection { &members[..] } else { &[] };
    let convex = Convex::of(limiting.iter().map(|m| m.node).chain(clips.iter().copied()), leaves);
    Group { op, members, surfaces, deciders, clips, bounds, convex, solid: None, ranked: true }
}

/// What boxes tell about some members; those that are cheap to ask first.
fn deciders(built: &[Built], leaves: &Leaves, mut order: Vec<u32>) -> Vec<Decider> {
    order.sort_by_key(|&i| leaves.cost(built[i as usize].member.node));
    let known = |index: u32| {
        let (Boxes { inside, outside, .. }, node) =
            (built[index as usize].boxes(), built[index as usize].member.node);
        Decider { member: index, quick: leaves.is_quick(node), inside, outside }
    };
    order.into_iter().map(known).collect()
}

/// Bicubic patches do not obey their own clips (shapes spec, section 1.4).
fn is_patch(object: &Object) -> bool {
    matches!(&object.kind, ObjectKind::Shape(s) if matches!(**s, Shape::BicubicPatch { .. }))
}
