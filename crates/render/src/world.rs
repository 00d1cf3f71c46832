//! The frozen world: a scene compiled for rays, shared by all threads.
use std::sync::Arc;

use raggio_geometry::{BuildError, Geometry, Interaction, InteriorId, Material, TextureId};
use raggio_image::Rgb;
use raggio_math::{Affine, Vec3};
use raggio_scene::{GammaMode, Interior, PhotonFlags, Scene};
use raggio_shading::{Noise, Texture};
use rustc_hash::FxHashMap;

use crate::atmosphere::Sky;
use crate::camera::Camera;
use crate::lights::{LightSets, LightSource};
use crate::media::MediaList;
use crate::{photons, radiosity, subsurface};

/// A scene made ready for rays.
pub struct World {
    pub(crate) geometry: Geometry,
    /// By `TextureId`.
    textures: Vec<WorldTexture>,
    /// By `InteriorId`.
    interiors: Vec<WorldInterior>,
    /// By `MaterialId`: what surfaces let through.
    passing: Vec<Passing>,
    pub(crate) lights: Vec<LightSource>,
    pub(crate) light_sets: LightSets,
    pub(crate) camera: Camera,
    pub(crate) sky: Sky,
    /// Media of empty space.
    pub(crate) air: MediaList,
    pub(crate) rules: Rules,
    /// Diffuse light between surfaces.
    pub(crate) radiosity: Option<radiosity::Rules>,
    /// What photons are shot at.
    pub(crate) photons: Option<photons::Plan>,
    /// Light under surfaces.
    pub(crate) subsurface: Option<subsurface::Rules>,
    /// Does any interior or empty space have media?
    pub(crate) any_media: bool,
    /// Do samples of any of them lie at random?
    pub(crate) random_media: bool,
}

/// What a material's surfaces let through of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Passing {
    Nothing,
    /// The same share everywhere.
    Always(Rgb),
    /// It depends on the place.
    Varies,
}

/// A compiled texture at its place.
pub(crate) struct WorldTexture {
    pub texture: Arc<Texture>,
    /// From the world to the texture and back; `None` is the identity.
    pub frame: Option<Box<Frame>>,
}

/// A transform with its inverse.
pub(crate) struct Frame {
    pub texture_from_world: Affine,
    pub world_from_texture: Affine,
}

/// An interior with what rays ask of it worked out.
pub(crate) struct WorldInterior {
    pub interior: Arc<Interior>,
    pub hollow: bool,
    /// Refractive index, the atmosphere's where none was given.
    pub ior: f64,
    pub dispersion: f64,
    pub media: MediaList,
    /// For subsurface light, where the scene has it.
    pub albedo: Option<Arc<subsurface::Albedo>>,
}

/// The global settings that shading asks for.
pub(crate) struct Rules {
    pub bailout: f32,
    pub max_trace_level: u16,
    pub ambient_light: Rgb,
    /// Wavelengths for `irid`.
    pub wavelengths: Rgb,
    /// Does the scene follow the rules of 3.7?
    pub modern: bool,
    pub gamma: GammaMode,
    pub noise: Noise,
    /// Refractive index and dispersion of empty space.
    pub air_ior: f64,
    pub air_dispersion: f64,
}

impl World {
    /// Makes a scene ready.
    ///
    /// # Errors
    /// If the scene holds a shape, camera or light that cannot be built. Effects that [`World::unsupported`] names
    /// are left out without an error.
    pub fn build(scene: &Scene) -> Result<World, BuildError> {
        let rules = Rules::new(scene);
        let mut geometry = Geometry::build(scene)?;
        let (textures, asks_uv) = compile_textures(&geometry, rules.noise);
        geometry.asks_uv = asks_uv || geometry.materials.iter().any(|m| m.uv_mapping);
        let interiors = compile_interiors(&geometry, &rules, scene.settings.subsurface.is_some());
        let lights = geometry
            .lights
            .iter()
            .enumerate()
            .map(|(i, placed)| LightSource::build(i, &placed.light, &geometry))
            .collect::<Result<Vec<_>, _>>()?;
        let air = MediaList::new(&scene.atmosphere.media, &Affine::IDENTITY, rules.noise);
        let any_media = !air.is_empty() || interiors.iter().any(|i| !i.media.is_empty());
        let random_media = air.is_random() || interiors.iter().any(|i| i.media.is_random());
        Ok(World {
            light_sets: LightSets::new(&geometry),
            radiosity: radiosity_rules(scene, &geometry),
            photons: photons::Plan::new(scene),
            subsurface: subsurface::Rules::new(&scene.settings),
            camera: Camera::build(&scene.camera, rules.noise, &geometry)?,
            sky: Sky::new(scene, rules.noise),
            passing: passing_materials(&geometry, &textures, &interiors),
            geometry,
            textures,
            interiors,
            lights,
            air,
            rules,
            any_media,
            random_media,
        })
    }

