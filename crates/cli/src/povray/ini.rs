//! Command lines and INI files: words, quotes, comments, sections, files that name files.
use std::path::{Path, PathBuf};

use super::keys::{OptionError, Settings};
use super::switches;

/// How deep INI files may name each other.
const DEEPEST: usize = 16;

/// Applies the words of a command line in their order.
///
/// An argument with spaces falls apart at them, unless it has quotes of its own: that is how `+I"a b.pov"` arrives from
/// callers that quote for a shell that is not there.
pub(crate) fn apply_arguments(arguments: &[String], settings: &mut Settings) -> Result<(), OptionError> {
    for word in arguments.iter().flat_map(|argument| words(argument)) {
        apply_word(&word, settings, 0)?;
    }
    Ok(())
}

/// Reads an INI file, `name.ini` or `name.ini[section]`.
pub(crate) fn apply_file(name: &str, settings: &mut Settings) -> Result<(), OptionError> {
    apply_nested(name, settings, 0)
}

/// A switch, `key=value`, a scene or an INI file.
fn apply_word(word: &str, settings: &mut Settings, depth: usize) -> Result<(), OptionError> {
    if word.starts_with(['+', '-']) {
        return switches::apply(word, settings);
    }
    match word.split_once('=') {
        Some((key, value)) if !key.contains('[') => apply_key(key, value, settings, depth),
        _ if ends_with(word, ".pov") => settings.set("Input_File_Name", word),
        _ => apply_nested(word, settings, depth),
    }
}

fn apply_key(key: &str, value: &str, settings: &mut Settings, depth: usize) -> Result<(), OptionError> {
    if key.eq_ignore_ascii_case("Include_Ini") {
        return apply_nested(value, settings, depth);
    }
    settings.set(key, value)
}

fn ends_with(word: &str, ending: &str) -> bool {
    word.len() >= ending.len()
        && word.is_char_boundary(word.len() - ending.len())
        && word[word.len() - ending.len()..].eq_ignore_ascii_case(ending)
}

fn apply_nested(name: &str, settings: &mut Settings, depth: usize) -> Result<(), OptionError> {
    let (file, section) = match name.strip_suffix(']').and_then(|n| n.rsplit_once('[')) {
        Some((file, section)) => (file, Some(section)),
        None => (name, None),
    };
    if depth >= DEEPEST {
        return Err(OptionError::new(name, "INI files name each other in a circle"));
    }
    let text = find(file, &settings.libraries)
        .and_then(|path| std::fs::read(path).ok())
        .ok_or_else(|| OptionError::new(name, "there is no such INI file"))?;
    apply_text(&String::from_utf8_lossy(&text), section, settings, depth)
}

/// The file itself or with `.ini`, here or in the library folders.
fn find(name: &str, libraries: &[String]) -> Option<PathBuf> {
    let folders = std::iter::once(Path::new("")).chain(libraries.iter().map(Path::new));
    folders
        .flat_map(|folder| [folder.join(name), folder.join(format!("{name}.ini"))])
        .find(|path| path.is_file())
}

/// Applies the lines before the first section, and those of the section that is asked for.
fn apply_text(
    text: &str,
    section: Option<&str>,
    settings: &mut Settings,
    depth: usize,
) -> Result<(), OptionError> {
    let mut active = true;
    for line in text.trim_start_matches('\u{feff}').lines() {
        let line = without_comment(line).trim();
        if let Some(name) = line.strip_prefix('[').and_then(|l| l.split_once(']')).map(|(name, _)| name) {
            active = section.is_some_and(|s| s.trim().eq_ignore_ascii_case(name.trim()));
        } else if active && !line.is_empty() {
            apply_line(line, settings, depth)?;
        }
    }
    Ok(())
}

/// `key = value` takes the whole line; other lines are words.
fn apply_line(line: &str, settings: &mut Settings, depth: usize) -> Result<(), OptionError> {
    if let Some((key, value)) = line.split_once('=') {
        let key = key.trim();
        if !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            return apply_key(key, &unquoted(value.trim()), settings, depth + 1);
        }
    }
    words(line).iter().try_for_each(|word| apply_word(word, settings, depth + 1))
}

/// Cuts at `;` or `#` outside quotes.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    for (i, c) in line.char_indices() {
        match (quote, c) {
            (None, ';' | '#') => return &line[..i],
            (None, '"' | '\'') => quote = Some(c),
            (Some(q), c) if q == c => quote = None,
            _ => {}
        }
    }
    line
}

/// Takes quotes off, wherever they are.
fn unquoted(text: &str) -> String {
    pieces(text, false).into_iter().next().unwrap_or_default()
}

/// Words between spaces; quotes hold words together and vanish.
pub(super) fn words(text: &str) -> Vec<String> {
    pieces(text, true)
}

fn pieces(text: &str, split: bool) -> Vec<String> {
    let mut found = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for c in text.chars() {
        match quote {
            Some(q) if q == c => quote = None,
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            None if split && c.is_whitespace() => found.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    found.extend(word);
    found
}
