//! Layered textures up to version 3.1: what the upper layers let through, they let through untinted.
use std::sync::Arc;

use raggio_scene::{Color, Layer, Pigment, PigmentKind, Texture, TextureKind};

use crate::parser::Parser;

/// The last version whose upper layers do not tint.
const UNTINTED: u16 = 310;

/// Makes all layers from one on pass light untinted, if the version in force is so old.
pub fn settle(p: &Parser, texture: &mut Texture, from: usize) {
    if p.settings.version.language <= UNTINTED
        && let TextureKind::Layers(layers) = &mut texture.kind
    {
        layers[from..].iter_mut().for_each(|layer: &mut Layer| untint(&mut layer.pigment));
    }
}

/// Images keep their tint, as in POV-Ray.
fn untint(pigment: &mut Arc<Pigment>) {
    if !tints(pigment) {
        return;
    }
    match &mut Arc::make_mut(pigment).kind {
        PigmentKind::Solid { color, .. } => pass(color),
        PigmentKind::ColorMap { map, .. } => Arc::make_mut(map).iter_mut().for_each(|(_, color)| pass(color)),
        PigmentKind::PigmentMap { map, .. } => map.iter_mut().for_each(|(_, pigment)| untint(pigment)),
        PigmentKind::Uv(inner) => untint(inner),
        PigmentKind::Image { .. } => {}
    }
}

fn pass(color: &mut Color) {
    color.transmit += std::mem::take(&mut color.filter);
}

/// Is there anything to change? What others share is copied only then.
fn tints(pigment: &Pigment) -> bool {
    match &pigment.kind {
        PigmentKind::Solid { color, .. } => color.filter != 0.0,
        PigmentKind::ColorMap { map, .. } => map.iter().any(|(_, color)| color.filter != 0.0),
        PigmentKind::PigmentMap { map, .. } => map.iter().any(|(_, pigment)| tints(pigment)),
        PigmentKind::Uv(inner) => tints(inner),
        PigmentKind::Image { .. } => false,
    }
}
