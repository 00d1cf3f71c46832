//! The command line against what POV-Ray 3.7 was seen to do with it.
use std::path::PathBuf;

use raggio::Region;
use raggio::image::{Curve, Dither, Format};

use super::animation::{frames, output_path};
use super::ini::{apply_arguments, apply_file, words};
use super::keys::{OptionError, Settings, StreamKind};
use super::run::region;

/// The settings that arguments make, written as a shell would get them: apart at spaces, quotes kept.
fn read(line: &str) -> Result<Settings, OptionError> {
    let mut settings = Settings::default();
    let arguments: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
    apply_arguments(&arguments, &mut settings)?;
    Ok(settings)
}

fn good(line: &str) -> Settings {
    read(line).unwrap_or_else(|e| panic!("{line}: {e:?}"))
}

/// The settings from an INI file with this text, and then from arguments.
fn from_ini(text: &str, section: &str) -> Result<Settings, OptionError> {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("inc.ini"), "Width=15\n").expect("a file");
    let path = folder.path().join("t.ini");
    std::fs::write(&path, text).expect("a file");
    let mut settings = Settings::default();
    settings.set("Library_Path", &folder.path().to_string_lossy()).expect("a library");
    apply_file(&format!("{}{section}", path.display()), &mut settings)?;
    Ok(settings)
}

/// The name of the picture that a command line makes, and of its last frame.
fn picture(line: &str) -> PathBuf {
    let settings = good(line);
    let frames = frames(&settings);
    output_path(&settings, &frames, frames.list.last().expect("a frame").number)
}

#[test]
fn known_callers_are_understood() {
    let vapory = good("scene.pov +H30 +W40 +Q9 +A0.010000 -D Output_File_Type=P +O-");
    assert_eq!((vapory.width, vapory.height, vapory.format), (40, 30, Format::Pnm));
    assert_eq!((vapory.antialias, vapory.threshold), (true, 0.01));
    let leocad = good("+I\"scene.pov\" +W40 +H30 -O- +Q11 +R3 +A0.1 +J0.5 +FN -D");
    assert_eq!((leocad.input.as_deref(), leocad.output.as_deref()), (Some("scene.pov"), Some("-")));
    assert_eq!((leocad.quality, leocad.depth, leocad.jitter_amount), (9, Some(3), 0.5));
    let magick = good("+iscene.pov -D0 +oout.png +fn8 +w40 +h30 +a -q9 -kfi0 -kff0");
    assert!(!frames(&magick).animated && magick.antialias && magick.bits == 8);
    let drawxtl = good("+W40 +H30 -D +FC +A0.3 -P scene.pov");
    assert!(drawxtl.run_length && drawxtl.format == Format::Tga);
    let gdis = good("+Iscene.pov -Ga -P +W40 +H30 +FT +A +AM2 -D");
    assert!(gdis.streams.iter().all(|s| !s.console) && gdis.sampling_method == 2 && !gdis.run_length);
    let inkscape = good("+X +V +A +W40 +H30 +Iscene.pov +FN -D");
    assert!(inkscape.verbose && inkscape.antialias);
    let small = good("+iscene.pov +w40 +h30 -d +fn +oa.png +q9 +a0.3 +am2 +r2 +j +wt1");
    assert_eq!((small.threads, small.depth, small.jitter), (1, Some(2), true));
}

#[test]
fn what_the_program_refuses_is_refused() {
    for line in [
        "+ZZ9",
        "+FS",
        "+FD",
        "+FX",
        "+FN16g",
        "+FNG8",
        "Bogus_Key=3",
        "-v9x",
        "--generation",
        "-W 40",
        "+I scene.pov",
        "/W40",
        "Declare=Name=\"abc\"",
        "+QR",
        "+AC0.9",
        "+b100",
        "+BP16",
        "-visual",
        "+GH",
        "+EN",
        "-T",
        "+NA",
        "+RS",
        "Radiosity=On",
        "Stochastic_Seed=1",
        "Histogram_Type=N",
        "+TD1",
        "+FG",
        "-geometry",
        "scene",
        "nothere.ini",
        "Width=abc",
        "+A0,2",
        "+Wabc",
    ] {
        assert!(read(line).is_err(), "{line}");
    }
}

