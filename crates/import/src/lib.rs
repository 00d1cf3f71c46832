//! Meshes from files: OBJ with its materials, PLY, STL; bytes in, [`raggio_scene::Mesh`] out.
//!
//! Invariants: every index of a mesh that comes out is in range, every number finite, every triangle has an area.
//! Nothing is allocated for a count that a file merely claims: counts are checked against the bytes that are there.
//! Coordinates are taken as they stand. Deliberately absent: the file system ([`Surroundings`] stands for it), cameras and
//! lights.
#![warn(missing_docs)]

mod draft;
mod mtl;
mod obj;
mod ply;
mod stl;
mod text;

use raggio_image::Curve;
use raggio_scene::Mesh;
use thiserror::Error;

/// A kind of model file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// The polygon format of Stanford.
    Ply,
    /// Stereolithography.
    Stl,
}

impl Format {
    /// By the ending of a name.
    pub fn from_name(name: &str) -> Option<Format> {
        let ending = name.rsplit_once('.')?.1.to_ascii_lowercase();
        match ending.as_str() {
            "obj" => Some(Format::Obj),
            "ply" => Some(Format::Ply),
            "stl" => Some(Format::Stl),
            _ => None,
        }
    }
}

/// Why a model cannot be read.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ImportError {
    /// At a line of a text, counted from 1.
    #[error("line {line}: {what}")]
    Line {
        /// The line.
        line: usize,
        /// What is wrong there.
        what: String,
    },
    /// At a place in a binary file.
    #[error("byte {offset}: {what}")]
    Byte {
        /// How many bytes come before it.
        offset: usize,
        /// What is wrong there.
        what: String,
    },
    /// With the whole.
    #[error("{0}")]
    Whole(String),
}

/// The result of reading.
pub type Result<T> = std::result::Result<T, ImportError>;

/// What a model may ask about its surroundings.
pub struct Surroundings<'a> {
    /// The bytes of a file that the model names, as a material library or a picture.
    pub find: &'a dyn Fn(&str) -> Option<Vec<u8>>,
    /// The working space that colours of pictures are converted to; `None` leaves them alone.
    pub working: Option<Curve>,
}

/// Reads a model.
///
/// # Errors
/// Where and why the file is no model of this format.
pub fn read(format: Format, bytes: &[u8], around: &Surroundings) -> Result<Mesh> {
    match format {
        Format::Obj => obj::read(bytes, around),
        Format::Ply => ply::read(bytes),
        Format::Stl => stl::read(bytes),
    }
}
