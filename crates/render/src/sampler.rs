//! One sample of the picture: camera rays and what they see.
use raggio_geometry::RayClass;
use raggio_math::Ray;

use crate::antialias::{Difference, First, NonRecursive, Patch, Recursive, Shoot, Viewed};
use crate::api::{Antialias, AntialiasMethod, Options, Region};
use crate::camera::{Frame, Lens};
use crate::film::{Pixel, Tile};
use crate::integrator::{Beam, PixelCone, Quality, Tracer};
use crate::photons;
use crate::radiosity;
use crate::sampling::Streams;
use crate::world::World;

/// What is where no ray leaves the camera.
const NOTHING: Pixel = [0.0, 0.0, 0.0, 1.0];

/// Samples for anti-aliasing.
struct Samples<'s, 'w> {
    sampler: &'s mut Sampler<'w>,
    differs: Difference,
    known: Option<&'s First>,
}

impl Shoot for Samples<'_, '_> {
    fn first(&mut self, x: f64, y: f64) -> Viewed {
        match self.known {
            Some(first) => first.at(x, y),
            None => self.differs.view(self.sampler.sample(x, y)),
        }
    }

    fn more(&mut self, x: f64, y: f64) -> Pixel {
        self.sampler.sample(x, y)
    }
}

/// Takes samples for one tile.
pub struct Sampler<'w> {
    tracer: Tracer<'w>,
    options: &'w Options,
    frame: Frame,
}

impl<'w> Sampler<'w> {
    /// A sampler for the thread that calls, which may use `stack` bytes of its stack for rays.
    pub fn new(
        world: &'w World,
        options: &'w Options,
        stack: usize,
        radiosity: Option<radiosity::State<'w>>,
        photons: &'w photons::Maps,
    ) -> Self {
        let max_level = options.max_trace_level.unwrap_or(world.rules.max_trace_level).clamp(1, 256);
        let mut tracer = Tracer::new(world, Quality::new(options.quality), max_level, stack);
        tracer.radiosity = radiosity.filter(|_| tracer.quality.global_light());
        let plan = world.photons.as_ref().filter(|_| !photons.is_empty());
        tracer.photons = plan.map(|plan| photons::State::new(photons, plan));
        let frame = Frame { width: options.width as f64, height: options.height as f64 };
        tracer.pixel = pixel_cone(world, frame);
        Sampler { tracer, options, frame }
    }

