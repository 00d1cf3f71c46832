//! Objects: shapes and their combinations, with everything that is attached to them.
use std::sync::Arc;

use raggio_math::Affine;

use crate::{Interior, Light, Shape, Texture};

/// Something with a place of its own: `item`'s coordinates mapped into the surrounding ones.
#[derive(Debug)]
pub struct Placed<T> {
    /// What is placed.
    pub item: Arc<T>,
    /// Where. Most things were never moved; scenes of a million objects hold millions of these.
    parent_from_item: Option<Box<Affine>>,
}

impl<T> Placed<T> {
    /// At the origin, unturned.
    pub fn new(item: Arc<T>) -> Self {
        Placed { item, parent_from_item: None }
    }

    /// At a place.
    pub fn at(item: Arc<T>, parent_from_item: &Affine) -> Self {
        let mut placed = Placed::new(item);
        placed.set(*parent_from_item);
        placed
    }

    /// Where it is.
    pub fn parent_from_item(&self) -> Affine {
        self.parent_from_item.as_deref().copied().unwrap_or(Affine::IDENTITY)
    }

    /// Applies a transform after those already applied.
    pub fn transform(&mut self, t: &Affine) {
        self.set(*t * self.parent_from_item());
    }

    fn set(&mut self, place: Affine) {
        self.parent_from_item = (place != Affine::IDENTITY).then(|| Box::new(place));
    }
}

impl<T> Clone for Placed<T> {
    fn clone(&self) -> Self {
        Placed { item: self.item.clone(), parent_from_item: self.parent_from_item.clone() }
    }
}

/// A node of the scene's tree.
#[derive(Clone, Debug)]
pub struct Object {
    /// What it is.
    pub kind: ObjectKind,
    /// From the coordinates of `kind` to the parent's.
    pub parent_from_object: Affine,
    /// Texture in the parent's coordinates; `None` takes the nearest ancestor's (the front end gives every finished
    /// top-level object the default texture where nothing else applies).
    pub texture: Option<Placed<Texture>>,
    /// Texture of surfaces seen from inside.
    pub interior_texture: Option<Placed<Texture>>,
    /// Its inside; `None` shares the nearest ancestor's.
    pub interior: Option<Placed<Interior>>,
    /// `clipped_by`: points outside any of them do not exist. In the parent's coordinates.
    pub clips: Vec<Arc<Object>>,
    /// `bounded_by`, in the parent's coordinates.
    pub bounds: Vec<Arc<Object>>,
    /// `inverse`: inside and outside change places.
    pub inverse: bool,
    /// `hollow`; `None` where not stated, so that a parent's word counts.
    pub hollow: Option<bool>,
    /// Casts no shadow.
    pub no_shadow: bool,
    /// Not seen by camera rays.
    pub no_image: bool,
    /// Not seen by reflected rays.
    pub no_reflection: bool,
    /// Not seen by radiosity rays.
    pub no_radiosity: bool,
    /// Lit from behind as well.
    pub double_illuminate: bool,
    /// `uv_mapping`: textures live in (u, v, 0) and do not move with the object.
    pub uv_mapping: bool,
    /// `sturm`
    pub sturm: bool,
    /// `hierarchy off` on a shape that has an inner search structure. Combinations then see all of a mesh without an
    /// inside, not only what a ray meets first.
    pub hierarchy: bool,
    /// `split_union off` keeps a union of the top level together, which shows where its surfaces coincide.
    pub split_union: bool,
    /// `radiosity { importance }`
    pub radiosity_importance: Option<f32>,
    /// Photon switches.
    pub photons: PhotonFlags,
}

/// `photons { ... }` of an object or light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct PhotonFlags {
    /// Density factor; `None` is no target.
    pub target: Option<f32>,
    pub reflection: Option<bool>,
    pub refraction: Option<bool>,
    pub pass_through: bool,
    /// `collect`; `None` means yes.
    pub collect: Option<bool>,
}

/// What an object is.
#[derive(Clone, Debug)]
pub enum ObjectKind {
    /// One shape.
    Shape(Arc<Shape>),
    /// Several objects combined.
    Csg {
        /// How.
        op: Csg,
        /// What; for a difference the first is what the others cut.
        children: Arc<Vec<Arc<Object>>>,
    },
    /// A light source, at top level or inside a union.
    Light(Arc<Light>),
    /// `light_group { ... }`: its lights shine only on its objects. Otherwise a union.
    LightGroup {
        /// Objects and lights.
        children: Arc<Vec<Arc<Object>>>,
        /// Do the scene's other lights shine on its objects too?
        global_lights: bool,
    },
}

/// How objects are combined (shapes spec, section 8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Csg {
    /// Every surface of every child.
    Union,
    /// Surfaces not inside another child.
    Merge,
    /// Surfaces inside all other children.
    Intersection,
    /// The first child without the others.
    Difference {
        /// `cutaway_textures`
        cutaway_textures: bool,
    },
    /// An intersection with `cutaway_textures`.
    CutawayIntersection,
}

impl Object {
    /// A bare object.
    pub fn new(kind: ObjectKind) -> Self {
        Object {
            kind,
            parent_from_object: Affine::IDENTITY,
            texture: None,
            interior_texture: None,
            interior: None,
            clips: Vec::new(),
            bounds: Vec::new(),
            inverse: false,
            hollow: None,
            no_shadow: false,
            no_image: false,
            no_reflection: false,
            no_radiosity: false,
            double_illuminate: false,
            uv_mapping: false,
            sturm: false,
            hierarchy: true,
            split_union: true,
            radiosity_importance: None,
            photons: PhotonFlags::default(),
        }
    }

    /// Applies a transform after those already applied, to the object and all that is attached to it. A texture of an
    /// object with `uv_mapping` stays.
    pub fn transform(&mut self, t: &Affine) {
        self.parent_from_object = *t * self.parent_from_object;
        if !self.uv_mapping {
            for texture in [&mut self.texture, &mut self.interior_texture].into_iter().flatten() {
                texture.transform(t);
            }
        }
        if let Some(interior) = &mut self.interior {
            interior.transform(t);
        }
        for other in self.clips.iter_mut().chain(&mut self.bounds) {
            Arc::make_mut(other).transform(t);
        }
    }
}
