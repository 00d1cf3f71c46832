//! Pigments: from a point to a colour (textures spec, sections 7 and 9).
use std::sync::Arc;

use raggio_function::Bounds;
use raggio_image::{Color, Rgb};
use raggio_math::Vec3;
use raggio_scene::{self as scene, PatternKind, PigmentKind};

use crate::compiler::Compiler;
use crate::image::Image;
use crate::map::{Blend, Map};
use crate::memory::{FOUR, Number, ONE, Sample, remembered};
use crate::pattern::each;
use crate::warp::WarpList;
use crate::{Context, Noise, Pattern};

/// A compiled pigment.
#[derive(Debug)]
pub struct Pigment {
    kind: Kind,
    quick_color: Option<Color>,
    opaque: bool,
    smooth: bool,
    effort: Effort,
    /// For one worth it that is in use at several places.
    number: Number,
}

/// What it takes to find a value or a colour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// Does it hang on the place alone?
    pub local: bool,
    /// Does it take long?
    pub long: bool,
}

#[derive(Debug)]
enum Kind {
    Solid(Color),
    Colors {
        pattern: Box<Pattern>,
        map: Map<Color>,
    },
    /// The same where the pattern knows large values beforehand: above a bound there is one color.
    Foreseen {
        pattern: Box<Pattern>,
        map: Map<Color>,
        bound: f64,
        beyond: Color,
    },
    Pigments {
        pattern: Box<Pattern>,
        map: Map<Arc<Pigment>>,
    },
    Average {
        pattern: Box<Pattern>,
        map: Map<Arc<Pigment>>,
    },
    Image {
        warps: WarpList,
        image: Box<Image>,
    },
    Uv(Arc<Pigment>),
}

/// What an image shows beside its one copy: nothing, and all that lies behind.
const CLEAR: Color = Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };

fn lets_nothing_through(color: &Color) -> bool {
    color.filter == 0.0 && color.transmit == 0.0
}

impl Compiler {
    /// Compiles a pigment with all its parts.
    pub(crate) fn pigment(&mut self, pigment: &scene::Pigment) -> Pigment {
        let kind = match &pigment.kind {
            PigmentKind::Solid { color, .. } => Kind::Solid(*color),
            PigmentKind::ColorMap { pattern, map } => {
                colors(self.pattern(pattern), Map::new(map.iter().copied()))
            }
            PigmentKind::PigmentMap { pattern, map } => {
                if let Some(map) = plain_colors(pattern, map) {
                    return Pigment::of(colors(self.pattern(pattern), map), pigment.quick_color);
                }
                let map = Map::new(map.iter().map(|(at, entry)| (*at, self.shared_pigment(entry))));
                let average = matches!(pattern.kind, PatternKind::Average);
                // Of a map with one entry nobody asks where in it one is.
                let even = map.items().len() == 1;
                let pattern = Box::new(if even { self.mover(pattern) } else { self.pattern(pattern) });
                if average { Kind::Average { pattern, map } } else { Kind::Pigments { pattern, map } }
            }
            PigmentKind::Image { warps, image } => {
                Kind::Image { warps: WarpList::compile(warps), image: Box::new(Image::compile(image)) }
            }
            PigmentKind::Uv(inner) => {
                self.asks_uv = true;
                Kind::Uv(self.shared_pigment(inner))
            }
        };
        Pigment::of(kind, pigment.quick_color)
    }
}

/// The colours of a map whose entries are no more than colours, as those of densities mostly are. A mean of them is no map.
fn plain_colors(pattern: &scene::Pattern, map: &[(f32, Arc<scene::Pigment>)]) -> Option<Map<Color>> {
    let plain = |(at, entry): &(f32, Arc<scene::Pigment>)| match entry.kind {
        PigmentKind::Solid { color, .. } if entry.quick_color.is_none() => Some((*at, color)),
        _ => None,
    };
    let average = matches!(pattern.kind, PatternKind::Average);
    let entries = map.iter().map(plain).collect::<Option<Vec<_>>>()?;
    (!average && entries.len() > 1).then(|| Map::new(entries))
}

