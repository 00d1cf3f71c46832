//! Every variant of every format, and broken files, which must be refused with the place of the fault.
#![allow(clippy::unwrap_used)]
use raggio_import::{Format, ImportError, Surroundings, read};
use raggio_scene::{FaceIndices, FaceTexture, Mesh, PigmentKind, TextureKind, has_area};

fn nothing_around() -> Surroundings<'static> {
    Surroundings { find: &|_| None, working: None }
}

fn load(format: Format, bytes: impl AsRef<[u8]>) -> Result<Mesh, ImportError> {
    read(format, bytes.as_ref(), &nothing_around())
}

fn line_of(error: ImportError) -> usize {
    match error {
        ImportError::Line { line, .. } => line,
        other => panic!("{other}"),
    }
}

const SQUARE: [[f32; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
const HALVES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

fn assert_square(mesh: &Mesh) {
    assert_eq!((&mesh.vertices[..], &mesh.faces.corners[..]), (&SQUARE[..], &HALVES[..]));
}

// ---- OBJ

#[test]
fn obj_polygons_become_fans_and_indices_count_from_both_ends() {
    let points = "# a square\nv 0 0 0\nv 1 0 0 1.0\r\nv 1 1 0\nv 0 1 0\n";
    for face in ["f 1 2 3 4", "f -4 -3 -2 -1 # all", "f 1 \\\n 2 3 4", "g x\ns off\nl 1 2\nf 1 2 3\nf 1 3 4"]
    {
        let mesh = load(Format::Obj, format!("{points}{face}\n")).unwrap();
        assert_square(&mesh);
        assert_eq!((&mesh.faces.normals, &mesh.faces.uvs), (&FaceIndices::None, &FaceIndices::None));
    }
}

#[test]
fn obj_corners_bring_normals_and_texture_coordinates() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1\nvt 0 1 0\nvn 0 0 2\nvn 0 1 1\nvn 1 0 1\n";
    let mesh = load(Format::Obj, format!("{text}f 1/1/1 2/2/2 3/3/3\n")).unwrap();
    assert_eq!((&mesh.faces.normals, &mesh.faces.uvs), (&FaceIndices::Corners, &FaceIndices::Corners));
    assert_eq!((mesh.normals[0], mesh.uvs[1]), ([0., 0., 1.], [1., 0.]));
    let mesh = load(Format::Obj, format!("{text}f 1//3 2//3 3//1\nf 1/1 2/1 3/2\nf 1 2 3\n")).unwrap();
    let (a, b, c) = (mesh.faces.face(0), mesh.faces.face(1), mesh.faces.face(2));
    assert_eq!((a.normals, a.uvs), (Some([2, 2, 0]), None));
    assert_eq!((b.normals, b.uvs), (None, Some([0, 0, 1])));
    assert_eq!((c.normals, c.uvs), (None, None));
}

#[test]
fn obj_zero_normals_make_their_triangles_flat() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 0 1\nf 1//1 2//2 3//2\nf 1//2 2//2 3//2\n";
    let mesh = load(Format::Obj, text).unwrap();
    assert_eq!((mesh.faces.face(0).normals, mesh.faces.face(1).normals), (None, Some([1, 1, 1])));
}

#[test]
fn obj_materials_become_textures() {
    let library =
        "newmtl red paint\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 50\nd 0.75\nnewmtl map\nmap_Kd -s 1 1 1 dot.ppm\n";
    let find = |name: &str| match name {
        "a.mtl" => Some(library.as_bytes().to_vec()),
        "dot.ppm" => Some(b"P3 1 1 255 10 20 30".to_vec()),
        _ => None,
    };
    let text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red paint\nf 1 2 3\nusemtl map\nf 1 2 3\nusemtl ?\nf 1 2 3";
    let mesh = read(Format::Obj, text.as_bytes(), &Surroundings { find: &find, working: None }).unwrap();
    let (none, one) = (FaceTexture::Object, FaceTexture::One);
    assert_eq!(mesh.faces.textures, [none, one(0), one(1), none]);
    let layer = |i: usize| match &mesh.textures[i].kind {
        TextureKind::Layers(layers) => layers[0].clone(),
        other => panic!("{other:?}"),
    };
    let PigmentKind::Solid { color, .. } = layer(0).pigment.kind else { panic!("a plain colour") };
    assert_eq!((color.rgb.to_array(), color.transmit), ([1., 0., 0.], 0.25));
    assert_eq!((layer(0).finish.specular, layer(0).finish.roughness), (0.5, 0.02));
    assert!(matches!(layer(1).pigment.kind, PigmentKind::Uv(_)));
}

