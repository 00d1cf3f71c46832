//! What must hold for every ray: a hundred thousand of them at each shape.
//!
//! Hits alternate between entry and exit, `inside` changes at each and nowhere else (also by marching along the ray in
//! small steps), `closest` is the first of them, and a ray that starts at one finds the next.
use super::fields::*;
use super::functions::*;
use super::swept::*;
use super::*;
use crate::LocalHit;
use crate::shapes::nurbs::tests as nurbs;

const RAYS: u32 = 100_000;
/// Every so many rays one is marched along, in so many steps.
const MARCHED: u32 = 100;
const STEPS: u32 = 500;
/// Rays start so far from the middle.
const FAR: f64 = 4.0;

/// How much a shape may deviate, in its own units.
#[derive(Clone, Copy)]
struct Allowed {
    /// Of a hit from the surface, across it.
    off: f64,
    /// Hits nearer than this to where a ray starts may be passed over.
    least: f64,
    /// Gaps shorter than this between hits may be missed, at grazing rays.
    gap: f64,
    /// Thin parts may be passed over, so that only the hits themselves can be judged.
    thin: bool,
    /// The surface does not close around what counts as inside.
    open: bool,
}

const EXACT: Allowed = Allowed { off: 1e-7, least: 2e-4, gap: 1e-5, thin: false, open: false };

/// Found by steps of 0.0001.
const STEPPED: Allowed = Allowed { off: 1e-4, least: 2e-3, gap: 1e-3, thin: false, open: false };

/// Found by a march in steps of 0.02 or more.
const MARCHED_SHAPE: Allowed = Allowed { off: 1e-6, least: 2e-2, gap: 2e-2, thin: false, open: false };

/// Found by a march that passes thin parts over.
const DEEP: Allowed = Allowed { off: 1e-6, gap: 1e-5, thin: true, ..MARCHED_SHAPE };

/// As exact, and open.
const OPEN: Allowed = Allowed { open: true, ..EXACT };

/// Numbers between -1 and 1 without pattern, the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.next(), self.next(), self.next())
    }
}

/// One ray with all its hits in order.
struct Shot<'a> {
    surface: &'a ShapeKind,
    ray: Ray,
    hits: Vec<LocalHit>,
    allowed: Allowed,
}

impl Shot<'_> {
    /// What is wrong, if anything is.
    fn fault(&self, march: bool) -> Option<String> {
        let solid = self.surface.is_solid() && !self.allowed.open;
        let first = self.surface.closest(&self.ray, (0.0, f64::INFINITY)).map(|h| h.t);
        if first != self.hits.first().map(|h| h.t) {
            return Some(format!("the closest is at {first:?}"));
        }
        if self.hits.len() % 2 == 1 && solid {
            return Some("it never comes out".into());
        }
        if let Some(i) = (0..self.hits.len()).find(|&i| !(self.allowed.thin || self.starts_again(i))) {
            return Some(format!("a ray from hit {i} goes astray"));
        }
        if !solid {
            return None;
        }
        if let Some(i) = (0..self.hits.len()).find(|&i| !self.changes_at(i)) {
            return Some(format!("`inside` does not change at hit {i}"));
        }
        let last = 2.0 * FAR;
        (0..STEPS)
            .filter(|_| march && !self.allowed.thin)
            .map(|k| last * f64::from(k) / f64::from(STEPS))
            .find(|&t| !self.agrees_at(t))
            .map(|t| format!("`inside` is wrong at {t}"))
    }

    /// How far a hit may be off along the ray.
    fn slack(&self, hit: &LocalHit) -> f64 {
        let across = self.surface.normal(self.ray.at(hit.t), hit).dot(self.ray.dir).abs();
        self.allowed.off / across.max(1e-4)
    }

    /// Is it inside on one side of a hit and outside on the other?
    fn changes_at(&self, i: usize) -> bool {
        let (hit, slack) = (&self.hits[i], self.slack(&self.hits[i]));
        let before = i.checked_sub(1).map_or(f64::NEG_INFINITY, |k| self.hits[k].t);
        let after = self.hits.get(i + 1).map_or(f64::INFINITY, |h| h.t);
        let near = self.allowed.gap.max(3.0 * slack);
        if hit.t - before < near || after - hit.t < near {
            return true;
        }
        let inside = |t: f64| self.surface.inside(self.ray.at(t));
        inside(hit.t - slack) == (i % 2 == 1) && inside(hit.t + slack) == i.is_multiple_of(2)
    }

    /// Is `inside` at a distance what the hits say? Stretches shorter than the gap may be passed over.
    fn agrees_at(&self, t: f64) -> bool {
        let gap = self.allowed.gap;
        let passed = self.hits.iter().filter(|h| h.t < t).count();
        let near = self.hits.iter().any(|h| (h.t - t).abs() < self.slack(h).max(gap));
        let agrees = |t: f64| self.surface.inside(self.ray.at(t)) != passed.is_multiple_of(2);
        near || agrees(t) || agrees(t - 0.5 * gap) || agrees(t + 0.5 * gap)
    }

    /// Does a ray from a hit find the next one?
    fn starts_again(&self, i: usize) -> bool {
        let t = self.hits[i].t;
        let Some(next) = self.hits[i + 1..].iter().find(|h| h.t - t > self.allowed.least) else {
            return true;
        };
        // Nothing that could be taken for it or missed instead.
        if self.hits.iter().any(|h| h.t > t && h.t < next.t) {
            return true;
        }
        let found = self.surface.closest(&Ray::new(self.ray.at(t), self.ray.dir), (MIN_HIT, f64::INFINITY));
        found.is_some_and(|h| (t + h.t - next.t).abs() < self.slack(next))
    }
}