/// A pattern with a map of colours.
fn colors(pattern: Pattern, map: Map<Color>) -> Kind {
    let pattern = Box::new(pattern);
    match map.tail().filter(|_| pattern.foresees()) {
        Some((bound, &beyond)) if bound < 1.0 => Kind::Foreseen { pattern, map, bound, beyond },
        _ => Kind::Colors { pattern, map },
    }
}

#[inline]
fn color_at(map: &Map<Color>, value: f64) -> Color {
    match map.at(value) {
        Blend::One(color) => color.copied().unwrap_or_default(),
        Blend::Two(low, high, t) => low.lerp(*high, t),
    }
}

#[inline]
fn rgb_at(map: &Map<Color>, value: f64) -> Rgb {
    match map.at(value) {
        Blend::One(color) => color.map_or(Rgb::ZERO, |color| color.rgb),
        // Between equal ones there is nothing to work out; densities have many such.
        Blend::Two(low, high, _) if low.rgb == high.rgb => low.rgb,
        Blend::Two(low, high, t) => low.lerp_rgb(*high, t),
    }
}

impl Kind {
    fn is_opaque(&self) -> bool {
        match self {
            Kind::Solid(color) => lets_nothing_through(color),
            Kind::Colors { map, .. } | Kind::Foreseen { map, .. } => map.items().all(lets_nothing_through),
            Kind::Pigments { map, .. } | Kind::Average { map, .. } => map.items().all(|p| p.opaque),
            Kind::Image { image, .. } => image.is_opaque(),
            Kind::Uv(inner) => inner.opaque,
        }
    }

    /// Texture coordinates do not tell how fast they change, so that what hangs on them is not smooth.
    fn is_smooth(&self) -> bool {
        match self {
            Kind::Solid(_) | Kind::Colors { .. } | Kind::Foreseen { .. } | Kind::Uv(_) => false,
            Kind::Pigments { map, .. } | Kind::Average { map, .. } => map.items().any(|p| p.smooth),
            Kind::Image { image, .. } => image.is_smooth(),
        }
    }

    fn effort(&self) -> Effort {
        match self {
            Kind::Solid(_) | Kind::Image { .. } => Effort { local: true, long: false },
            Kind::Colors { pattern, .. } | Kind::Foreseen { pattern, .. } => pattern.effort(),
            Kind::Pigments { pattern, map } | Kind::Average { pattern, map } => {
                map.items().map(|entry| entry.effort).fold(pattern.effort(), |all, effort| Effort {
                    local: all.local && effort.local,
                    long: all.long || effort.long,
                })
            }
            Kind::Uv(_) => Effort { local: false, long: false },
        }
    }
}

impl Pigment {
    fn of(kind: Kind, quick_color: Option<Color>) -> Pigment {
        let (opaque, smooth, effort) = (kind.is_opaque(), kind.is_smooth(), kind.effort());
        Pigment { kind, quick_color, opaque, smooth, effort, number: Number::default() }
    }

    /// Remembers from now on what it gave last, if that saves anything.
    pub(crate) fn remember(&self) {
        if self.effort.local && self.effort.long {
            self.number.give();
        }
    }

    /// What it takes to find its colour.
    pub(crate) fn effort(&self) -> Effort {
        self.effort
    }

    /// [`Pigment::sample`], maybe from memory.
    #[inline]
    pub(crate) fn ask(&self, p: Vec3, context: &Context) -> Sample {
        match self.number.get() {
            None => self.sample(p, context),
            Some(number) => self.remembered(number, p, context),
        }
    }

    /// Not inlined: the way without memory is to stay short.
    #[inline(never)]
    fn remembered(&self, number: u32, p: Vec3, context: &Context) -> Sample {
        remembered(&ONE, number, [p], || [self.sample(p, context)])[0]
    }

