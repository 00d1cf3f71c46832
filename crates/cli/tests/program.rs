//! The program as callers run it: files, streams, exit codes.
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

const SCENE: &str = "#version 3.7; global_settings { assumed_gamma 1 }\n\
    #debug concat(\"w=\", str(image_width, 0, 0), \" clock=\", str(clock, 0, 3), \"\\n\")\n\
    camera { location -3*z look_at 0 }\n\
    light_source { <-3, 3, -3> rgb 1 }\n\
    sphere { 0, 1 pigment { rgb <1, 0, 0> } }\n";

fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("scene.pov"), SCENE).expect("a scene");
    std::fs::write(folder.path().join("bad.pov"), "sphere {\n 0, 1\n pigment { nonsense }\n}\n")
        .expect("a scene");
    folder
}

fn run(folder: &TempDir, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_raggio"))
        .args(arguments)
        .current_dir(folder.path())
        .env_remove("POVINI")
        .env("HOME", folder.path())
        .output()
        .expect("the program")
}

fn size(path: &Path) -> (u32, u32) {
    let bytes = std::fs::read(path).expect("a picture");
    let word = |at: usize| u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    assert!(bytes.starts_with(b"\x89PNG"));
    (word(16), word(20))
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn renders_through_both_doors_alike() {
    let folder = folder();
    let modern = run(&folder, &["render", "scene.pov", "--size", "24x18", "-o", "a.png"]);
    assert!(modern.status.success(), "{}", text(&modern.stderr));
    let old = run(&folder, &["povray", "+Iscene.pov", "+W24", "+H18", "-D", "+Ob.png"]);
    assert!(old.status.success(), "{}", text(&old.stderr));
    assert_eq!(size(&folder.path().join("a.png")), (24, 18));
    let bytes = |name: &str| std::fs::read(folder.path().join(name)).expect("a picture");
    assert_eq!(bytes("a.png"), bytes("b.png"));
    let messages = text(&old.stderr);
    for expected in
        ["= [Parsing...] =", "= [Rendering...] =", "(100%)", "w=24 clock=0.000\n", "\nPOV-Ray finished\n"]
    {
        assert!(messages.contains(expected), "{expected:?} in {messages}");
    }
    assert!(old.stdout.is_empty());
}

#[test]
fn pictures_go_to_standard_output() {
    let folder = folder();
    let ppm = run(&folder, &["povray", "scene.pov", "+W8", "+H6", "-D", "Output_File_Type=P", "+O-", "-V"]);
    let header = text(&ppm.stdout[..ppm.stdout.len() - 8 * 6 * 3]);
    assert!(header.starts_with("P6\n") && header.ends_with("\n8 6\n255\n"), "{header}");
    assert!(!text(&ppm.stderr).contains('%'));
    let png = run(&folder, &["scene.pov", "--size", "8x6", "-o", "-"]);
    assert!(png.stdout.starts_with(b"\x89PNG"));
}

#[test]
fn animations_number_their_frames() {
    let folder = folder();
    let run = run(&folder, &["povray", "scene.pov", "+W8", "+H6", "-D", "+KFF2", "+GAall.log"]);
    assert!(run.status.success(), "{}", text(&run.stderr));
    for name in ["scene1.png", "scene2.png"] {
        assert_eq!(size(&folder.path().join(name)), (8, 6));
    }
    let log = std::fs::read_to_string(folder.path().join("all.log")).expect("a log");
    assert!(log.contains("clock=0.000") && log.contains("clock=1.000"), "{log}");
}

#[test]
fn faults_end_with_one_and_leave_no_picture() {
    let folder = folder();
    for arguments in [
        &["povray", "+Ibad.pov", "+W8", "+H6"][..],
        &["povray", "+Imissing.pov"],
        &["povray", "+ZZ9", "scene.pov"],
        &["povray"],
        &["povray", "scene.pov", "+W8", "+H6", "+Onowhere/a.png"],
        &["povray", "scene.pov", "+W0", "+H6"],
        &["render", "bad.pov", "-o", "x.png"],
        &["render", "scene.pov", "-o", "x.docx"],
        &["check", "bad.pov"],
        &["check", "missing.pov"],
    ] {
        let output = run(&folder, arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {}", text(&output.stderr));
        assert!(!output.stderr.is_empty(), "{arguments:?}");
    }
    let bad = text(&run(&folder, &["povray", "+Ibad.pov", "+W8", "+H6"]).stderr);
    assert!(bad.contains("File 'bad.pov' line 3: Parse Error: "), "{bad}");
    assert!(bad.contains("Render failed"), "{bad}");
    let pictures = std::fs::read_dir(folder.path()).expect("a folder").flatten();
    assert_eq!(pictures.filter(|f| f.path().extension().is_some_and(|e| e == "png")).count(), 0);
}

#[test]
fn a_max_gradient_that_is_too_low_is_warned_of_once() {
    let folder = folder();
    let surface = |x: f64, max_gradient: f64| {
        format!(
            "isosurface {{ function {{ 3*y + sin({x}*x) }} max_gradient {max_gradient} pigment {{ rgb 1 }} translate {x}*x }}\n"
        )
    };
    let scene = |max_gradient: f64| {
        let pair = surface(-1.1, max_gradient) + &surface(1.1, max_gradient);
        std::fs::write(folder.path().join("iso.pov"), format!("camera {{ location -5*z }}\n{pair}"))
            .expect("a scene");
    };
    let warnings = |arguments: &[&str]| {
        let said = text(&run(&folder, arguments).stderr);
        said.lines().filter(|line| line.contains("max_gradient")).map(str::to_owned).collect::<Vec<_>>()
    };
    scene(1.0);
    for arguments in [&["render", "iso.pov", "--size", "24x18"][..], &["povray", "+Iiso.pov", "+W24", "+H18"]]
    {
        let said = warnings(arguments);
        assert!(said.len() == 1 && said[0].contains("1.000") && said[0].contains("holes: 2; "), "{said:?}");
    }
    scene(4.0);
    assert!(warnings(&["render", "iso.pov", "--size", "24x18"]).is_empty());
}

#[test]
fn messages_come_as_json_lines() {
    let folder = folder();
    let output = run(&folder, &["check", "bad.pov", "--message-format", "json"]);
    let messages = text(&output.stderr);
    let first: serde_json::Value = serde_json::from_str(messages.lines().next().unwrap_or("")).expect("JSON");
    assert_eq!((&first["severity"], &first["line"]), (&"error".into(), &3.into()), "{messages}");
}

#[test]
fn a_sweep_makes_one_sheet() {
    let folder = folder();
    let output =
        run(&folder, &["sweep", "scene.pov", "--quality", "0..9:3", "--size", "40x30", "-o", "s.png"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let (width, height) = size(&folder.path().join("s.png"));
    assert!(width > 4 * 40 && height > 30, "{width} {height}");
}

#[test]
fn a_gallery_shows_what_there_is() {
    let folder = folder();
    let output = run(&folder, &["gallery", "finishes", "--size", "16x12", "-o", "g.png"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let (width, height) = size(&folder.path().join("g.png"));
    assert!(width > 24 * 16 && height > 12, "{width} {height}");
    assert!(!run(&folder, &["gallery", "flowers"]).status.success());
}

#[test]
fn settings_come_from_ini_files_around() {
    let folder = folder();
    std::fs::write(folder.path().join("povray.ini"), "Width=9\nHeight=7\n").expect("a file");
    assert!(run(&folder, &["povray", "scene.pov"]).status.success());
    assert_eq!(size(&folder.path().join("scene.png")), (9, 7));
}

#[test]
fn the_built_in_scene_says_where_its_picture_is_and_what_to_try_next() {
    let folder = folder();
    let drawn = run(&folder, &["render", "--size", "16x12"]);
    assert!(drawn.status.success(), "{}", text(&drawn.stderr));
    assert_eq!(size(&folder.path().join("default.png")), (16, 12));
    let said = text(&drawn.stderr);
    assert!(said.contains("default.png") && said.contains("raggio render scene.pov"), "{said}");
}
