//! Material libraries of OBJ files.
//!
//! `Kd` or `map_Kd` is the colour, `Ks` and `Ns` the highlight, `d` or `Tr` how much is seen through. `Ns` is the
//! exponent of a Blinn highlight, which is one over the scene's roughness.
use std::sync::Arc;

use raggio_image::{Color, Curve, FileCurve, Rgb, decode};
use raggio_scene::{Finish, ImageMap, Interpolation, Layer, Pigment, PigmentKind, Texture, TextureKind};

use crate::text::{Lines, Words};
use crate::{Result, Surroundings};

/// A material as it is written.
struct Material {
    name: String,
    diffuse: Rgb,
    specular: Rgb,
    exponent: f32,
    opacity: f32,
    picture: Option<Arc<ImageMap>>,
}

/// The textures of a library by their names.
pub(crate) fn read(bytes: &[u8], around: &Surroundings) -> Result<Vec<(String, Arc<Texture>)>> {
    let mut materials: Vec<Material> = Vec::new();
    for mut words in Lines::new(bytes) {
        let key = words.next().unwrap_or_default();
        if key == b"newmtl" {
            materials.push(Material::new(words.name()));
        } else if let Some(material) = materials.last_mut() {
            material.item(key, &mut words, around)?;
        }
    }
    Ok(materials.into_iter().map(|m| (m.name.clone(), Arc::new(m.texture()))).collect())
}

impl Material {
    fn new(name: String) -> Self {
        let (diffuse, specular) = (Rgb::splat(0.8), Rgb::ZERO);
        Material { name, diffuse, specular, exponent: 0.0, opacity: 1.0, picture: None }
    }

    fn item(&mut self, key: &[u8], words: &mut Words, around: &Surroundings) -> Result<()> {
        match key {
            b"Kd" => self.diffuse = Rgb::from_array(words.point()?),
            b"Ks" => self.specular = Rgb::from_array(words.point()?),
            b"Ns" => self.exponent = words.number()? as f32,
            b"d" => self.opacity = words.number()?.clamp(0.0, 1.0) as f32,
            b"Tr" => self.opacity = 1.0 - words.number()?.clamp(0.0, 1.0) as f32,
            b"map_Kd" => {
                let name = words.name();
                // Options stand before the name; none of them is known here, so the last word is the name.
                let last = name.split_ascii_whitespace().last().unwrap_or_default();
                let name = if name.starts_with('-') { last } else { &name };
                self.picture = picture(name, words, around)?;
            }
            _ => {}
        }
        Ok(())
    }

    fn texture(self) -> Texture {
        let transmit = 1.0 - self.opacity;
        let kind = match self.picture {
            Some(image) => {
                let mut image = ImageMap::clone(&image);
                image.transmit_all = transmit;
                let pigment = PigmentKind::Image { warps: Vec::new(), image: Arc::new(image) };
                PigmentKind::Uv(Arc::new(Pigment { kind: pigment, quick_color: None }))
            }
            None => PigmentKind::solid(Color { rgb: self.diffuse, filter: 0.0, transmit }),
        };
        let mut finish = Finish { diffuse: 1.0, diffuse_raw: 1.0, ..Finish::default() };
        if self.exponent > 0.0 {
            finish.specular = raggio_image::grey(self.specular);
            finish.roughness = 1.0 / self.exponent;
        }
        let pigment = Arc::new(Pigment { kind, quick_color: None });
        Texture { kind: TextureKind::Layers(vec![Layer { pigment, normal: None, finish }]) }
    }
}

/// A picture that cannot be found leaves the plain colour.
fn picture(name: &str, words: &Words, around: &Surroundings) -> Result<Option<Arc<ImageMap>>> {
    let Some(bytes) = (around.find)(&name.replace('\\', "/")) else { return Ok(None) };
    let bitmap = match decode(&bytes, raggio_image::Format::from_name(name)) {
        Ok(bitmap) => bitmap,
        Err(fault) => return words.error(format!("in the picture {name}: {fault}")),
    };
    let from = match bitmap.curve {
        FileCurve::Stated(curve) => Some(curve),
        FileCurve::CustomSrgb => Some(Curve::Srgb),
        FileCurve::Linear => Some(Curve::Linear),
        FileCurve::None => None,
    };
    Ok(Some(Arc::new(ImageMap {
        conversion: from.zip(around.working).filter(|(from, to)| from != to),
        premultiplied: bitmap.premultiplied,
        interpolation: Interpolation::Bilinear,
        ..ImageMap::new(bitmap.into())
    })))
}