    /// [`Pigment::sample4`], maybe from memory.
    #[inline]
    pub(crate) fn ask4(&self, points: &[Vec3; 4], context: &Context) -> [Sample; 4] {
        match self.number.get() {
            None => self.sample4(points, context),
            Some(number) => remembered(&FOUR, number, *points, || self.sample4(points, context)),
        }
    }

    /// Compiles a pigment.
    pub fn compile(pigment: &scene::Pigment, noise: Noise) -> Self {
        Compiler::new(noise).pigment(pigment)
    }

    /// The colour at a point; `None` where an image used `once` has none.
    #[inline]
    pub fn eval(&self, p: Vec3, context: &Context) -> Option<Color> {
        let (color, found) = self.sample(p, context);
        found.then_some(color)
    }

    /// The colour at a point without what it lets through, white where there is none.
    pub fn rgb(&self, p: Vec3, context: &Context) -> Rgb {
        match &self.kind {
            Kind::Solid(color) => color.rgb,
            Kind::Colors { pattern, map } => rgb_at(map, pattern.eval(p, context)),
            Kind::Foreseen { pattern, map, bound, beyond } => {
                let value = pattern.eval_unless_above(pattern.warp(p), *bound, context);
                value.map_or(beyond.rgb, |value| rgb_at(map, value))
            }
            _ => self.sample(p, context).0.rgb,
        }
    }

    /// The colour at a point, clear white where there is none, and whether there is one.
    #[inline(always)]
    pub fn sample(&self, p: Vec3, context: &Context) -> (Color, bool) {
        self.sample_at(p.x, p.y, p.z, context)
    }

    /// Coordinates come in registers, where they need not be waited for.
    fn sample_at(&self, x: f64, y: f64, z: f64, context: &Context) -> (Color, bool) {
        let p = Vec3::new(x, y, z);
        match &self.kind {
            Kind::Solid(color) => (*color, true),
            Kind::Colors { pattern, map } => (color_at(map, pattern.eval(p, context)), true),
            Kind::Foreseen { pattern, map, bound, beyond } => {
                let value = pattern.eval_unless_above(pattern.warp(p), *bound, context);
                (value.map_or(*beyond, |value| color_at(map, value)), true)
            }
            Kind::Pigments { pattern, map } => {
                let p = pattern.warp(p);
                pigment_at(&map.at(pattern.eval_warped(p, context)), p, context)
            }
            Kind::Average { pattern, map } => {
                let p = pattern.warp(p);
                average(map, |pigment| pigment.ask(p, context))
            }
            Kind::Image { warps, image } => image_color(image.color(warps.apply(p))),
            Kind::Uv(inner) => inner.sample(context.uv_point(), context),
        }
    }

    /// Where the colour's components lie over bounds of a point, if anything is known of them.
    pub(crate) fn enclose(&self, p: [Bounds; 3]) -> [Bounds; 5] {
        match &self.kind {
            Kind::Solid(color) => color.to_array().map(Bounds::constant),
            Kind::Colors { pattern, map } => map.enclose(pattern.enclose(p)),
            _ => [Bounds::UNKNOWN; 5],
        }
    }

    /// [`Pigment::sample`] at four points, faster than one by one where patterns are.
    pub(crate) fn sample4(&self, points: &[Vec3; 4], context: &Context) -> [(Color, bool); 4] {
        match &self.kind {
            Kind::Colors { pattern, map } => {
                each(&pattern.eval4(points, context), |&value| (color_at(map, value), true))
            }
            Kind::Pigments { pattern, map } => {
                let points = each(points, |&p| pattern.warp(p));
                let blends = each(&pattern.eval_warped4(&points, context), |&value| map.at(value));
                match common(&blends) {
                    Some((low, high, t)) => {
                        let (low, high) = (low.ask4(&points, context), high.ask4(&points, context));
                        each(&[0, 1, 2, 3], |&i| mix(low[i], high[i], t[i]))
                    }
                    None => each(&[0, 1, 2, 3], |&i| pigment_at(&blends[i], points[i], context)),
                }
            }
            _ => each(points, |&p| self.sample(p, context)),
        }
    }

