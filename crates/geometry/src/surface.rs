//! What every shape can answer, in its own coordinates.
use raggio_math::{Aabb, Ray, Vec2, Vec3};

/// A hit in a shape's own coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LocalHit {
    /// Distance along the (unit) direction.
    pub t: f64,
    /// Which part: face, segment, cap, triangle; the shape's own numbering.
    pub part: u32,
    /// The shape's own parameters of the place (barycentric, curve parameter ...).
    pub u: f64,
    /// See `u`.
    pub v: f64,
}

impl LocalHit {
    /// A hit of a shape that needs no words of its own.
    #[inline]
    pub fn at(t: f64) -> Self {
        LocalHit { t, ..LocalHit::default() }
    }
}

/// A shape, ready to be hit. Rays come in the shape's own coordinates with a direction of unit length; distances are
/// in those coordinates.
pub trait Surface: Send + Sync {
    /// A box around its surface, infinite where it has no bounds.
    fn bounds(&self) -> Aabb;
    /// How far it reaches along a vector: no less than the greatest dot product with its points; `None` where nothing is
    /// known but its box. Boxes of shapes that have been turned lie closer with it.
    fn reach(&self, _along: Vec3) -> Option<f64> {
        None
    }
    /// A box around its inside, where that is not the box of the surface (half spaces behind a disc, the ground under
    /// a height field).
    fn inside_bounds(&self) -> Aabb {
        self.bounds()
    }
    /// Appends every hit with `range.0 < t < range.1`, in any order. Solids report entry and exit.
    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>);
    /// The nearest of [`Surface::hits`].
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let mut all = Vec::new();
        self.hits(ray, range, &mut all);
        all.into_iter().min_by(|a, b| a.t.total_cmp(&b.t))
    }
    /// The nearest of [`Surface::hits`] that `counts` says yes to, given its distance; `None` where the shape has no
    /// quicker way than to look at all of them.
    fn closest_counted(
        &self,
        _ray: &Ray,
        _range: (f64, f64),
        _counts: &mut dyn FnMut(f64) -> bool,
    ) -> Option<Option<LocalHit>> {
        None
    }
    /// Is the point inside? Always false for shapes without an inside.
    fn inside(&self, p: Vec3) -> bool;
    /// Has the shape an inside at all (can it be a member of an intersection)?
    fn is_solid(&self) -> bool {
        true
    }
    /// The raw outward normal at a hit, unit length.
    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3;
    /// Texture coordinates by the shape's own rule; `None` takes x and y of the world point.
    fn uv(&self, _p: Vec3, _hit: &LocalHit) -> Option<Vec2> {
        None
    }
}
