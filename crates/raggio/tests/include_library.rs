//! Our include files give the values that POV-Ray's own give, as recorded from it.
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio::{InstalledLibrary, SceneOptions};

/// Largest difference of a printed number, relative to its size: `Spline_Trans` and meshes in single precision.
const TOLERANCE: f64 = 2e-4;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/include")
}

/// The `@name values` lines that a scene prints.
fn printed(name: &str) -> Vec<String> {
    let options = SceneOptions {
        installed_library: InstalledLibrary::Never,
        ..SceneOptions::file(folder().join(name))
    };
    let mut text = String::new();
    let never = Arc::new(AtomicBool::new(false));
    if let Err(failure) = raggio::load_with(&options, &mut |t| text.push_str(t), &never) {
        panic!("{}", failure.render());
    }
    text.lines().filter(|l| l.starts_with('@')).map(String::from).collect()
}

fn numbers(line: &str) -> Option<Vec<f64>> {
    line.split_once(' ')?.1.split(',').map(|n| n.parse().ok()).collect()
}

fn agree(expected: &str, actual: &str) -> bool {
    match (numbers(expected), numbers(actual)) {
        (Some(a), Some(b)) => {
            a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= TOLERANCE * a.abs().max(1.0))
        }
        _ => expected == actual,
    }
}

/// Lines are matched by name and order; what was not recorded is not compared.
#[track_caller]
fn check(name: &str) {
    let recorded =
        std::fs::read_to_string(folder().join(format!("{name}.expected"))).expect("recorded values");
    let actual = printed(&format!("{name}.pov"));
    let key = |line: &str| line.split(' ').next().unwrap_or_default().to_string();
    let names: std::collections::HashSet<String> = recorded.lines().map(key).collect();
    let actual: Vec<&String> = actual.iter().filter(|l| names.contains(&key(l))).collect();
    let mut faults = Vec::new();
    for (expected, actual) in recorded.lines().zip(&actual) {
        if !agree(expected, actual) {
            faults.push(format!("{expected}\n    ours {actual}"));
        }
    }
    let count = recorded.lines().count();
    assert!(count > 100 && count == actual.len(), "{count} values recorded, {} printed", actual.len());
    assert!(faults.is_empty(), "{} of {count} differ:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn colours_constants_glasses_and_metals() {
    check("values");
}

#[test]
fn arrays_strings_and_colour_spaces() {
    check("arrays_strings_colors");
}

#[test]
fn statistics_vectors_and_derivatives() {
    check("math");
}

#[test]
fn random_distributions() {
    check("random");
}

#[test]
fn every_file_can_be_included_with_the_colours_alone() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("include");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("the library") {
        let name = entry.expect("a file").file_name().into_string().expect("a plain name");
        let scene =
            format!("#version 3.7;\n#include \"colors.inc\"\n#include \"{name}\"\n#include \"{name}\"\n");
        let mut options = SceneOptions::text("scene.pov", scene.into_bytes());
        options.installed_library = InstalledLibrary::Never;
        (options.parse.image_width, options.parse.image_height) = (80, 60);
        if let Err(failure) = raggio::load(&options) {
            panic!("{name}: {}", failure.render());
        }
        count += 1;
    }
    assert!(count > 30, "{count}");
}

/// Lines of a file's name and the names that POV-Ray 3.7 knows by `#ifdef` after including its file of that name; five
/// that only its own macros use are left out.
#[test]
fn every_name_of_the_original_files_is_there() {
    let recorded = std::fs::read_to_string(folder().join("names.txt")).expect("recorded names");
    let (mut count, mut missing) = (0, Vec::new());
    for line in recorded.lines() {
        let (file, names) = line.split_once(' ').unwrap_or((line, ""));
        let names: Vec<&str> = names.split(' ').filter(|name| !name.is_empty()).collect();
        let before = if file.starts_with("shapes") { "#include \"shapes.inc\"\n" } else { "" };
        let asks: String = names.iter().map(|n| format!("#ifndef({n}) #debug \"{n}\\n\" #end\n")).collect();
        let scene = format!(
            "#version 3.7;\n#include \"colors.inc\"\n{before}#include \"{file}\"\n#debug \"@\\n\"\n{asks}"
        );
        let mut options = SceneOptions::text("scene.pov", scene.into_bytes());
        options.installed_library = InstalledLibrary::Never;
        (options.parse.image_width, options.parse.image_height) = (80, 60);
        let mut text = String::new();
        let never = Arc::new(AtomicBool::new(false));
        if let Err(failure) = raggio::load_with(&options, &mut |t| text.push_str(t), &never) {
            panic!("{file}: {}", failure.render());
        }
        let (_, absent) = text.rsplit_once("@\n").expect("the end of the file");
        missing.extend(absent.lines().map(|name| format!("{file}: {name}")));
        count += names.len();
    }
    assert!(count > 1500, "{count} names");
    assert!(missing.is_empty(), "{} of {count} names: {missing:?}", missing.len());
}
