//! A ray in the world, made ready once for all the boxes on its way.
use raggio_bvh::Slab;
use raggio_math::Ray;

/// A ray with what the tests of boxes need of it.
pub(crate) struct Probe {
    pub(crate) ray: Ray,
    pub(crate) slab: Slab,
}

impl Probe {
    #[inline]
    pub(crate) fn new(ray: &Ray) -> Self {
        Probe { ray: *ray, slab: Slab::new(ray) }
    }
}
