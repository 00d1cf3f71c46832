//! PLY, in text and binary of either byte order.
//!
//! Vertices may bring normals and texture coordinates, faces may be polygons. Any other element or property, colours
//! among them, is read over.
mod data;
mod header;
mod rows;

use data::{Binary, Numbers, Text};
use header::{Element, Encoding, Header};
use raggio_scene::{FaceIndices, Faces, Mesh};
use rayon::prelude::*;
use rows::Layout;

use crate::{ImportError, Result, draft};

/// Reads a file.
pub(crate) fn read(bytes: &[u8]) -> Result<Mesh> {
    let header = header::read(bytes)?;
    let at = header.length;
    match header.encoding {
        Encoding::Text => tables(&header, Text { rest: &bytes[at..], line: header.lines + 1 }),
        Encoding::LittleEndian => tables(&header, Binary::<false> { bytes, at }),
        Encoding::BigEndian => tables(&header, Binary::<true> { bytes, at }),
    }
}

/// All elements in their order.
fn tables<N: Numbers>(header: &Header, mut numbers: N) -> Result<Mesh> {
    let mut mesh = Mesh::default();
    let mut seen_vertices = false;
    for element in &header.elements {
        let least = element.least_row(header.encoding);
        if least == 0 {
            continue;
        }
        if element.count > numbers.left() / least || element.count > draft::MOST {
            let what = "the file is too short for its elements called";
            return numbers.error(&format!("{what} `{}` ({})", element.name, element.count));
        }
        match element.name.as_str() {
            "vertex" if !seen_vertices => {
                vertices(element, &mut numbers, &mut mesh)?;
                seen_vertices = true;
            }
            "face" => faces(element, &mut numbers, &mut mesh.faces)?,
            _ => skip(element, &mut numbers)?,
        }
    }
    let count = mesh.vertices.len();
    if mesh.faces.corners.par_iter().any(|corners| corners.iter().any(|&i| i as usize >= count)) {
        return Err(ImportError::Whole(format!("a face names a vertex beyond the last of {count}")));
    }
    draft::finished(mesh)
}

/// Reads one row; lists are read over.
#[inline(always)]
fn row<N: Numbers>(element: &Element, numbers: &mut N, values: &mut [f64]) -> Result<()> {
    for (property, value) in element.properties.iter().zip(values) {
        match property.length {
            None => *value = numbers.number(property.scalar)?,
            Some(length) => {
                for _ in 0..list_length(numbers.number(length)?, numbers)? {
                    numbers.number(property.scalar)?;
                }
            }
        }
    }
    Ok(())
}

fn list_length<N: Numbers>(length: f64, numbers: &N) -> Result<usize> {
    match (0.0..=numbers.left() as f64).contains(&length) {
        true => Ok(length as usize),
        false => numbers.error("a list is longer than the file"),
    }
}

fn skip<N: Numbers>(element: &Element, numbers: &mut N) -> Result<()> {
    let mut values = vec![0.0; element.properties.len()];
    (0..element.count).try_for_each(|_| row(element, numbers, &mut values))
}

fn vertices<N: Numbers>(element: &Element, numbers: &mut N, mesh: &mut Mesh) -> Result<()> {
    let places = |names: &[&[&str]]| names.iter().map(|n| element.position(n)).collect::<Option<Vec<_>>>();
    let Some(place) = places(&[&["x"], &["y"], &["z"]]) else {
        return Err(ImportError::Whole("the vertices have no x, y and z".to_owned()));
    };
    let normal = places(&[&["nx"], &["ny"], &["nz"]]);
    let uv = places(&[&["u", "s", "texture_u"], &["v", "t", "texture_v"]]);
    if normal.is_some() {
        mesh.faces.normals = FaceIndices::Corners;
    }
    if uv.is_some() {
        mesh.faces.uvs = FaceIndices::Corners;
    }
    if even_vertices(element, numbers, mesh, [Some(&place), normal.as_ref(), uv.as_ref()]).is_some() {
        return Ok(());
    }
    mesh.vertices.reserve_exact(element.count);
    let mut values = vec![0.0; element.properties.len()];
    for _ in 0..element.count {
        row(element, numbers, &mut values)?;
        mesh.vertices.push(finite([values[place[0]], values[place[1]], values[place[2]]], numbers)?);
        if let Some(n) = &normal {
            mesh.normals.push(finite([values[n[0]], values[n[1]], values[n[2]]], numbers)?);
        }
        if let Some(uv) = &uv {
            mesh.uvs.push(finite([values[uv[0]], values[uv[1]]], numbers)?);
        }
    }
    Ok(())
}

