//! How long one core takes for a value of each pattern: `cargo run --release -p raggio-shading --example pattern_speed`.
use std::hint::black_box;
use std::time::Instant;

use raggio_math::Vec3;
use raggio_scene::{
    CrackleSettings, FractalKind, FractalSettings, Pattern as ScenePattern, PatternKind, Turbulence, Warp,
    Wave,
};
use raggio_shading::{Context, Noise, Pattern};

const COUNT: u32 = 20_000;
const RUNS: usize = 15;

/// Prints the best of several short runs, so that other work on the machine counts little.
fn report(name: &str, kind: PatternKind, warps: Vec<Warp>) {
    let scene =
        ScenePattern { kind, warps, wave: Wave::Ramp, frequency: 1.0, phase: 0.0, noise_generator: 0 };
    let pattern = Pattern::compile(&scene, Noise::default());
    let run = || {
        let start = Instant::now();
        let points = (0..COUNT).map(|i| {
            let t = f64::from(i) * 0.0037;
            Vec3::new(t - 30.0, 7.0 - 0.31 * t, 5.0 + 0.17 * t)
        });
        black_box(points.map(|p| pattern.eval(p, &Context::NONE)).sum::<f64>());
        start.elapsed().as_secs_f64()
    };
    let best = (0..RUNS).map(|_| run()).fold(f64::INFINITY, f64::min);
    println!("{name}: {:.0} ns", best / f64::from(COUNT) * 1e9);
}

fn main() {
    let turbulence = vec![Warp::ClassicTurbulence(Turbulence { amount: Vec3::ONE, ..Turbulence::default() })];
    let crackle = |metric| PatternKind::Crackle(CrackleSettings { metric, ..CrackleSettings::default() });
    let mandel = FractalSettings {
        kind: FractalKind::Power(2),
        julia: None,
        iterations: 50,
        exterior_type: 1,
        exterior_factor: 1.0,
        interior_type: 0,
        interior_factor: 1.0,
    };
    let pavement =
        PatternKind::Pavement { sides: 6, tiles: 4, pattern: 3, exterior: 0, interior: 1, form: 1 };
    report("checker", PatternKind::Checker, Vec::new());
    report("gradient", PatternKind::Gradient(Vec3::X), Vec::new());
    report("bozo", PatternKind::Bozo, Vec::new());
    report("bozo with turbulence", PatternKind::Bozo, turbulence.clone());
    report("granite", PatternKind::Granite, Vec::new());
    report("agate", PatternKind::Agate { turbulence: 1.0 }, Vec::new());
    report("marble", PatternKind::Marble, turbulence.clone());
    report("wood", PatternKind::Wood, turbulence);
    report("wrinkles", PatternKind::Wrinkles, Vec::new());
    report("ripples", PatternKind::Ripples, Vec::new());
    report("crackle", crackle(2.0), Vec::new());
    report("crackle, metric 1", crackle(1.0), Vec::new());
    report("crackle, metric 3", crackle(3.0), Vec::new());
    report("hexagon", PatternKind::Hexagon, Vec::new());
    report("mandel", PatternKind::Fractal(mandel), Vec::new());
    report("tiling 17", PatternKind::Tiling(17), Vec::new());
    report("tiling 24", PatternKind::Tiling(24), Vec::new());
    report("tiling 25", PatternKind::Tiling(25), Vec::new());
    report("tiling 27", PatternKind::Tiling(27), Vec::new());
    report("pavement", pavement, Vec::new());
}
