//! `cargo xtask bench` and `speed-parse`: whole processes, ours and POV-Ray's in turn, and the ratio of their medians.

use crate::args::{Args, parse_size};
use crate::conformance::installed_library;
use crate::process;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, SystemTime};

/// A scene and the size at which it is timed.
struct Job {
    name: String,
    scene: PathBuf,
    size: (u32, u32),
}

/// One line of the result.
#[derive(Serialize)]
struct Timing {
    scene: String,
    width: u32,
    height: u32,
    povray_s: f64,
    raggio_s: f64,
    ratio: f64,
}

#[derive(Serialize)]
struct Results {
    command: String,
    threads: usize,
    runs: usize,
    geometric_mean: f64,
    worst: f64,
    failed: Vec<String>,
    timings: Vec<Timing>,
}

/// What is timed.
#[derive(Clone, Copy, PartialEq)]
enum What {
    /// The whole process, wall clock.
    Frame,
    /// Reading the scene, as each program says itself.
    Reading,
}

/// What both commands need to know.
struct Runner {
    what: What,
    binary: PathBuf,
    runs: usize,
    threads: usize,
    /// With both programs' own anti-aliasing.
    antialias: bool,
    limit: Duration,
}

/// The scenes of a list in `benches/`, `speed` unless `--set` names another. They are found below a folder of
/// POV-Ray's examples, those that begin with `scenes/` in the project.
pub fn frames(words: &[String]) -> Result<(), String> {
    let mut args = Args::new(words);
    let runner = Runner::from_args(&mut args, What::Frame)?;
    let filter = args.value("--filter")?.unwrap_or_default();
    let set = args.value("--set")?.unwrap_or_else(|| "speed".into());
    let root = PathBuf::from(args.last_word()?.ok_or("bench needs the folder of POV-Ray's examples")?);
    let jobs = read_list(&set, &root, &filter)?;
    let (mut command, mut name) = ("bench".to_string(), "bench".to_string());
    if set != "speed" {
        command += &format!(" --set {set}");
        name += &format!("-{set}");
    }
    if runner.antialias {
        command += " --antialias";
        name += "-antialiased";
    }
    runner.run(&command, &name, &jobs)
}

/// The jobs of `benches/SET.txt` whose names contain `filter`.
fn read_list(set: &str, root: &Path, filter: &str) -> Result<Vec<Job>, String> {
    let list = crate::root_folder().join(format!("benches/{set}.txt"));
    let text = std::fs::read_to_string(&list).map_err(|e| format!("{}: {e}", list.display()))?;
    let mut jobs = Vec::new();
    for line in text.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with('#')) {
        let (name, size) =
            line.split_once(char::is_whitespace).ok_or_else(|| format!("no size in `{line}`"))?;
        let size = parse_size(size.trim()).ok_or_else(|| format!("`{size}` is no size"))?;
        if name.contains(filter) {
            let own = name.starts_with("scenes/").then(crate::root_folder);
            jobs.push(Job { name: name.into(), scene: own.as_deref().unwrap_or(root).join(name), size });
        }
    }
    Ok(jobs)
}

/// The scenes `scenes/bench/parse-*.pov`: how long reading them takes, by what both programs print of it.
pub fn parse(words: &[String]) -> Result<(), String> {
    let mut args = Args::new(words);
    let runner = Runner::from_args(&mut args, What::Reading)?;
    if let Some(word) = args.last_word()? {
        return Err(format!("unexpected `{word}`"));
    }
    let folder = crate::root_folder().join("scenes/bench");
    let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut jobs: Vec<Job> = entries
        .flatten()
        .map(|e| (e.file_name().to_string_lossy().into_owned(), e.path()))
        .filter(|(name, _)| name.starts_with("parse-") && name.ends_with(".pov"))
        .map(|(name, scene)| Job { name, scene, size: (16, 12) })
        .collect();
    jobs.sort_by(|a, b| a.name.cmp(&b.name));
    runner.run("speed-parse", "speed-parse", &jobs)
}

impl Runner {
    fn from_args(args: &mut Args, what: What) -> Result<Self, String> {
        let binary = process::renderer(args)?;
        let runs = args.parsed("--runs", 3usize)?.max(1);
        Ok(Runner {
            what,
            binary,
            runs,
            threads: args.parsed("--threads", 2)?,
            antialias: args.flag("--antialias"),
            limit: Duration::from_secs(300),
        })
    }

    /// Times all jobs. `command` repeats it, `name` is that of its results.
    fn run(&self, command: &str, name: &str, jobs: &[Job]) -> Result<(), String> {
        let mut timings = Vec::new();
        let mut failed = Vec::new();
        println!("{:<48} {:>10} {:>9} {:>9} {:>7}", "scene", "size", "POV-Ray", "Raggio", "ratio");
        for job in jobs {
            match self.time(job)? {
                Ok(t) => {
                    let size = format!("{}x{}", t.width, t.height);
                    println!(
                        "{:<48} {size:>10} {:>8.2}s {:>8.2}s {:>7.2}",
                        t.scene, t.povray_s, t.raggio_s, t.ratio
                    );
                    timings.push(t);
                }
                Err(why) => {
                    println!("{:<48} {why}", job.name);
                    failed.push(format!("{}: {why}", job.name));
                }
            }
        }
        let ratios: Vec<f64> = timings.iter().map(|t| t.ratio).collect();
        let results = Results {
            command: format!("cargo xtask {command}"),
            threads: self.threads,
            runs: self.runs,
            geometric_mean: geometric_mean(&ratios),
            worst: ratios.iter().copied().fold(f64::INFINITY, f64::min),
            failed,
            timings,
        };
        println!(
            "\n{} scenes: geometric mean {:.2}, worst {:.2}",
            ratios.len(),
            results.geometric_mean,
            results.worst
        );
        save(name, &results)
    }