/// Options that the program accepts, alone.
const TAKEN: &str = "\
+F | -F | +FN5 | +FP16 | +FJ50 | +FB | +FE | +FH | +UA | Grayscale_Output=on | Compression=9
+KFI9 +KFF11 +KI0 +KF2 | +KC | +SP32 +EP4 | +C | -V | Verbose=false | -GD -GR -GS | -GW -GF
+GAall.log | All_File=1 | +GIopts.ini | All_Console=Off | Warning_Level=0 | +Q0 | +R9 | +J
-J | -A | +A0.0 | +AM3 | +AG1.0 | +X | -X | +P | +MB1 | -MB | +BM2 | +UD | -UL | +UV | +UR
+SU | +UO | +WT0 | +MV3.5 | +BS16 | +HIhdr.inc | +RTR | +HR | +GP | +TH | +UF | -d0 | +DGT
+LX | Max_Image_Buffer_Memory=64 | Split_Unions=On | Light_Buffer=Off
High_Reproducibility=on | Bounding=Off | Antialias_Depth=4 | Sampling_Method=2
File_Gamma=1.0 | Display_Gamma=sRGB | Dither=on | Dither_Method=B2 | Palette=3
Test_Abort_Count=100 | Field_Render=on | Odd_Field=on | Pre_Scene_Command=false
Render_Pattern=1 | Render_Block_Step=3 | Real_Time_Raytracing=on | Warning_Console=off
+RFI | +RFcache.rca | +STP2 | -RVP | +W8.5";

#[test]
fn what_the_program_takes_is_taken() {
    for line in TAKEN.lines().flat_map(|line| line.split(" | ")) {
        good(line);
    }
}

#[test]
fn switches_set_what_they_say() {
    let s = good("+W8.5 +H6 +FN16 +UA +THD1 +K.5 +L/a +Lb +MV3.5 Declare=A=1/2 Declare=B=0.5");
    assert_eq!((s.width, s.height, s.bits, s.alpha), (8, 6, 16, true));
    assert_eq!((s.dither, s.dither_method, s.clock), (true, Dither::D1, Some(0.5)));
    assert_eq!((s.libraries.len(), s.version), (2, Some(3.5)));
    assert_eq!(s.declares, [("A".to_owned(), 1.0), ("B".to_owned(), 0.5)]);
    assert_eq!(good("-TH").dither_method, Dither::FloydSteinberg);
    assert_eq!((good("-FT").output_to_file, good("-FT +F").format), (false, Format::Tga));
    assert!(good("+FNG").grey);
    assert_eq!(good("File_Gamma=1.8").file_curve, Curve::Power(1.8));
    assert_eq!(good("+FN3").bits, 5);
    assert!(!good("+RTR").output_to_file);
    let streams = good("-GA +GDdebug.txt All_File=1").streams;
    assert_eq!(streams[StreamKind::Debug as usize].file.as_deref(), Some("debug.txt"));
    assert_eq!(streams[StreamKind::All as usize].file.as_deref(), Some("alltext.out"));
    assert!(streams[StreamKind::Debug as usize].console && !streams[StreamKind::Fatal as usize].console);
}

#[test]
fn arguments_with_spaces_fall_apart_unless_quoted() {
    assert_eq!(words("+I\"my scene.pov\" '-O x' +W4"), ["+Imy scene.pov", "-O x", "+W4"]);
    let mut settings = Settings::default();
    apply_arguments(&["+I\"my scene.pov\"".to_owned()], &mut settings).expect("a quoted name");
    assert_eq!(settings.input.as_deref(), Some("my scene.pov"));
    apply_arguments(&["+Imy scene.pov".to_owned()], &mut settings).expect("two words");
    assert_eq!(settings.input.as_deref(), Some("scene.pov"));
    assert!(apply_arguments(&["Output_File_Name=my out".to_owned()], &mut settings).is_err());
    assert!(apply_arguments(&["Width = 8".to_owned()], &mut settings).is_err());
}

#[test]
fn ini_files_have_comments_quotes_and_sections() {
    let s = from_ini(
        "\u{feff}; all\r\nInput_File_Name = my scene.pov ; comment\r\n# more\r\nWIDTH = 33\r\n+H12 -A\r\n\
         Output_File_Name=\"a;b.png\" ; x\r\n[big]\r\nWidth=20\r\n[small]\r\nWidth=4\r\n[big]\r\nHeight=3\r\n",
        "",
    );
    let s = s.expect("settings");
    assert_eq!((s.width, s.height), (33, 12));
    assert_eq!(s.input.as_deref(), Some("my scene.pov"));
    assert_eq!(s.output.as_deref(), Some("a;b.png"));
    let sections = "Width=8\nHeight=6\n[big]\nWidth=20\n[small]\nWidth=4\n[big]\nHeight=3\n";
    let size = |section: &str| from_ini(sections, section).map(|s| (s.width, s.height));
    assert_eq!(size(""), Ok((8, 6)));
    assert_eq!(size("[big]"), Ok((20, 3)));
    assert_eq!(size("[SMALL]"), Ok((4, 6)));
    assert_eq!(size("[nope]"), Ok((8, 6)));
}