impl Subject {
    fn keeps_the_laws(&self, allowed: Allowed) {
        let mut numbers = Numbers(1);
        let (mut faults, mut met) = (Vec::new(), 0);
        let alongs: [Vec3; 16] = std::array::from_fn(|_| numbers.vector());
        let reaches: Vec<_> =
            alongs.into_iter().filter_map(|along| Some((along, self.surface.reach(along)?))).collect();
        for k in 0..RAYS {
            let origin = numbers.vector().normalize() * FAR;
            let ray = Ray::new(origin, (numbers.vector() - origin).normalize());
            let mut hits = Vec::new();
            self.surface.hits(&ray, (0.0, f64::INFINITY), &mut hits);
            hits.sort_by(|a, b| a.t.total_cmp(&b.t));
            met += u32::from(!hits.is_empty());
            reaches.iter().for_each(|&(along, reach)| {
                let beyond = hits.iter().find(|h| ray.at(h.t).dot(along) > reach + 1e-6);
                assert!(beyond.is_none(), "{}: ray {k} meets it beyond its reach along {along}", self.name);
            });
            let shot = Shot { surface: &self.surface, ray, hits, allowed };
            if let Some(fault) = shot.fault(k % MARCHED == 0) {
                let at: Vec<f64> = shot.hits.iter().map(|h| h.t).collect();
                faults.push(format!("ray {k}: {fault}; hits {at:?}, {:?} {:?}", ray.origin, ray.dir));
            }
        }
        assert!(met > RAYS / 50, "{}: only {met} rays meet it", self.name);
        faults.truncate(400);
        let shown = faults.iter().take(5).cloned().collect::<Vec<_>>().join("\n");
        assert!(faults.is_empty(), "{}: {} rays break the laws\n{shown}", self.name, faults.len());
    }
}

fn simple(name: &'static str) -> Subject {
    let v = Vec3::new;
    let shape = match name {
        "sphere" => Shape::Sphere { center: v(0.2, -0.1, 0.3), radius: 0.9 },
        "box" => Shape::Box { min: v(-1.0, -0.4, -0.7), max: v(0.6, 0.9, 0.8) },
        "cylinder" => {
            Shape::Cylinder { base: v(-0.5, -0.8, 0.1), cap: v(0.6, 0.7, -0.3), radius: 0.5, open: false }
        }
        "cone" => Shape::Cone {
            base: v(-0.5, -0.8, 0.1),
            base_radius: 0.9,
            cap: v(0.6, 0.7, -0.3),
            cap_radius: 0.2,
            open: false,
        },
        "ellipsoid" => Shape::Quadric([1.0, 2.0, 1.5, 0.2, 0.1, -0.3, 0.1, 0.2, 0.0, -1.0]),
        "disc" => Shape::Disc { center: v(0.1, 0.2, 0.0), normal: v(0.3, 0.5, 0.8), radius: 1.0, hole: 0.4 },
        _ => Shape::Triangle { points: [v(-1.0, -0.5, 0.2), v(0.9, -0.8, -0.3), v(0.1, 1.0, 0.4)] },
    };
    plain(name, shape)
}

