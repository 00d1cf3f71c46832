//! `tiling`: 27 ways to cover the plane of x and z with regular pieces (textures spec, section 4.2).
mod dodecagon;
mod penrose;
mod pentagon;
mod periodic;
mod table;

use dodecagon::Dodecagons;
use penrose::Penrose;
use periodic::Periodic;

/// Keeps classes apart where the value stands between them.
const EPS6: f64 = 1e-6;

/// A compiled `tiling`.
#[derive(Debug)]
pub(super) enum Tiling {
    Periodic(Box<Periodic>),
    Dodecagons(Dodecagons),
    Pentagons,
    Penrose(Penrose),
}

impl Tiling {
    /// Tiling 1 to 27.
    pub fn new(number: u8) -> Option<Tiling> {
        Some(match number {
            1..=21 => Tiling::Periodic(Box::new(Periodic::new(&table::TILINGS[usize::from(number) - 1]))),
            22 => Tiling::Dodecagons(Dodecagons::WithTriangles),
            23 => Tiling::Dodecagons(Dodecagons::WithSquares { classes: 1 }),
            24 => Tiling::Dodecagons(Dodecagons::WithSquares { classes: 3 }),
            25 => Tiling::Pentagons,
            26 => Tiling::Penrose(Penrose::Kites),
            27 => Tiling::Penrose(Penrose::Rhombs),
            _ => return None,
        })
    }

    /// `(class + nearness to an edge) / classes`.
    pub fn value(&self, x: f64, z: f64) -> f64 {
        match self {
            Tiling::Periodic(periodic) => periodic.value(x, z),
            Tiling::Dodecagons(dodecagons) => dodecagons.value(x, z),
            Tiling::Pentagons => pentagon::value(x, z),
            Tiling::Penrose(penrose) => penrose.value(x, z),
        }
    }
}
