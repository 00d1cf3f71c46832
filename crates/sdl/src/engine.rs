//! What the language asks of the outside world: the engine and the files.
use std::sync::Arc;

use raggio_function::External;
use raggio_math::{Aabb, Vec3};
use raggio_scene::{Curve, Mesh, Object, Pattern, Pigment, Settings};

/// Questions that a running scene puts to the engine. Answers must not depend on anything but the arguments.
pub trait Engine: Sync {
    /// `trace`: the first hit of the ray with the object, and the raw unit normal there. `dir` is of unit length.
    fn trace(&self, object: &Arc<Object>, origin: Vec3, dir: Vec3) -> Option<(Vec3, Vec3)>;
    /// `inside`; `None` where the object has no inside at all.
    fn inside(&self, object: &Arc<Object>, point: Vec3) -> Option<bool>;
    /// `min_extent`, `max_extent`.
    fn bounds(&self, object: &Arc<Object>) -> Aabb;
    /// `function { pigment { ... } }`, five components.
    fn pigment_function(&self, pigment: Arc<Pigment>, settings: &Settings) -> Arc<dyn External>;
    /// `function { pattern { ... } }`, one component: the value before any map.
    fn pattern_function(&self, pattern: Arc<Pattern>, settings: &Settings) -> Arc<dyn External>;
}

/// The files that a scene reads and writes.
pub trait Files: Sync {
    /// The bytes of a file, looked up as given and then in the library folders and the embedded library; with the name
    /// under which it was found. `names` are tried in order, each in every place.
    fn find(&self, names: &[String]) -> Option<(String, Vec<u8>)>;
    /// The triangles of a model file (`mesh { file "..." }`), or what is wrong with it; `None` where there is no such
    /// file. Colours of its pictures are converted to the working space; `None` leaves them alone.
    fn mesh(&self, _name: &str, _working: Option<Curve>) -> Option<Result<Mesh, String>> {
        None
    }
    /// Writes (or appends to) a file for `#fopen ... write|append`.
    fn write(&self, name: &str, bytes: &[u8], append: bool) -> std::io::Result<()>;
}
