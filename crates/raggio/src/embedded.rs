//! The include files and the default scene that travel inside the program.

/// One include file by its exact name.
pub fn file(name: &str) -> Option<&'static [u8]> {
    FILES.iter().find(|(n, _)| *n == name).map(|(_, text)| *text)
}

/// The scene that is rendered when none is named.
pub const DEFAULT_SCENE: &str = include_str!("../../../scenes/default.pov");

macro_rules! includes {
    ($($name:literal)*) => {
        const FILES: &[(&str, &[u8])] = &[$(($name, include_bytes!(concat!("../include/", $name)))),*];
    };
}

includes! {
    "arrays.inc"
    "ash.map"
    "benediti.map"
    "bubinga.map"
    "cedar.map"
    "chars.inc"
    "colors.inc"
    "consts.inc"
    "debug.inc"
    "finish.inc"
    "functions.inc"
    "glass.inc"
    "glass_old.inc"
    "golds.inc"
    "ior.inc"
    "logo.inc"
    "marbteal.map"
    "math.inc"
    "metals.inc"
    "orngwood.map"
    "pinkmarb.map"
    "rad_def.inc"
    "rand.inc"
    "rdgranit.map"
    "screen.inc"
    "shapes.inc"
    "shapes2.inc"
    "shapes3.inc"
    "shapes_old.inc"
    "shapesq.inc"
    "skies.inc"
    "stage1.inc"
    "stars.inc"
    "stdcam.inc"
    "stdinc.inc"
    "stoneold.inc"
    "stones.inc"
    "stones1.inc"
    "stones2.inc"
    "strings.inc"
    "sunpos.inc"
    "teak.map"
    "textures.inc"
    "transforms.inc"
    "whiteash.map"
    "woodmaps.inc"
    "woods.inc"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_folder_is_listed() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/include");
        let mut names: Vec<_> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        assert_eq!(FILES.iter().map(|(name, _)| *name).collect::<Vec<_>>(), names);
    }
}
