//! Where the hits of a search go: all of them, or only the nearest.
//!
//! A shape writes its search once, against [`Collect`]; the search asks for the interval that still matters and can
//! stop early when only the nearest hit is wanted.
use super::Few;
use crate::LocalHit;

/// Takes hits.
pub(crate) trait Collect {
    /// Are all hits wanted, not only the nearest?
    const ALL: bool = false;
    /// Hits are wanted in this open interval; it may shrink with each hit taken.
    fn range(&self) -> (f64, f64);
    /// Takes a hit if it lies in the range.
    fn push(&mut self, hit: LocalHit);
    /// Is it enough to know that there is a hit between two distances? Then it has been taken.
    #[inline]
    fn settles(&mut self, _from: f64, _to: f64) -> bool {
        false
    }
    /// Takes a hit; are farther ones still wanted?
    #[inline]
    fn take(&mut self, hit: LocalHit) -> bool {
        self.push(hit);
        hit.t < self.range().1
    }
}

/// Keeps every hit.
pub(crate) struct All<'a> {
    pub(crate) range: (f64, f64),
    pub(crate) out: &'a mut Vec<LocalHit>,
}

impl Collect for All<'_> {
    const ALL: bool = true;

    #[inline]
    fn range(&self) -> (f64, f64) {
        self.range
    }
    #[inline]
    fn push(&mut self, hit: LocalHit) {
        if self.range.0 < hit.t && hit.t < self.range.1 {
            self.out.push(hit);
        }
    }
}

/// Keeps the hits of a shape that has but a few.
pub(crate) struct AllOfFew<'a> {
    pub(crate) range: (f64, f64),
    pub(crate) out: &'a mut Few,
}

impl Collect for AllOfFew<'_> {
    const ALL: bool = true;

    #[inline]
    fn range(&self) -> (f64, f64) {
        self.range
    }
    #[inline]
    fn push(&mut self, hit: LocalHit) {
        self.out.push(hit.t, hit.part, self.range);
    }
}

/// Keeps the nearest hit.
pub(crate) struct Nearest {
    range: (f64, f64),
    best: Option<LocalHit>,
}

impl Nearest {
    pub(crate) fn new(range: (f64, f64)) -> Self {
        Nearest { range, best: None }
    }
    pub(crate) fn best(self) -> Option<LocalHit> {
        self.best
    }
}

impl Collect for Nearest {
    #[inline]
    fn range(&self) -> (f64, f64) {
        self.range
    }
    #[inline]
    fn push(&mut self, hit: LocalHit) {
        if self.range.0 < hit.t && hit.t < self.range.1 {
            self.range.1 = hit.t;
            self.best = Some(hit);
        }
    }
}

/// Keeps the nearest hit, or any that `stops` says yes to.
pub(crate) struct Enough<F> {
    pub(crate) nearest: Nearest,
    pub(crate) stops: F,
}

impl<F: FnMut(&LocalHit) -> bool> Collect for Enough<F> {
    #[inline]
    fn range(&self) -> (f64, f64) {
        self.nearest.range
    }
    #[inline]
    fn push(&mut self, hit: LocalHit) {
        self.nearest.push(hit);
    }
    #[inline]
    fn settles(&mut self, from: f64, to: f64) -> bool {
        let (range, hit) = (self.nearest.range, LocalHit::at(to));
        let settled = range.0 < from && to < range.1 && (self.stops)(&hit);
        if settled {
            self.nearest.push(hit);
        }
        settled
    }
}

/// Keeps the nearest hit that counts.
pub(crate) struct Counted<'a> {
    pub(crate) nearest: Nearest,
    /// Does the hit at a distance count?
    pub(crate) counts: &'a mut dyn FnMut(f64) -> bool,
}

impl Collect for Counted<'_> {
    #[inline]
    fn range(&self) -> (f64, f64) {
        self.nearest.range
    }
    #[inline]
    fn push(&mut self, hit: LocalHit) {
        let range = self.nearest.range;
        if range.0 < hit.t && hit.t < range.1 && (self.counts)(hit.t) {
            self.nearest.push(hit);
        }
    }
}

/// Hands on hits whose distances count from a start along the ray.
pub(crate) struct Offset<'a, C> {
    pub(crate) start: f64,
    pub(crate) to: &'a mut C,
}

impl<C: Collect> Collect for Offset<'_, C> {
    const ALL: bool = C::ALL;

    #[inline]
    fn range(&self) -> (f64, f64) {
        let range = self.to.range();
        (range.0 - self.start, range.1 - self.start)
    }
    #[inline]
    fn push(&mut self, hit: LocalHit) {
        self.to.push(LocalHit { t: hit.t + self.start, ..hit });
    }
}

/// Writes `hits`, `closest` and `closest_counted` of a [`crate::Surface`] for a shape with `fn search(&self, &Ray, &mut impl Collect)`.
/// The number is the least distance at which the shape reports a hit.
macro_rules! searched_from {
    ($least:expr) => {
        fn hits(&self, ray: &raggio_math::Ray, range: (f64, f64), out: &mut Vec<crate::LocalHit>) {
            let range = crate::shapes::beyond(range, $least);
            self.search(ray, &mut crate::shapes::collect::All { range, out });
        }
        fn closest(&self, ray: &raggio_math::Ray, range: (f64, f64)) -> Option<crate::LocalHit> {
            let mut nearest = crate::shapes::collect::Nearest::new(crate::shapes::beyond(range, $least));
            self.search(ray, &mut nearest);
            nearest.best()
        }
        fn closest_counted(
            &self,
            ray: &raggio_math::Ray,
            range: (f64, f64),
            counts: &mut dyn FnMut(f64) -> bool,
        ) -> Option<Option<crate::LocalHit>> {
            let nearest = crate::shapes::collect::Nearest::new(crate::shapes::beyond(range, $least));
            let mut counted = crate::shapes::collect::Counted { nearest, counts };
            self.search(ray, &mut counted);
            Some(counted.nearest.best())
        }
    };
}
pub(crate) use searched_from;
