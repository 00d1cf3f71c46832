//! Lights: where they stand, which surfaces they shine on, how their light thins out and is shadowed.
mod area;
mod attenuation;
mod buffer;
mod shadow;

use raggio_geometry::{BuildError, Geometry, LightGroupId, Material};
use raggio_image::Rgb;
use raggio_math::{Ray, Vec3};
use raggio_scene as scene;

use buffer::LightBuffer;

pub use area::{AreaGrid, AreaScratch};
pub use attenuation::Cone;
pub use buffer::Before;
pub use shadow::Start;

/// So many lights of a scene have buffers.
const MOST_BUFFERS: usize = 64;

/// A light ready to shine.
pub struct LightSource {
    /// Its place among the world's lights.
    pub index: usize,
    /// Where it stands.
    pub position: Vec3,
    /// Where it points.
    pub point_at: Vec3,
    /// Unit vector from the light towards `point_at`.
    pub axis: Vec3,
    /// Its colour.
    pub color: Rgb,
    /// How it narrows.
    pub cone: Cone,
    /// Are its rays parallel to the axis?
    pub parallel: bool,
    /// Without shadows and highlights.
    pub shadowless: bool,
    /// `fade_distance` and `fade_power`.
    pub fade: Option<(f64, f64)>,
    /// Soft shadows.
    pub area: Option<AreaGrid>,
    /// The object that light must pass.
    pub projected_through: Option<Box<Geometry>>,
    /// Does scattering media see it?
    pub media_interaction: bool,
    /// Do fog and atmospheric media dim it?
    pub media_attenuation: bool,
    /// Photon switches.
    pub photons: scene::PhotonFlags,
    /// What stands in its way, for lights whose rays all come from one point.
    buffer: Option<LightBuffer>,
}

/// The way from a point to a light.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// From the point towards the light; put together once, shadow rays go along it.
    pub ray: Ray,
    /// Distance along it; negative behind the plane of a parallel light.
    pub distance: f64,
}

impl LightSource {
    /// Makes a light ready.
    ///
    /// # Errors
    /// If the object that it shines through cannot be built.
    pub fn build(index: usize, light: &scene::Light, geometry: &Geometry) -> Result<LightSource, BuildError> {
        let kind = &light.kind;
        let parallel = light.parallel || matches!(kind, scene::LightKind::Cylinder { .. });
        let from_one_point = !parallel && light.area.is_none();
        // Where all objects are tested at once, only what is plainly clear saves anything.
        let pays = !geometry.is_small() || geometry.is_all_convex();
        let buffered = index < MOST_BUFFERS && from_one_point && pays;
        let through = light.projected_through.as_ref().map(Geometry::of_object).transpose()?;
        Ok(LightSource {
            index,
            position: light.location,
            point_at: light.point_at,
            axis: (light.point_at - light.location).try_normalize().unwrap_or(Vec3::Z),
            color: light.color,
            cone: Cone::new(&light.kind),
            parallel,
            buffer: buffered.then(|| LightBuffer::new(light.location, geometry)),
            shadowless: matches!(light.kind, scene::LightKind::Shadowless),
            fade: attenuation::fade(light),
            area: light.area.as_ref().map(AreaGrid::new),
            projected_through: through.map(Box::new),
            media_interaction: light.media_interaction,
            media_attenuation: light.media_attenuation,
            photons: light.photons,
        })
    }

    /// What may stand in the way of light that goes on a path to a surface, which is perhaps that of a leaf that does not
    /// stand in its `own` light. Small worlds are asked only where that may leave nothing to ask.
    #[inline]
    pub fn before(&self, path: &Path, own: Option<u32>, geometry: &Geometry) -> Before<'_> {
        match &self.buffer {
            _ if own.is_none() && geometry.is_small() => Before::UNKNOWN,
            Some(buffer) => buffer.towards(-path.ray.dir, path.distance, geometry),
            None => Before::UNKNOWN,
        }
    }

    /// The way from `p` to the light's centre (light spec, section 5.1).
    #[inline]
    pub fn path(&self, p: Vec3) -> Path {
        self.path_to(p, self.position)
    }

    /// The way from `p` to a point of an area light.
    #[inline]
    pub fn path_to(&self, p: Vec3, point: Vec3) -> Path {
        let offset = point - p;
        if self.parallel {
            let dir = (point - self.point_at).try_normalize().unwrap_or(-self.axis);
            return Path { ray: Ray::new(p, dir), distance: offset.dot(dir) };
        }
        let distance = offset.length();
        let dir = if distance > 0.0 { offset / distance } else { -self.axis };
        Path { ray: Ray::new(p, dir), distance }
    }
}

/// Which lights shine on what: the scene's own first, then those of the object's light group.
pub struct LightSets {
    /// Lights without a group.
    global: Vec<u32>,
    /// By group: its own lights, and the same after the global ones.
    groups: Vec<(Vec<u32>, Vec<u32>)>,
}

impl LightSets {
    /// Sorts the lights of a scene.
    pub fn new(geometry: &Geometry) -> LightSets {
        let count = 1 + geometry
            .lights
            .iter()
            .map(|l| l.group)
            .chain(geometry.materials.iter().map(|m| m.light_group))
            .flatten()
            .map(|g| g.0 as usize)
            .max()
            .map_or(0, |m| m + 1);
        let of = |group: Option<LightGroupId>| -> Vec<u32> {
            let members = geometry.lights.iter().enumerate().filter(|(_, l)| l.group == group);
            members.map(|(i, _)| i as u32).collect()
        };
        let global = of(None);
        let groups = (0..count as u32)
            .map(|g| {
                let own = of(Some(LightGroupId(g)));
                let both = global.iter().chain(&own).copied().collect();
                (own, both)
            })
            .collect();
        LightSets { global, groups }
    }

    /// The lights that shine on a material.
    pub fn of(&self, material: &Material) -> &[u32] {
        match material.light_group {
            None => &self.global,
            Some(group) if material.global_lights => &self.groups[group.0 as usize].1,
            Some(group) => &self.groups[group.0 as usize].0,
        }
    }

    /// The scene's own lights.
    pub fn global(&self) -> &[u32] {
        &self.global
    }
}
