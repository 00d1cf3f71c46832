//! From a scene to a picture: the frozen world, cameras, lights, integrators, the film.
//!
//! Invariants: the picture does not depend on the number of threads; after [`World::build`] nothing fails.
//! Deliberately absent: files, the language, arguments.

mod antialias;
mod api;
mod atmosphere;
mod camera;
mod film;
mod integrator;
mod lights;
mod media;
mod packed;
mod photons;
mod radiosity;
mod sampler;
mod sampling;
mod subsurface;
mod world;

pub use api::{Antialias, AntialiasMethod, Film, Options, Region};
pub use world::World;

#[cfg(test)]
extern crate self as raggio_render;
#[cfg(test)]
#[path = "../tests/stage/mod.rs"]
mod stage;
