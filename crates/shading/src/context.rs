//! What evaluation is told beyond the point: the scene's noise, and the surface at hand.
use raggio_math::{Vec2, Vec3};

/// What the scene says to all noise: default generator, number of waves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noise {
    /// 1, 2 or 3.
    pub generator: u8,
    /// Sources of `ripples` and `waves`.
    pub waves: u32,
}

impl Default for Noise {
    fn default() -> Self {
        Noise { generator: 2, waves: 10 }
    }
}

/// What is known at a surface beyond the point; patterns like `slope` and `aoi` ask for it.
#[derive(Clone, Copy, Debug)]
pub struct Context {
    /// The normal so far, unit, in the world, facing the viewer; `None` where there is no surface (sky, media,
    /// functions).
    pub normal: Option<Vec3>,
    /// The hit in the world, which `slope { point_at }` looks from.
    pub point: Vec3,
    /// The ray's unit direction in the world.
    pub ray_dir: Vec3,
    /// Texture coordinates.
    pub uv: Vec2,
}

impl Context {
    /// No surface at all.
    pub const NONE: Context =
        Context { normal: None, point: Vec3::ZERO, ray_dir: Vec3::ZERO, uv: Vec2::ZERO };

    /// The point that `uv_mapping` puts in place of the one in space.
    #[inline]
    pub(crate) fn uv_point(&self) -> Vec3 {
        Vec3::new(self.uv.x, self.uv.y, 0.0)
    }
}
