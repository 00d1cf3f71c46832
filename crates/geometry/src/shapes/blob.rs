//! The blob: a level surface of the sum of fields around balls and rounded rods (shapes spec, section 4).
//!
//! Along a ray each component adds `strength * u^2` on a span where `u`, a quadratic, is positive. Between the ends of
//! spans the sum is a quartic; it is made in Bernstein form, where most segments are seen at once to have no root.
use raggio_math::{Aabb, Affine, Ray, Vec3, poly, transform};
use raggio_scene::{BlobComponent, BlobShape};
use smallvec::SmallVec;

use super::collect::{Collect, searched_from};
use super::parts::Parts;
use crate::shape_pool::uniform_scale;
use crate::texturing::PartUses;
use crate::{LocalHit, Surface};

mod reach;

/// Blobs report no hit nearer than this, in the world.
const LEAST: f64 = 1e-2;
/// Field values this little below the threshold count as inside.
const TOLERANCE: f64 = 1e-6;

/// A blob, ready to be hit.
pub(crate) struct Blob {
    threshold: f64,
    elements: Vec<Element>,
    parts: Parts,
    /// Around the surface.
    bounds: Aabb,
    /// So long are the parts of a ray that are searched one after another.
    stretch: f64,
}

/// Blobs of so many components are searched at once.
const FEW: usize = 16;
/// Parts of a ray are as long as this share of the blob.
const STRETCH: f64 = 0.1;

/// The box around all that the components of a blob act in.
pub(crate) fn acting(blob: &raggio_scene::Blob) -> Aabb {
    let boxes = blob.components.iter().map(|c| Element::new(c, &Affine::IDENTITY).bounds());
    boxes.filter(|b| !b.is_empty()).fold(Aabb::EMPTY, |all, b| all.union(&b))
}

/// A component.
#[derive(Clone, Copy, Debug)]
struct Element {
    strength: f64,
    form: Form,
}

/// What a component is the field of.
#[derive(Clone, Copy, Debug)]
enum Form {
    /// A ball that is round where rays are asked.
    Ball { centre: Vec3, per_radius2: f64 },
    /// Anything else, in a frame of its own where its radius is 1: a ball about the origin, or a rod from the origin along
    /// z.
    Placed {
        unit_from_blob: Affine,
        /// Length of a rod in radii; 0 for a ball.
        length: f64,
    },
}

/// Where a component acts along a ray: on `from..to`, with `u(t) = peak - bend (t - middle)^2`.
#[derive(Clone, Copy, Debug)]
struct Span {
    from: f64,
    to: f64,
    strength: f64,
    peak: f64,
    bend: f64,
    middle: f64,
}

type Spans = SmallVec<[Span; 16]>;

impl Element {
    fn new(component: &BlobComponent, world_from_blob: &Affine) -> Self {
        let component_from_blob = (*world_from_blob * component.blob_from_component).inverse();
        let (unit_from_component, length) = match component.shape {
            BlobShape::Sphere { center, radius } => {
                (transform::scale(Vec3::splat(1.0 / radius)) * transform::translate(-center), 0.0)
            }
            BlobShape::Cylinder { base, cap, radius } => {
                let axis = (cap - base).try_normalize().unwrap_or(Vec3::Z);
                let (x, y) = axis.any_orthonormal_pair();
                let upright = Affine::from_mat3(raggio_math::Mat3::from_cols(x, y, axis).transpose());
                let to_unit =
                    transform::scale(Vec3::splat(1.0 / radius)) * upright * transform::translate(-base);
                (to_unit, (cap - base).length() / radius)
            }
        };
        let unit_from_blob = unit_from_component * component_from_blob;
        let form = match uniform_scale(&unit_from_blob) {
            Some(scale) if length == 0.0 && scale > 0.0 => {
                let centre = unit_from_blob.inverse().transform_point3(Vec3::ZERO);
                Form::Ball { centre, per_radius2: scale * scale }
            }
            _ => Form::Placed { unit_from_blob, length },
        };
        Element { strength: component.strength, form }
    }