    /// The effects of a scene that are not built yet and would be left out of its picture.
    pub fn unsupported(scene: &Scene) -> Vec<&'static str> {
        let mut missing = Vec::new();
        if let Some(photons) = &scene.settings.photons {
            if photons.save_file.is_some() {
                missing.push("save_file of photons");
            }
            if photons.load_file.is_some() {
                missing.push("load_file of photons");
            }
        }
        if scene.settings.subsurface.is_some_and(|s| s.radiosity) && scene.settings.radiosity.is_some() {
            missing.push("radiosity of subsurface light");
        }
        missing
    }

    /// What a render has found to be wrong with the scene, to be asked after it. Isosurfaces with the same
    /// `max_gradient` share a warning, as a scene may hold hundreds of them.
    pub fn warnings(&self) -> Vec<String> {
        let mut steep = self.geometry.steep_isosurfaces();
        steep.sort_by(|a, b| a.0.total_cmp(&b.0));
        let said = |alike: &[(f64, f64)]| {
            let greatest = alike.iter().fold(0.0, |greatest, &(_, found)| f64::max(greatest, found));
            let (count, set) = (alike.len(), alike[0].0);
            format!(
                "isosurfaces with a max_gradient of {set:.3} that may have holes: {count}; found was {greatest:.3}"
            )
        };
        steep.chunk_by(|a, b| a.0 == b.0).map(said).collect()
    }

    pub(crate) fn texture(&self, id: TextureId) -> &WorldTexture {
        &self.textures[id.0 as usize]
    }

    pub(crate) fn interior(&self, id: InteriorId) -> &WorldInterior {
        &self.interiors[id.0 as usize]
    }

    pub(crate) fn material(&self, hit: &Interaction) -> &Material {
        &self.geometry.materials[hit.material.0 as usize]
    }

    /// What the surface of a leaf lets through of light.
    #[inline]
    pub(crate) fn passing(&self, leaf: u32) -> Passing {
        self.geometry.plain_material(leaf).map_or(Passing::Varies, |m| self.passing[m.0 as usize])
    }

    /// Does the surface of a leaf stop all light?
    pub(crate) fn stops_at(&self, leaf: u32) -> bool {
        self.passing(leaf) == Passing::Nothing
    }

    /// Do photons bring what the surface of a leaf lets through of a light?
    pub(crate) fn photons_replace(&self, leaf: u32, light: &PhotonFlags) -> bool {
        let material = &self.geometry.materials[self.geometry.material_at(leaf).0 as usize];
        photons::replaces_light(&material.photons, light)
    }

    /// Do all these interiors let fog and media show?
    pub(crate) fn all_hollow(&self, list: &[InteriorId]) -> bool {
        list.iter().all(|&id| self.interior(id).hollow)
    }
}

impl WorldTexture {
    /// A point of the world in the texture's own coordinates.
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.frame.as_ref().map_or(p, |f| f.texture_from_world.transform_point3(p))
    }
}

impl Rules {
    fn new(scene: &Scene) -> Rules {
        let settings = &scene.settings;
        Rules {
            bailout: settings.adc_bailout,
            max_trace_level: settings.max_trace_level.clamp(1, 256),
            ambient_light: settings.ambient_light,
            wavelengths: settings.irid_wavelength,
            modern: settings.version.effective >= 370,
            gamma: settings.gamma,
            noise: Noise { generator: settings.noise_generator, waves: settings.number_of_waves },
            air_ior: f64::from(scene.atmosphere.ior),
            air_dispersion: f64::from(scene.atmosphere.dispersion),
        }
    }
}

/// Each texture once, however often it is placed; and whether any looks at texture coordinates.
fn compile_textures(geometry: &Geometry, noise: Noise) -> (Vec<WorldTexture>, bool) {
    let placed = &geometry.textures;
    let (compiled, asks_uv) = Texture::compile_all(placed.iter().map(|p| &p.texture), noise);
    let at_place = |(placed, texture): (&raggio_geometry::PlacedTexture, Arc<Texture>)| {
        let frame = placed
            .texture_from_world
            .as_deref()
            .map(|t| Box::new(Frame { texture_from_world: *t, world_from_texture: t.inverse() }));
        WorldTexture { texture, frame }
    };
    (placed.iter().zip(compiled).map(at_place).collect(), asks_uv)
}

fn passing_materials(
    geometry: &Geometry,
    textures: &[WorldTexture],
    interiors: &[WorldInterior],
) -> Vec<Passing> {
    let of = |id: TextureId| {
        let texture = &textures[id.0 as usize].texture;
        match texture.even_transmission() {
            _ if texture.is_opaque() => Passing::Nothing,
            Some(share) => Passing::Always(share),
            None => Passing::Varies,
        }
    };
    let passing = |m: &Material| {
        let outside = m.texture.map_or(Passing::Varies, of);
        // Caustics depend on the angle.
        let bright = interiors[m.interior.0 as usize].interior.caustics != 0.0;
        let varies = m.interior_texture.is_some_and(|inside| of(inside) != outside);
        if varies || (bright && outside != Passing::Nothing) { Passing::Varies } else { outside }
    };
    geometry.materials.iter().map(passing).collect()
}

fn compile_interiors(geometry: &Geometry, rules: &Rules, subsurface: bool) -> Vec<WorldInterior> {
    let mut known = FxHashMap::default();
    let mut albedo = |ior: f64| {
        let new = || Arc::new(subsurface::Albedo::new(ior));
        known.entry(ior.to_bits()).or_insert_with(new).clone()
    };
    let compile = |info: &raggio_geometry::InteriorInfo| {
        let interior = info.interior.clone();
        let ior = if interior.ior == 0.0 { rules.air_ior } else { f64::from(interior.ior) };
        WorldInterior {
            hollow: info.hollow,
            ior,
            albedo: subsurface.then(|| albedo(ior)),
            dispersion: f64::from(interior.dispersion),
            media: MediaList::new(
                &interior.media,
                info.world_from_interior.as_deref().unwrap_or(&Affine::IDENTITY),
                rules.noise,
            ),
            interior,
        }
    };
    geometry.interiors.iter().map(compile).collect()
}

fn radiosity_rules(scene: &Scene, geometry: &Geometry) -> Option<radiosity::Rules> {
    let default = scene.settings.default_radiosity_importance;
    let uneven = default < 1.0
        || geometry
            .materials
            .iter()
            .any(|m| m.radiosity_importance.is_some_and(|importance| importance < 1.0));
    let settings = scene.settings.radiosity.as_ref()?;
    Some(radiosity::Rules::new(settings, scene.camera.location, default, uneven))
}
