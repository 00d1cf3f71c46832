//! The numbered internal functions: what `internal(n)` computes (language spec, section 3.4).
//!
//! [`TABLE`] registers each of them once. Parameters are numbered from 1, as in the manual's chapter on internal
//! functions.
mod branches;
mod helices;
mod noises;
mod over_bounds;
mod over_numbers;

pub(crate) use noises::generator_number;

use crate::Internal;
use crate::bounds::Bounds;
use over_numbers::{length, turned};

/// The point and the parameters of a call; native code writes its fields in their order.
#[derive(Clone, Copy)]
#[repr(C)]
pub(crate) struct Args<N = f64> {
    pub(crate) x: N,
    pub(crate) y: N,
    pub(crate) z: N,
    /// `p[1]` is the first parameter; `p[0]` is not used.
    pub(crate) p: [f64; 11],
}

impl Args {
    /// From the registers of x, y, z and the parameters in their order; missing ones are 0.
    #[inline]
    pub(crate) fn gather(registers: &[u32], get: impl Fn(u32) -> f64) -> Self {
        let at = |i: usize| registers.get(i).map_or(0.0, |&r| get(r));
        let mut p = [0.0; 11];
        for (slot, &r) in p[1..].iter_mut().zip(registers.get(3..).unwrap_or(&[])) {
            *slot = get(r);
        }
        Args { x: at(0), y: at(1), z: at(2), p }
    }
}

/// An internal function as code.
pub(crate) type InternalFn = fn(&Args) -> f64;

/// What is known of an internal function.
pub(crate) struct Entry {
    /// Without its `f_`.
    name: &'static str,
    /// How many parameters there are after x, y, z.
    parameters: usize,
    /// Its value.
    pub(crate) value: InternalFn,
    /// Its bounds over bounds of the point, if anything is known of them.
    pub(crate) bounds: Option<fn(&Args<Bounds>) -> Bounds>,
}

static NOTHING: Entry = Entry { name: "", parameters: 0, value: noises::nothing, bounds: None };

impl Internal {
    /// `f_noise3d`: noise of the scene's generator.
    pub const NOISE: Internal = Internal(76);
    /// `f_noise_generator`: noise of the generator that the parameter names.
    pub(crate) const NOISE_OF_GENERATOR: Internal = Internal(78);

    /// How many arguments it takes, x, y and z among them; `None` if there is no such function.
    pub fn params(self) -> Option<usize> {
        self.name().map(|_| 3 + self.entry().parameters)
    }

    /// Its name in the standard include file, without the leading `f_`.
    pub fn name(self) -> Option<&'static str> {
        Some(self.entry().name).filter(|name| !name.is_empty())
    }

    /// What is known of it.
    pub(crate) fn entry(self) -> &'static Entry {
        TABLE.get(usize::from(self.0)).unwrap_or(&NOTHING)
    }

    /// The code and the number of arguments.
    pub(crate) fn implementation(self) -> (&'static Entry, usize) {
        (self.entry(), 3 + self.entry().parameters)
    }
}

/// A table of entries: name, number of parameters, and the code, found in its module. The code of `both` modules is
/// written once for numbers and for bounds.
macro_rules! table {
    ($($kind:ident $name:literal $parameters:literal $module:ident::$f:ident;)*) => {
        [$(Entry { name: $name, parameters: $parameters, value: table!(value $kind $module $f), bounds: table!(bounds $kind $module $f) },)*]
    };
    (value both $module:ident $f:ident) => { over_numbers::$module::$f };
    (bounds both $module:ident $f:ident) => { Some(over_bounds::$module::$f) };
    (value noise $module:ident $f:ident) => { $module::$f };
    (bounds noise $module:ident $f:ident) => { Some(over_bounds::$f) };
    (value plain $module:ident $f:ident) => { $module::$f };
    (bounds plain $module:ident $f:ident) => { None };
}