    fn bounds(&self) -> Aabb {
        match &self.form {
            Form::Ball { centre, per_radius2 } => {
                Aabb { min: *centre, max: *centre }.grown(per_radius2.sqrt().recip())
            }
            Form::Placed { unit_from_blob, .. } if !unit_from_blob.is_finite() => Aabb::EMPTY,
            Form::Placed { unit_from_blob, length } => {
                let unit = Aabb::new(Vec3::splat(-1.0), Vec3::new(1.0, 1.0, 1.0 + length));
                unit.transformed(&unit_from_blob.inverse())
            }
        }
    }

    /// How far it reaches along a vector.
    fn reach(&self, along: Vec3) -> f64 {
        match &self.form {
            Form::Ball { centre, per_radius2 } => {
                centre.dot(along) + along.length() * per_radius2.sqrt().recip()
            }
            Form::Placed { unit_from_blob, .. } if !unit_from_blob.is_finite() => f64::NEG_INFINITY,
            Form::Placed { unit_from_blob, length } => {
                let blob_from_unit = unit_from_blob.inverse();
                let in_unit = blob_from_unit.matrix3.transpose() * along;
                blob_from_unit.translation.dot(along) + in_unit.length() + (length * in_unit.z).max(0.0)
            }
        }
    }

    /// `u = 1 - d^2`, where d is the distance from the component's centre or axis in radii; and minus half its gradient.
    #[inline]
    fn field(&self, p: Vec3) -> (Vec3, f64) {
        match &self.form {
            Form::Ball { centre, per_radius2 } => {
                let away = (p - *centre) * *per_radius2;
                (away, 1.0 - away.dot(p - *centre))
            }
            Form::Placed { unit_from_blob, length } => {
                let mut q = unit_from_blob.transform_point3(p);
                q.z -= q.z.clamp(0.0, *length);
                (transform::normal_by_inverse(unit_from_blob, q), 1.0 - q.length_squared())
            }
        }
    }

    /// Adds the spans on the ray that reach into what is `wanted`; answers what the component comes to at most there.
    #[inline]
    fn add_spans(&self, ray: &Ray, wanted: (f64, f64), out: &mut Spans) -> f64 {
        let range = (f64::NEG_INFINITY, f64::INFINITY);
        let (unit, length) = match &self.form {
            Form::Ball { centre, per_radius2 } => {
                // Rays come with a direction of unit length.
                let (o, d) = (ray.origin - *centre, ray.dir);
                let middle = -o.dot(d);
                let peak = 1.0 - per_radius2 * (o + d * middle).length_squared();
                return self.add_part(middle, *per_radius2, peak, range, wanted, out);
            }
            Form::Placed { unit_from_blob, length } => (ray.transformed(unit_from_blob), *length),
        };
        let (o, d) = (unit.origin, unit.dir);
        let mut add_span = |o: Vec3, d: Vec3, range| self.add_span(o, d, range, wanted, out);
        if length == 0.0 {
            return add_span(o, d, range);
        }
        let end = Vec3::new(o.x, o.y, o.z - length);
        if d.z == 0.0 {
            let o = Vec3::new(o.x, o.y, o.z - o.z.clamp(0.0, length));
            return add_span(o, d, range);
        }
        // Before the rod's nearer end, beside the rod, after its farther end.
        let (base, cap) = (-o.z / d.z, (length - o.z) / d.z);
        let (near, far, first, last) = if d.z > 0.0 { (base, cap, o, end) } else { (cap, base, end, o) };
        let flat = |v: Vec3| Vec3::new(v.x, v.y, 0.0);
        let before = add_span(first, d, (range.0, near));
        let beside = add_span(flat(o), flat(d), (near, far));
        before.max(beside).max(add_span(last, d, (far, range.1)))
    }

    /// The span in which `1 - |o + t d|^2` is positive, cut to `range`.
    #[inline]
    fn add_span(&self, o: Vec3, d: Vec3, range: (f64, f64), wanted: (f64, f64), out: &mut Spans) -> f64 {
        let bend = d.length_squared();
        let middle = if bend > 0.0 { -o.dot(d) / bend } else { 0.0 };
        let peak = 1.0 - (o + d * middle).length_squared();
        self.add_part(middle, bend, peak, range, wanted, out)
    }

