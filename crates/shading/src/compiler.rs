//! What compiling carries along: the scene's noise, and what has been compiled already, so that shared parts stay
//! shared however deep they are nested.
use std::sync::Arc;

use raggio_scene as scene;
use rustc_hash::FxHashMap;

use crate::{Noise, Normal, Pigment, Texture};

/// Compiles textures, pigments, normals or patterns with all their parts. The addresses in the tables stay valid because
/// the scene's parts that are being compiled are borrowed all the while.
pub(crate) struct Compiler {
    pub noise: Noise,
    /// Does any part look at texture coordinates?
    pub asks_uv: bool,
    pigments: FxHashMap<*const scene::Pigment, Arc<Pigment>>,
    /// By address and by whether `no_bump_scale` is inherited.
    normals: FxHashMap<(*const scene::Normal, bool), Arc<Normal>>,
    textures: FxHashMap<*const scene::Texture, Arc<Texture>>,
}

impl Compiler {
    pub fn new(noise: Noise) -> Self {
        Compiler {
            noise,
            asks_uv: false,
            pigments: FxHashMap::default(),
            normals: FxHashMap::default(),
            textures: FxHashMap::default(),
        }
    }

    /// The compiled form of a pigment that may be in use elsewhere.
    pub fn shared_pigment(&mut self, pigment: &Arc<scene::Pigment>) -> Arc<Pigment> {
        let key = Arc::as_ptr(pigment);
        if let Some(done) = self.pigments.get(&key) {
            done.remember();
            return done.clone();
        }
        let compiled = Arc::new(self.pigment(pigment));
        self.pigments.insert(key, compiled.clone());
        compiled
    }

    /// The compiled form of a normal that may be in use elsewhere.
    pub fn shared_normal(&mut self, normal: &Arc<scene::Normal>, no_bump_scale: bool) -> Arc<Normal> {
        let key = (Arc::as_ptr(normal), no_bump_scale);
        if let Some(done) = self.normals.get(&key) {
            return done.clone();
        }
        let compiled = Arc::new(self.normal(normal, no_bump_scale));
        self.normals.insert(key, compiled.clone());
        compiled
    }

    /// The compiled form of a texture that may be in use elsewhere.
    pub fn shared_texture(&mut self, texture: &Arc<scene::Texture>) -> Arc<Texture> {
        let key = Arc::as_ptr(texture);
        if let Some(done) = self.textures.get(&key) {
            return done.clone();
        }
        let compiled = Arc::new(self.texture(texture));
        self.textures.insert(key, compiled.clone());
        compiled
    }
}
