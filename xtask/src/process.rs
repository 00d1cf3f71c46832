//! Running programs with a time limit, ours above all.

use crate::args::Args;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Our program: what `--binary` says, or the one that `cargo build --release` makes.
pub fn renderer(args: &mut Args) -> Result<PathBuf, String> {
    let binary = match args.value("--binary")? {
        Some(path) => PathBuf::from(path),
        None => crate::target_folder()?.join("release/raggio"),
    };
    let binary = std::path::absolute(&binary).map_err(|e| format!("{}: {e}", binary.display()))?;
    if binary.exists() {
        Ok(binary)
    } else {
        Err(format!("{} is missing: cargo build --release", binary.display()))
    }
}

/// How a program ended.
pub struct Outcome {
    /// Exit status; `None` when it was stopped by us or by a signal.
    pub code: Option<i32>,
    /// Did it run past its limit?
    pub timed_out: bool,
    /// Wall clock time of the whole process.
    pub wall: Duration,
    /// What it wrote to standard error.
    pub stderr: String,
}

/// Runs a command without input; standard output is dropped.
pub fn run(command: &mut Command, limit: Duration) -> Result<Outcome, String> {
    let log = std::env::temp_dir().join(format!(
        "xtask-{}-{:?}.log",
        std::process::id(),
        std::thread::current().id()
    ));
    let said = |e: std::io::Error| format!("{:?}: {e}", command.get_program());
    let file = std::fs::File::create(&log).map_err(said)?;
    let program = format!("{:?}", command.get_program());
    let start = Instant::now();
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(file)
        .spawn()
        .map_err(|e| format!("{program}: {e}"))?;
    let mut timed_out = false;
    let status = loop {
        if let Some(status) = child.try_wait().map_err(|e| format!("{program}: {e}"))? {
            break status;
        }
        if start.elapsed() > limit && !timed_out {
            timed_out = true;
            child.kill().map_err(|e| format!("{program}: {e}"))?;
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    let wall = start.elapsed();
    let stderr = String::from_utf8_lossy(&std::fs::read(&log).unwrap_or_default()).into_owned();
    // A log that stays behind in the temporary folder does no harm.
    let _ = std::fs::remove_file(&log);
    Ok(Outcome { code: if timed_out { None } else { status.code() }, timed_out, wall, stderr })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exit_codes_messages_and_limits_are_reported() {
        let done =
            run(Command::new("sh").args(["-c", "echo no >&2; exit 3"]), Duration::from_secs(5)).expect("ran");
        assert_eq!((done.code, done.stderr.as_str(), done.timed_out), (Some(3), "no\n", false));
        let slow = run(Command::new("sleep").arg("5"), Duration::from_millis(50)).expect("ran");
        assert!(slow.timed_out && slow.code.is_none());
        assert!(slow.wall < Duration::from_secs(4));
    }
}
