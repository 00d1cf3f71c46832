//! The numbered internal functions: what `internal(n)` computes (language spec, section 3.4).
//!
//! [`TABLE`] registers each of them once. Parameters are numbered from 1, as in the manual's chapter on internal
//! functions.
mod curves;
mod helices;
mod lumps;
mod noises;
mod polynomials;

use crate::Internal;
use crate::builtin::{maximum, minimum};

/// The point and the parameters of a call.
#[derive(Clone, Copy)]
pub(crate) struct Args {
    x: f64,
    y: f64,
    z: f64,
    /// `p[1]` is the first parameter; `p[0]` is not used.
    p: [f64; 11],
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

    /// The squares of the coordinates.
    fn squares(&self) -> (f64, f64, f64) {
        (self.x * self.x, self.y * self.y, self.z * self.z)
    }

    /// The squared distance from the origin.
    fn r2(&self) -> f64 {
        let (x2, y2, z2) = self.squares();
        x2 + y2 + z2
    }

    /// A field of strength `p[1]`, kept within -10 and 10; not-a-number gives -10.
    fn field(&self, e: f64) -> f64 {
        minimum(maximum(-10.0, self.p[1] * e), 10.0)
    }

    /// Sweeps a plane curve around the y axis if parameter `first` says so: the two that follow are the curve's offset
    /// from the axis and its turn in degrees.
    fn swept(mut self, first: usize) -> Args {
        let (switch, offset, degrees) = (self.p[first], self.p[first + 1], self.p[first + 2]);
        if switch > 0.0 {
            let rho = length(self.x, self.z) - offset;
            if degrees != 0.0 {
                (self.x, self.y) = turned(rho, self.y, degrees.to_radians());
            } else {
                self.x = rho;
            }
        }
        self
    }
}

/// The length of the vector (x, y). Faster than `f64::hypot`, which also minds overflow.
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// The point (x, y) turned by an angle in radians.
fn turned(x: f64, y: f64, angle: f64) -> (f64, f64) {
    let (sin, cos) = angle.sin_cos();
    (x * cos - y * sin, x * sin + y * cos)
}

/// An internal function as code.
pub(crate) type InternalFn = fn(&Args) -> f64;

/// Name without its `f_`, number of parameters after x, y, z, and the code.
type Entry = (&'static str, usize, InternalFn);

/// What numbers without a function give.
fn nothing(_: &Args) -> f64 {
    0.0
}

impl Internal {
    /// `f_noise3d`: noise of the scene's generator.
    pub const NOISE: Internal = Internal(76);
    /// `f_noise_generator`: noise of the generator that the parameter names.
    pub(crate) const NOISE_OF_GENERATOR: Internal = Internal(78);

    /// How many arguments it takes, x, y and z among them; `None` if there is no such function.
    pub fn params(self) -> Option<usize> {
        TABLE.get(usize::from(self.0)).filter(|e| !e.0.is_empty()).map(|e| 3 + e.1)
    }

    /// Its name in the standard include file, without the leading `f_`.
    pub fn name(self) -> Option<&'static str> {
        TABLE.get(usize::from(self.0)).map(|e| e.0).filter(|name| !name.is_empty())
    }

    /// The code and the number of arguments.
    pub(crate) fn implementation(self) -> (InternalFn, usize) {
        TABLE.get(usize::from(self.0)).map_or((nothing, 3), |e| (e.2, 3 + e.1))
    }
}

use {curves as c, helices as h, lumps as l, noises as n, polynomials as p};

