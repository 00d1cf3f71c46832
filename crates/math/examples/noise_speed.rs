//! How many noise evaluations a second one core makes: `cargo run --release -p raggio-math --example noise_speed`.
use std::hint::black_box;
use std::time::Instant;

use raggio_math::Vec3;
use raggio_math::noise::{dnoise, dturbulence, noise, noise4, turbulence};

const COUNT: u32 = 10_000;
const RUNS: usize = 500;

/// Prints the best of many short runs, so that other work on the machine counts little.
fn report(name: &str, evaluate: impl Fn(Vec3) -> f64) {
    let run = || {
        let start = Instant::now();
        let points = (0..COUNT).map(|i| {
            let t = f64::from(i) * 0.037 - 1000.0;
            Vec3::new(t, -0.31 * t, 5.0 + 0.17 * t)
        });
        black_box(points.map(&evaluate).sum::<f64>());
        start.elapsed().as_secs_f64()
    };
    let best = (0..RUNS).map(|_| run()).fold(f64::INFINITY, f64::min);
    println!("{name}: {:.1} million a second", f64::from(COUNT) / best / 1e6);
}

fn main() {
    for generator in 1..=3 {
        report(&format!("noise, generator {generator}"), |p| noise(generator, p));
    }
    let four = |p: Vec3| noise4(2, &[p, 1.1 * p, 0.9 * p, p + 0.02]).iter().sum();
    report("noise at four points", four);
    report("vector noise", |p| dnoise(p).element_sum());
    report("vector turbulence of 6 octaves", |p| dturbulence(p, 6, 0.5, 2.0).element_sum());
    report("turbulence of 4 octaves", |p| turbulence(2, p, 4, 0.5, 2.0));
    report("turbulence of 8 octaves", |p| turbulence(2, p, 8, 0.5, 2.0));
    report("turbulence of 6 octaves", |p| turbulence(2, p, 6, 0.5, 2.0));
}