    /// [`Pigment::eval`] where images that are `smooth` show the mean of a footprint: a point, and points
    /// [`FOOTPRINT_STEP`](crate::FOOTPRINT_STEP) along its axes.
    pub fn eval_over(&self, points: &[Vec3; 3], context: &Context) -> Option<Color> {
        let (color, found) = self.sample_over(points, context);
        found.then_some(color)
    }

    fn sample_over(&self, points: &[Vec3; 3], context: &Context) -> (Color, bool) {
        if !self.smooth {
            return self.sample(points[0], context);
        }
        match &self.kind {
            Kind::Pigments { pattern, map } => {
                let points = points.map(|p| pattern.warp(p));
                match map.at(pattern.eval_warped(points[0], context)) {
                    Blend::One(entry) => {
                        entry.map_or((Color::BLACK, true), |e| e.sample_over(&points, context))
                    }
                    Blend::Two(low, high, t) => {
                        mix(low.sample_over(&points, context), high.sample_over(&points, context), t)
                    }
                }
            }
            Kind::Average { pattern, map } => {
                let points = points.map(|p| pattern.warp(p));
                average(map, |pigment| pigment.sample_over(&points, context))
            }
            Kind::Image { warps, image } => image_color(image.color_over(&points.map(|p| warps.apply(p)))),
            Kind::Solid(_) | Kind::Colors { .. } | Kind::Foreseen { .. } | Kind::Uv(_) => {
                self.sample(points[0], context)
            }
        }
    }

    /// Does any image in it look at the camera's pixels?
    pub fn is_smooth(&self) -> bool {
        self.smooth
    }

    /// Does no part of it ever let light through?
    pub fn is_opaque(&self) -> bool {
        self.opaque
    }

    /// Its colour, where that is the same everywhere.
    #[inline]
    pub fn even_color(&self) -> Option<&Color> {
        match &self.kind {
            Kind::Solid(color) => Some(color),
            _ => None,
        }
    }

    /// The colour for low quality.
    pub fn quick_color(&self) -> Option<Color> {
        self.quick_color
    }
}

#[inline]
fn pigment_at(blend: &Blend<'_, Arc<Pigment>>, p: Vec3, context: &Context) -> (Color, bool) {
    match blend {
        Blend::One(entry) => entry.map_or((Color::BLACK, true), |e| e.ask(p, context)),
        Blend::Two(low, high, t) => mix(low.ask(p, context), high.ask(p, context), *t),
    }
}

/// The two entries that all four lie between, as they usually do, being neighbours; and where.
fn common<'a>(blends: &[Blend<'a, Arc<Pigment>>; 4]) -> Option<(&'a Pigment, &'a Pigment, [f64; 4])> {
    let Blend::Two(low, high, _) = blends[0] else { return None };
    let mut at = [0.0; 4];
    for (at, blend) in at.iter_mut().zip(blends) {
        match blend {
            Blend::Two(l, h, t) if std::ptr::eq(*l, low) && std::ptr::eq(*h, high) => *at = *t,
            _ => return None,
        }
    }
    Some((low, high, at))
}

/// A mix is found where either part is.
fn mix((a, a_found): (Color, bool), (b, b_found): (Color, bool), t: f64) -> (Color, bool) {
    (a.lerp(b, t), a_found || b_found)
}

fn image_color(color: Option<Color>) -> (Color, bool) {
    color.map_or((CLEAR, false), |color| (color, true))
}

fn average(map: &Map<Arc<Pigment>>, sample: impl Fn(&Pigment) -> (Color, bool)) -> (Color, bool) {
    let total = map.total_weight() as f32;
    let (mut sum, mut found) = (Color::BLACK, false);
    for (weight, pigment) in map.weighted() {
        let (color, here) = sample(pigment);
        let weight = weight / total;
        sum.rgb += color.rgb * weight;
        sum.filter += color.filter * weight;
        sum.transmit += color.transmit * weight;
        found |= here;
    }
    (sum, found)
}
