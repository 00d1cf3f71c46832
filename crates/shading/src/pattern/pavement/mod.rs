//! `pavement`: tiles grown from equal squares, triangles or hexagons (textures spec, section 4.3).
mod square;
mod table;
mod triangle;

use table::{SHAPES, ShapeData};

/// A compiled `pavement`.
#[derive(Debug)]
pub(super) struct Pavement {
    shape: Shape,
    style: Style,
}

/// How edges and corners are rounded off.
#[derive(Clone, Copy, Debug)]
struct Style {
    exterior: u8,
    interior: u8,
    form: u8,
}

/// One of the tiles.
#[derive(Clone, Copy)]
struct Shape(&'static ShapeData);

impl std::fmt::Debug for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Shape{:?}", self.0.id)
    }
}

impl Shape {
    fn sides(self) -> u8 {
        self.0.id.0
    }

    /// Which of the sides and corners of a cell belong to the outline of its tile.
    fn code(self, i: i64, j: i64) -> u32 {
        let columns = i64::from(self.0.columns);
        let rows = self.0.codes.len() as i64 / columns;
        let block = j.div_euclid(rows);
        let column = i.wrapping_sub(block.wrapping_mul(i64::from(self.0.shift))).rem_euclid(columns);
        u32::from(self.0.codes[(j.rem_euclid(rows) * columns + column) as usize])
    }
}

impl Pavement {
    /// `id` holds number of sides, number of tiles, and pattern; `None` for one that does not exist.
    pub fn new(id: (u8, u8, u8), exterior: u8, interior: u8, form: u8) -> Option<Self> {
        let shape = SHAPES.iter().find(|shape| shape.id == id)?;
        let forms = if id.0 == 4 { 4 } else { 3 };
        let style = Style { exterior: exterior % 3, interior: interior % 3, form: form % forms };
        Some(Pavement { shape: Shape(shape), style })
    }

    /// 0 in the middle of a tile, 1 at its edge.
    pub fn value(&self, x: f64, z: f64) -> f64 {
        if self.shape.sides() == 4 {
            square::value(self.shape, self.style, x, z)
        } else {
            triangle::value(self.shape, self.style, x, z)
        }
    }
}
