//! The cone, and the cylinder as the cone of equal radii.
use raggio_math::{Aabb, Affine, EPS, Ray, Vec3};

use super::quadric::two_roots;
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
    #[inline(always)]
    fn split(&self, v: Vec3) -> (f64, Vec3) {
        let h = v.dot(self.axis);
        (h, v - self.axis * h)
    }

    /// Is it closed, and no double cone?
    pub(crate) fn is_convex(&self) -> bool {
        let one_sided = self.base_radius >= 0.0 && self.cap_radius >= 0.0;
        !self.open && one_sided && self.widest() > 0.0 && self.length > 0.0
    }

    /// Where the ray, whose direction may be of any length, is inside a convex one.
    #[inline(always)]
    pub(crate) fn stretch(&self, ray: &Ray) -> Stretch {
        Stretch::between(self.ends(ray).map(|ends| ends.map(|(t, _)| t).into()))
    }

    /// Where the ray enters and leaves a convex one, by which parts: inside is between the planes of the caps, and within
    /// the side.
    #[inline(always)]
    fn ends(&self, ray: &Ray) -> Option<[(f64, u32); 2]> {
        // Work from the point of the ray nearest to the middle: far origins lose no digits.
        let to_middle = self.base + self.axis * (0.5 * self.length) - ray.origin;
        let shift = to_middle.dot(ray.dir) / ray.dir.length_squared();
        let (oh, offset) = self.split(ray.at(shift) - self.base);
        let (dh, across) = self.split(ray.dir);
        let caps = match dh != 0.0 {
            true if dh > 0.0 => (-oh / dh, (self.length - oh) / dh),
            true => ((self.length - oh) / dh, -oh / dh),
            false if oh >= 0.0 && oh <= self.length => (f64::NEG_INFINITY, f64::INFINITY),
            false => return None,
        };
        let (enter, leave) = self.held_by_side(caps, self.side_along(oh, offset, dh, across), dh);
        let (first, last) = if dh > 0.0 { (BASE, CAP) } else { (CAP, BASE) };
        let part = |t: f64, plane: f64, cap: u32| if t == plane { cap } else { SIDE };
        (enter < leave).then_some([
            (enter + shift, part(enter, caps.0, first)),
            (leave + shift, part(leave, caps.1, last)),
        ])
    }

    /// What the side leaves of the way between the planes of the caps.
    #[inline(always)]
    fn held_by_side(&self, caps: (f64, f64), (a, b, c): (f64, f64, f64), dh: f64) -> (f64, f64) {
        const NOWHERE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);
        let after = |t: f64| (if t > caps.0 { t } else { caps.0 }, caps.1);
        let before = |t: f64| (caps.0, if t < caps.1 { t } else { caps.1 });
        if a.abs() < EPS * EPS {
            return match b {
                0.0 if c > 0.0 => NOWHERE,
                0.0 => caps,
                _ if b > 0.0 => before(-0.5 * c / b),
                _ => after(-0.5 * c / b),
            };
        }
        let Some((first, last)) = two_roots(a, b, c) else {
            return if a > 0.0 { NOWHERE } else { caps };
        };
        if a > 0.0 {
            return (after(first).0, before(last).1);
        }
        // Steeper than the side: inside beyond one end, and beyond the other inside the cone's mirror image.
        if self.slope * dh > 0.0 { after(last) } else { before(first) }
    }

    /// All hits within the range; at most a double cone's four.
    #[inline]
    pub(crate) fn few(&self, ray: &Ray, range: (f64, f64), out: &mut Few) {
        let range = beyond(range, LEAST);
        if !self.is_convex() {
            return self.crossings(ray, |t, part| out.push(t, part, range));
        }
        if let Some(ends) = self.ends(ray) {
            ends.into_iter().for_each(|(t, part)| out.push(t, part, range));
        }
    }

    /// Calls `found` with all hits of the line and their parts, for all kinds.
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

    /// `a`, `b`, `c` of how much the square of the distance from the axis is greater than that of the radius:
    /// `a t^2 + 2 b t + c`.
    #[inline(always)]
    fn side_along(&self, oh: f64, offset: Vec3, dh: f64, across: Vec3) -> (f64, f64, f64) {
        let (r, grow) = (self.base_radius + self.slope * oh, self.slope * dh);
        (
            across.length_squared() - grow * grow,
            offset.dot(across) - r * grow,
            offset.length_squared() - r * r,
        )
    }

    /// Hits of the side: where the distance from the axis is the radius at that height.
    #[inline]
    fn side(&self, oh: f64, offset: Vec3, dh: f64, across: Vec3, out: &mut impl FnMut(f64, u32)) {
        let (a, b, c) = self.side_along(oh, offset, dh, across);
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
        if self.is_convex() {
            let (lo, hi) = beyond(range, LEAST);
            let [enter, leave] = self.ends(ray)?;
            let (t, part) = if enter.0 > lo { enter } else { leave };
            return (t > lo && t < hi).then(|| LocalHit { part, ..LocalHit::at(t) });
        }
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
