//! `cargo xtask tidy`: the rules of the house that the compiler does not know.

mod floors;
mod source;

use source::SourceFile;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// No file may be longer, unless the allow list says why.
const MAX_FILE_LINES: usize = 800;
/// No function may be longer, unless the allow list says why.
const MAX_FUNCTION_LINES: usize = 80;

/// Checks the workspace, prints the table of sizes, and fails with the list of what is wrong.
pub fn run(args: &[String]) -> Result<(), String> {
    if let Some(extra) = args.first() {
        return Err(format!("tidy takes no arguments, found `{extra}`"));
    }
    let metadata = floors::metadata()?;
    let root = PathBuf::from(metadata["workspace_root"].as_str().unwrap_or("."));
    let mut faults = floors::check(&metadata);

    let allow = AllowList::read(&root)?;
    let mut used = vec![false; allow.entries.len()];
    let mut sizes: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (room, folder) in floors::rooms(&metadata) {
        for path in rust_files(&folder) {
            let file = SourceFile::read(&root, &path)?;
            sizes.entry(room.clone()).or_default().push(file.lines);
            faults.extend(judge(&file, &allow, &mut used));
        }
    }
    for (entry, used) in allow.entries.iter().zip(used) {
        if !used {
            faults.push(format!("xtask/tidy-allow.txt: `{}` is no longer needed", entry.key));
        }
    }
    print_table(&sizes);
    if faults.is_empty() {
        println!("tidy: all in order");
        return Ok(());
    }
    Err(format!("{}\ntidy: {} faults", faults.join("\n"), faults.len()))
}

/// What is wrong with one file.
fn judge(file: &SourceFile, allow: &AllowList, used: &mut [bool]) -> Vec<String> {
    let mut faults = Vec::new();
    if file.lines > MAX_FILE_LINES && !allow.permits(&file.path, used) {
        faults.push(format!("{}: {} lines, at most {MAX_FILE_LINES}", file.path, file.lines));
    }
    for f in &file.functions {
        let key = format!("{}::{}", file.path, f.name);
        if f.lines > MAX_FUNCTION_LINES && !allow.permits(&key, used) {
            faults.push(format!(
                "{}:{}: function `{}` has {} lines, at most {MAX_FUNCTION_LINES}",
                file.path, f.first_line, f.name, f.lines
            ));
        }
    }
    if !file.has_heading {
        faults.push(format!("{}:1: the first line must be `//!`: what room is this?", file.path));
    }
    // A test's stub may be one that must never be reached.
    let is_test = file.path.contains("/tests/");
    for (line, macro_name) in file.leftovers.iter().filter(|(_, name)| !(is_test && name == "unimplemented"))
    {
        faults.push(format!("{}:{line}: `{macro_name}!` is left over", file.path));
    }
    faults
}

/// Files and functions that may be long, each with its reason: `path` or `path::function`, blanks, the reason.
struct AllowList {
    entries: Vec<AllowEntry>,
}

struct AllowEntry {
    key: String,
}

impl AllowList {
    fn read(root: &Path) -> Result<Self, String> {
        let path = root.join("xtask/tidy-allow.txt");
        let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        let mut entries = Vec::new();
        for (i, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let Some((key, _reason)) = line.split_once(char::is_whitespace) else {
                return Err(format!("{}:{}: `{line}` gives no reason", path.display(), i + 1));
            };
            entries.push(AllowEntry { key: key.to_string() });
        }
        Ok(AllowList { entries })
    }

    fn permits(&self, key: &str, used: &mut [bool]) -> bool {
        let found = self.entries.iter().position(|e| e.key == key);
        if let Some(i) = found {
            used[i] = true;
        }
        found.is_some()
    }
}

/// Every `.rs` file of a package, in a fixed order.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(dir) = open.pop() {
        for entry in std::fs::read_dir(&dir).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() && path.file_name().is_some_and(|n| n != "target") {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn print_table(sizes: &BTreeMap<String, Vec<usize>>) {
    println!("{:<10} {:>6} {:>7} {:>7} {:>7}", "room", "files", "lines", "median", "longest");
    for (room, lines) in sizes {
        let mut sorted = lines.clone();
        sorted.sort_unstable();
        println!(
            "{room:<10} {:>6} {:>7} {:>7} {:>7}",
            sorted.len(),
            sorted.iter().sum::<usize>(),
            sorted[sorted.len() / 2],
            sorted[sorted.len() - 1]
        );
    }
}
