//! Photons: light that mirrors and lenses throw on surfaces, found by shooting from the lights (photon spec, section
//! 2; photon mapping is Jensen's, 1996).
//!
//! Rings of photons are shot by many threads, but each starts at a place of the random sequence that is known before,
//! so that the map is the same for any number of threads.
mod gather;
mod map;
mod search;
mod shoot;
mod travel;

use std::sync::Arc;

use raggio_geometry::{Hit, Material};
use raggio_image::Rgb;
use raggio_math::{Aabb, Affine, Ray, Vec3};
use raggio_scene::{self as scene, Object, ObjectKind, PhotonFlags, Scene};

pub use gather::State;
use map::PhotonMap;
pub use shoot::shoot;

/// What photons are shot at, and how.
pub struct Plan {
    settings: scene::Photons,
    targets: Vec<Target>,
}

/// An object that photons are shot at.
struct Target {
    flags: PhotonFlags,
    /// Box around it in the world.
    bounds: Aabb,
    /// Which top-level object it belongs to.
    object: u32,
}

/// The box of what has none: photons are aimed at it all the same, but so far apart that hardly any is.
const UNBOUNDED: Aabb = Aabb { min: Vec3::splat(-1e10), max: Vec3::splat(1e10) };

impl Plan {
    /// Looks for a scene's targets; `None` where there are none or photons are off.
    pub fn new(scene: &Scene) -> Option<Plan> {
        let settings = scene.settings.photons.as_ref().filter(|p| p.gather_max > 0)?;
        let mut targets = Vec::new();
        for (i, object) in scene.objects.iter().enumerate() {
            find_targets(object, &Affine::IDENTITY, i as u32, &mut targets);
        }
        (!targets.is_empty()).then(|| Plan { settings: settings.clone(), targets })
    }
}

/// A flagged object is a target as a whole; others may have targets among their parts.
fn find_targets(object: &Arc<Object>, world_from_parent: &Affine, top: u32, targets: &mut Vec<Target>) {
    if object.photons.target.is_some() {
        let mut placed = (**object).clone();
        placed.transform(world_from_parent);
        let bounds = raggio_geometry::extent(&placed).intersection(&UNBOUNDED);
        targets.push(Target { flags: object.photons, bounds, object: top });
        return;
    }
    let world_from_object = *world_from_parent * object.parent_from_object;
    let children = match &object.kind {
        ObjectKind::Csg { children, .. } => children,
        ObjectKind::LightGroup { children, global_lights: true } => children,
        _ => return,
    };
    children.iter().for_each(|child| find_targets(child, &world_from_object, top, targets));
}

impl Target {
    /// Is this surface part of the target?
    fn owns(&self, material: &Material, ray: &Ray, hit: &Hit) -> bool {
        material.object == self.object
            && material.photons.target.is_some()
            && self.bounds.grown(1e-3).contains(ray.at(hit.t))
    }
}

/// Is an effect switched on by one side and off by neither?
fn allowed(object: Option<bool>, light: Option<bool>) -> bool {
    (object == Some(true) && light != Some(false)) || (object != Some(false) && light == Some(true))
}

/// Does such an object stop ordinary light, because photons bring what it lets through?
pub fn replaces_light(object: &PhotonFlags, light: &PhotonFlags) -> bool {
    object.target.is_some() && allowed(object.refraction, light.refraction)
}

/// The photons of a scene.
#[derive(Default)]
pub struct Maps {
    /// On surfaces.
    surface: PhotonMap,
    /// In media.
    media: PhotonMap,
}

impl Maps {
    /// Is there nothing?
    pub fn is_empty(&self) -> bool {
        self.surface.is_empty() && self.media.is_empty()
    }
}

/// A photon that was stored.
#[derive(Clone, Copy, Debug)]
pub struct Photon {
    /// Where it landed.
    pub p: [f32; 3],
    /// Its power, as coarse as the original keeps it.
    pub power: Rgb,
    /// Where it came from.
    pub toward: Vec3,
}

#[cfg(test)]
mod tests;
