//! From a scene's pattern to the compiled one.
use raggio_geometry::Geometry;
use raggio_math::{EPS, Vec2, Vec3};
use raggio_scene::{self as scene, PatternKind, Warp};

use super::crackle::Crackle;
use super::noisy::Turbulence;
use super::pavement::Pavement;
use super::ripples::Waves;
use super::slope::Slope;
use super::tiling::Tiling;
use super::wave::Waveform;
use super::{Inside, Kind, Pattern};
use crate::compiler::Compiler;
use crate::image::Image;
use crate::warp::WarpList;

impl Compiler {
    /// Compiles a pattern and what hangs on it.
    pub(crate) fn pattern(&mut self, pattern: &scene::Pattern) -> Pattern {
        Pattern {
            kind: self.kind(pattern),
            warps: WarpList::compile(acting_warps(pattern)),
            wave: Waveform::of(pattern),
        }
    }

    /// One whose value nobody asks: it only moves the point.
    pub(crate) fn mover(&mut self, pattern: &scene::Pattern) -> Pattern {
        Pattern {
            kind: Kind::Zero,
            warps: WarpList::compile(acting_warps(pattern)),
            wave: Waveform::of(pattern),
        }
    }

    fn kind(&mut self, pattern: &scene::Pattern) -> Kind {
        let noise = self.generator(pattern);
        let turbulence = own_turbulence(pattern);
        match &pattern.kind {
            PatternKind::Average | PatternKind::Facets { .. } => Kind::Zero,
            PatternKind::Agate { turbulence: strength } => {
                Kind::Agate { noise, turbulence, strength: f64::from(*strength) }
            }
            PatternKind::Aoi => Kind::Aoi,
            PatternKind::Boxed => Kind::Boxed,
            PatternKind::Bozo => Kind::Bozo { noise },
            PatternKind::Brick { size, mortar } => {
                let gap = f64::from((f64::from(*mortar) - 2.0 * EPS) as f32);
                Kind::Brick { size: *size, mortar: Vec3::splat(gap) / *size, gap }
            }
            PatternKind::Cells => Kind::Cells,
            PatternKind::Checker => Kind::Checker,
            PatternKind::Crackle(settings) => Kind::Crackle(Box::new(Crackle::new(settings, noise))),
            PatternKind::Cubic => Kind::Cubic,
            PatternKind::Cylindrical => Kind::Cylindrical,
            PatternKind::DensityFile(file) => Kind::Density(file.clone()),
            PatternKind::Dents => Kind::Dents { noise },
            PatternKind::Fractal(settings) => Kind::Fractal(Box::new(*settings)),
            PatternKind::Function(function) => Kind::Function(function.clone()),
            PatternKind::Gradient(direction) => Kind::Gradient { direction: direction.normalize_or_zero() },
            PatternKind::Granite => Kind::Granite { noise },
            PatternKind::Hexagon => Kind::Hexagon,
            PatternKind::Image(image) => Kind::Image(Box::new(Image::compile(image))),
            PatternKind::Leopard => Kind::Leopard,
            PatternKind::Marble => Kind::Marble { noise, turbulence },
            // An object that cannot be built is reported where the scene's objects are; here it has no inside.
            PatternKind::Object(object) => Geometry::of_object(object)
                .map_or(Kind::Zero, |geometry| Kind::Object(Box::new(Inside(geometry)))),
            PatternKind::Onion => Kind::Onion,
            PatternKind::Pavement { sides, tiles, pattern, exterior, interior, form } => {
                Pavement::new((*sides, *tiles, *pattern), *exterior, *interior, *form)
                    .map_or(Kind::Zero, Kind::Pavement)
            }
            PatternKind::Pigment(pigment) => Kind::Pigment(self.shared_pigment(pigment)),
            PatternKind::Planar => Kind::Planar,
            PatternKind::Quilted { control0, control1 } => {
                Kind::Quilted { controls: Vec2::new(f64::from(*control0), f64::from(*control1)) }
            }
            PatternKind::Radial => Kind::Radial,
            PatternKind::Ripples => Kind::Ripples(Waves::of_one_frequency(pattern, self.noise.waves)),
            PatternKind::Slope(settings) => Kind::Slope(Box::new(Slope::new(settings))),
            PatternKind::Spherical => Kind::Spherical,
            PatternKind::Spiral1(arms) => Kind::Spiral1 { arms: f64::from(*arms), noise, turbulence },
            PatternKind::Spiral2(arms) => Kind::Spiral2 { arms: f64::from(*arms), noise, turbulence },
            PatternKind::Square => Kind::Square,
            PatternKind::Tiling(number) => Tiling::new(*number).map_or(Kind::Zero, Kind::Tiling),
            PatternKind::Triangular => Kind::Triangular,
            PatternKind::Waves => Kind::Waves(Waves::of_own_frequencies(pattern, self.noise.waves)),
            PatternKind::Wood => Kind::Wood { turbulence },
            PatternKind::Wrinkles => Kind::Wrinkles { noise },
        }
    }

    /// The pattern's own generator, or the scene's.
    pub(crate) fn generator(&self, pattern: &scene::Pattern) -> u8 {
        if pattern.noise_generator == 0 { self.noise.generator } else { pattern.noise_generator }
    }
}

/// The classic turbulence at the end of the list, which some formulas use themselves; without one its defaults.
fn own_turbulence(pattern: &scene::Pattern) -> Turbulence {
    Turbulence(match pattern.warps.last() {
        Some(Warp::ClassicTurbulence(turbulence)) => *turbulence,
        _ => scene::Turbulence::default(),
    })
}

/// Marble and wood use their turbulence inside the formula only; everything else is displaced by it.
fn acting_warps(pattern: &scene::Pattern) -> &[Warp] {
    match (&pattern.kind, pattern.warps.split_last()) {
        (PatternKind::Marble | PatternKind::Wood, Some((Warp::ClassicTurbulence(_), before))) => before,
        _ => &pattern.warps,
    }
}
