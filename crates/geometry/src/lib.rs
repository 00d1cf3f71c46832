//! First hits, all hits and inside tests for every shape; CSG; the search structure over a scene.
//!
//! Invariants: [`Geometry::build`] may fail, nothing after it can. A [`Hit`] is a few words; the [`Interaction`] is made
//! once, for the winner. Deliberately absent: colours, lights' effects, cameras.

mod body;
mod borders;
mod convex;
mod extent;
mod flatten;
mod index;
mod inherit;
mod leaf;
mod materials;
mod obstacles;
mod outlook;
mod probe;
mod screen;
mod shaft;
mod shape_pool;
mod shapes;
mod solid;
mod standing;
mod surface;
mod texturing;
mod tree;
mod world;

pub use extent::extent;
pub use obstacles::{BlockerGuess, Obstacles, Segment};
pub use screen::{Lanes, RAYS, Screen, Verdict};
pub use shaft::Shaft;
pub use standing::{Nearest, Standing};
pub use surface::{LocalHit, Surface};
pub use world::{
    BuildError, Geometry, Hit, Interaction, InteriorId, InteriorInfo, LightGroupId, Material, MaterialId,
    PlacedLight, PlacedTexture, RayClass, TextureId, TextureUse, TextureUses,
};
