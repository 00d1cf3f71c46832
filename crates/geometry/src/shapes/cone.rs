//! The cone, and the cylinder as the cone of equal radii.
use raggio_math::{Aabb, Affine, EPS, Ray, Vec3};

use super::{Few, Stretch, beyond, clearly_beyond, start_along};
use crate::{LocalHit, Surface};

/// The least distance a cone reports.
const LEAST: f64 = 1e-9;

/// Parts of hits: the side, the cap at the base, the cap at the far end.
const SIDE: u32 = 0;
const BASE: u32 = 1;
const CAP: u32 = 2;

/// A cone between two radii; with radii of opposite sign a double cone through the point between.
#[derive(Clone, Copy)]
pub(crate) struct Cone {
    base: Vec3,
    /// Unit vector from base to cap.
    axis: Vec3,
    length: f64,
    base_radius: f64,
    cap_radius: f64,
    /// Growth of the radius per unit of height.
    slope: f64,
    open: bool,
}

impl Cone {
    pub(crate) fn new(base: Vec3, base_radius: f64, cap: Vec3, cap_radius: f64, open: bool) -> Self {
        let length = (cap - base).length();
        let axis = if length > 0.0 { (cap - base) / length } else { Vec3::Y };
        let slope = match (cap_radius - base_radius).abs() < EPS {
            true => 0.0,
            false => (cap_radius - base_radius) / length,
        };
        Cone { base, axis, length, base_radius, cap_radius, slope, open }
    }

    /// A cylinder; a negative radius counts as its absolute value.
    pub(crate) fn cylinder(base: Vec3, cap: Vec3, radius: f64, open: bool) -> Self {
        Cone::new(base, radius.abs(), cap, radius.abs(), open)
    }

    fn widest(&self) -> f64 {
        self.base_radius.abs().max(self.cap_radius.abs())
    }

    /// The same in other coordinates, in which all lengths are multiplied.
    pub(crate) fn moved(&self, there_from_here: &Affine, scale: f64) -> Self {
        let (base, axis) = (self.base, self.axis * self.length);
        Cone {
            base: there_from_here.transform_point3(base),
            axis: there_from_here.transform_vector3(axis).normalize_or(Vec3::Y),
            length: self.length * scale,
            base_radius: self.base_radius * scale,
            cap_radius: self.cap_radius * scale,
            ..*self
        }
    }

    /// Are all points beyond a plane along the axis that the widest part stays behind?
    pub(crate) fn misses(&self, hull: &[Vec3; 8]) -> bool {
        let (_, offset) = self.split(hull[0] - self.base);
        let Some(direction) = offset.try_normalize() else { return false };
        clearly_beyond(start_along(hull, direction), self.widest() + self.base.dot(direction))
    }

    /// Height over the base, and the offset from the axis.
    #[inline]
    fn split(&self, v: Vec3) -> (f64, Vec3) {
        let h = v.dot(self.axis);
        (h, v - self.axis * h)
    }

    /// Is it closed, and no double cone?
    pub(crate) fn is_convex(&self) -> bool {
        !self.open && self.base_radius >= 0.0 && self.cap_radius >= 0.0 && self.length > 0.0
    }

