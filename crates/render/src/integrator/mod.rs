//! The Whitted integrator with POV-Ray's rules: what a ray sees (light spec, section 3).
mod dispersion;
mod footprint;
mod interiors;
mod layers;
pub(crate) mod lobes;
mod local;
pub(crate) mod reflection;
pub(crate) mod refraction;
mod seen;
pub(crate) mod surface;
mod textures;

use raggio_geometry::{BlockerGuess, Hit, InteriorId, RayClass};
use raggio_image::Rgb;
use raggio_math::{FAR, MIN_HIT, Ray};
use smallvec::SmallVec;

use crate::lights::AreaScratch;
use crate::sampling::Streams;
use crate::world::World;
use crate::{photons, radiosity};

pub use footprint::PixelCone;
pub use interiors::toggle;
pub(crate) use refraction::fade;
pub use seen::Seen;
pub use textures::{NormalPath, for_each_plain, placed};

/// The interiors around a ray, in the order in which it entered them.
pub type Interiors = SmallVec<[InteriorId; 8]>;

/// A ray with its history.
#[derive(Clone, Copy, Debug)]
pub struct Beam<'a> {
    /// Where it goes.
    pub ray: &'a Ray,
    /// What it is inside of.
    pub interiors: &'a [InteriorId],
    /// How much it counts for the picture.
    pub weight: f32,
    /// Which objects it sees.
    pub class: RayClass,
    /// Does a miss show as transparency?
    pub alpha: bool,
    /// In nanometres; `None` while it carries all light.
    pub wavelength: Option<f64>,
    /// Hits beyond do not count.
    pub reach: f64,
}

/// What the quality option leaves on (light spec, section 8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    level: u8,
    area_lights: bool,
    volume: bool,
}

#[allow(missing_docs)]
impl Quality {
    pub fn new(level: u8) -> Self {
        Quality { level, area_lights: level >= 5, volume: level >= 9 }
    }
    /// Gathered light does without soft shadows, and without fog and media unless they are asked for.
    pub fn for_gather(self, media: bool) -> Self {
        Quality { area_lights: false, volume: self.volume && media, ..self }
    }
    pub fn lights(self) -> bool {
        self.level >= 2
    }
    pub fn shadows(self) -> bool {
        self.level >= 4
    }
    pub fn area_lights(self) -> bool {
        self.area_lights
    }
    pub fn quick_color(self) -> bool {
        self.level <= 5
    }
    pub fn refraction(self) -> bool {
        self.level >= 6
    }
    pub fn reflection(self) -> bool {
        self.level >= 8
    }
    pub fn normals(self) -> bool {
        self.level >= 8
    }
    pub fn volume(self) -> bool {
        self.volume
    }
    pub fn global_light(self) -> bool {
        self.level >= 9
    }
}

/// A thread's tracer: the world, the state of the present ray tree, and memory to work in.
pub struct Tracer<'w> {
    /// What rays are shot at.
    pub world: &'w World,
    /// What is left on.
    pub quality: Quality,
    /// Random numbers of the present camera sample.
    pub streams: Streams,
    /// Rays so far in the present row.
    pub(crate) level: u16,
    pub(crate) max_level: u16,
    /// Rays with less weight are not traced.
    pub(crate) bailout: f32,
    /// Diffuse light between surfaces, where the scene has it.
    pub radiosity: Option<radiosity::State<'w>>,
    /// Photons, where the scene has them.
    pub photons: Option<photons::State<'w>>,
    /// How often light in work was scattered under surfaces.
    pub(crate) scatter_depth: u32,
    /// What a pixel covers, and how far the light in work has come from the camera.
    pub(crate) pixel: PixelCone,
    way: f64,
    /// Light that arrives at the surface points in work, by light, each once for all layers.
    arriving: Vec<Option<Rgb>>,
    pub(crate) area_scratch: Option<Box<AreaScratch>>,
    /// What last stood before each light.
    pub(crate) blockers: Vec<BlockerGuess>,
    /// Where the stack stood at first, and how much of it may be used: rays that pass straight through count for no
    /// level, so that nothing else limits them.
    stack_base: usize,
    stack_allowance: usize,
}

