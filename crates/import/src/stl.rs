//! STL, text and binary. Equal corners become one vertex; the normals, which repeat what the corners say, are left out.
use raggio_scene::{Faces, Mesh};
use rustc_hash::FxHashMap;

use crate::text::Lines;
use crate::{ImportError, Result, draft};

/// Bytes before the triangles of a binary file: a free text, and their number.
const HEADER: usize = 84;
/// Bytes of a triangle: a normal, three corners, two bytes of no meaning.
const TRIANGLE: usize = 50;

/// Corners that are put together by their exact place.
#[derive(Default)]
struct Welder {
    vertices: Vec<[f32; 3]>,
    known: FxHashMap<[u32; 3], u32>,
    corners: Vec<[u32; 3]>,
}

impl Welder {
    fn vertex(&mut self, place: [f32; 3]) -> u32 {
        // Adding zero makes the two zeros one.
        let place = place.map(|v| v + 0.0);
        *self.known.entry(place.map(f32::to_bits)).or_insert_with(|| {
            self.vertices.push(place);
            self.vertices.len() as u32 - 1
        })
    }

    fn finished(self) -> Result<Mesh> {
        let faces = Faces { corners: self.corners, ..Faces::default() };
        draft::finished(Mesh { vertices: self.vertices, faces, ..Mesh::default() })
    }
}

/// Reads a file of either kind.
pub(crate) fn read(bytes: &[u8]) -> Result<Mesh> {
    // Binary files may begin with `solid` as well; their length tells.
    let binary = count(bytes).is_some_and(|n| bytes.len() == HEADER + n * TRIANGLE);
    match binary || !bytes.trim_ascii_start().starts_with(b"solid") {
        true => read_binary(bytes),
        false => read_text(bytes),
    }
}

fn count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER - 4..)?.first_chunk()?;
    Some(u32::from_le_bytes(*count) as usize)
}

fn read_binary(bytes: &[u8]) -> Result<Mesh> {
    let end = |what: String| Err(ImportError::Byte { offset: bytes.len(), what });
    let Some(count) = count(bytes) else {
        return end("this is no STL file: it neither begins with `solid` nor has a header".to_owned());
    };
    let triangles = bytes[HEADER..].chunks_exact(TRIANGLE);
    if triangles.len() < count {
        return end(format!("the file ends after {} of {count} triangles", triangles.len()));
    }
    let mut welder = Welder { corners: Vec::with_capacity(count), ..Welder::default() };
    for (i, triangle) in triangles.take(count).enumerate() {
        let value = |k: usize| {
            let at = 12 + 4 * k;
            triangle[at..].first_chunk().map_or(0.0, |bytes| f32::from_le_bytes(*bytes))
        };
        let places = [0, 3, 6].map(|k| [value(k), value(k + 1), value(k + 2)]);
        if !places.iter().flatten().all(|v| v.is_finite()) {
            let what = "a corner is not finite".to_owned();
            return Err(ImportError::Byte { offset: HEADER + i * TRIANGLE, what });
        }
        let corners = places.map(|place| welder.vertex(place));
        welder.corners.push(corners);
    }
    welder.finished()
}

fn read_text(bytes: &[u8]) -> Result<Mesh> {
    let mut welder = Welder::default();
    let mut polygon = Vec::new();
    let (mut open, mut line) = (false, 1);
    for mut words in Lines::new(bytes) {
        line = words.line;
        match words.next().unwrap_or_default() {
            b"facet" => (open, polygon) = (true, Vec::new()),
            b"vertex" if open => polygon.push(welder.vertex(words.point()?)),
            b"endfacet" if open && polygon.len() >= 3 => {
                welder.corners.extend(draft::fan(&polygon));
                open = false;
            }
            b"endfacet" => return words.error("a facet has three corners"),
            b"outer" | b"endloop" if open => {}
            b"solid" | b"endsolid" if !open => {}
            word => {
                let word = String::from_utf8_lossy(word).into_owned();
                return words.error(format!("`{word}` is not expected here"));
            }
        }
    }
    match open {
        true => Err(ImportError::Line { line, what: "the file ends inside a facet".to_owned() }),
        false => welder.finished(),
    }
}
