//! The running defaults, and `#default` which changes them.
use std::sync::Arc;

use raggio_scene::{Camera, Color, Finish, Layer, Normal, Pigment, Texture, TextureKind};

use super::util::{set32, word};
use super::{camera, normal, texture};
use crate::keyword::Kw;
use crate::parser::{Parser, Result};

/// What blocks begin with.
#[derive(Clone, Debug)]
pub struct Defaults {
    /// One plain layer.
    pub texture: Arc<Texture>,
    /// What normals begin with when the default texture has none.
    pub bump_size: f32,
    /// What a camera begins with; `None` is the language's own.
    pub camera: Option<Arc<Camera>>,
    /// `radiosity { importance }` of objects that give none.
    pub radiosity_importance: f32,
}

impl Default for Defaults {
    fn default() -> Self {
        let pigment = Arc::new(Pigment::solid(Color::BLACK));
        let layer = Layer { pigment, normal: None, finish: Finish::default() };
        let texture = Arc::new(Texture { kind: TextureKind::Layers(vec![layer]) });
        Defaults { texture, bump_size: normal::BUMP_SIZE, camera: None, radiosity_importance: 1.0 }
    }
}

impl Defaults {
    fn layer(&self) -> Option<&Layer> {
        match &self.texture.kind {
            TextureKind::Layers(layers) => layers.last(),
            _ => None,
        }
    }

    /// The default texture's pigment.
    pub fn pigment(&self) -> Arc<Pigment> {
        match self.layer() {
            Some(layer) => layer.pigment.clone(),
            None => Arc::new(Pigment::solid(Color::BLACK)),
        }
    }

    /// The default texture's normal.
    pub fn normal(&self) -> Option<Arc<Normal>> {
        self.layer().and_then(|layer| layer.normal.clone())
    }

    /// The default texture's finish.
    pub fn finish(&self) -> Finish {
        self.layer().map_or_else(Finish::default, |layer| layer.finish)
    }
}

/// `#default { ... }`; the word has been read.
pub fn default_directive(p: &mut Parser) -> Result<()> {
    p.block("#default", |p| {
        let span = p.span();
        match word(p)? {
            Some(Kw::Texture) => {
                p.next()?;
                let new = texture::block(p)?;
                if !matches!(&new.kind, TextureKind::Layers(layers) if layers.len() == 1) {
                    return p.error(
                        "bad-default",
                        "the default texture cannot be layered or patterned",
                        span,
                    );
                }
                p.defaults.texture = Arc::new(new);
            }
            Some(Kw::Normal) => {
                p.next()?;
                let mut new = (*p.defaults.texture).clone();
                let base = p.defaults.normal();
                let draft = normal::read(p, base.as_deref())?;
                p.defaults.bump_size = draft.bump_size();
                texture::top_layer(p, &mut new)?.normal = draft.finish(p)?;
                p.defaults.texture = Arc::new(new);
            }
            Some(part @ (Kw::Pigment | Kw::Finish)) => {
                let mut new = (*p.defaults.texture).clone();
                texture::layer_part(p, &mut new, part)?;
                p.defaults.texture = Arc::new(new);
            }
            Some(Kw::Camera) => {
                p.next()?;
                p.defaults.camera = Some(Arc::new(camera::block(p)?));
            }
            Some(Kw::Radiosity) => {
                p.next()?;
                let mut importance = p.defaults.radiosity_importance;
                p.block("radiosity", |p| match word(p)? {
                    Some(Kw::Importance) => set32(p, &mut importance),
                    _ => Ok(false),
                })?;
                p.defaults.radiosity_importance = importance;
                p.settings.default_radiosity_importance = importance;
            }
            _ => return Ok(false),
        }
        Ok(true)
    })
}
