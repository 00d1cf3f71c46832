//! A model file by itself: put on a stage, framed, lit.
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use raggio_diag::{Diagnostic, Sources};
use raggio_image::Curve;
use raggio_import::Format;
use raggio_math::{Affine, Mat3, Vec3, transform};
use raggio_scene::{Camera, Mesh, ObjectKind, Shape};
use raggio_sdl::Declared;
use rayon::prelude::*;

use crate::engine::LiveEngine;
use crate::files::{DiskFiles, InstalledLibrary};
use crate::load::{Failure, Loaded, SceneOptions, unreadable};
use crate::mapped;

/// Camera, light and a ball in place of the model.
const STAGE: &str = include_str!("stage.pov");
/// Air around the model, as a factor of its size in the picture.
const MARGIN: f64 = 1.08;
/// The stage's camera stands this far away until the model is there.
const FIRST_AWAY: f64 = 4.0;

/// The scene that shows a model.
pub(crate) fn load(path: &Path, options: &SceneOptions) -> Result<Loaded, Failure> {
    let failed = |diagnostic| Failure { diagnostics: vec![diagnostic], sources: Sources::default() };
    let files = DiskFiles::new(path.parent(), &options.libraries, InstalledLibrary::Never);
    let name = path.to_string_lossy();
    let bytes = mapped::open(path).map_err(|error| failed(*unreadable(path, &error)))?;
    let mesh = files
        .model(&name, &bytes, Some(Curve::Linear))
        .map_err(|fault| failed(Diagnostic::error("bad-model", format!("{name}: {fault}"), None)))?;
    drop(bytes);
    let mut loaded = stage(options, &files)?;
    let points = Points::of(&mesh);
    let stage_from_mesh = placement(&points, up(Format::from_name(&name)));
    frame(&mut loaded.scene.camera, &points, &stage_from_mesh);
    for object in &mut loaded.scene.objects {
        if matches!(&object.kind, ObjectKind::Shape(_)) {
            let object = Arc::make_mut(object);
            object.uv_mapping = true;
            object.parent_from_object = stage_from_mesh;
            object.kind = ObjectKind::Shape(Arc::new(Shape::Mesh(Arc::new(mesh))));
            break;
        }
    }
    Ok(loaded)
}

/// The stage as a scene.
fn stage(options: &SceneOptions, files: &DiskFiles) -> Result<Loaded, Failure> {
    let mut sources = Sources::default();
    let mut parse = options.parse.clone();
    parse.declares.push(("Away".to_owned(), Declared::Number(FIRST_AWAY)));
    let (engine, cancel) = (LiveEngine::default(), Arc::new(AtomicBool::new(false)));
    match raggio_sdl::parse(
        &mut sources,
        "the stage",
        STAGE.as_bytes(),
        &engine,
        files,
        &parse,
        &mut |_| {},
        &cancel,
    ) {
        Ok(parsed) => Ok(Loaded { scene: parsed.scene, warnings: parsed.warnings, sources }),
        Err(diagnostics) => Err(Failure { diagnostics, sources }),
    }
}

/// Which way is up by custom: z in files for printing, y in all others.
fn up(format: Option<Format>) -> Vec3 {
    match format {
        Some(Format::Stl) => Vec3::Z,
        _ => Vec3::Y,
    }
}

/// The vertices that triangles have; others do not count. Asking each triangle for its corners would take several
/// times as long.
struct Points<'a> {
    vertices: &'a [[f32; 3]],
    used: Vec<AtomicBool>,
}

impl Points<'_> {
    fn of(mesh: &Mesh) -> Points<'_> {
        let used: Vec<AtomicBool> = mesh.vertices.iter().map(|_| AtomicBool::new(false)).collect();
        mesh.faces.corners.par_iter().for_each(|corners| {
            corners.iter().for_each(|&i| used[i as usize].store(true, Ordering::Relaxed));
        });
        Points { vertices: &mesh.vertices, used }
    }

    fn iter(&self) -> impl Iterator<Item = Vec3> {
        let used = self.vertices.iter().zip(&self.used).filter(|(_, used)| used.load(Ordering::Relaxed));
        used.map(|(&[x, y, z], _)| Vec3::new(f64::from(x), f64::from(y), f64::from(z)))
    }
}

/// Stands the model upright with the middle of its box at the origin, the box in the unit ball.
fn placement(points: &Points, up: Vec3) -> Affine {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for p in points.iter() {
        (low, high) = (low.min(p), high.max(p));
    }
    let radius = (high - low).length() / 2.0;
    let upright = match up == Vec3::Z {
        true => Mat3::from_cols(Vec3::X, -Vec3::Z, Vec3::Y),
        false => Mat3::IDENTITY,
    };
    Affine::from_mat3(upright)
        * transform::scale(Vec3::splat(1.0 / radius))
        * transform::translate(-(low + (high - low) / 2.0))
}

