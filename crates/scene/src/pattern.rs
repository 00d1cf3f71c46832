//! Patterns and warps: from a point to a number (textures spec, sections 2 to 7).
use std::sync::Arc;

use raggio_math::{Affine, Vec2, Vec3};

use crate::{Curve, Function, Mosaic, Object, Pigment};

/// A pattern with everything that happens before and after its formula.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// The formula.
    pub kind: PatternKind,
    /// What acts on the point before it, first to act first.
    pub warps: Vec<Warp>,
    /// Wave form applied to the value.
    pub wave: Wave,
    /// 0 leaves the value unwrapped.
    pub frequency: f32,
    /// Added after `frequency`.
    pub phase: f32,
    /// 1, 2 or 3; 0 takes the scene's.
    pub noise_generator: u8,
}

/// Wave forms.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Wave {
    Ramp,
    Triangle,
    Sine,
    Scallop,
    Cubic,
    Poly(f32),
}

/// Classic turbulence: amount per axis, octaves, omega, lambda.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Turbulence {
    pub amount: Vec3,
    /// 1..=10
    pub octaves: u32,
    pub omega: f32,
    pub lambda: f32,
}

impl Default for Turbulence {
    fn default() -> Self {
        Turbulence { amount: Vec3::ZERO, octaves: 6, omega: 0.5, lambda: 2.0 }
    }
}

/// Something that moves the point before a pattern looks at it.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Warp {
    /// A transform as written; the point goes through its inverse, which is stored with it.
    Transform {
        forward: Affine,
        inverse: Affine,
    },
    /// `turbulence`, `octaves` ... outside `warp { }`. Always the last of the list.
    ClassicTurbulence(Turbulence),
    /// `warp { turbulence }`
    Turbulence(Turbulence),
    Repeat {
        axis: u8,
        width: f32,
        flip: Vec3,
        offset: Vec3,
    },
    BlackHole {
        center: Vec3,
        radius: f64,
        strength: f64,
        falloff: f64,
        inverse: bool,
        /// Zero components do not repeat.
        repeat: Option<Vec3>,
        turbulence: Option<Vec3>,
    },
    Cylindrical {
        orientation: Vec3,
        dist_exp: f64,
    },
    Spherical {
        orientation: Vec3,
        dist_exp: f64,
    },
    Toroidal {
        orientation: Vec3,
        dist_exp: f64,
        major_radius: f64,
    },
    Planar {
        orientation: Vec3,
        distance: f64,
    },
    Cubic,
}

/// The formulas.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum PatternKind {
    /// Maps only: every entry counts by its weight.
    Average,
    Agate {
        turbulence: f32,
    },
    Aoi,
    Boxed,
    /// `bozo`, `spotted` and `bumps` are one formula.
    Bozo,
    Brick {
        size: Vec3,
        mortar: f32,
    },
    Cells,
    Checker,
    Crackle(CrackleSettings),
    Cubic,
    Cylindrical,
    DensityFile(Arc<DensityFile>),
    Dents,
    Facets {
        size: f64,
        coords: f64,
        metric: f64,
    },
    Fractal(FractalSettings),
    Function(Arc<Function>),
    Gradient(Vec3),
    Granite,
    Hexagon,
    Image(Arc<ImageMap>),
    Leopard,
    Marble,
    Object(Arc<Object>),
    Onion,
    Pavement {
        sides: u8,
        tiles: u8,
        pattern: u8,
        exterior: u8,
        interior: u8,
        form: u8,
    },
    Pigment(Arc<Pigment>),
    Planar,
    Quilted {
        control0: f32,
        control1: f32,
    },
    Radial,
    Ripples,
    Slope(SlopeSettings),
    Spherical,
    Spiral1(i32),
    Spiral2(i32),
    Square,
    /// 1..=27
    Tiling(u8),
    Triangular,
    Waves,
    Wood,
    Wrinkles,
}

/// `crackle` and its controls.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct CrackleSettings {
    pub form: Vec3,
    pub metric: f64,
    pub offset: f64,
    pub solid: bool,
}

