//! What a PLY file says about itself before its data begins.
use crate::text::Words;
use crate::{ImportError, Result};

/// How the data is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A kind of number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn of(word: &[u8]) -> Option<Scalar> {
        Some(match word {
            b"char" | b"int8" => Scalar::I8,
            b"uchar" | b"uint8" => Scalar::U8,
            b"short" | b"int16" => Scalar::I16,
            b"ushort" | b"uint16" => Scalar::U16,
            b"int" | b"int32" => Scalar::I32,
            b"uint" | b"uint32" => Scalar::U32,
            b"float" | b"float32" => Scalar::F32,
            b"double" | b"float64" => Scalar::F64,
            _ => return None,
        })
    }

    /// Its size in a binary file.
    pub(super) fn bytes(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }
}

/// A property of each row of an element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Property {
    pub name: String,
    /// For a list, the kind of its length.
    pub length: Option<Scalar>,
    pub scalar: Scalar,
}

/// A table of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
}

impl Element {
    /// Where a property stands.
    pub(super) fn position(&self, names: &[&str]) -> Option<usize> {
        self.properties.iter().position(|p| names.contains(&p.name.as_str()))
    }

    /// The fewest bytes that a row takes.
    pub(super) fn least_row(&self, encoding: Encoding) -> usize {
        let least = |p: &Property| match encoding {
            // A digit and what parts it from the next.
            Encoding::Text => 2,
            _ => p.length.unwrap_or(p.scalar).bytes(),
        };
        self.properties.iter().map(least).sum()
    }
}

/// The header, and where the data begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Bytes of the header.
    pub length: usize,
    /// Lines of the header.
    pub lines: usize,
}

/// Most bytes of a header's line, so that binary data is not taken for one.
const LONGEST_LINE: usize = 4096;

pub(super) fn read(bytes: &[u8]) -> Result<Header> {
    if !bytes.starts_with(b"ply") {
        return Err(ImportError::Byte { offset: 0, what: "a PLY file begins with `ply`".to_owned() });
    }
    let mut header = Header { encoding: Encoding::Text, elements: Vec::new(), length: 0, lines: 0 };
    let mut known_encoding = false;
    loop {
        let rest = &bytes[header.length..];
        let window = &rest[..rest.len().min(LONGEST_LINE)];
        header.lines += 1;
        let Some(end) = window.iter().position(|&b| b == b'\n') else {
            let what = "the header has no `end_header`".to_owned();
            return Err(ImportError::Line { line: header.lines, what });
        };
        header.length += end + 1;
        let mut words = Words::new(&rest[..end], header.lines);
        match words.next().unwrap_or_default() {
            b"end_header" if known_encoding => return Ok(header),
            b"end_header" => return words.error("the header has no `format`"),
            b"ply" | b"comment" | b"obj_info" | b"" => {}
            b"format" => {
                header.encoding = encoding(&mut words)?;
                known_encoding = true;
            }
            b"element" => header.elements.push(element(&mut words)?),
            b"property" => match header.elements.last_mut() {
                Some(element) => element.properties.push(property(&mut words)?),
                None => return words.error("a property comes before any element"),
            },
            _ => return words.error("this is no line of a PLY header"),
        }
    }
}

fn encoding(words: &mut Words) -> Result<Encoding> {
    match words.next() {
        Some(b"ascii") => Ok(Encoding::Text),
        Some(b"binary_little_endian") => Ok(Encoding::LittleEndian),
        Some(b"binary_big_endian") => Ok(Encoding::BigEndian),
        _ => words.error("the format is none of ascii, binary_little_endian, binary_big_endian"),
    }
}

fn element(words: &mut Words) -> Result<Element> {
    let name = String::from_utf8_lossy(words.next().unwrap_or_default()).into_owned();
    let count = words.next().and_then(|word| std::str::from_utf8(word).ok()?.parse().ok());
    match count {
        Some(count) => Ok(Element { name, count, properties: Vec::new() }),
        None => words.error("an element has a name and a number"),
    }
}

fn property(words: &mut Words) -> Result<Property> {
    let first = words.next().unwrap_or_default();
    let (length, scalar) = match first {
        b"list" => match words.next().and_then(Scalar::of) {
            Some(length) => (Some(length), words.next().and_then(Scalar::of)),
            None => (None, None),
        },
        _ => (None, Scalar::of(first)),
    };
    match (scalar, words.next()) {
        (Some(scalar), Some(name)) => {
            Ok(Property { name: String::from_utf8_lossy(name).into_owned(), length, scalar })
        }
        _ => words.error("a property has a type and a name"),
    }
}