#[test]
fn obj_faults_name_their_line() {
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for fault in [
        "f 1 2",
        "f 1 2 4",
        "f 0 1 2",
        "f -4 1 2",
        "f 1/1 2/1 3/1",
        "f 1 2 x",
        "f 1 2 3/1/1/1",
        "v 1 2",
        "v 1 nan 0",
        "v 1e99 0 0",
    ] {
        let error = load(Format::Obj, format!("{points}{fault}\n")).unwrap_err();
        assert_eq!(line_of(error), 4, "{fault}");
    }
    assert!(matches!(load(Format::Obj, points), Err(ImportError::Whole(_))));
    assert!(load(Format::Obj, "").is_err());
}

// ---- PLY

const PLY: &str = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

/// The square with other elements and properties all around what counts, in binary. `odd` gives the vertices a list.
fn binary_ply(big: bool, odd: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let list = if odd { "property list uint8 short odd\n" } else { "" };
    let mut bytes = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 4\nproperty uchar red\nproperty double z\nproperty float32 y\n{list}property float x\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\nelement empty 1000000000000\nelement edge 1\nproperty int a\nelement face 2\nproperty list ushort uint vertex_index\nproperty short flags\nend_header\n"
    )
    .into_bytes();
    fn put<const N: usize>(out: &mut Vec<u8>, big: bool, mut little: [u8; N]) {
        if big {
            little.reverse();
        }
        out.extend(little);
    }
    for [x, y, z] in SQUARE {
        bytes.push(9);
        put(&mut bytes, big, f64::from(z).to_le_bytes());
        put(&mut bytes, big, y.to_le_bytes());
        if odd {
            bytes.push(1);
            put(&mut bytes, big, 77i16.to_le_bytes());
        }
        for value in [x, 0.0, 0.0, 3.0, x, y] {
            put(&mut bytes, big, value.to_le_bytes());
        }
    }
    put(&mut bytes, big, 5i32.to_le_bytes());
    for half in HALVES {
        put(&mut bytes, big, 3u16.to_le_bytes());
        half.iter().for_each(|i| put(&mut bytes, big, i.to_le_bytes()));
        put(&mut bytes, big, 1i16.to_le_bytes());
    }
    bytes
}

#[test]
fn ply_texts_are_read() {
    assert_square(&load(Format::Ply, PLY).unwrap());
    assert_square(
        &load(Format::Ply, PLY.trim_end().replace('\n', "\r\n").replace("1 1 0\r\n", "1 1 0 ")).unwrap(),
    );
}

#[test]
fn ply_binaries_are_read_in_both_byte_orders_whatever_else_they_hold() {
    for (big, odd) in [(false, true), (true, true), (false, false), (true, false)] {
        let mesh = load(Format::Ply, binary_ply(big, odd)).unwrap();
        assert_square(&mesh);
        assert_eq!((&mesh.faces.normals, &mesh.faces.uvs), (&FaceIndices::Corners, &FaceIndices::Corners));
        assert_eq!((mesh.normals[3], mesh.uvs[2]), ([0., 0., 1.], [1., 1.]));
    }
}

#[test]
fn ply_files_cut_short_anywhere_are_refused() {
    for odd in [false, true] {
        let whole = binary_ply(false, odd);
        for length in 0..whole.len() {
            assert!(load(Format::Ply, &whole[..length]).is_err(), "{length} bytes");
        }
    }
    for length in 0..PLY.len() - 2 {
        assert!(load(Format::Ply, &PLY[..length]).is_err(), "{length} bytes");
    }
}

/// A table of equally long rows is read at once; where it goes wrong the place is named all the same.
#[test]
fn ply_faults_in_binary_name_their_place() {
    let whole = binary_ply(false, false);
    let data = whole.len() - 2 * 16 - 4 - 4 * 37;
    let fault = |at: usize, new: &[u8]| {
        let mut bytes = whole.clone();
        bytes[at..at + new.len()].copy_from_slice(new);
        match load(Format::Ply, bytes).unwrap_err() {
            ImportError::Byte { offset, .. } => offset - data,
            other => panic!("{other}"),
        }
    };
    assert_eq!(fault(data + 2 * 37 + 9, &f32::NAN.to_le_bytes()), 3 * 37);
    let faces = 4 * 37 + 4;
    assert_eq!(fault(data + faces + 16, &60_000u16.to_le_bytes()), faces + 18);
    assert_eq!(fault(data + faces + 16 + 2, &u32::MAX.to_le_bytes()), faces + 16 + 6);
}