    /// The span in which `peak - bend (t - middle)^2` is positive, cut to `range`.
    #[inline(always)]
    fn add_part(
        &self,
        middle: f64,
        bend: f64,
        peak: f64,
        range: (f64, f64),
        wanted: (f64, f64),
        out: &mut Spans,
    ) -> f64 {
        if peak.is_nan() || peak <= 0.0 {
            return 0.0;
        }
        let reach = (peak / bend).sqrt();
        let (from, to) = (range.0.max(middle - reach), range.1.min(middle + reach));
        if !(from < to && to > wanted.0 && from < wanted.1) {
            return 0.0;
        }
        out.push(Span { from, to, strength: self.strength, peak, bend, middle });
        let away = middle.max(from.max(wanted.0)).min(to.min(wanted.1)) - middle;
        let u = peak - bend * away * away;
        (self.strength * u * u).max(0.0)
    }
}

impl Span {
    /// Adds `strength * u^2` on `a..=b` to Bernstein coefficients of degree 4.
    #[inline]
    fn add_to(&self, a: f64, b: f64, sum: &mut [f64; 5]) {
        let (a, b) = (a - self.middle, b - self.middle);
        let u0 = self.peak - self.bend * a * a;
        let u1 = self.peak - self.bend * a * b;
        let u2 = self.peak - self.bend * b * b;
        let s = self.strength;
        sum[0] += s * u0 * u0;
        sum[1] += s * u0 * u1;
        sum[2] += s * (2.0 * u1 * u1 + u0 * u2) / 3.0;
        sum[3] += s * u1 * u2;
        sum[4] += s * u2 * u2;
    }
}

impl Blob {
    /// A blob of the given components at its place: rays and points are then those of the world.
    pub(crate) fn new(blob: &raggio_scene::Blob, world_from_blob: &Affine) -> Self {
        let elements: Vec<_> = blob.components.iter().map(|c| Element::new(c, world_from_blob)).collect();
        let boxes: Vec<_> = elements.iter().map(Element::bounds).collect();
        let parts = Parts::new(&boxes);
        let acting = parts.bounds();
        let stretch = STRETCH * acting.size().length();
        let mut made = Blob { threshold: blob.threshold, elements, parts, bounds: acting, stretch };
        made.bounds = made.hull(acting);
        made
    }

    fn search<C: Collect>(&self, ray: &Ray, to: &mut C) {
        let range = to.range();
        // Where only the nearest hit is wanted, most of many components need not be asked.
        let stretch = if C::ALL || self.elements.len() <= FEW { f64::INFINITY } else { self.stretch };
        let (mut from, mut spans) = (range.0, Spans::new());
        loop {
            let (most, until) = self.gather(ray, (from, range.1), stretch, &mut spans);
            if most >= self.surely_less() {
                spans.sort_unstable_by(|a, b| a.from.total_cmp(&b.from));
                let end = if until < range.1 { until } else { f64::INFINITY };
                self.sweep(&spans, (from, end), to);
            }
            if until >= to.range().1 {
                return;
            }
            from = until;
            spans.clear();
        }
    }

    /// Is it plain that the field is too weak all along a range of the ray?
    pub(crate) fn plainly_misses(&self, ray: &Ray, range: (f64, f64)) -> bool {
        self.gather(ray, range, f64::INFINITY, &mut Spans::new()).0 < self.surely_less()
    }

    /// Nowhere is a point inside, or on the surface, where the field is less than this.
    fn surely_less(&self) -> f64 {
        self.threshold - 2.0 * TOLERANCE
    }

