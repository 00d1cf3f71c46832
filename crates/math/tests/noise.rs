//! Noise against values recorded from the language's reference renderer.
use raggio_math::Vec3;
use raggio_math::noise::{dturbulence, hash3, noise, random, random3, turbulence, wave_sources};

fn rows(text: &str) -> Vec<Vec<f64>> {
    text.lines().skip(1).map(|l| l.split(',').map(|c| c.parse().expect("a number")).collect()).collect()
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} {b}");
}

#[test]
fn three_generators_give_the_recorded_noise() {
    let rows = rows(include_str!("data/noise_samples.csv"));
    assert_eq!(rows.len(), 200);
    for r in rows {
        let p = Vec3::new(r[0], r[1], r[2]);
        for g in 1..=3 {
            near(noise(g, p), r[2 + g as usize]);
        }
    }
}

#[test]
fn turbulence_gives_the_recorded_sums() {
    let rows = rows(include_str!("data/turbulence_samples.csv"));
    assert_eq!(rows.len(), 60);
    for r in rows {
        let (lambda, omega, octaves) = (r[0] as f32, r[1] as f32, r[2] as u32);
        let p = Vec3::new(r[3], r[4], r[5]);
        let d = dturbulence(p, octaves, omega, lambda);
        for k in 0..3 {
            near(d[k], r[6 + k]);
        }
        for g in 1..=3 {
            near(turbulence(g, p, octaves, omega, lambda), r[8 + g as usize]);
        }
    }
}

#[test]
fn wave_sources_are_the_recorded_ones() {
    let sources = wave_sources(50);
    for r in rows(include_str!("data/wave_sources.csv")) {
        let s = sources[r[0] as usize];
        near(s.center.x, r[1]);
        near(s.center.y, r[2]);
        near(s.center.z, r[3]);
        near(s.frequency, r[4]);
    }
    assert_eq!(wave_sources(0).len(), 1);
}

#[test]
fn the_random_table_is_the_mersenne_twister() {
    let rows = rows(include_str!("data/mt_doubles_check.csv"));
    assert_eq!(rows.len(), 20);
    for r in rows {
        near(random(r[0] as usize), r[1]);
        near(random3(r[0] as usize + 32768)[0], r[1]);
    }
}

#[test]
fn hashes_repeat_every_4096() {
    assert_eq!(hash3(-1, -2, -3), hash3(4095, 4094, 4093));
    assert!((0..1000).all(|i| hash3(i, -i, 7 * i) < 4096));
    assert_eq!((hash3(0, 0, 0), hash3(5, 9, -2)), (3687, 2282));
}

#[test]
fn noise_outlives_nonsense() {
    for c in [f64::NAN, f64::INFINITY, -1e300, 1e17, 9.3e18] {
        for g in 1..=3 {
            let n = noise(g, Vec3::new(c, 0.3, 0.2));
            assert!((0.0..=1.0).contains(&n), "generator {g} at {c} gives {n}");
        }
    }
}