    /// What the sampler has learnt for radiosity.
    pub fn into_radiosity(self) -> Option<radiosity::State<'w>> {
        self.tracer.radiosity
    }

    /// Follows the ray through a place for the sake of the radiosity cache alone.
    pub fn look(&mut self, x: f64, y: f64) {
        if let Some(ray) = self.tracer.world.camera.ray(x, y, self.frame, None) {
            self.shoot(&ray, f64::INFINITY, x, y, 0);
        }
    }

    /// All pixels of a tile, row by row. What is known of anti-aliasing's first samples is not taken again.
    pub fn tile(&mut self, tile: &Tile, known: Option<&First>) -> Vec<Pixel> {
        let Some(antialias) = self.options.antialias else {
            let places = tile.y.clone().flat_map(|y| tile.x.clone().map(move |x| (x as f64, y as f64)));
            return places.map(|(x, y)| self.sample(x, y)).collect();
        };
        let differs = self.difference(&antialias);
        let mut samples = Samples { sampler: self, differs, known };
        match antialias.method {
            AntialiasMethod::NonRecursive => {
                NonRecursive { differs, depth: antialias.depth, jitter: antialias.jitter }
                    .tile(tile, &mut samples)
            }
            AntialiasMethod::Recursive => {
                Recursive::new(differs, antialias.depth, antialias.jitter).tile(tile, &mut samples)
            }
        }
    }

    /// Some of anti-aliasing's first samples.
    pub fn patch(&mut self, region: &Region, part: &Tile, antialias: &Antialias) -> Patch {
        let differs = self.difference(antialias);
        First::patch(region, antialias, part, &differs, |x, y| self.sample(x, y))
    }

    fn difference(&self, antialias: &Antialias) -> Difference {
        Difference::new(self.tracer.world.rules.gamma, antialias.gamma, antialias.threshold)
    }

    /// The picture at a place in pixel coordinates, where a pixel's centre is an integer.
    pub fn sample(&mut self, x: f64, y: f64) -> Pixel {
        let camera = &self.tracer.world.camera;
        if camera.mesh.is_some() {
            return self.mesh_sample(x, y);
        }
        if let Some(lens) = &camera.lens {
            return self.blurred(x, y, lens);
        }
        match &camera.ray(x, y, self.frame, None) {
            Some(ray) => self.shoot(ray, f64::INFINITY, x, y, 0),
            None => NOTHING,
        }
    }

    /// What a camera ray sees. The place and the number of the sample there name its random numbers.
    fn shoot(&mut self, ray: &Ray, reach: f64, x: f64, y: f64, number: u64) -> Pixel {
        let world = self.tracer.world;
        self.tracer.streams = Streams::new(self.options.seed, x.to_bits() as i64, y.to_bits() as i64, number);
        let around;
        let interiors = match world.camera.interiors() {
            Some(same) => same,
            None => {
                around = world.geometry.interiors_at(ray.origin);
                &around[..]
            }
        };
        let beam = Beam {
            ray,
            interiors,
            weight: 1.0,
            class: RayClass::Camera,
            alpha: self.options.alpha,
            wavelength: None,
            reach,
        };
        self.tracer.trace(&beam, false).to_pixel()
    }

    /// Depth of field: samples over the lens until they agree.
    fn blurred(&mut self, x: f64, y: f64, lens: &Lens) -> Pixel {
        let (mut sum, mut squares, mut done) = ([0.0; 4], [0.0; 4], 0);
        loop {
            for _ in 0..lens.group(done) {
                let sample = lens.sample(x, y, done);
                let camera = &self.tracer.world.camera;
                let pixel = match &camera.ray(sample.x, sample.y, self.frame, Some(&sample)) {
                    Some(ray) => self.shoot(ray, f64::INFINITY, x, y, done as u64),
                    None => NOTHING,
                };
                for ((sum, square), value) in sum.iter_mut().zip(&mut squares).zip(pixel) {
                    *sum += f64::from(value);
                    *square += f64::from(value) * f64::from(value);
                }
                done += 1;
            }
            if lens.enough(done, &sum, &squares) {
                return sum.map(|v| (v / done as f64) as f32);
            }
        }
    }

    /// A mesh camera's pixel: the mean of its rays.
    fn mesh_sample(&mut self, x: f64, y: f64) -> Pixel {
        let Some(mesh) = &self.tracer.world.camera.mesh else { return NOTHING };
        let (mut sum, mut count) = ([0.0; 4], 0.0);
        for k in 0..mesh.rays_per_pixel() {
            if let Some(ray) = mesh.ray(x, y, k, self.frame) {
                let pixel = self.shoot(&ray, mesh.max_distance, x, y, u64::from(k));
                sum.iter_mut().zip(pixel).for_each(|(sum, value)| *sum += value);
                count += 1.0;
            }
        }
        if count == 0.0 { NOTHING } else { sum.map(|v| v / count) }
    }
}

/// What a pixel in the middle of the picture covers; nothing for cameras without rays there.
fn pixel_cone(world: &World, frame: Frame) -> PixelCone {
    if world.camera.mesh.is_some() {
        return PixelCone::default();
    }
    let (x, y) = (0.5 * frame.width, 0.5 * frame.height);
    let ray = |x: f64| world.camera.ray(x, y, frame, None);
    match (ray(x - 0.5), ray(x + 0.5)) {
        (Some(a), Some(b)) => PixelCone::between(&a, &b),
        _ => PixelCone::default(),
    }
}
