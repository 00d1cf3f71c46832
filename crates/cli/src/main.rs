//! The door: a first one, that renders one scene.
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (w, h) = args[1].split_once('x').unwrap();
    let (width, height) = (w.parse().unwrap(), h.parse().unwrap());
    let mut options = raggio::SceneOptions::file(PathBuf::from(&args[0]));
    (options.parse.image_width, options.parse.image_height) = (width as u32, height as u32);
    let t = std::time::Instant::now();
    let loaded = match raggio::load_with(&options, &mut |s| eprint!("{s}"), &Default::default()) {
        Ok(l) => l,
        Err(f) => {
            eprintln!("{}", f.render());
            std::process::exit(1)
        }
    };
    eprintln!("parse {:?}", t.elapsed());
    for m in World::unsupported(&loaded.scene) {
        eprintln!("unsupported: {m}");
    }
    let t = std::time::Instant::now();
    let world = loaded.build().unwrap_or_else(|f| {
        eprintln!("{}", f.render());
        std::process::exit(1)
    });
    eprintln!("build {:?}", t.elapsed());
    let t = std::time::Instant::now();
    let o = raggio::RenderOptions { width, height, region: None, quality: 9, antialias: None, threads: 2, seed: 0, max_trace_level: None, alpha: false };
    let film = world.render(&o, &AtomicBool::new(false), &|_, _| {});
    eprintln!("render {:?}", t.elapsed());
    let picture = raggio::image::Picture { width, height, pixels: film.pixels };
    let working = match loaded.scene.settings.gamma {
        raggio::scene::GammaMode::None => None,
        raggio::scene::GammaMode::Working(c) => Some(c),
    };
    raggio::write_picture(&picture, &raggio::image::EncodeOptions { working, ..Default::default() }, Path::new(&args[2])).unwrap();
}
use raggio::World;