/// Moves the camera along its view until the model fills the picture.
fn frame(camera: &mut Camera, points: &Points, stage_from_mesh: &Affine) {
    let (ahead, up, right) = (camera.direction, camera.up, camera.right);
    // How far to the side one sees at depth 1.
    let side = |axis: Vec3| axis.length() / 2.0 / ahead.length() / MARGIN;
    let (across, along) = (side(right), side(up));
    let (ahead, up, right) = (ahead.normalize(), up.normalize(), right.normalize());
    let mut away = 0.0f64;
    for p in points.iter() {
        let p = stage_from_mesh.transform_point3(p);
        let needed = (p.dot(right).abs() / across).max(p.dot(up).abs() / along);
        away = away.max(needed - p.dot(ahead));
    }
    camera.location = -ahead * away;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(name: &str, text: &str, size: (u32, u32)) -> Loaded {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join(name);
        std::fs::write(&path, text).unwrap();
        let mut options = SceneOptions::file(path);
        (options.parse.image_width, options.parse.image_height) = size;
        crate::load(&options).unwrap_or_else(|failure| panic!("{}", failure.render()))
    }

    /// Places of points in the picture, -1 to 1.
    fn seen(loaded: &Loaded, points: &[[f64; 3]]) -> Vec<(f64, f64)> {
        let object = loaded.scene.objects.iter().find(|o| matches!(o.kind, ObjectKind::Shape(_))).unwrap();
        let camera = &loaded.scene.camera;
        let place = |p: &[f64; 3]| {
            let p = object.parent_from_object.transform_point3(Vec3::from_array(*p)) - camera.location;
            let depth = p.dot(camera.direction.normalize()) / camera.direction.length();
            let on = |axis: Vec3| 2.0 * p.dot(axis.normalize()) / axis.length() / depth;
            (on(camera.right), on(camera.up))
        };
        points.iter().map(place).collect()
    }

    const CORNERS: [[f64; 3]; 4] = [[0.0; 3], [2e6, 0.0, 0.0], [0.0, 1e6, 0.0], [0.0, 0.0, 1e6]];

    #[test]
    fn models_of_any_size_fill_the_picture_and_stand_upright() {
        let obj = "v 0 0 0\nv 2e6 0 0\nv 0 1e6 0\nv 0 0 1e6\nv 1e9 0 0\nf 1 2 3\nf 1 3 4\n";
        for size in [(400, 100), (300, 400)] {
            let loaded = shown("a.obj", obj, size);
            let places = seen(&loaded, &CORNERS);
            let reach = places.iter().map(|(x, y)| x.abs().max(y.abs())).fold(0.0, f64::max);
            assert!((reach - 1.0 / MARGIN).abs() < 1e-6, "{places:?}");
            // x goes to the right, y up: no mirror.
            assert!(places[1].0 > places[0].0 && places[2].1 > places[0].1, "{places:?}");
        }
    }

    #[test]
    fn models_for_printing_have_z_up() {
        let corner = |i: usize| CORNERS[i].map(|v| v.to_string()).join(" ");
        let facet = |[a, b, c]: [usize; 3]| {
            let [a, b, c] = [a, b, c].map(corner);
            format!("facet normal 0 0 0 outer loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\n")
        };
        let stl = format!("solid\n{}{}", facet([0, 1, 2]), facet([0, 2, 3]));
        let places = seen(&shown("a.STL", &stl, (100, 100)), &CORNERS);
        assert!(places[3].1 > places[0].1 && places[1].0 > places[0].0, "{places:?}");
    }

    #[test]
    fn faults_name_the_file_and_the_place() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.ply");
        std::fs::write(&path, "ply\nnonsense\n").unwrap();
        let failure = crate::load(&SceneOptions::file(&path)).err().unwrap();
        assert_eq!(failure.diagnostics[0].code, "bad-model");
        assert!(failure.render().contains("a.ply: line 2: "), "{}", failure.render());
        std::fs::remove_file(&path).unwrap();
        let failure = crate::load(&SceneOptions::file(&path)).err().unwrap();
        assert_eq!(failure.diagnostics[0].code, "missing-scene");
    }

    #[test]
    fn scenes_take_models_as_meshes() {
        let dir = tempfile::tempdir().unwrap();
        std::fs::write(dir.path().join("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        std::fs::write(dir.path().join("b.obj"), "f 1 2 3\n").unwrap();
        let run = |text: &str| {
            let path = dir.path().join("scene.pov");
            std::fs::write(&path, text).unwrap();
            crate::load(&SceneOptions::file(path))
        };
        let loaded = run("#version 3.7; mesh { file \"a.obj\" inside_vector y pigment { rgb 1 } }").unwrap();
        let ObjectKind::Shape(shape) = &loaded.scene.objects[0].kind else { panic!("a shape") };
        let Shape::Mesh(mesh) = &**shape else { panic!("{shape:?}") };
        assert_eq!((mesh.faces.len(), mesh.inside_vector), (1, Some(Vec3::Y)));
        for (file, code) in [("b.obj", "bad-model"), ("c.obj", "file-not-found"), ("scene.pov", "bad-model")]
        {
            let failure = run(&format!("#version 3.7; mesh {{ file \"{file}\" }}")).err().unwrap();
            assert_eq!(failure.diagnostics.last().unwrap().code, code, "{file}");
        }
        let own = "#version 3.7; #declare file = 1; mesh { triangle { 0, x*file, y } }";
        assert!(run(own).is_ok());
    }
}
