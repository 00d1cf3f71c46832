//! Reads a scene and prints how long that took. Every object is taken for the unit sphere, every pigment for black.
use std::sync::Arc;

use raggio_diag::Sources;
use raggio_function::External;
use raggio_math::{Aabb, Vec3};
use raggio_scene::{Object, Pattern, Pigment, Settings};
use raggio_sdl::{Engine, Files, ParseOptions, parse};

/// An engine that knows one shape.
struct UnitSphere;

/// A function with so many components, all 0.
#[derive(Debug)]
struct Nothing(usize);

impl External for Nothing {
    fn eval(&self, _: &[f64]) -> [f64; 5] {
        [0.0; 5]
    }
    fn components(&self) -> usize {
        self.0
    }
    fn as_any(&self) -> &dyn std::any::Any {
        self
    }
}

impl Engine for UnitSphere {
    fn trace(&self, _: &Arc<Object>, origin: Vec3, dir: Vec3) -> Option<(Vec3, Vec3)> {
        let b = origin.dot(dir);
        let discriminant = b * b - origin.length_squared() + 1.0;
        let hit = origin + dir * (-b - discriminant.sqrt());
        (discriminant >= 0.0).then_some((hit, hit))
    }
    fn inside(&self, _: &Arc<Object>, point: Vec3) -> Option<bool> {
        Some(point.length() < 1.0)
    }
    fn bounds(&self, _: &Arc<Object>) -> Aabb {
        Aabb::new(Vec3::splat(-1.0), Vec3::splat(1.0))
    }
    fn pigment_function(&self, _: Arc<Pigment>, _: &Settings) -> Arc<dyn External> {
        Arc::new(Nothing(5))
    }
    fn pattern_function(&self, _: Arc<Pattern>, _: &Settings) -> Arc<dyn External> {
        Arc::new(Nothing(1))
    }
}

/// The file system, with the folders named on the command line behind the current one.
struct Disk(Vec<String>);

impl Files for Disk {
    fn find(&self, names: &[String]) -> Option<(String, Vec<u8>)> {
        let folders = std::iter::once(".").chain(self.0.iter().map(String::as_str));
        let folders: Vec<&str> = folders.collect();
        let path = |name: &String, folder: &str| std::path::Path::new(folder).join(name);
        let found = names.iter().flat_map(|name| folders.iter().map(move |folder| path(name, folder)));
        let mut readable =
            found.filter_map(|path| Some((path.display().to_string(), std::fs::read(&path).ok()?)));
        readable.next()
    }
    fn write(&self, _: &str, _: &[u8], _: bool) -> std::io::Result<()> {
        Ok(())
    }
}

fn main() {
    let mut args = std::env::args().skip(1);
    let name = args.next().expect("usage: parse_time SCENE [FOLDER...]");
    let text = std::fs::read(&name).expect("the scene can be read");
    let mut sources = Sources::default();
    let start = std::time::Instant::now();
    let files = Disk(args.collect());
    let mut debug = |text: &str| eprint!("{text}");
    let options =
        ParseOptions { image_width: 160, image_height: 120, frame_number: 1.0, ..Default::default() };
    let result = parse(&mut sources, &name, text, &UnitSphere, &files, &options, &mut debug, &Arc::default());
    println!("{:.3} s", start.elapsed().as_secs_f64());
    match result {
        Ok(parsed) => println!("{} objects, {} warnings", parsed.scene.objects.len(), parsed.warnings.len()),
        Err(faults) => faults.iter().for_each(|fault| eprint!("{}", fault.render(&sources, false))),
    }
}
