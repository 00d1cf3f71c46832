//! Radiosity: diffuse light between surfaces by cached samples (media and radiosity spec, section 3; the method is
//! the irradiance cache of Ward, Rubinstein and Clear 1988).
//!
//! The picture does not depend on threads: samples of a pass are seen by later passes, and within the pass only by
//! the group of tiles that made them. Pass k has 2^k groups; threads without a group help with the rays of new samples.
mod ahead;
mod cache;
mod gather;
mod octree;
mod pretrace;

use raggio_image::{Rgb, grey};
use raggio_math::Vec3;
use raggio_scene::RadiositySettings;

use crate::film::Turns;
use crate::integrator::Tracer;
use crate::integrator::surface::SurfacePoint;
use ahead::Asked;
pub use cache::Cache;
use cache::{Found, Query, Sample};
pub use pretrace::pretrace;

/// The settings of a scene with what follows from them.
pub struct Rules {
    settings: RadiositySettings,
    /// From which limits of reuse are measured.
    eye: Vec3,
    default_importance: f32,
    /// Has any object less importance than another?
    uneven: bool,
    /// The first directions of gathers, all of them as a rule.
    directions: Vec<Vec3>,
}

/// The most directions that are worked out before.
const MOST_DIRECTIONS: u32 = 1 << 16;

impl Rules {
    /// Works out a scene's rules.
    pub fn new(settings: &RadiositySettings, eye: Vec3, default_importance: f32, uneven: bool) -> Rules {
        let known = settings.count_pool.clamp(1, MOST_DIRECTIONS);
        let directions = (0..known).map(gather::direction).collect();
        Rules { settings: *settings, eye, default_importance, uneven, directions }
    }

    fn limit(&self) -> u32 {
        self.settings.recursion_limit
    }

    /// Rays of a gather.
    fn rays(&self, depth: u32) -> u32 {
        (self.settings.count >> depth.min(31)).max(5)
    }

    /// Samples wanted for a reuse.
    fn wanted(&self, depth: u32) -> f32 {
        let nearest = self.settings.nearest_count.max(1);
        match depth {
            0 => nearest as f32,
            1 => nearest.min(2) as f32,
            _ => 1.0,
        }
    }
}

/// What a tracer keeps for radiosity.
pub struct State<'w> {
    rules: &'w Rules,
    /// Samples of earlier passes.
    shared: &'w Cache,
    /// Samples of this group.
    pub own: Cache,
    /// Where the sequence of directions goes on, by depth.
    pub cursors: Vec<u32>,
    /// How many gathers lie between the present ray and the camera.
    depth: u32,
    /// Is this before the final picture?
    pretrace: bool,
    /// How well the light of the present ray is known.
    ray_quality: f32,
    /// The work of all threads, of which those that have none left help with gathers.
    turns: Option<&'w Turns>,
    /// With helpers: the samples made, with their depths.
    made: Vec<(u32, Sample)>,
    /// Of a helper: the samples of the group that it works for.
    before: Option<&'w Cache>,
    /// Of a helper: what the present ray wants to know. Helpers make no samples.
    asked: Option<Asked>,
}

impl<'w> State<'w> {
    /// A fresh state for a group of tiles.
    pub fn new(rules: &'w Rules, shared: &'w Cache, pretrace: bool) -> Self {
        State {
            rules,
            shared,
            own: Cache::new(rules.limit()),
            cursors: vec![0; rules.limit() as usize],
            depth: 0,
            pretrace,
            ray_quality: 1.0,
            turns: None,
            made: Vec::new(),
            before: None,
            asked: None,
        }
    }

    /// The same with the help of threads that have no turn left.
    pub fn with_helpers_of(self, turns: &'w Turns) -> Self {
        State { turns: Some(turns), ..self }
    }

    /// Is diffuse light to be had for the present ray?
    #[inline]
    pub fn gathers(&self) -> bool {
        self.depth < self.rules.limit()
    }

    /// Surfaces that the camera sees need no lights before the final picture.
    pub fn skips_lights(&self) -> bool {
        self.pretrace && self.depth == 0
    }
}

impl Tracer<'_> {
    /// The diffuse light from all around at a point, on the side of the surface to which `raw` points, for a layer with
    /// the normal `n` that counts as much as `weight`; `None` where it is not to be had any more.
    pub(crate) fn irradiance(
        &mut self,
        point: &SurfacePoint<'_>,
        (n, raw): (Vec3, Vec3),
        weight: f32,
    ) -> Option<Rgb> {
        let state = self.radiosity.as_ref().filter(|s| s.gathers())?;
        let (rules, depth, settings) = (state.rules, state.depth, &state.rules.settings);
        let mut error = settings.error_bound;
        if state.pretrace {
            error *= settings.low_error_factor;
        }
        error += (0.25 - weight).max(0.0);
        let query = Query {
            p: point.surface.p,
            n: if settings.normal { n } else { raw },
            error: f64::from(error) * f64::from(1u32 << depth.min(20)),
            sharp: !state.pretrace && depth == 0,
        };
        let mut found = Found::default();
        state.shared.look_up(depth, &query, &mut found);
        if let Some(before) = state.before {
            before.look_up(depth, &query, &mut found);
        }
        state.own.look_up(depth, &query, &mut found);
        let wanted = rules.wanted(depth);
        let lazy = !state.pretrace && !settings.always_sample && found.weight > 0.0;
        let enough = 4.0 * found.weight >= wanted || lazy;
        if let Some(asked) = self.radiosity.as_mut().and_then(|s| s.asked.as_mut()) {
            asked.queries.push((depth, query));
            asked.stuck |= !enough;
        } else if !enough {
            let (light, quality) = self.gather(point, query.n, raw);
            found.sum += light * quality;
            found.weight += quality;
        }
        let mut light = if found.weight > 0.0 { found.sum / found.weight } else { Rgb::ZERO };
        light = light * (1.0 - settings.gray_threshold) + Rgb::splat(grey(light) * settings.gray_threshold);
        if let Some(state) = &mut self.radiosity {
            state.ray_quality = state.ray_quality.min(4.0 * found.weight / wanted);
        }
        Some(light * rules.settings.brightness)
    }
}