/// After few steps of the orbits a fractal is smooth, so that a march can meet all of it.
fn few_steps(name: &'static str) -> Subject {
    let julia = raggio_scene::Julia { max_iteration: 2, precision: 50.0, ..functions::julia_data(name) };
    plain(name, Shape::Julia(Box::new(julia)))
}

macro_rules! laws {
    ($($test:ident: $subject:expr, $allowed:expr;)*) => {
        $(#[test]
        fn $test() {
            $subject.keeps_the_laws($allowed);
        })*
    };
}

laws! {
    sphere: simple("sphere"), EXACT;
    cuboid: simple("box"), EXACT;
    cylinder: simple("cylinder"), EXACT;
    cone: simple("cone"), EXACT;
    ellipsoid: simple("ellipsoid"), EXACT;
    triangle: simple("triangle"), EXACT;
    ring: torus("torus"), EXACT;
    quartic: polynomial("quartic"), Allowed { off: 1e-4, ..EXACT };
    sextic: polynomial("poly6"), Allowed { off: 1e-4, ..EXACT };
    blob_of_balls: blob("blob"), Allowed { off: 1e-6, least: 1.1e-2, ..EXACT };
    blob_with_a_dent: blob("blob_neg"), Allowed { off: 1e-6, least: 1.1e-2, ..EXACT };
    blob_with_a_rod: blob("blob_cyl"), Allowed { off: 1e-6, least: 1.1e-2, ..EXACT };
    linear_prism: prism("prism"), EXACT;
    quadratic_prism: prism("prism_quad"), EXACT;
    cubic_prism: prism("prism_cubic"), EXACT;
    conic_prism: prism("prism_conic"), EXACT;
    cushion: superellipsoid("super"), Allowed { off: 1e-6, ..EXACT };
    star: superellipsoid("super_star"), Allowed { off: 1e-6, ..EXACT };
    linear_lathe: lathe("lathe_linear"), EXACT;
    quadratic_lathe: lathe("lathe_quad"), OPEN;
    cubic_lathe: lathe("lathe_cubic"), OPEN;
    bezier_lathe: lathe("lathe_bezier"), OPEN;
    linear_sweep: sweep("sweep_linear"), OPEN;
    cubic_sweep: sweep("sweep_cubic"), OPEN;
    b_spline_sweep: sweep("sweep_b"), Allowed { least: 2e-3, ..OPEN };
    landscape: height_field("hf_func"), OPEN;
    parametric_tube: parametric(), EXACT;
    disc_with_a_hole: simple("disc"), OPEN;
    surface_of_revolution: sor("sor"), EXACT;
    egg: ovus("ovus"), EXACT;
    egg_on_its_head: ovus("ovus_top"), EXACT;
    patch: bicubic("bicubic1"), EXACT;
    text_of_our_own: super::laws::text(), EXACT;
    isosurface: functions::isosurface("iso_all"), STEPPED;
    isosurface_in_a_ball: functions::isosurface("iso_closed"), STEPPED;
    isosurface_with_noise: functions::isosurface("iso_noise"), STEPPED;
    julia_fractal_at_full_depth: functions::julia("julia"), DEEP;
    julia_fractal_of_cubes_at_full_depth: functions::julia("julia_cube"), DEEP;
    julia_fractal_of_hypercomplex_numbers_at_full_depth: functions::julia("julia_hyper"), DEEP;
    julia_fractal: few_steps("julia"), MARCHED_SHAPE;
    julia_fractal_of_cubes: few_steps("julia_cube"), MARCHED_SHAPE;
    julia_fractal_of_hypercomplex_numbers: few_steps("julia_hyper"), MARCHED_SHAPE;
    nurbs_ring: plain("nurbs ring", Shape::Nurbs(Arc::new(nurbs::ring()))), EXACT;
    nurbs_patch: plain("nurbs patch", Shape::Nurbs(Arc::new(nurbs::wavy()))), EXACT;
}
