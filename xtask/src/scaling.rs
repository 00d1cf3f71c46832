//! `cargo xtask scaling`: how the time to trace grows with pixels, objects, copies, lights, depth and threads.

use crate::args::Args;
use crate::process;
use serde::Serialize;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// One series of runs.
struct Series {
    name: &'static str,
    /// Below `scenes/bench`.
    scene: &'static str,
    values: &'static [u64],
    vary: Vary,
}

/// What is varied.
#[derive(Clone, Copy, PartialEq)]
enum Vary {
    /// The scene's `N`.
    Declared,
    /// The picture's width; the value is the number of pixels.
    Pixels,
    /// `--threads`
    Threads,
}

const SERIES: &[Series] = &[
    Series {
        name: "pixels",
        scene: "scale-spheres.pov",
        values: &[19_200, 76_800, 307_200, 1_228_800],
        vary: Vary::Pixels,
    },
    Series {
        name: "spheres",
        scene: "scale-spheres.pov",
        values: &[100, 1_000, 10_000, 100_000, 1_000_000],
        vary: Vary::Declared,
    },
    Series {
        name: "copies of a mesh",
        scene: "scale-instances.pov",
        values: &[100, 1_000, 10_000, 100_000],
        vary: Vary::Declared,
    },
    Series { name: "lights", scene: "scale-lights.pov", values: &[1, 4, 16, 64], vary: Vary::Declared },
    Series { name: "depth", scene: "scale-depth.pov", values: &[2, 4, 8, 16, 32], vary: Vary::Declared },
    Series { name: "threads", scene: "scale-lights.pov", values: &[1, 2], vary: Vary::Threads },
];

/// One run of one series; seconds are medians.
#[derive(Serialize)]
struct Point {
    n: u64,
    read_s: f64,
    build_s: f64,
    trace_s: f64,
}

#[derive(Serialize)]
struct Fit {
    series: &'static str,
    /// The trace time grows as this power of n.
    exponent: f64,
    points: Vec<Point>,
}

/// Runs all series, or those whose name contains `--filter`; `--most` leaves larger values out.
pub fn run(words: &[String]) -> Result<(), String> {
    let mut args = Args::new(words);
    let filter = args.value("--filter")?.unwrap_or_default();
    let most = args.parsed("--most", u64::MAX)?;
    let runs = args.parsed("--runs", 3usize)?.max(1);
    let binary = process::renderer(&mut args)?;
    if let Some(word) = args.last_word()? {
        return Err(format!("unexpected `{word}`"));
    }
    let mut fits = Vec::new();
    for series in SERIES.iter().filter(|s| s.name.contains(&filter)) {
        println!("{:<18} {:>9} {:>9} {:>9} {:>9}", series.name, "n", "read", "build", "trace");
        let mut points = Vec::new();
        for &n in series.values.iter().filter(|&&n| n <= most) {
            let point = measure(&binary, series, n, runs)?;
            println!(
                "{:<18} {n:>9} {:>8.3}s {:>8.3}s {:>8.3}s",
                "", point.read_s, point.build_s, point.trace_s
            );
            points.push(point);
        }
        let exponent = exponent(&points);
        println!("{:<18} time grows as n^{exponent:.2}\n", "");
        fits.push(Fit { series: series.name, exponent, points });
    }
    crate::bench::save("scaling", &fits)
}

fn measure(binary: &Path, series: &Series, n: u64, runs: usize) -> Result<Point, String> {
    let mut times: Vec<[f64; 3]> = Vec::new();
    for _ in 0..runs {
        let done = process::run(&mut command(binary, series, n), Duration::from_secs(600))?;
        if done.code != Some(0) {
            return Err(format!("{} with {n}: {}", series.scene, done.stderr.trim()));
        }
        times.push(steps(&done.stderr).ok_or_else(|| format!("no times in: {}", done.stderr.trim()))?);
    }
    let mut median = |i: usize| {
        times.sort_by(|a, b| a[i].total_cmp(&b[i]));
        times[times.len() / 2][i]
    };
    Ok(Point { n, read_s: median(0), build_s: median(1), trace_s: median(2) })
}

fn command(binary: &Path, series: &Series, n: u64) -> Command {
    let mut command = Command::new(binary);
    command.arg("render").arg(crate::root_folder().join("scenes/bench").join(series.scene));
    let width = if series.vary == Vary::Pixels { (n as f64 * 4.0 / 3.0).sqrt().round() as u64 } else { 640 };
    command.arg("--size").arg(format!("{width}x{}", width * 3 / 4));
    let threads = if series.vary == Vary::Threads { n } else { 1 };
    command.arg("--threads").arg(threads.to_string());
    let declared = match series.vary {
        Vary::Declared => n,
        Vary::Pixels => 10_000,
        Vary::Threads => 16,
    };
    command.arg("--declare").arg(format!("N={declared}"));
    let picture = std::env::temp_dir().join(format!("scaling-{}.png", std::process::id()));
    command.arg("-o").arg(picture).args(["--timing", "--message-format", "json"]);
    command
}

/// Seconds of reading, building and tracing in the message about times.
fn steps(stderr: &str) -> Option<[f64; 3]> {
    let seconds = stderr.lines().rev().find_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        message.get("seconds").cloned()
    })?;
    let of = |name: &str| seconds.get(name)?.as_f64();
    Some([of("read")?, of("build")?, of("trace")?])
}

/// The slope of the straight line through the logarithms (least squares).
fn exponent(points: &[Point]) -> f64 {
    let logs: Vec<(f64, f64)> =
        points.iter().map(|p| ((p.n as f64).ln(), p.trace_s.max(1e-9).ln())).collect();
    let count = logs.len() as f64;
    let mean = logs.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / count, m.1 + p.1 / count));
    let (mut along, mut both) = (0.0, 0.0);
    for (x, y) in logs {
        along += (x - mean.0) * (x - mean.0);
        both += (x - mean.0) * (y - mean.1);
    }
    both / along
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_found_again() {
        let point = |n: u64| Point { n, read_s: 0.0, build_s: 0.0, trace_s: 3.0 * (n as f64).powf(0.7) };
        assert!((exponent(&[point(10), point(100), point(5000)]) - 0.7).abs() < 1e-12);
    }

    #[test]
    fn times_are_read_from_messages() {
        let text = "{\"severity\":\"warning\"}\n{\"code\":\"timing\",\"seconds\":{\"read\":1.0,\"build\":2.0,\"trace\":0.5}}\n";
        assert_eq!(steps(text), Some([1.0, 2.0, 0.5]));
        assert_eq!(steps("nothing"), None);
    }
}
