//! "Did you mean ...?"

/// The word that is nearest to `name`, if one is near enough to be meant.
pub fn nearest<'w>(name: &str, words: impl Iterator<Item = &'w str>) -> Option<&'w str> {
    let most = (name.len() / 3).clamp(1, 3);
    let close = |word: &&str| word.len().abs_diff(name.len()) <= most && *word != name;
    words
        .filter(close)
        .map(|word| (distance(name, word), word))
        .filter(|(d, _)| *d <= most)
        .min()
        .map(|(_, w)| w)
}

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other; letter case is
/// free.
fn distance(a: &str, b: &str) -> usize {
    let (a, b) = (a.to_ascii_lowercase().into_bytes(), b.to_ascii_lowercase().into_bytes());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let last = &rows[i - 1];
            let mut d =
                (last[j - 1] + usize::from(a[i - 1] != b[j - 1])).min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                d = d.min(rows[i - 2][j - 2] + 1);
            }
            row.push(d);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_found() {
        let words = ["sphere", "box", "cylinder"];
        let ask = |name| nearest(name, words.into_iter());
        assert_eq!(ask("shpere"), Some("sphere"));
        assert_eq!(ask("Sphere"), Some("sphere"));
        assert_eq!(ask("cilynder"), Some("cylinder"));
        assert_eq!(ask("teapot"), None);
    }
}
