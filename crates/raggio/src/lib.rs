//! Raggio: a ray tracer for POV-Ray scenes.
//!
//! ```no_run
//! use std::sync::atomic::AtomicBool;
//! let loaded = raggio::load(&raggio::SceneOptions::file("scene.pov")).map_err(|f| f.render())?;
//! let world = loaded.build().map_err(|f| f.render())?;
//! let film = world.render(&raggio::RenderOptions::default(), &AtomicBool::new(false), &|_, _| {});
//! # Ok::<(), String>(())
//! ```
//!
//! This crate wires the rooms below it together and adds nothing of its own but files, the embedded include library
//! and the order of things.
#![warn(missing_docs)]

mod embedded;
mod engine;
mod files;
mod load;
mod mapped;
mod model;
mod output;

pub use embedded::DEFAULT_SCENE;
pub use files::InstalledLibrary;
pub use load::{Failure, Loaded, SceneOptions, load, load_with};
pub use output::{OutputError, write_picture, write_whole};
pub use raggio_diag as diag;
pub use raggio_image as image;
pub use raggio_render::{Antialias, AntialiasMethod, Film, Options as RenderOptions, Region, World};
pub use raggio_scene as scene;
pub use raggio_sdl::{Declared, ParseOptions};
