//! The few arguments of the commands: `--name value`, `--flag`, and plain words.

/// Takes arguments out of a list one by one, so that what is left over can be refused.
pub struct Args {
    words: Vec<String>,
}

impl Args {
    /// From the words after the command's name.
    pub fn new(words: &[String]) -> Self {
        Args { words: words.to_vec() }
    }

    /// Is the flag there?
    pub fn flag(&mut self, name: &str) -> bool {
        match self.words.iter().position(|w| w == name) {
            Some(i) => {
                self.words.remove(i);
                true
            }
            None => false,
        }
    }

    /// The word after `name`.
    pub fn value(&mut self, name: &str) -> Result<Option<String>, String> {
        let Some(i) = self.words.iter().position(|w| w == name) else { return Ok(None) };
        if i + 1 >= self.words.len() {
            return Err(format!("{name} needs a value"));
        }
        self.words.remove(i);
        Ok(Some(self.words.remove(i)))
    }

    /// The word after `name` as a number or another thing that can be read from text.
    pub fn parsed<T: std::str::FromStr>(&mut self, name: &str, default: T) -> Result<T, String> {
        match self.value(name)? {
            Some(word) => word.parse().map_err(|_| format!("{name}: `{word}` does not fit")),
            None => Ok(default),
        }
    }

    /// `WxH`.
    pub fn size(&mut self, name: &str, default: (u32, u32)) -> Result<(u32, u32), String> {
        let Some(word) = self.value(name)? else { return Ok(default) };
        parse_size(&word).ok_or_else(|| format!("{name}: `{word}` is not WIDTHxHEIGHT"))
    }

    /// The only plain word, if any; anything else is an error.
    pub fn last_word(self) -> Result<Option<String>, String> {
        match self.words.as_slice() {
            [] => Ok(None),
            [word] if !word.starts_with("--") => Ok(Some(word.clone())),
            [word, ..] => Err(format!("unexpected `{word}`")),
        }
    }
}

/// Reads `160x120`.
pub fn parse_size(word: &str) -> Option<(u32, u32)> {
    let (w, h) = word.split_once('x')?;
    Some((w.parse().ok().filter(|w| *w > 0)?, h.parse().ok().filter(|h| *h > 0)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn args(text: &str) -> Args {
        Args::new(&text.split(' ').map(String::from).collect::<Vec<_>>())
    }

    #[test]
    fn flags_values_and_words_are_told_apart() {
        let mut a = args("--jobs 3 folder --povray --size 80x60");
        assert!(a.flag("--povray") && !a.flag("--povray"));
        assert_eq!(a.parsed("--jobs", 1usize), Ok(3));
        assert_eq!(a.size("--size", (1, 1)), Ok((80, 60)));
        assert_eq!(a.last_word(), Ok(Some("folder".into())));
    }

    #[test]
    fn wrong_arguments_are_refused() {
        assert!(args("--jobs").value("--jobs").is_err());
        assert!(args("--jobs x").parsed("--jobs", 1usize).is_err());
        assert!(args("--size 80x0").size("--size", (1, 1)).is_err());
        assert!(args("--unknown").last_word().is_err());
        assert!(args("a b").last_word().is_err());
    }
}
