//! `cargo xtask dist`: the program as it is handed out, laid out by what it does when it renders.
//!
//! It is built twice: first so that it counts which way it goes how often, then with what it counted on the scenes of
//! this repository (profile-guided optimisation, the rustc book). Source and results are the same as `cargo build
//! --release` gives.

use crate::args::Args;
use crate::{conformance, process, root_folder, target_folder};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// Folders of scenes to learn from.
const TRAINING: [&str; 2] = ["conformance", "scenes"];
/// The size at which they are rendered: large enough that most of the time goes into rays.
const SIZE: &str = "160x120";
/// A scene that takes longer teaches nothing new.
const LIMIT: Duration = Duration::from_secs(60);

/// Builds the program twice and says where it is.
pub fn run(words: &[String]) -> Result<(), String> {
    let mut args = Args::new(words);
    let cpu = args.value("--cpu")?;
    if let Some(word) = args.last_word()? {
        return Err(format!("unexpected `{word}`"));
    }
    let host = said_by_rustc("host-tuple")?;
    let merge = merge_tool(&host)?;
    let folder = target_folder()?.join("dist");
    let (counts, profile) = (folder.join("counts"), folder.join("raggio.profdata"));
    // There may be none yet.
    let _ = std::fs::remove_dir_all(&counts);
    std::fs::create_dir_all(&counts).map_err(|e| format!("{}: {e}", counts.display()))?;
    let flags = |profile: String| [Some(profile), cpu.as_ref().map(|cpu| format!("-Ctarget-cpu={cpu}"))];
    let binary = build(&folder, &host, flags(format!("-Cprofile-generate={}", counts.display())))?;
    train(&binary, &counts, &folder.join("training.png"))?;
    succeed(Command::new(merge).arg("merge").arg("-o").arg(&profile).arg(&counts))?;
    let binary = build(&folder, &host, flags(format!("-Cprofile-use={}", profile.display())))?;
    println!("{}", binary.display());
    Ok(())
}

fn said_by_rustc(what: &str) -> Result<String, String> {
    let said = Command::new("rustc").args(["--print", what]).output().map_err(|e| format!("rustc: {e}"))?;
    Ok(String::from_utf8_lossy(&said.stdout).trim().to_string())
}

/// The tool that puts counts together; it comes with rustc as a component.
fn merge_tool(host: &str) -> Result<PathBuf, String> {
    let name = format!("llvm-profdata{}", std::env::consts::EXE_SUFFIX);
    let sysroot = said_by_rustc("sysroot")?;
    let tool = Path::new(&sysroot).join("lib/rustlib").join(host).join("bin").join(name);
    match tool.exists() {
        true => Ok(tool),
        false => Err(format!("{} is missing: rustup component add llvm-tools", tool.display())),
    }
}

/// Builds the program with flags for the compiler. The target is named so that they count for it alone, not for what
/// runs while it is built.
fn build(folder: &Path, host: &str, flags: [Option<String>; 2]) -> Result<PathBuf, String> {
    let flags: Vec<String> = flags.into_iter().flatten().collect();
    let mut command = Command::new("cargo");
    command
        .args(["build", "--release", "--package", "raggio-cli", "--target", host, "--target-dir"])
        .arg(folder);
    command.env("CARGO_ENCODED_RUSTFLAGS", flags.join("\x1f")).current_dir(root_folder());
    succeed(&mut command)?;
    Ok(folder.join(host).join("release").join(format!("raggio{}", std::env::consts::EXE_SUFFIX)))
}

/// Renders scenes with the program that counts. Some of them are there to be refused.
fn train(binary: &Path, counts: &Path, picture: &Path) -> Result<(), String> {
    let mut rendered = 0;
    for folder in TRAINING {
        for scene in conformance::scenes_below(&root_folder().join(folder))? {
            let mut command = Command::new(binary);
            command.current_dir(scene.parent().unwrap_or(Path::new(".")));
            command.arg("render").arg(&scene).args(["--size", SIZE, "--threads", "1", "-o"]).arg(picture);
            // All runs add to one file for each of them that goes on at the same time.
            command.env("LLVM_PROFILE_FILE", counts.join("%1m.profraw"));
            rendered += usize::from(process::run(&mut command, LIMIT)?.code == Some(0));
        }
    }
    println!("learnt from {rendered} scenes");
    Ok(())
}

fn succeed(command: &mut Command) -> Result<(), String> {
    let status = command.status().map_err(|e| format!("{:?}: {e}", command.get_program()))?;
    if status.success() { Ok(()) } else { Err(format!("{:?}: {status}", command.get_program())) }
}
