//! `warp { black_hole }`: a sphere that draws the pattern in or pushes it out, alone or repeated.
use raggio_math::noise::{hash3, random3};
use raggio_math::turns::floor;
use raggio_math::{EPS, Vec3};

#[derive(Debug)]
pub(super) struct BlackHole {
    center: Vec3,
    radius: f64,
    strength: f64,
    falloff: f64,
    /// The same, where it is a small whole number.
    whole_falloff: Option<i32>,
    /// Pushes instead of pulling.
    inverse: bool,
    repeat: Option<Blocks>,
}

/// Blocks of space with a hole in each.
#[derive(Debug)]
struct Blocks {
    size: Vec3,
    /// How far the hole wanders from block to block.
    wander: Vec3,
}

impl BlackHole {
    /// Blocks grow and holes move where they would not fit, as the language prescribes.
    pub fn new(
        mut center: Vec3,
        radius: f64,
        strength: f64,
        falloff: f64,
        inverse: bool,
        repeat: Option<Vec3>,
        turbulence: Option<Vec3>,
    ) -> Self {
        let wander = turbulence.unwrap_or(Vec3::ZERO);
        let repeat = repeat.map(|mut size| {
            for k in 0..3 {
                if size[k] > 0.0 {
                    center[k] = center[k].max(radius);
                    size[k] = size[k].max(center[k] + radius + wander[k]);
                }
            }
            Blocks { size, wander }
        });
        let whole_falloff = (falloff.trunc() == falloff && falloff.abs() <= 16.0).then_some(falloff as i32);
        BlackHole { center, radius, strength, falloff, whole_falloff, inverse, repeat }
    }

    pub fn apply(&self, p: Vec3) -> Vec3 {
        let from_center = p - self.center_near(p);
        let distance = from_center.length();
        if distance >= self.radius {
            return p;
        }
        let depth = (self.radius - distance) / self.radius;
        let reach = match self.whole_falloff {
            Some(n) => depth.powi(n),
            None => depth.powf(self.falloff),
        };
        let pull = (reach * self.strength).min(1.0);
        p + from_center * if self.inverse { -pull } else { pull }
    }

    fn center_near(&self, p: Vec3) -> Vec3 {
        let Some(Blocks { size, wander }) = &self.repeat else { return self.center };
        let block = |k: usize| if size[k] >= EPS { floor(p[k] / size[k]) } else { 0.0 };
        let block = Vec3::new(block(0), block(1), block(2));
        let shift = if *wander == Vec3::ZERO {
            Vec3::ZERO
        } else {
            Vec3::from(random3(hash3(block.x as i64, block.y as i64, block.z as i64))) * *wander
        };
        self.center + shift + *size * block
    }
}