/// Triangles come out as they stand in the file, and a polygon among them changes nothing for the others.
#[test]
fn ply_tables_of_many_triangles_are_read_with_or_without_a_polygon() {
    let count = 50_000u32;
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        count + 3,
        count + 1
    )
    .into_bytes();
    for i in 0..count + 3 {
        for value in [i as f32, (i * i % 101) as f32, 1.0] {
            bytes.extend(value.to_le_bytes());
        }
    }
    let face = |corners: &[u32]| {
        let mut row = vec![corners.len() as u8];
        corners.iter().for_each(|i| row.extend(i.to_le_bytes()));
        row
    };
    (0..count).for_each(|i| bytes.extend(face(&[i, i + 1, i + 2])));
    for last in [&[5, 6, 7][..], &[5, 6, 7, 8]] {
        let mesh = load(Format::Ply, [&bytes[..], &face(last)].concat()).unwrap();
        assert_eq!(mesh.vertices[777], [777.0, (777 * 777 % 101) as f32, 1.0]);
        assert_eq!(mesh.faces.corners.last(), Some(&if last.len() == 3 { [5, 6, 7] } else { [5, 7, 8] }));
        let kept: Vec<[u32; 3]> =
            (0..count).map(|i| [i, i + 1, i + 2]).filter(|&c| has_area(&mesh.vertices, c)).collect();
        assert_eq!(mesh.faces.corners[..kept.len()], kept[..]);
    }
}

#[test]
fn ply_faults_are_refused() {
    let changed = |from: &str, to: &str| {
        assert!(PLY.contains(from), "{from}");
        load(Format::Ply, PLY.replacen(from, to, 1)).unwrap_err()
    };
    assert_eq!(line_of(changed("4 0 1 2 3", "4 0 1 2 -3")), 15);
    assert_eq!(line_of(changed("1 1 0", "1 nan 0")), 13);
    assert_eq!(line_of(changed("1 1 0", "1 one 0")), 13);
    assert_eq!(line_of(changed("ascii", "utf8")), 2);
    assert_eq!(line_of(changed("property float y", "property real y")), 6);
    assert_eq!(line_of(changed("vertex 4", "vertex four")), 4);
    assert_eq!(line_of(changed("end_header\n", "")), 10);
    for (from, to) in [
        ("4 0 1 2 3", "4 0 1 2 4"),
        ("float x", "float a"),
        ("vertex_indices", "corners"),
        ("list uchar int", "int"),
        ("format ascii 1.0\n", ""),
        ("ply", "plx"),
        // Counts that nothing in the file bears out must not be believed.
        ("vertex 4", "vertex 99999999999999"),
        ("face 1", "face 18446744073709551615"),
        ("4 0 1 2 3", "4000000000 0 1 2 3"),
        ("4 0 1 2 3", "-4 0 1 2 3"),
        ("4 0 1 2 3", "2 0 1"),
    ] {
        changed(from, to);
    }
}

// ---- STL

const STL: &str = "solid square\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 1 0\n endloop\nendfacet\nfacet normal 0 0 1\n outer loop\n  vertex -0.0 0 0\n  vertex 1 1 0\n  vertex 0 1 0\n endloop\nendfacet\nendsolid square\n";

fn binary_stl(header: &str, corners: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = format!("{header:80}").into_bytes();
    bytes.extend((corners.len() as u32).to_le_bytes());
    for triangle in corners {
        bytes.extend([0; 12]);
        triangle.iter().flatten().for_each(|v| bytes.extend(v.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn stl_files_of_both_kinds_share_their_corners() {
    assert_square(&load(Format::Stl, STL).unwrap());
    let corners = HALVES.map(|half| half.map(|i| SQUARE[i as usize]));
    for header in ["made by a program", "solid made by a program"] {
        assert_square(&load(Format::Stl, binary_stl(header, &corners)).unwrap());
    }
}

#[test]
fn stl_triangles_without_area_are_dropped() {
    let corners = [[SQUARE[0], SQUARE[1], SQUARE[2]], [SQUARE[0], SQUARE[1], SQUARE[1]]];
    assert_eq!(load(Format::Stl, binary_stl("x", &corners)).unwrap().faces.len(), 1);
    assert!(load(Format::Stl, binary_stl("x", &corners[1..])).is_err());
}

#[test]
fn stl_faults_are_refused() {
    let corners = HALVES.map(|half| half.map(|i| SQUARE[i as usize]));
    let whole = binary_stl("x", &corners);
    for length in 0..whole.len() {
        assert!(load(Format::Stl, &whole[..length]).is_err(), "{length} bytes");
    }
    let mut nan = corners;
    nan[1][0][0] = f32::NAN;
    let error = load(Format::Stl, binary_stl("x", &nan)).unwrap_err();
    assert!(matches!(error, ImportError::Byte { offset: 134, .. }), "{error}");
    for (from, to, line) in [
        ("vertex 1 1 0", "vertex 1 1", 6),
        ("vertex 1 1 0", "vertex 1 inf 0", 6),
        ("vertex 1 1 0", "corner 1 1 0", 6),
        ("  vertex 1 1 0\n", "", 7),
        ("endfacet\nendsolid square\n", "", 14),
    ] {
        assert_eq!(line_of(load(Format::Stl, STL.replacen(from, to, 1)).unwrap_err()), line, "{to}");
    }
}
