//! Normals: what bends a surface's normal (textures spec, section 8).
mod bump;
mod slope;
mod special;

use std::sync::Arc;

use raggio_math::Vec3;
use raggio_scene::{self as scene, NormalKind, PatternKind};

use crate::compiler::Compiler;
use crate::image::Image;
use crate::map::{Blend, Map};
use crate::warp::WarpList;
use crate::{Context, Noise, Pattern};

/// A compiled normal.
#[derive(Debug)]
pub struct Normal {
    kind: Kind,
    /// Lengths count, so that scaling a pattern scales its bumps: `no_bump_scale`.
    scaled: bool,
}

#[derive(Debug)]
enum Kind {
    Special { warps: WarpList, special: special::Special },
    Slope { pattern: Pattern, slope: slope::Slope },
    Map { pattern: Pattern, map: Map<Arc<Normal>> },
    Average { pattern: Pattern, map: Map<Arc<Normal>> },
    Bump { warps: WarpList, image: Image, size: f64 },
    Uv(Arc<Normal>),
}

impl Compiler {
    /// Compiles a normal with all its parts. `no_bump_scale` passes down from the map that it stands in.
    pub(crate) fn normal(&mut self, normal: &scene::Normal, no_bump_scale: bool) -> Normal {
        let scaled = normal.no_bump_scale || no_bump_scale;
        let amount = f64::from(normal.amount);
        let kind = match &normal.kind {
            NormalKind::Special { pattern, settings } => Kind::Special {
                warps: WarpList::compile(&settings.warps),
                special: self.special(pattern, settings, amount),
            },
            NormalKind::Slope { pattern, map } => Kind::Slope {
                pattern: self.pattern(pattern),
                slope: slope::Slope::new(amount, f64::from(normal.accuracy), map.as_deref()),
            },
            NormalKind::Map { pattern, map } => {
                let map = Map::new(map.iter().map(|(at, entry)| (*at, self.shared_normal(entry, scaled))));
                let average = matches!(pattern.kind, PatternKind::Average);
                let pattern = self.pattern(pattern);
                if average { Kind::Average { pattern, map } } else { Kind::Map { pattern, map } }
            }
            NormalKind::Bump { warps, image } => {
                Kind::Bump { warps: WarpList::compile(warps), image: Image::compile(image), size: amount }
            }
            NormalKind::Uv(inner) => {
                self.asks_uv = true;
                Kind::Uv(self.shared_normal(inner, scaled))
            }
        };
        Normal { kind, scaled }
    }
}

impl Normal {
    /// Compiles a normal.
    pub fn compile(normal: &scene::Normal, noise: Noise) -> Self {
        Compiler::new(noise).normal(normal, false)
    }

    /// `no_bump_scale`: do lengths count, so that scaling an object scales its bumps?
    pub fn keeps_lengths(&self) -> bool {
        self.scaled
    }

    /// The bent normal, of unit length unless lengths count. `n` is unit, unless lengths count, and faces the viewer;
    /// the answer need not.
    pub fn perturb(&self, n: Vec3, p: Vec3, context: &Context) -> Vec3 {
        let bent = self.bend(n, p, context);
        // Where lengths do not count it is of unit length already, or nothing.
        if bent.is_finite() && (self.scaled || bent.length_squared() > 0.5) { bent } else { n }
    }

    /// The bent normal with the length that it has by the rules of `no_bump_scale`.
    fn bend(&self, n: Vec3, p: Vec3, context: &Context) -> Vec3 {
        match &self.kind {
            Kind::Uv(inner) => {
                let bent = inner.bend(n, context.uv_point(), context);
                // Inside, lengths may count.
                if self.scaled { bent } else { bent.normalize_or(bent) }
            }
            Kind::Special { warps, special } => self.within(warps, n, |n| special.bend(n, warps.apply(p))),
            Kind::Bump { warps, image, size } => {
                self.within(warps, n, |n| bump::bend(image, *size, n, warps.apply(p)))
            }
            Kind::Slope { pattern, slope } => {
                self.within(pattern.warps(), n, |n| slope.bend(pattern, n, pattern.warp(p), context))
            }
            Kind::Map { pattern, map } => self.within(pattern.warps(), n, |n| {
                let p = pattern.warp(p);
                match map.at(pattern.eval_warped(p, context)) {
                    Blend::One(entry) => entry.map_or(n, |entry| entry.bend(n, p, context)),
                    Blend::Two(low, high, t) => low.bend(n, p, context).lerp(high.bend(n, p, context), t),
                }
            }),
            Kind::Average { pattern, map } => self.within(pattern.warps(), n, |n| {
                let p = pattern.warp(p);
                let sum: Vec3 =
                    map.weighted().map(|(w, entry)| f64::from(w) * entry.bend(n, p, context)).sum();
                sum / map.total_weight()
            }),
        }
    }

    /// Carries the normal into the pattern's space, bends it there, and carries it back.
    fn within(&self, warps: &WarpList, n: Vec3, bend: impl FnOnce(Vec3) -> Vec3) -> Vec3 {
        warps.normal_out(bend(warps.normal_in(n, self.scaled)), self.scaled)
    }
}
