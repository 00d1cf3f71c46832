//! From a scene to a picture: the frozen world, cameras, lights, integrators, the film.
//!
//! Invariants: the picture does not depend on the number of threads; after [`World::build`] nothing fails.
//! Deliberately absent: files, the language, arguments.

mod api;

pub use api::{Antialias, AntialiasMethod, Film, Options, Region, World};
