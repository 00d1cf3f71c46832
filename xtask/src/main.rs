//! The house's own tools: `cargo xtask tidy | conformance | bench | speed-parse | scaling | fuzz | dist`. No other crate may depend on this one.

mod args;
mod bench;
mod conformance;
mod dist;
mod fuzz;
mod picture;
mod process;
mod scaling;
mod tidy;

use std::path::PathBuf;
use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask <command>

  tidy
      floors of the workspace, sizes of files and functions, headings, leftovers
  conformance FOLDER [--povray] [--jobs N] [--filter TEXT] [--size 160x120]
              [--references FOLDER] [--library FOLDER] [--binary FILE]
      every scene below the folder with our renderer and with POV-Ray, compared by FLIP;
      --povray makes missing references, --references takes finished ones
  bench FOLDER [--set speed] [--antialias] [--filter TEXT] [--runs 3] [--threads 2] [--binary FILE]
      whole-process times against POV-Ray for the scenes in benches/SET.txt
  speed-parse [--runs 3] [--binary FILE]
      the same for scenes/bench/parse-*.pov, whose time goes into reading
  scaling [--filter TEXT] [--most N] [--runs 3] [--binary FILE]
      how the time to trace grows with pixels, objects, lights, depth, threads
  fuzz FOLDER [--count 300] [--seed 1] [--seconds 30] [--binary FILE]
      scenes below the folder with a few words changed: each must end in a picture or an error message
  dist [--cpu NAME]
      the fastest program: built with what it was seen to do on the scenes of this repository
";

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1);
    let command = words.next().unwrap_or_default();
    let rest: Vec<String> = words.collect();
    let outcome = match command.as_str() {
        "tidy" => tidy::run(&rest),
        "conformance" => conformance::run(&rest),
        "bench" => bench::frames(&rest),
        "speed-parse" => bench::parse(&rest),
        "scaling" => scaling::run(&rest),
        "fuzz" => fuzz::run(&rest),
        "dist" => dist::run(&rest),
        _ => Err(USAGE.to_string()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// The root of the workspace: this crate's folder's parent.
fn root_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| PathBuf::from("."), PathBuf::from)
}

/// Where builds and results go.
fn target_folder() -> Result<PathBuf, String> {
    match std::env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => std::path::absolute(folder).map_err(|e| format!("CARGO_TARGET_DIR: {e}")),
        None => Ok(root_folder().join("target")),
    }
}
