//! How many noise evaluations a second one core makes: `cargo run --release -p raggio-math --example noise_speed`.
use std::hint::black_box;
use std::time::Instant;

use raggio_math::Vec3;
use raggio_math::noise::{dnoise, noise};

const COUNT: u32 = 10_000_000;

fn report(name: &str, mut evaluate: impl FnMut(Vec3) -> f64) {
    evaluate(Vec3::ZERO);
    let start = Instant::now();
    let mut sum = 0.0;
    for i in 0..COUNT {
        let t = f64::from(i) * 0.037;
        sum += evaluate(Vec3::new(t, -0.31 * t, 5.0 + 0.17 * t));
    }
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{name}: {:.1} million a second (mean {:.4})",
        f64::from(COUNT) / seconds / 1e6,
        black_box(sum) / f64::from(COUNT)
    );
}

fn main() {
    report("generator 1", |p| noise(1, p));
    report("generator 2", |p| noise(2, p));
    report("generator 3", |p| noise(3, p));
    report("vector", |p| dnoise(p).x);
}