/// All internal functions by number.
#[rustfmt::skip]
static TABLE: [Entry; 79] = table! {
    both "algbr_cyl1" 5 curves::algbr_cyl1;
    both "algbr_cyl2" 5 curves::algbr_cyl2;
    both "algbr_cyl3" 5 curves::algbr_cyl3;
    both "algbr_cyl4" 5 curves::algbr_cyl4;
    both "bicorn" 2 polynomials::bicorn;
    both "bifolia" 2 polynomials::bifolia;
    both "blob" 5 lumps::blob;
    both "blob2" 4 lumps::blob2;
    both "boy_surface" 2 polynomials::boy_surface;
    plain "comma" 1 branches::comma;
    both "cross_ellipsoids" 4 lumps::cross_ellipsoids;
    both "crossed_trough" 1 polynomials::crossed_trough;
    both "cubic_saddle" 1 polynomials::cubic_saddle;
    both "cushion" 1 polynomials::cushion;
    both "devils_curve" 1 polynomials::devils_curve;
    both "devils_curve_2d" 6 curves::devils_curve_2d;
    both "dupin_cyclid" 6 polynomials::dupin_cyclid;
    both "ellipsoid" 3 lumps::ellipsoid;
    plain "enneper" 1 branches::enneper;
    both "flange_cover" 4 lumps::flange_cover;
    both "folium_surface" 3 polynomials::folium_surface;
    both "folium_surface_2d" 6 curves::folium_surface_2d;
    both "glob" 1 polynomials::glob;
    both "heart" 1 polynomials::heart;
    plain "helical_torus" 10 helices::helical_torus;
    plain "helix1" 7 helices::helix1;
    plain "helix2" 7 helices::helix2;
    plain "hex_x" 1 branches::hex_x;
    plain "hex_y" 1 branches::hex_y;
    both "hetero_mf" 6 fractals::hetero_mf;
    both "hunt_surface" 1 polynomials::hunt_surface;
    both "hyperbolic_torus" 3 polynomials::hyperbolic_torus;
    both "isect_ellipsoids" 4 lumps::isect_ellipsoids;
    both "kampyle_of_eudoxus" 3 polynomials::kampyle_of_eudoxus;
    both "kampyle_of_eudoxus_2d" 6 curves::kampyle_of_eudoxus_2d;
    both "klein_bottle" 1 polynomials::klein_bottle;
    both "kummer_surface_v1" 1 polynomials::kummer_surface_v1;
    both "kummer_surface_v2" 4 polynomials::kummer_surface_v2;
    both "lemniscate_of_gerono" 1 polynomials::lemniscate_of_gerono;
    both "lemniscate_of_gerono_2d" 6 curves::lemniscate_of_gerono_2d;
    both "mesh1" 5 lumps::mesh1;
    both "mitre" 1 polynomials::mitre;
    both "nodal_cubic" 1 polynomials::nodal_cubic;
    both "odd" 1 polynomials::cushion;
    both "ovals_of_cassini" 4 polynomials::ovals_of_cassini;
    both "paraboloid" 1 polynomials::paraboloid;
    both "parabolic_torus" 3 polynomials::parabolic_torus;
    both "ph" 0 lumps::ph;
    both "pillow" 1 polynomials::pillow;
    both "piriform" 1 polynomials::piriform;
    both "piriform_2d" 7 curves::piriform_2d;
    both "poly4" 5 lumps::poly4;
    plain "polytubes" 6 helices::polytubes;
    both "quantum" 1 lumps::quantum;
    both "quartic_paraboloid" 1 polynomials::quartic_paraboloid;
    both "quartic_saddle" 1 polynomials::quartic_saddle;
    both "quartic_cylinder" 3 polynomials::quartic_cylinder;
    both "r" 0 lumps::r;
    both "ridge" 6 fractals::ridge;
    both "ridged_mf" 6 fractals::ridged_mf;
    both "rounded_box" 4 lumps::rounded_box;
    both "sphere" 1 lumps::sphere;
    both "spikes" 5 lumps::spikes;
    both "spikes_2d" 4 lumps::spikes_2d;
    plain "spiral" 6 helices::spiral;
    both "steiners_roman" 1 polynomials::steiners_roman;
    both "strophoid" 4 polynomials::strophoid;
    both "strophoid_2d" 7 curves::strophoid_2d;
    both "superellipsoid" 2 lumps::superellipsoid;
    both "th" 0 lumps::th;
    both "torus" 2 lumps::torus;
    both "torus2" 3 polynomials::torus2;
    both "torus_gumdrop" 1 polynomials::torus_gumdrop;
    both "umbrella" 1 polynomials::umbrella;
    both "witch_of_agnesi" 2 polynomials::witch_of_agnesi;
    both "witch_of_agnesi_2d" 6 curves::witch_of_agnesi_2d;
    plain "noise3d" 0 noises::nothing;
    plain "" 0 noises::nothing;
    noise "noise_generator" 1 noises::noise_generator;
};