/// All internal functions by number.
#[rustfmt::skip]
const TABLE: [Entry; 79] = [
    ("algbr_cyl1", 5, c::algbr_cyl1), ("algbr_cyl2", 5, c::algbr_cyl2), ("algbr_cyl3", 5, c::algbr_cyl3),
    ("algbr_cyl4", 5, c::algbr_cyl4), ("bicorn", 2, p::bicorn), ("bifolia", 2, p::bifolia),
    ("blob", 5, l::blob), ("blob2", 4, l::blob2), ("boy_surface", 2, p::boy_surface), ("comma", 1, l::comma),
    ("cross_ellipsoids", 4, l::cross_ellipsoids), ("crossed_trough", 1, p::crossed_trough),
    ("cubic_saddle", 1, p::cubic_saddle), ("cushion", 1, p::cushion), ("devils_curve", 1, p::devils_curve),
    ("devils_curve_2d", 6, c::devils_curve_2d), ("dupin_cyclid", 6, p::dupin_cyclid),
    ("ellipsoid", 3, l::ellipsoid), ("enneper", 1, p::enneper), ("flange_cover", 4, l::flange_cover),
    ("folium_surface", 3, p::folium_surface), ("folium_surface_2d", 6, c::folium_surface_2d),
    ("glob", 1, p::glob), ("heart", 1, p::heart), ("helical_torus", 10, h::helical_torus),
    ("helix1", 7, h::helix1), ("helix2", 7, h::helix2), ("hex_x", 1, l::hex_x), ("hex_y", 1, l::hex_y),
    ("hetero_mf", 6, n::hetero_mf), ("hunt_surface", 1, p::hunt_surface),
    ("hyperbolic_torus", 3, p::hyperbolic_torus), ("isect_ellipsoids", 4, l::isect_ellipsoids),
    ("kampyle_of_eudoxus", 3, p::kampyle_of_eudoxus), ("kampyle_of_eudoxus_2d", 6, c::kampyle_of_eudoxus_2d),
    ("klein_bottle", 1, p::klein_bottle), ("kummer_surface_v1", 1, p::kummer_surface_v1),
    ("kummer_surface_v2", 4, p::kummer_surface_v2), ("lemniscate_of_gerono", 1, p::lemniscate_of_gerono),
    ("lemniscate_of_gerono_2d", 6, c::lemniscate_of_gerono_2d), ("mesh1", 5, l::mesh1), ("mitre", 1, p::mitre),
    ("nodal_cubic", 1, p::nodal_cubic), ("odd", 1, p::cushion), ("ovals_of_cassini", 4, p::ovals_of_cassini),
    ("paraboloid", 1, p::paraboloid), ("parabolic_torus", 3, p::parabolic_torus), ("ph", 0, l::ph),
    ("pillow", 1, p::pillow), ("piriform", 1, p::piriform), ("piriform_2d", 7, c::piriform_2d),
    ("poly4", 5, l::poly4), ("polytubes", 6, h::polytubes), ("quantum", 1, l::quantum),
    ("quartic_paraboloid", 1, p::quartic_paraboloid), ("quartic_saddle", 1, p::quartic_saddle),
    ("quartic_cylinder", 3, p::quartic_cylinder), ("r", 0, l::r), ("ridge", 6, n::ridge),
    ("ridged_mf", 6, n::ridged_mf), ("rounded_box", 4, l::rounded_box), ("sphere", 1, l::sphere),
    ("spikes", 5, l::spikes), ("spikes_2d", 4, l::spikes_2d), ("spiral", 6, h::spiral),
    ("steiners_roman", 1, p::steiners_roman), ("strophoid", 4, p::strophoid), ("strophoid_2d", 7, c::strophoid_2d),
    ("superellipsoid", 2, l::superellipsoid), ("th", 0, l::th), ("torus", 2, l::torus), ("torus2", 3, p::torus2),
    ("torus_gumdrop", 1, p::torus_gumdrop), ("umbrella", 1, p::umbrella), ("witch_of_agnesi", 2, p::witch_of_agnesi),
    ("witch_of_agnesi_2d", 6, c::witch_of_agnesi_2d), ("noise3d", 0, nothing), ("", 0, nothing),
    ("noise_generator", 1, n::noise_generator),
];
