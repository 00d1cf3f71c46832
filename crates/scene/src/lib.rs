//! The waist: plain data for everything that a scene can contain.
//!
//! What a front end (`sdl`, later `import`) hands over and every engine starts from. A [`Scene`] is fully evaluated:
//! no names, no files, no defaults left to look up, every colour in the scene's working space, every number finite.
//! New kinds of shape, pattern or light are variants of closed enums here, so that the compiler names every room that
//! has not dealt with them.
//!
//! # What the next stage may rely on
//! * Statements were checked: counts, ranges and degenerate input were refused or mended by the front end.
//! * Sharing is meaning-free, except for interiors: the same `Arc` in two places means the same as two equal copies.
//!   Each object of the final tree that has an interior has one of its own; a child without one shares that of its
//!   nearest ancestor.
//! * Transforms are kept where they were written: an [`Object`] maps its own coordinates to its parent's with
//!   `parent_from_object`, and everything attached to it ([`Placed`] textures, interiors, clips) is placed in the
//!   parent's coordinates as well. So transforming a tree touches its root alone.
//!
//! Deliberately absent: files, engines, anything that is computed from the data.
#![warn(missing_docs)]

mod atmosphere;
mod camera;
mod finish;
mod interior;
mod light;
mod mesh;
mod normal;
mod nurbs;
mod object;
mod pattern;
mod pigment;
mod settings;
mod shape;
mod texture;

pub use atmosphere::{Atmosphere, Background, Fog, FogKind, Rainbow, SkySphere};
pub use camera::{Camera, CameraKind, FocalBlur, MeshCamera};
pub use finish::{Finish, Irid, LegacyInterior, Reflection, Subsurface};
pub use interior::{Density, Interior, Media, Scattering};
pub use light::{AreaLight, Light, LightKind};
pub use mesh::{FaceIndices, FaceTexture, Faces, Mesh, MeshFace, has_area};
pub use normal::{Normal, NormalKind, NormalPattern};
pub use nurbs::{Knots, Nurbs, Trim};
pub use object::{Csg, Object, ObjectKind, PhotonFlags, Placed};
pub use pattern::{
    CrackleSettings, DensityFile, FractalKind, FractalSettings, ImageMap, ImageSource, Interpolation,
    MapType, Pattern, PatternKind, SlopeSettings, Turbulence, Warp, Wave,
};
pub use pigment::{ColorMap, Map, Pigment, PigmentKind};
pub use raggio_function::Function;
pub use raggio_image::{Bitmap, Color, Curve, Mosaic, Rgb};
pub use settings::{GammaMode, Photons, RadiositySettings, Settings, SubsurfaceSettings, Version};
pub use shape::{
    Blob, BlobComponent, BlobShape, Container, Contour, Curve2, CurveKind, Glyph, HeightField, Isosurface,
    IsosurfaceEvaluate, Julia, JuliaAlgebra, JuliaFunction, Parametric, Prism, Shape, SplineKind,
    SweepSphere,
};
pub use texture::{Layer, Texture, TextureKind};

use std::sync::Arc;

/// A whole scene.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Global settings.
    pub settings: Settings,
    /// The view.
    pub camera: Camera,
    /// Background, sky, fog and what else fills empty space.
    pub atmosphere: Atmosphere,
    /// The top-level objects, lights among them, in the order of the scene.
    pub objects: Vec<Arc<Object>>,
}
