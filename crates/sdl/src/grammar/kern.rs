//! The classic `kern` table of TrueType fonts. Old fonts list their pairs in no order, and a text asks for few of them:
//! they are looked for one by one.
use raggio_math::Vec2;

/// How pairs of glyphs move together, in font units.
#[derive(Default)]
pub struct Kerning<'a> {
    tables: Vec<Subtable<'a>>,
}

struct Subtable<'a> {
    /// The values are the least that is left of the sum, not added to it.
    minimum: bool,
    /// The values act across the line.
    cross_stream: bool,
    /// The values replace what earlier tables gave.
    replaces: bool,
    /// Six bytes each: left, right, value.
    pairs: &'a [u8],
}

impl<'a> Kerning<'a> {
    /// Reads the table as far as it is whole; subtables of other formats or for vertical text are passed over.
    pub fn new(table: &'a [u8]) -> Self {
        let mut kerning = Kerning::default();
        let Some(count) = word(table, 2) else { return kerning };
        let mut rest = table.get(4..).unwrap_or_default();
        for _ in 0..count {
            let (Some(length), Some(coverage)) = (word(rest, 2), word(rest, 4)) else { break };
            if coverage >> 8 == 0 && coverage & 1 != 0 {
                kerning.tables.push(Subtable {
                    minimum: coverage & 2 != 0,
                    cross_stream: coverage & 4 != 0,
                    replaces: coverage & 8 != 0,
                    pairs: pairs(rest),
                });
            }
            rest = rest.get(usize::from(length).max(6)..).unwrap_or_default();
        }
        kerning
    }

    /// What a pair moves by, along the line and across it.
    pub fn of(&self, left: u16, right: u16) -> Vec2 {
        let mut kern = Vec2::ZERO;
        for table in &self.tables {
            let Some(value) = table.value(left, right) else { continue };
            let part = if table.cross_stream { &mut kern.y } else { &mut kern.x };
            *part = match table {
                Subtable { minimum: true, .. } => part.max(value),
                Subtable { replaces: true, .. } => value,
                _ => *part + value,
            };
        }
        kern
    }
}

impl Subtable<'_> {
    /// What the last entry of a pair says.
    fn value(&self, left: u16, right: u16) -> Option<f64> {
        let ([a, b], [c, d]) = (left.to_be_bytes(), right.to_be_bytes());
        let entry = self.pairs.chunks_exact(6).rfind(|entry| entry[..4] == [a, b, c, d])?;
        word(entry, 4).map(|value| f64::from(value as i16))
    }
}

/// The pairs of a subtable of format 0.
fn pairs(subtable: &[u8]) -> &[u8] {
    let all = subtable.get(14..).unwrap_or_default();
    let count = usize::from(word(subtable, 6).unwrap_or(0));
    &all[..all.len().min(6 * count)]
}

fn word(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(subtables: &[(u16, &[[i16; 3]])]) -> Vec<u8> {
        let mut words = vec![0, subtables.len() as i16];
        for (coverage, pairs) in subtables {
            let length = 14 + 6 * pairs.len() as i16;
            words.extend([0, length, *coverage as i16, pairs.len() as i16, 0, 0, 0]);
            words.extend(pairs.iter().flatten());
        }
        words.iter().flat_map(|w| w.to_be_bytes()).collect()
    }

    #[test]
    fn pairs_need_no_order_and_subtables_combine() {
        let bytes = table(&[(1, &[[9, 1, -20], [3, 4, 7]]), (1, &[[3, 4, 1]])]);
        let kerning = Kerning::new(&bytes);
        assert_eq!(kerning.of(9, 1), Vec2::new(-20.0, 0.0));
        assert_eq!(kerning.of(3, 4), Vec2::new(8.0, 0.0));
        assert_eq!(kerning.of(4, 3), Vec2::ZERO);
        let bytes = table(&[(1, &[[1, 2, 5]]), (9, &[[1, 2, -3]]), (5, &[[1, 2, 4]])]);
        let kerning = Kerning::new(&bytes);
        assert_eq!(kerning.of(1, 2), Vec2::new(-3.0, 4.0));
        assert_eq!(Kerning::new(&[0, 0, 0, 3, 0]).of(1, 2), Vec2::ZERO);
    }
}