#[test]
fn ini_files_are_lenient_where_the_program_is() {
    let size = |text: &str| from_ini(text, "").map(|s| (s.width, s.height));
    assert_eq!(size("Height=5\nWidth=10 Height=4\n"), Ok((10, 5)));
    assert_eq!(size("Width=9.9\nHeight=472.8"), Ok((9, 472)));
    assert_eq!(size("inc.ini\nHeight=2"), Ok((15, 2)));
    assert_eq!(size("Include_Ini=inc.ini\nHeight=2"), Ok((15, 2)));
    assert_eq!(
        from_ini("Output_File_Name='my out.png'", "").map(|s| s.output),
        Ok(Some("my out.png".to_owned()))
    );
    assert_eq!(from_ini("Antialias=maybe", "").map(|s| s.antialias), Ok(false));
    assert_eq!(from_ini("Start_Column= 0.1", "").map(|s| s.columns.0), Ok(Some(0.1)));
    assert_eq!(from_ini("scene.pov", "").map(|s| s.input), Ok(Some("scene.pov".to_owned())));
    assert!(size("// comment\n").is_err() && size("Width=abc").is_err() && size("nope.ini").is_err());
    assert!(size("t.ini").is_err(), "a file that includes itself");
}

#[test]
fn pictures_are_named_as_there() {
    for (line, name) in [
        ("scene.pov", "scene.png"),
        ("sub/in.pov", "sub/in.png"),
        ("scene.pov +FT", "scene.tga"),
        ("scene.pov +FC", "scene.tga"),
        ("scene.pov +FP", "scene.ppm"),
        ("scene.pov +FJ", "scene.jpg"),
        ("scene.pov +Oa.jpg", "a.jpg.png"),
        ("scene.pov +Oout", "out.png"),
        ("scene.pov +Oa.png +Ob.png", "b.png"),
        ("scene.pov +Ox.PNG", "x.PNG.png"),
        ("scene.pov +Osub/", "sub/scene.png"),
        ("scene.pov +Ofoo.tga +FT", "foo.tga"),
        ("+Iscene", "scene.png"),
        ("scene.pov +O-", "-"),
        ("scene.pov +KFF3", "scene3.png"),
        ("scene.pov +KFI9 +KFF11", "scene11.png"),
        ("scene.pov +KFF11 +EF9", "scene09.png"),
        ("scene.pov +KFF100 +SF7 +EF7", "scene007.png"),
        ("scene.pov +KFF4 +Oframe.png", "frame4.png"),
    ] {
        assert_eq!(picture(line), PathBuf::from(name), "{line}");
    }
}

#[test]
fn clocks_run_through_the_frames() {
    let clocks = |line: &str| {
        let f = frames(&good(line));
        let list: Vec<(i64, f64)> =
            f.list.iter().map(|f| (f.number, (f.clock * 1e4).round() / 1e4)).collect();
        (list, f.initial_frame, f.final_frame, (f.clock_delta * 1e4).round() / 1e4)
    };
    assert_eq!(clocks("+K0.25"), (vec![(0, 0.25)], 0, 0, 0.0));
    assert_eq!(clocks("+KFF3"), (vec![(1, 0.0), (2, 0.5), (3, 1.0)], 1, 3, 0.5));
    assert_eq!(clocks("+KFI9 +KFF11 +KI0 +KF2"), (vec![(9, 0.0), (10, 1.0), (11, 2.0)], 9, 11, 1.0));
    assert_eq!(clocks("+KFF2 +KC"), (vec![(1, 0.0), (2, 0.5)], 1, 3, 0.5));
    assert_eq!(clocks("+KFF100 +SF7 +EF7"), (vec![(7, 0.0606)], 1, 100, 0.0101));
    assert_eq!(clocks("+KFF10 +SF0.25 +EF0.35").0, [(2, 0.1111), (3, 0.2222)]);
    assert_eq!(clocks("+KFF10 +SF0.15 +EF0.16").0, [(1, 0.0)]);
    assert_eq!(clocks("+KFF5 Frame_Step=2").0, [(1, 0.0), (3, 0.5), (5, 1.0)]);
    assert_eq!(clocks("+KFI0 +KFF2 +KC +K0.7").0, [(0, 0.0), (1, 0.3333), (2, 0.6667)]);
    assert_eq!(clocks("+KFF1").0, [(1, 0.0)]);
}

#[test]
fn parts_of_pictures_count_from_one_or_in_fractions() {
    let part = |line: &str| region(&good(line));
    let edges = |left, top, right, bottom| Ok(Some(Region { left, top, right, bottom }));
    assert_eq!(part("+W8 +H6"), Ok(None));
    assert_eq!(part("+W8 +H6 +SC3 +EC4 +SR0.5 +ER0.75"), edges(2, 3, 4, 4));
    assert_eq!(part("+W10 +H10 +SC0.25 +EC0.55 +SR0.34 +ER1"), edges(2, 3, 5, 10));
    assert_eq!(part("+W10 +H10 +SC1 +SR1 +EC1 +ER5"), edges(0, 0, 10, 5));
    assert_eq!(part("+W40 +H30 +SR11 +ER20"), edges(0, 10, 40, 20));
    assert!(part("+W10 +H10 +EC20").is_err() && part("+W0 +H30").is_err());
    assert_eq!(part("+W10 +H10 +SC9 +EC3"), edges(8, 0, 8, 10));
}
