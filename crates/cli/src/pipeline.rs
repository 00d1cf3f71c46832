//! The way from options to a film, the same for every door.
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use raggio::image::{Curve, EncodeOptions, Picture};
use raggio::scene::GammaMode;
use raggio::{Failure, Film, Loaded, RenderOptions, SceneOptions, World};

/// A scene that is ready to be rendered.
pub(crate) struct Ready {
    pub loaded: Loaded,
    pub world: World,
    /// How long reading took.
    pub parse_time: Duration,
    /// How long it took to make the world ready for rays.
    pub build_time: Duration,
}

/// Reads a scene and builds its world.
pub(crate) fn prepare(
    scene: &SceneOptions,
    debug: &mut (dyn FnMut(&str) + Send),
    cancel: &Arc<AtomicBool>,
) -> Result<Ready, Failure> {
    let start = Instant::now();
    let loaded = raggio::load_with(scene, debug, cancel)?;
    let parse_time = start.elapsed();
    let world = loaded.build()?;
    Ok(Ready { loaded, world, parse_time, build_time: start.elapsed() - parse_time })
}

/// What is left out of the picture because it is not built yet.
pub(crate) fn left_out(loaded: &Loaded) -> Option<String> {
    let missing = World::unsupported(&loaded.scene);
    (!missing.is_empty()).then(|| format!("left out, not built yet: {}", missing.join(", ")))
}

/// Options with everything at its default.
pub(crate) fn render_options((width, height): (usize, usize)) -> RenderOptions {
    RenderOptions { width, height, ..RenderOptions::default() }
}

/// The film as a picture.
pub(crate) fn picture(film: Film) -> Picture {
    Picture { width: film.width, height: film.height, pixels: film.pixels }
}

/// Encoding options that know the scene's working space.
pub(crate) fn encode_options(loaded: &Loaded, options: EncodeOptions) -> EncodeOptions {
    EncodeOptions { working: working(loaded), ..options }
}

fn working(loaded: &Loaded) -> Option<Curve> {
    match loaded.scene.settings.gamma {
        GammaMode::None => None,
        GammaMode::Working(curve) => Some(curve),
    }
}

/// The text of standard input, for scenes named `-`.
pub(crate) fn standard_input() -> std::io::Result<Vec<u8>> {
    let mut text = Vec::new();
    std::io::Read::read_to_end(&mut std::io::stdin().lock(), &mut text)?;
    Ok(text)
}
