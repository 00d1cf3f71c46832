//! Patterns: from a point to a number (textures spec, sections 2 to 4).
//!
//! Each family of formulas has its file; [`Kind`] lists them all, and is what evaluation dispatches on.
mod block;
mod compile;
mod complex;
mod crackle;
mod crackle_bounds;
mod density;
mod few;
mod fractal;
mod geometric;
mod noisy;
mod pavement;
mod ripples;
mod scatter;
mod slope;
mod tiling;
mod wave;

use std::sync::Arc;

use raggio_function::Bounds;
use raggio_geometry::Geometry;
use raggio_image::grey;
use raggio_math::noise::{noise, noise4};
use raggio_math::turns::fraction;
use raggio_math::{Vec2, Vec3};
use raggio_scene as scene;

use crate::compiler::Compiler;
use crate::image::Image;
use crate::pigment::Effort;
use crate::warp::WarpList;
use crate::{Context, Noise, Pigment};

pub(crate) use block::{CubeFace, cube_face};
pub(crate) use crackle::{Metric, nearest_feature};
pub(crate) use geometric::quilt_strength;
pub(crate) use noisy::{Turbulence, wrinkle_bend};
pub(crate) use ripples::Waves;

/// A compiled pattern.
#[derive(Debug)]
pub struct Pattern {
    kind: Kind,
    warps: WarpList,
    wave: wave::Waveform,
}

/// The formulas, with all that can be worked out before the first point.
#[derive(Debug)]
enum Kind {
    /// Always 0: what has no value of its own.
    Zero,
    Agate {
        noise: u8,
        turbulence: Turbulence,
        strength: f64,
    },
    Aoi,
    Boxed,
    Bozo {
        noise: u8,
    },
    Brick {
        size: Vec3,
        mortar: Vec3,
        gap: f64,
    },
    Cells,
    Checker,
    Crackle(Box<crackle::Crackle>),
    Cubic,
    Cylindrical,
    Density(Arc<scene::DensityFile>),
    Dents {
        noise: u8,
    },
    Fractal(Box<scene::FractalSettings>),
    Function(Arc<scene::Function>),
    Gradient {
        direction: Vec3,
    },
    Granite {
        noise: u8,
    },
    Hexagon,
    Image(Box<Image>),
    Leopard,
    Marble {
        noise: u8,
        turbulence: Turbulence,
    },
    Object(Box<Inside>),
    Onion,
    Pavement(pavement::Pavement),
    Pigment(Arc<Pigment>),
    Planar,
    Quilted {
        controls: Vec2,
    },
    Radial,
    Ripples(Waves),
    Slope(Box<slope::Slope>),
    Spherical,
    Spiral1 {
        arms: f64,
        noise: u8,
        turbulence: Turbulence,
    },
    Spiral2 {
        arms: f64,
        noise: u8,
        turbulence: Turbulence,
    },
    Square,
    Tiling(tiling::Tiling),
    Triangular,
    Waves(Waves),
    Wood {
        turbulence: Turbulence,
    },
    Wrinkles {
        noise: u8,
    },
}

/// What becomes of each of four things. (The array's own `map` is not always inlined, and then costs more than the work.)
#[inline(always)]
pub(crate) fn each<A, B>([a, b, c, d]: &[A; 4], mut f: impl FnMut(&A) -> B) -> [B; 4] {
    [f(a), f(b), f(c), f(d)]
}

/// A compiled object that is asked for insideness only.
pub(super) struct Inside(Geometry);

impl std::fmt::Debug for Inside {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Inside")
    }
}

impl Pattern {
    /// Compiles a pattern.
    pub fn compile(pattern: &scene::Pattern, noise: Noise) -> Self {
        Compiler::new(noise).pattern(pattern)
    }

    /// The value at a point, waves applied (textures spec, section 2).
    #[inline]
    pub fn eval(&self, p: Vec3, context: &Context) -> f64 {
        self.eval_warped(self.warp(p), context)
    }

    /// The point that the formula sees, and that the entries of the pattern's map start from.
    #[inline]
    pub(crate) fn warp(&self, p: Vec3) -> Vec3 {
        self.warps.apply(p)
    }

    /// The value at a point that has been warped already.
    #[inline]
    pub(crate) fn eval_warped(&self, p: Vec3, context: &Context) -> f64 {
        self.wave.apply(self.kind.value(p, context))
    }

    /// The values at four points.
    #[inline]
    pub(crate) fn eval4(&self, points: &[Vec3; 4], context: &Context) -> [f64; 4] {
        self.eval_warped4(&each(points, |&p| self.warp(p)), context)
    }

    /// Is there a shortcut to values above a bound?
    pub(crate) fn foresees(&self) -> bool {
        let shortcut = match &self.kind {
            Kind::Crackle(crackle) => crackle.is_usual(),
            Kind::Wrinkles { .. } => true,
            _ => false,
        };
        shortcut && self.wave.is_plain()
    }

    /// The value at a point that has been warped already; `None` where it is known to be above `bound`, for patterns
    /// with a shortcut.
    #[inline]
    pub(crate) fn eval_unless_above(&self, p: Vec3, bound: f64, context: &Context) -> Option<f64> {
        match &self.kind {
            Kind::Crackle(crackle) => crackle.value_unless_above(p, bound),
            Kind::Wrinkles { noise } => noisy::wrinkles_unless_above(p, bound, *noise),
            _ => Some(self.eval_warped(p, context)),
        }
    }