impl<'w> Tracer<'w> {
    /// A tracer for the thread that calls, which may use that many bytes of its stack.
    pub fn new(world: &'w World, quality: Quality, max_level: u16, stack_allowance: usize) -> Self {
        Tracer {
            world,
            quality,
            streams: Streams::default(),
            level: 0,
            max_level,
            bailout: world.rules.bailout,
            radiosity: None,
            photons: None,
            scatter_depth: 0,
            pixel: PixelCone::default(),
            way: 0.0,
            arriving: Vec::new(),
            area_scratch: None,
            blockers: vec![BlockerGuess::default(); world.lights.len()],
            stack_base: stack_position(),
            stack_allowance,
        }
    }

    /// A tracer for the thread that calls which goes on where this one stands, with that much of its stack and without
    /// radiosity and photons.
    pub(crate) fn fork(&self, stack_allowance: usize) -> Tracer<'_> {
        Tracer {
            streams: self.streams,
            level: self.level,
            bailout: self.bailout,
            scatter_depth: self.scatter_depth,
            pixel: self.pixel,
            way: self.way,
            ..Tracer::new(self.world, self.quality, self.max_level, stack_allowance)
        }
    }

    /// How much of the stack is left.
    pub(crate) fn stack_left(&self) -> usize {
        self.stack_allowance.saturating_sub(self.stack_base.abs_diff(stack_position()))
    }

    /// What a ray sees. `continued` rays go straight on through a surface and use up no level.
    pub fn trace(&mut self, beam: &Beam<'_>, continued: bool) -> Seen {
        if self.is_last() || beam.weight < self.bailout || self.stack_is_spent() {
            return Seen::BLACK;
        }
        let mut hit = Hit::NONE;
        let found = self.world.geometry.closest_into(beam.ray, (MIN_HIT, beam.reach), beam.class, &mut hit);
        self.follow(beam, found.then_some(&hit), continued)
    }

    /// Is the ray in work the last of its row, so that none that it would give rise to is traced?
    #[inline]
    pub(crate) fn is_last(&self) -> bool {
        self.level >= self.max_level
    }

    /// What a ray sees whose nearest hit is known.
    #[inline]
    pub fn follow(&mut self, beam: &Beam<'_>, hit: Option<&Hit>, continued: bool) -> Seen {
        let step = u16::from(!continued);
        self.level += step;
        let mut seen = match hit {
            Some(hit) => self.surface(beam, hit),
            None => self.world.sky.miss(beam),
        };
        self.level -= step;
        let empty = self.world.sky.is_clear() && self.world.air.is_empty();
        if !empty && self.quality.volume() && self.world.all_hollow(beam.interiors) {
            self.atmosphere(beam, hit, &mut seen);
        }
        seen
    }

    /// Is there no room for one more ray?
    pub(crate) fn stack_is_spent(&self) -> bool {
        self.stack_base.abs_diff(stack_position()) > self.stack_allowance
    }

    /// Rainbows, media of empty space and fog over the way to the hit.
    #[inline(never)]
    fn atmosphere(&mut self, beam: &Beam<'_>, hit: Option<&Hit>, seen: &mut Seen) {
        let world = self.world;
        let depth = hit.map_or(FAR, |hit| hit.t);
        world.sky.rainbows(beam.ray, depth, &mut self.streams.numbers().lights, seen);
        if !world.air.is_empty() {
            let lights = match hit {
                Some(hit) => {
                    let surface = world.geometry.interaction(beam.ray, hit);
                    world.light_sets.of(world.material(&surface))
                }
                None => world.light_sets.global(),
            };
            self.media_along(&[&world.air], beam, depth, lights, seen);
        }
        world.sky.fogs(beam.ray, depth, seen);
    }
}

/// Where the stack stands, as a number that only serves to be compared.
fn stack_position() -> usize {
    let here = 0u8;
    std::hint::black_box(std::ptr::addr_of!(here)) as usize
}
