//! The result to look at: expected | difference | actual of each scene, worst first.

use super::judge::{Status, Verdict};
use super::scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const HEAD: &str = "<!doctype html><meta charset=utf-8><title>Conformance</title><style>\
body{font:14px sans-serif;margin:2em;background:#222;color:#ddd}img{image-rendering:pixelated;height:240px}\
h2{margin:1em 0 .2em;font-size:15px}.match{color:#7c7}.bad{color:#e77}.skip{color:#888}</style>\
<h1>expected | difference | actual</h1>\n";

/// Writes `index.html` and returns its path.
pub fn write(scenes: &[Scene], verdicts: &[Verdict], out: &Path) -> Result<PathBuf, String> {
    let mut order: Vec<usize> = (0..scenes.len()).collect();
    order.sort_by(|&a, &b| badness(&verdicts[b].status).total_cmp(&badness(&verdicts[a].status)));
    let mut html = String::from(HEAD);
    for i in order {
        let (class, text) = describe(&verdicts[i].status);
        // Writing to a string cannot fail.
        let _ = writeln!(html, "<h2 class={class}>{} {}</h2>", escape(&scenes[i].key), escape(&text));
        if let Some(path) = &verdicts[i].panel {
            let _ = write!(html, "<img src=\"file://{}\">", escape(&path.to_string_lossy()));
        }
    }
    let path = out.join("index.html");
    std::fs::create_dir_all(out).map_err(|e| format!("{}: {e}", out.display()))?;
    std::fs::write(&path, html).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(path)
}

/// Failures first, then by error, skipped ones last.
fn badness(status: &Status) -> f32 {
    match status {
        Status::Panic(_) => 4.0,
        Status::Timeout => 3.0,
        Status::Diagnostic(_) => 2.0,
        Status::Differs(error) => 1.0 + error,
        Status::Match(error) => *error,
        Status::Skipped(_) => -1.0,
    }
}

fn describe(status: &Status) -> (&'static str, String) {
    match status {
        Status::Match(error) => ("match", format!("{error:.4}")),
        Status::Differs(error) => ("bad", format!("differs {error:.4}")),
        Status::Diagnostic(message) => ("bad", message.clone()),
        Status::Panic(message) => ("bad", format!("panic: {message}")),
        Status::Timeout => ("bad", "timeout".into()),
        Status::Skipped(why) => ("skip", format!("skipped: {why}")),
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