impl Default for CrackleSettings {
    fn default() -> Self {
        CrackleSettings { form: Vec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false }
    }
}

/// Escape-time fractals.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct FractalSettings {
    pub kind: FractalKind,
    /// The constant of Julia forms; `None` for Mandelbrot forms.
    pub julia: Option<Vec2>,
    pub iterations: u32,
    pub exterior_type: u8,
    pub exterior_factor: f64,
    pub interior_type: u8,
    pub interior_factor: f64,
}

/// The iterated map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FractalKind {
    /// `z^e + c`, e in 2..=33
    Power(u8),
    /// `magnet 1`
    Magnet1,
    /// `magnet 2`
    Magnet2,
}

/// `slope { ... }`
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlopeSettings {
    /// The direction (not normalised), or the point looked at.
    pub direction: Vec3,
    /// Is `direction` a point?
    pub point_at: bool,
    /// Range of the slope that becomes 0..1; (0, 0) leaves it alone.
    pub slope_range: (f64, f64),
    /// `altitude`; `None` without it. Not normalised.
    pub altitude: Option<Vec3>,
    /// Range of the altitude that becomes 0..1; (0, 0) leaves it alone.
    pub altitude_range: (f64, f64),
}

/// A `density_file`: sizes and samples between 0 and 1, x fastest, then y, then z.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct DensityFile {
    pub size: [usize; 3],
    pub samples: Vec<f32>,
    /// 0 none, 1 trilinear, 2 tricubic.
    pub interpolation: u8,
}

/// An image with the options of `image_map`, `bump_map`, `image_pattern` and `material_map`.
#[derive(Clone, Debug)]
pub struct ImageMap {
    /// The picture.
    pub source: ImageSource,
    /// How a point becomes a place on the picture.
    pub map_type: MapType,
    /// No repetition.
    pub once: bool,
    /// Between pixels.
    pub interpolation: Interpolation,
    /// `smooth`, an addition: the mean of what one of the camera's pixels covers. Of pigments only.
    pub smooth: bool,
    /// `repeat u, v` and `offset u, v`
    pub repeat: Vec2,
    /// Shift in units of the picture.
    pub offset: Vec2,
    /// From the curve of the file's colours to the working space's; `None` leaves them alone. Alpha never converts.
    pub conversion: Option<(Curve, Curve)>,
    /// `premultiplied`, or what the file or format says.
    pub premultiplied: bool,
    /// `filter all` / `transmit all`
    pub filter_all: f32,
    /// See `filter_all`.
    pub transmit_all: f32,
    /// `filter n, f`: by palette index.
    pub filter_index: Vec<(u32, f32)>,
    /// `transmit n, t`: by palette index.
    pub transmit_index: Vec<(u32, f32)>,
    /// `use_index`, for bump maps and material maps.
    pub use_index: bool,
    /// `use_alpha`, for image patterns.
    pub use_alpha: bool,
}

impl ImageMap {
    /// A picture with the language's defaults and no conversion.
    pub fn new(mosaic: Mosaic) -> Self {
        ImageMap {
            source: ImageSource { mosaic: Arc::new(mosaic) },
            map_type: MapType::Planar,
            once: false,
            interpolation: Interpolation::None,
            smooth: false,
            repeat: Vec2::ONE,
            offset: Vec2::ZERO,
            conversion: None,
            premultiplied: false,
            filter_all: 0.0,
            transmit_all: 0.0,
            filter_index: Vec::new(),
            transmit_index: Vec::new(),
            use_index: false,
            use_alpha: false,
        }
    }
}

/// Where an image's samples come from. Functions have been sampled already.
#[derive(Clone, Debug)]
pub struct ImageSource {
    /// The samples, by rows or by tiles.
    pub mosaic: Arc<Mosaic>,
}

/// `map_type`
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum MapType {
    Planar,
    Spherical,
    Cylindrical,
    Torus,
}

/// `interpolate`
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Interpolation {
    None,
    Bilinear,
    Bicubic,
    NormalizedDistance,
}
