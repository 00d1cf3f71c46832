//! The result in words: matches per folder, the worst by name, and what was refused and why.

use super::judge::{Status, Verdict};
use super::scene::Scene;
use std::collections::BTreeMap;

/// How many of the worst scenes are named in each folder.
const WORST: usize = 5;

#[derive(Default)]
struct Group<'a> {
    matched: usize,
    renderable: usize,
    /// Error and name of the scenes that do not match; no picture counts as the worst.
    others: Vec<(f32, &'a str, &'static str)>,
}

/// Prints the report.
pub fn print(scenes: &[Scene], verdicts: &[Verdict]) {
    let mut groups: BTreeMap<&str, Group> = BTreeMap::new();
    let mut messages: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for (scene, verdict) in scenes.iter().zip(verdicts) {
        let group = groups.entry(&scene.group).or_default();
        group.renderable += 1;
        let mut other = |error, what| group.others.push((error, scene.key.as_str(), what));
        match &verdict.status {
            Status::Match(_) => group.matched += 1,
            Status::Differs(error) => other(*error, "differs"),
            Status::Diagnostic(message) => {
                other(f32::INFINITY, "diagnostic");
                messages.entry(general(message)).or_default().push(&scene.key);
            }
            Status::Panic(message) => {
                other(f32::INFINITY, "panic");
                messages.entry(format!("PANIC {message}")).or_default().push(&scene.key);
            }
            Status::Timeout => other(f32::INFINITY, "timeout"),
            Status::Skipped(_) => group.renderable -= 1,
        }
    }
    print_groups(&mut groups);
    print_messages(&messages);
}

fn print_groups(groups: &mut BTreeMap<&str, Group>) {
    println!("\n{:<16} matched/renderable", "folder");
    let (mut matched, mut renderable) = (0, 0);
    for (name, group) in groups.iter_mut() {
        println!("{name:<16} {}/{}", group.matched, group.renderable);
        matched += group.matched;
        renderable += group.renderable;
        group.others.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
        for (error, key, what) in group.others.iter().take(WORST) {
            let figure = if error.is_finite() { format!("{error:.4}") } else { "-".into() };
            println!("    {what:<10} {figure:>6}  {key}");
        }
        if group.others.len() > WORST {
            println!("    and {} more", group.others.len() - WORST);
        }
    }
    println!("{:<16} {matched}/{renderable}", "all");
}

fn print_messages(messages: &BTreeMap<String, Vec<&str>>) {
    if messages.is_empty() {
        return;
    }
    println!("\nrefused:");
    let mut sorted: Vec<_> = messages.iter().collect();
    sorted.sort_by_key(|(_, scenes)| std::cmp::Reverse(scenes.len()));
    for (message, scenes) in sorted {
        println!("{:>4}  {message}\n      {}", scenes.len(), scenes[..scenes.len().min(4)].join(", "));
    }
}

/// The message without the names in quotes, so that equal causes fall together.
fn general(message: &str) -> String {
    message
        .split('`')
        .enumerate()
        .map(|(i, part)| if i % 2 == 0 { part } else { "…" })
        .collect::<Vec<_>>()
        .join("`")
}

#[cfg(test)]
mod tests {
    use super::general;

    #[test]
    fn names_in_quotes_do_not_tell_messages_apart() {
        assert_eq!(general("error: cannot find `a.inc`"), general("error: cannot find `b.inc`"));
        assert_ne!(general("error: no `a`"), general("error: not `a`"));
    }
}
