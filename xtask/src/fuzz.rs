//! `cargo xtask fuzz`: scenes with a few words changed must end in a picture or in an error message, nothing else.

use crate::args::Args;
use crate::{conformance, process};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// Larger files are left out: reading them takes the time of many small ones.
const LARGEST: usize = 30_000;

/// What takes the place of a number.
const NUMBERS: [&str; 12] =
    ["0", "-1", "1e308", "-1e308", "1e-300", "(1/0)", "sqrt(-1)", "99999999", "<1, 2>", "0.5", "1e10", "x"];

/// What takes the place of any word.
const WORDS: [&str; 14] = [
    "}",
    "{",
    "(",
    ")",
    ",",
    ";",
    "#end",
    "#else",
    "rgb",
    "texture {",
    "\"\"",
    "<0, 0, 0>",
    "union {",
    "#declare",
];

/// Changes scenes below a folder and renders them small. Same seed, same changes.
pub fn run(words: &[String]) -> Result<(), String> {
    let mut args = Args::new(words);
    let binary = process::renderer(&mut args)?;
    let (seed, count) = (args.parsed("--seed", 1u64)?, args.parsed("--count", 300usize)?);
    let limit = Duration::from_secs(args.parsed("--seconds", 30)?);
    let root = args.last_word()?.ok_or("fuzz needs a folder of scenes")?;
    let root = std::path::absolute(&root).map_err(|e| format!("{root}: {e}"))?;
    let scenes = small_scenes(&root)?;
    let mut rng = fastrand::Rng::with_seed(seed);
    let kept = crate::target_folder()?.join("fuzz");
    std::fs::create_dir_all(&kept).map_err(|e| format!("{}: {e}", kept.display()))?;
    let (mut broken, mut slow) = (0, 0);
    for i in 0..count {
        let (path, text) = &scenes[rng.usize(..scenes.len())];
        let changed = kept.join(format!("{seed}-{i}.pov"));
        std::fs::write(&changed, mutated(text, &mut rng))
            .map_err(|e| format!("{}: {e}", changed.display()))?;
        let done = process::run(&mut render(&binary, &changed, path), limit)?;
        if matches!(done.code, Some(0 | 1)) {
            // One that cannot be removed is overwritten by the next run.
            let _ = std::fs::remove_file(&changed);
            continue;
        }
        let how = if done.timed_out { "takes too long" } else { "breaks" };
        println!("{} {how}, made from {}", changed.display(), path.display());
        *(if done.timed_out { &mut slow } else { &mut broken }) += 1;
    }
    println!("{count} changed scenes: {broken} broke the program, {slow} took more than {limit:?}");
    if broken == 0 { Ok(()) } else { Err(format!("{broken} scenes ended in neither picture nor error")) }
}

fn small_scenes(root: &Path) -> Result<Vec<(PathBuf, String)>, String> {
    let mut scenes = Vec::new();
    for path in conformance::scenes_below(root)? {
        let bytes = std::fs::read(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        if bytes.len() <= LARGEST {
            scenes.push((path, String::from_utf8_lossy(&bytes).into_owned()));
        }
    }
    if scenes.is_empty() { Err(format!("no small scenes below {}", root.display())) } else { Ok(scenes) }
}

/// The files beside the scene that a changed one was made from are found as a library's; what it writes itself lands
/// beside the changed one.
fn render(binary: &Path, scene: &Path, original: &Path) -> Command {
    let mut command = Command::new(binary);
    command.current_dir(scene.parent().unwrap_or(Path::new(".")));
    command.arg("render").arg(scene).args(["--size", "12x9", "--threads", "1", "-o"]);
    command.arg(scene.with_extension("png"));
    if let Some(folder) = original.parent() {
        command.arg("--library").arg(folder);
    }
    command
}

/// One to three words replaced, left out, doubled or exchanged.
fn mutated(text: &str, rng: &mut fastrand::Rng) -> String {
    let mut words = split(text);
    for _ in 0..rng.usize(1..=3) {
        let places: Vec<usize> = (0..words.len()).filter(|&i| !words[i].trim().is_empty()).collect();
        let numbers: Vec<usize> =
            places.iter().copied().filter(|&i| words[i].starts_with(|c: char| c.is_ascii_digit())).collect();
        let Some(&at) = rng.choice(&places) else { break };
        match (rng.u32(..100), rng.choice(&numbers)) {
            (0..40, Some(&number)) => words[number] = NUMBERS[rng.usize(..NUMBERS.len())].into(),
            (0..55, _) => words[at].clear(),
            (55..70, _) => words[at] = WORDS[rng.usize(..WORDS.len())].into(),
            (other, _) => {
                let from = words[places[rng.usize(..places.len())]].clone();
                words[at] = if other < 85 { from } else { format!("{} {from}", words[at]) };
            }
        }
    }
    words.concat()
}

/// Words, numbers, runs of blanks, and single signs; together they are the text again.
fn split(text: &str) -> Vec<String> {
    #[derive(PartialEq)]
    enum Kind {
        Word,
        Blank,
        Sign,
    }
    let kind = |c: char| match c {
        c if c.is_alphanumeric() || c == '_' || c == '.' => Kind::Word,
        c if c.is_whitespace() => Kind::Blank,
        _ => Kind::Sign,
    };
    let mut words: Vec<String> = Vec::new();
    let mut last = Kind::Sign;
    for c in text.chars() {
        let this = kind(c);
        match words.last_mut() {
            Some(word) if this == last && this != Kind::Sign => word.push(c),
            _ => words.push(c.to_string()),
        }
        last = this;
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_split_without_loss() {
        let text = "sphere { <0, 1.5,-2>, r_1 } // \"end\"\n";
        let words = split(text);
        assert_eq!(words.concat(), text);
        assert_eq!(&words[..5], ["sphere", " ", "{", " ", "<"]);
        assert!(words.contains(&"1.5".to_string()) && words.contains(&"r_1".to_string()));
    }

    #[test]
    fn the_same_seed_makes_the_same_changes() {
        let text = "box { 0, 1 pigment { rgb 0.5 } }";
        let change = |seed| mutated(text, &mut fastrand::Rng::with_seed(seed));
        assert_eq!(change(7), change(7));
        assert!((0..20).filter(|&seed| change(seed) != text).count() > 15);
        assert_eq!(mutated("", &mut fastrand::Rng::with_seed(1)), "");
    }
}