    /// Both programs in turn. The inner error says which of them does not render the scene.
    fn time(&self, job: &Job) -> Result<Result<Timing, String>, String> {
        let (mut theirs, mut ours) = (Vec::new(), Vec::new());
        for _ in 0..self.runs {
            for (name, mut command, times) in
                [("POV-Ray", self.peer(job), &mut theirs), ("Raggio", self.own(job), &mut ours)]
            {
                let done = process::run(&mut command, self.limit)?;
                if done.code != Some(0) {
                    return Ok(Err(format!("{name} does not render it")));
                }
                times.push(match self.what {
                    What::Frame => done.wall.as_secs_f64(),
                    What::Reading => reading_time(&done.stderr).ok_or(format!("{name} says no time"))?,
                });
            }
        }
        let (povray_s, raggio_s) = (median(&mut theirs), median(&mut ours));
        let (width, height) = job.size;
        Ok(Ok(Timing {
            scene: job.name.clone(),
            width,
            height,
            povray_s,
            raggio_s,
            ratio: povray_s / raggio_s,
        }))
    }

    fn peer(&self, job: &Job) -> Command {
        let (folder, name) = place(&job.scene);
        let mut command = Command::new("povray");
        command.current_dir(folder).arg(format!("+I\"{name}\"")).arg(format!("+O\"{}\"", picture("povray")));
        command.arg(format!("+W{}", job.size.0)).arg(format!("+H{}", job.size.1)).arg("-D");
        command.arg(if self.antialias { "+A0.3" } else { "-A" });
        command.arg(format!("+WT{}", self.threads));
        if let Some(library) = installed_library() {
            command.arg(format!("+L\"{}\"", library.display()));
        }
        command
    }

    fn own(&self, job: &Job) -> Command {
        let (folder, name) = place(&job.scene);
        let mut command = Command::new(&self.binary);
        command.current_dir(folder).arg("render").arg(name).arg("-o").arg(picture("raggio"));
        command.arg("--size").arg(format!("{}x{}", job.size.0, job.size.1));
        command.arg("--threads").arg(self.threads.to_string()).arg("--timing");
        if self.antialias {
            command.arg("--antialias=0.3");
        }
        if let Some(library) = installed_library() {
            command.arg("--library").arg(library);
        }
        command
    }
}

/// Seconds of reading by a program's own words: `Parse Time: ... (1.234 seconds)` or `read 1.234 s, build ...`.
fn reading_time(stderr: &str) -> Option<f64> {
    stderr.lines().find_map(|line| {
        let theirs = || line.split_once("Parse Time:")?.1.split_once('(')?.1.split_once(" seconds)");
        let ours = || line.strip_prefix("read ")?.split_once(" s,");
        theirs().or_else(ours)?.0.trim().parse().ok()
    })
}

fn place(scene: &Path) -> (&Path, String) {
    let name = scene.file_name().unwrap_or_default().to_string_lossy().into_owned();
    (scene.parent().unwrap_or(Path::new(".")), name)
}

fn picture(program: &str) -> String {
    std::env::temp_dir()
        .join(format!("bench-{program}-{}.png", std::process::id()))
        .to_string_lossy()
        .into_owned()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn geometric_mean(values: &[f64]) -> f64 {
    (values.iter().map(|v| v.ln()).sum::<f64>() / values.len().max(1) as f64).exp()
}

/// Writes results to `benches/results/`, with the day and the machine.
pub fn save(name: &str, results: &impl Serialize) -> Result<(), String> {
    let seconds = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |t| t.as_secs());
    let date = date_of((seconds / 86_400) as i64);
    let folder = crate::root_folder().join("benches/results");
    let path = folder.join(format!("{date}-{name}.json"));
    let dated = serde_json::json!({ "date": date, "machine": machine(), "results": results });
    let text = serde_json::to_string_pretty(&dated).map_err(|e| e.to_string())?;
    std::fs::create_dir_all(&folder)
        .and_then(|()| std::fs::write(&path, text + "\n"))
        .map_err(|e| format!("{}: {e}", path.display()))?;
    println!("written: {}", path.display());
    Ok(())
}

/// Processor, as far as the system tells, and cores.
fn machine() -> String {
    let known = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = known.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let model = model.map_or(std::env::consts::ARCH, |(_, model)| model.trim());
    format!("{model}, {} cores", std::thread::available_parallelism().map_or(1, usize::from))
}

/// The day in the calendar, by its number since 1970 (Howard Hinnant's `civil_from_days`).
fn date_of(days: i64) -> String {
    let days = days + 719_468;
    let era = days.div_euclid(146_097);
    let day_of_era = days.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_programs_tell_their_reading_time() {
        let theirs = "Parser Time\n  Parse Time:       0 hours  0 minutes  3 seconds (3.586 seconds)\n              using 1 thread(s)";
        assert_eq!(reading_time(theirs), Some(3.586));
        assert_eq!(reading_time("warning\nread 0.250 s, build 0.100 s\n"), Some(0.25));
        assert_eq!(reading_time("nothing"), None);
    }

    #[test]
    fn days_have_their_dates() {
        assert_eq!(date_of(0), "1970-01-01");
        assert_eq!(date_of(11_016), "2000-02-29");
        assert_eq!(date_of(20_779), "2026-11-22");
    }

    #[test]
    fn medians_and_means() {
        assert_eq!(median(&mut [9.0, 1.0, 3.0]), 3.0);
        assert!((geometric_mean(&[1.0, 4.0]) - 2.0).abs() < 1e-12);
    }
}