    /// Where the ray is inside a convex one; `None` where rounding has added or lost an end.
    #[inline]
    pub(crate) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let (mut ends, mut count) = ([0.0; 2], 0);
        self.crossings(ray, |t, _| {
            if count < 2 {
                ends[count] = t;
            }
            count += 1;
        });
        match count {
            0 => Some(Stretch::NOWHERE),
            2 => Some(Stretch::between(Some((ends[0].min(ends[1]), ends[0].max(ends[1]))))),
            _ => None,
        }
    }

    /// All hits within the range; at most a double cone's four.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        self.crossings(ray, |t, part| out.push(t, part, range));
    }

    /// Calls `found` with all hits of the line and their parts.
    #[inline]
    fn crossings(&self, ray: &Ray, mut found: impl FnMut(f64, u32)) {
        if self.widest() == 0.0 {
            return;
        }
        // Work from the point of the ray nearest to the middle: far origins lose no digits.
        let shift = (self.base + self.axis * (0.5 * self.length) - ray.origin).dot(ray.dir);
        let mut push = |t: f64, part: u32| found(t + shift, part);
        let (oh, offset) = self.split(ray.at(shift) - self.base);
        let (dh, across) = self.split(ray.dir);
        self.side(oh, offset, dh, across, &mut push);
        if !self.open && dh.abs() > EPS {
            for (height, radius, part) in [(0.0, self.base_radius, BASE), (self.length, self.cap_radius, CAP)]
            {
                let t = (height - oh) / dh;
                let there = (offset + across * t).length_squared() <= radius * radius;
                if there {
                    push(t, part);
                }
            }
        }
    }

    /// Hits of the side: where the distance from the axis is the radius at that height.
    #[inline]
    fn side(&self, oh: f64, offset: Vec3, dh: f64, across: Vec3, out: &mut impl FnMut(f64, u32)) {
        let (r, grow) = (self.base_radius + self.slope * oh, self.slope * dh);
        let a = across.length_squared() - grow * grow;
        let b = offset.dot(across) - r * grow;
        let c = offset.length_squared() - r * r;
        let mut push = |t: f64| {
            let h = oh + t * dh;
            if h >= 0.0 && h <= self.length {
                out(t, SIDE);
            }
        };
        if a.abs() < EPS * EPS {
            if b != 0.0 {
                push(-0.5 * c / b);
            }
            return;
        }
        let discriminant = b * b - a * c;
        if discriminant > 0.0 {
            let q = -(b + discriminant.sqrt().copysign(b));
            push(q / a);
            if q != 0.0 {
                push(c / q);
            }
        }
    }
}

impl Surface for Cone {
    fn bounds(&self) -> Aabb {
        let extent = (Vec3::ONE - self.axis * self.axis).max(Vec3::ZERO).map(f64::sqrt);
        let ring = |at: Vec3, radius: f64| {
            let e = extent * radius.abs();
            Aabb { min: at - e, max: at + e }
        };
        let cap = self.base + self.axis * self.length;
        ring(self.base, self.base_radius).union(&ring(cap, self.cap_radius))
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        let across = (along - self.axis * self.axis.dot(along)).length();
        let base = self.base.dot(along) + self.base_radius.abs() * across;
        let cap = (self.base + self.axis * self.length).dot(along) + self.cap_radius.abs() * across;
        Some(base.max(cap))
    }

    fn hits(&self, ray: &Ray, range: (f64, f64), out: &mut Vec<LocalHit>) {
        let mut few = Few::default();
        self.few(ray, range, &mut few);
        few.into_hits(out);
    }

    #[inline]
    fn closest(&self, ray: &Ray, range: (f64, f64)) -> Option<LocalHit> {
        let mut few = Few::default();
        self.few(ray, range, &mut few);
        few.pop_nearest()
    }

    /// A hair less than the solid if it has caps, a hair more if it is open: the rim of an open cone belongs to it, so what
    /// it cuts has no skin left where its end lies in the other's surface.
    fn inside(&self, p: Vec3) -> bool {
        let tolerance = if self.open { EPS } else { -EPS };
        let (h, offset) = self.split(p - self.base);
        let along = h / self.length;
        if !(along >= -tolerance && along <= 1.0 + tolerance) {
            return false;
        }
        let (r, widest) = (self.base_radius + self.slope * h, self.widest());
        offset.length_squared() <= r * r + tolerance * widest * widest
    }

    fn normal(&self, p: Vec3, hit: &LocalHit) -> Vec3 {
        match hit.part {
            BASE => -self.axis,
            CAP => self.axis,
            _ => {
                let (h, offset) = self.split(p - self.base);
                let r = self.base_radius + self.slope * h;
                (offset - self.axis * (r * self.slope)).normalize_or(self.axis)
            }
        }
    }
}