/// All vertices, if their rows are equally long and nothing is wrong with them. Places, normals and texture coordinates
/// are where `columns` says.
fn even_vertices<N: Numbers>(
    element: &Element,
    numbers: &mut N,
    mesh: &mut Mesh,
    columns: [Option<&Vec<usize>>; 3],
) -> Option<()> {
    let layout = Layout::of(&element.properties)?;
    let rows = layout.rows(element.count, numbers)?;
    let points = |columns: &Vec<usize>| layout.points::<3, N>(rows, columns);
    let vertices = points(columns[0]?)?;
    let normals = columns[1].map_or(Some(Vec::new()), points)?;
    let uvs = columns[2].map_or(Some(Vec::new()), |columns| layout.points::<2, N>(rows, columns))?;
    (mesh.vertices, mesh.normals, mesh.uvs) = (vertices, normals, uvs);
    let read = rows.len();
    numbers.skip(read);
    Some(())
}

/// All faces, if their rows are equally long and they are triangles, with which nothing is wrong.
fn even_faces<N: Numbers>(element: &Element, list: usize, numbers: &mut N) -> Option<Vec<[u32; 3]>> {
    let (layout, list) = Layout::of_triangles(&element.properties, list)?;
    let rows = layout.rows(element.count, numbers)?;
    let triangles = layout.triangles::<N>(rows, list)?;
    let read = rows.len();
    numbers.skip(read);
    Some(triangles)
}

fn finite<const K: usize, N: Numbers>(values: [f64; K], numbers: &N) -> Result<[f32; K]> {
    match draft::point(values) {
        Some(point) => Ok(point),
        None => numbers.error("this vertex is not finite"),
    }
}

fn faces<N: Numbers>(element: &Element, numbers: &mut N, faces: &mut Faces) -> Result<()> {
    let list = element.position(&["vertex_indices", "vertex_index"]);
    let Some(list) = list.filter(|&i| element.properties[i].length.is_some()) else {
        return Err(ImportError::Whole("the faces have no list of vertex_indices".to_owned()));
    };
    if faces.is_empty()
        && let Some(triangles) = even_faces(element, list, numbers)
    {
        faces.corners = triangles;
        return Ok(());
    }
    let split = |range: std::ops::Range<usize>| {
        let properties = element.properties[range].to_vec();
        Element { name: String::new(), count: 1, properties }
    };
    let (before, after) = (split(0..list), split(list + 1..element.properties.len()));
    let property = &element.properties[list];
    let length = property.length.unwrap_or(property.scalar);
    faces.corners.reserve_exact(element.count);
    let mut values = vec![0.0; element.properties.len()];
    let mut polygon: Vec<u32> = Vec::new();
    for _ in 0..element.count {
        row(&before, numbers, &mut values)?;
        polygon.clear();
        for _ in 0..list_length(numbers.number(length)?, numbers)? {
            let index = numbers.number(property.scalar)?;
            if !(0.0..draft::MOST as f64).contains(&index) {
                return numbers.error("this is no index of a vertex");
            }
            polygon.push(index as u32);
        }
        faces.corners.extend(draft::fan(&polygon));
        row(&after, numbers, &mut values)?;
    }
    Ok(())
}