    /// The values at four points that have been warped already.
    #[inline]
    pub(crate) fn eval_warped4(&self, points: &[Vec3; 4], context: &Context) -> [f64; 4] {
        let mut values = [0.0; 4];
        match &self.kind {
            Kind::Bozo { noise } => values = noise4(*noise, points),
            Kind::Fractal(settings) => values = fractal::values(settings, points),
            Kind::Crackle(crackle) => values = crackle.value4(points),
            Kind::Granite { noise } => values = noisy::granite4(points, *noise),
            Kind::Wrinkles { noise } => values = noisy::wrinkles4(points, *noise),
            Kind::Pigment(pigment) => {
                values = each(&pigment.ask4(points, context), |(color, _)| f64::from(grey(color.rgb)));
            }
            kind => {
                for (value, p) in values.iter_mut().zip(points) {
                    *value = kind.value(*p, context);
                }
            }
        }
        for value in &mut values {
            *value = self.wave.apply(*value);
        }
        values
    }

    /// Where the values lie over bounds of a point, and their slopes, if anything is known of them.
    pub(crate) fn enclose(&self, p: [Bounds; 3]) -> Bounds {
        let (Kind::Crackle(crackle), Some(p)) = (&self.kind, self.warps.enclose(p)) else {
            return Bounds::UNKNOWN;
        };
        self.wave.enclose(crackle.enclose(&p))
    }

    /// What it takes to find the value.
    pub(crate) fn effort(&self) -> Effort {
        let long = match &self.kind {
            Kind::Pigment(pigment) => {
                let Effort { local, long } = pigment.effort();
                return Effort { local, long: long || self.warps.are_turbulent() };
            }
            Kind::Aoi | Kind::Slope(_) => return Effort { local: false, long: false },
            Kind::Agate { .. }
            | Kind::Crackle(_)
            | Kind::Fractal(_)
            | Kind::Function(_)
            | Kind::Granite { .. }
            | Kind::Spiral1 { .. }
            | Kind::Spiral2 { .. }
            | Kind::Wrinkles { .. } => true,
            _ => self.warps.are_turbulent(),
        };
        Effort { local: true, long }
    }

    /// The warps, for normals on their way in and out.
    pub(crate) fn warps(&self) -> &WarpList {
        &self.warps
    }
}

impl Kind {
    #[inline(always)]
    fn value(&self, p: Vec3, context: &Context) -> f64 {
        self.value_at(p.x, p.y, p.z, context)
    }

    /// Coordinates come in registers: in memory they would have to be waited for where they have just been stored in
    /// parts of another size than those in which they are read.
    fn value_at(&self, x: f64, y: f64, z: f64, context: &Context) -> f64 {
        let p = Vec3::new(x, y, z);
        match self {
            Kind::Zero => 0.0,
            Kind::Agate { noise, turbulence, strength } => noisy::agate(p, *noise, turbulence, *strength),
            Kind::Aoi => slope::aoi(context),
            Kind::Boxed => geometric::falling(p.abs().max_element()),
            Kind::Bozo { noise: generator } => noise(*generator, p),
            Kind::Brick { size, mortar, gap } => block::brick(p, *size, *mortar, *gap),
            Kind::Cells => block::cells(p),
            Kind::Checker => block::checker(p),
            Kind::Crackle(crackle) => crackle.value(p),
            Kind::Cubic => f64::from(cube_face(p) as u8),
            Kind::Cylindrical => geometric::falling(Vec2::new(p.x, p.z).length()),
            Kind::Density(file) => density::value(file, p),
            Kind::Dents { noise: generator } => noise(*generator, p).powi(3),
            Kind::Fractal(settings) => fractal::value(settings, p),
            Kind::Function(function) => geometric::above_one_wraps(function.eval(&p.to_array())),
            Kind::Gradient { direction } => geometric::above_one_wraps(p.dot(*direction)),
            Kind::Granite { noise } => noisy::granite(p, *noise),
            Kind::Hexagon => block::hexagon(p),
            Kind::Image(image) => image.pattern_value(p),
            Kind::Leopard => geometric::leopard(p),
            Kind::Marble { noise, turbulence } => p.x + turbulence.along_x(*noise, p),
            Kind::Object(object) => f64::from(object.0.inside(p)),
            Kind::Onion => fraction(p.length()),
            Kind::Pavement(pavement) => pavement.value(p.x, p.z),
            Kind::Pigment(pigment) => f64::from(grey(pigment.ask(p, context).0.rgb)),
            Kind::Planar => geometric::falling(p.y.abs()),
            Kind::Quilted { controls } => geometric::quilted(p, *controls),
            Kind::Radial => geometric::radial(p),
            Kind::Ripples(waves) => waves.ripples_value(p),
            Kind::Slope(slope) => slope.value(p, context),
            Kind::Spherical => geometric::falling(p.length()),
            Kind::Spiral1 { arms, noise, turbulence } => noisy::spiral(p, *arms, *noise, turbulence),
            Kind::Spiral2 { arms, noise, turbulence } => {
                wave::triangle(p.truncate().length())
                    + wave::triangle(noisy::spiral(p, *arms, *noise, turbulence))
            }
            Kind::Square => block::square(p),
            Kind::Tiling(tiling) => tiling.value(p.x, p.z),
            Kind::Triangular => block::triangular(p),
            Kind::Waves(waves) => waves.waves_value(p),
            Kind::Wood { turbulence } => noisy::wood(p, turbulence),
            Kind::Wrinkles { noise } => noisy::wrinkles(p, *noise),
        }
    }
}
