//! The engine as a running scene sees it: answers to `trace`, `inside`, extents, and pigment functions.
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use raggio_function::External;
use raggio_geometry::{Geometry, RayClass};
use raggio_math::{Aabb, MIN_HIT, Ray, Vec3};
use raggio_scene::{Object, Pattern, Pigment, Settings};
use raggio_sdl::Engine;
use raggio_shading::{Noise, PatternFunction, PigmentFunction};

/// How many compiled objects are kept: scenes ask thousands of times about a few.
const KEPT: usize = 64;

/// An object that was asked about and its compiled form; `None` where it is of an unsupported kind.
type Compiled = (Arc<Object>, Option<Arc<Geometry>>);

/// Answers with the same geometry and shading that render the picture.
#[derive(Default)]
pub struct LiveEngine {
    /// By address; each entry keeps its object alive, so that an address names one object only.
    compiled: Mutex<HashMap<usize, Compiled>>,
}

impl LiveEngine {
    /// The compiled object; `None` where it is of an unsupported kind.
    fn geometry(&self, object: &Arc<Object>) -> Option<Arc<Geometry>> {
        let address = Arc::as_ptr(object) as usize;
        let mut compiled = self.compiled.lock().unwrap_or_else(PoisonError::into_inner);
        if compiled.len() >= KEPT && !compiled.contains_key(&address) {
            compiled.clear();
        }
        let entry = compiled
            .entry(address)
            .or_insert_with(|| (object.clone(), Geometry::of_object(object).ok().map(Arc::new)));
        entry.1.clone()
    }
}

fn noise(settings: &Settings) -> Noise {
    Noise { generator: settings.noise_generator, waves: settings.number_of_waves }
}

impl Engine for LiveEngine {
    fn trace(&self, object: &Arc<Object>, origin: Vec3, dir: Vec3) -> Option<(Vec3, Vec3)> {
        let geometry = self.geometry(object)?;
        let ray = Ray::new(origin, dir);
        let hit = geometry.closest(&ray, (MIN_HIT, f64::INFINITY), RayClass::Any)?;
        let at = geometry.interaction(&ray, &hit);
        Some((at.p, at.n))
    }

    fn inside(&self, object: &Arc<Object>, point: Vec3) -> Option<bool> {
        Some(self.geometry(object)?.inside(point))
    }

    fn bounds(&self, object: &Arc<Object>) -> Aabb {
        raggio_geometry::extent(object)
    }

    fn pigment_function(&self, pigment: Arc<Pigment>, settings: &Settings) -> Arc<dyn External> {
        Arc::new(PigmentFunction::new(pigment, noise(settings)))
    }

    fn pattern_function(&self, pattern: Arc<Pattern>, settings: &Settings) -> Arc<dyn External> {
        Arc::new(PatternFunction::new(pattern, noise(settings)))
    }
}