    /// Adds the spans of a ray that reach into a range, which ends sooner where that is longer than a stretch beyond the
    /// first span. Answers what the field comes to at most there, and where the range ends.
    #[inline]
    fn gather(&self, ray: &Ray, range: (f64, f64), stretch: f64, spans: &mut Spans) -> (f64, f64) {
        let (mut most, mut until) = (0.0, range.1);
        self.parts.visit_ray(ray, range, |i| {
            most += self.elements[i].add_spans(ray, (range.0, until), spans);
            if let Some(first) = spans.first()
                && until == range.1
            {
                let end = first.from.max(range.0) + stretch;
                // Far away a stretch may be too short to get on.
                until = if end > range.0 { until.min(end) } else { until };
            }
            until
        });
        (most, until)
    }

    /// Walks from one end of a span to the next within a range, nearest first.
    fn sweep(&self, spans: &[Span], range: (f64, f64), to: &mut impl Collect) {
        let mut active: SmallVec<[Span; 16]> = SmallVec::new();
        let mut waiting = spans.iter().peekable();
        let mut at = f64::NEG_INFINITY;
        loop {
            if active.is_empty() {
                let Some(next) = waiting.peek() else { return };
                at = next.from;
            }
            while let Some(span) = waiting.next_if(|s| s.from <= at) {
                active.push(*span);
            }
            let end = active.iter().map(|s| s.to).fold(range.1, f64::min);
            let end = waiting.peek().map_or(end, |s| end.min(s.from));
            if end > range.0 {
                self.search_segment(&active, at, end, range.0, to);
            }
            if end >= to.range().1.min(range.1) {
                return;
            }
            at = end;
            active.retain(|s| s.to > at);
        }
    }

    /// The hits between two ends of spans, from a distance on.
    fn search_segment(&self, active: &[Span], mut a: f64, b: f64, near: f64, to: &mut impl Collect) {
        let mut sum = [-self.threshold; 5];
        for span in active {
            span.add_to(a, b, &mut sum);
        }
        // A ray that leaves the surface has a root where it starts, which does not count: none is looked for there.
        if a < near && near < b {
            poly::bernstein_from((near - a) / (b - a), &mut sum);
            a = near;
        }
        for &s in poly::bernstein_roots(&sum).iter() {
            to.push(LocalHit::at(a + s * (b - a)));
        }
    }

    /// The share of each component in the field at a point: its index and its weight; the weights sum to 1. Empty where
    /// no component reaches.
    pub(crate) fn weights(&self, p: Vec3, out: &mut PartUses) {
        out.clear();
        let mut total = 0.0;
        self.parts.visit_point(p, |i| {
            let (_, u) = self.elements[i].field(p);
            if u > 0.0 {
                let weight = (self.elements[i].strength * u * u).abs();
                total += weight;
                out.push((i as u32, weight as f32));
            }
        });
        out.retain(|(_, weight)| *weight > 0.0);
        out.sort_unstable_by_key(|(i, _)| *i);
        out.iter_mut().for_each(|(_, weight)| *weight /= total as f32);
    }
}

impl Surface for Blob {
    searched_from!(LEAST);

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn reach(&self, along: Vec3) -> Option<f64> {
        if let Some(axis) = (0..3).find(|&k| along.abs() == Vec3::AXES[k]) {
            return Some(if along[axis] > 0.0 { self.bounds.max[axis] } else { -self.bounds.min[axis] });
        }
        let acting = self.elements.iter().map(|e| e.reach(along)).fold(f64::NEG_INFINITY, f64::max);
        Some(acting.min(self.reach_within(&self.bounds, along)))
    }

    fn inside(&self, p: Vec3) -> bool {
        let mut sum = 0.0;
        self.parts.visit_point(p, |i| {
            let u = self.elements[i].field(p).1.max(0.0);
            sum += self.elements[i].strength * u * u;
        });
        sum > self.threshold - TOLERANCE
    }

    fn normal(&self, p: Vec3, _hit: &LocalHit) -> Vec3 {
        let mut out = Vec3::ZERO;
        self.parts.visit_point(p, |i| {
            let e = &self.elements[i];
            let (q, u) = e.field(p);
            if u > 0.0 {
                out += q * (e.strength * u);
            }
        });
        out.try_normalize().unwrap_or(Vec3::X)
    }
}
