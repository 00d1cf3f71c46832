//! The scene while it is being read.
use std::sync::Arc;

use raggio_scene::{Atmosphere, Camera, Object};

/// What statements add to; `parse` makes the [`raggio_scene::Scene`] of it at the end.
#[derive(Debug, Default)]
pub struct SceneBuilder {
    /// Top-level objects, lights among them, in the order of the scene.
    pub objects: Vec<Arc<Object>>,
    /// The last `camera`.
    pub camera: Option<Camera>,
    /// Background, sky, fog and so on.
    pub atmosphere: Atmosphere,
}
