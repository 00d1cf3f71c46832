//! `cargo xtask conformance`: a folder of scenes through our renderer and through POV-Ray, side by side.

mod frames;
mod judge;
mod page;
mod report;
mod scene;

use crate::args::Args;
use crate::process;
use judge::Verdict;
use scene::Scene;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Everything that is the same for all scenes of a run.
pub struct Settings {
    binary: PathBuf,
    size: (u32, u32),
    /// May POV-Ray be run for missing references?
    povray: bool,
    /// A folder of reference pictures made before.
    references: Option<PathBuf>,
    /// The standard include folder, handed to both programs.
    library: Option<PathBuf>,
    /// Where pictures and the page go.
    out: PathBuf,
}

/// Runs the comparison; fails only when it cannot be made, since a folder of foreign scenes has no pass mark.
pub fn run(words: &[String]) -> Result<(), String> {
    let mut args = Args::new(words);
    let out = crate::target_folder()?.join("conformance");
    let absolute = |p: String| std::path::absolute(&p).map_err(|e| format!("{p}: {e}"));
    let settings = Settings {
        povray: args.flag("--povray"),
        size: args.size("--size", (160, 120))?,
        references: args.value("--references")?.map(absolute).transpose()?,
        library: args.value("--library")?.map(absolute).transpose()?.or_else(installed_library),
        binary: process::renderer(&mut args)?,
        out,
    };
    let jobs = args.parsed("--jobs", 1usize)?.max(1);
    let filter = args.value("--filter")?.unwrap_or_default();
    let root = absolute(args.last_word()?.ok_or("conformance needs a folder of scenes")?)?;
    let scenes = scene::find(&root, &filter)?;
    let verdicts = judge_all(&scenes, &settings, jobs)?;
    report::print(&scenes, &verdicts);
    let page = page::write(&scenes, &verdicts, &settings.out)?;
    println!("\npage: {}", page.display());
    Ok(())
}

/// The scene files below a folder, in a fixed order.
pub fn scenes_below(root: &Path) -> Result<Vec<PathBuf>, String> {
    Ok(scene::find(root, "")?.into_iter().map(|scene| scene.path).collect())
}

/// Debian's place for POV-Ray's include files, where they are installed.
pub fn installed_library() -> Option<PathBuf> {
    Some(PathBuf::from("/usr/share/povray-3.7/include")).filter(|p| p.is_dir())
}

/// Judges all scenes on a few threads; verdicts stand in the order of the scenes.
fn judge_all(scenes: &[Scene], settings: &Settings, jobs: usize) -> Result<Vec<Verdict>, String> {
    let next = AtomicUsize::new(0);
    let verdicts: Mutex<Vec<Option<Result<Verdict, String>>>> =
        Mutex::new(scenes.iter().map(|_| None).collect());
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(scene) = scenes.get(i) else { break };
                    let verdict = judge::judge(scene, settings);
                    eprintln!("[{}/{}] {}", i + 1, scenes.len(), scene.key);
                    verdicts.lock().expect("no thread panics with the lock")[i] = Some(verdict);
                }
            });
        }
    });
    verdicts.into_inner().expect("no thread panics with the lock").into_iter().flatten().collect()
}
