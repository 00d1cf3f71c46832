//! From a point in space to a place on the picture (textures spec, section 7.1).
use std::f64::consts::PI;

use raggio_math::turns::{rest, wrapped};
use raggio_math::{EPS, Vec2, Vec3};
use raggio_scene::MapType;

use super::{Image, Place};
use crate::warp::{longitude, torus_angles};

impl Image {
    /// `None` beside a picture used `once`, and where a mapping has no answer.
    pub(super) fn place(&self, p: Vec3) -> Option<Place> {
        let map = &*self.map;
        let mosaic = &map.source.mosaic;
        let pixels = Vec2::new(mosaic.width() as f64, mosaic.height() as f64);
        let size = pixels * map.repeat;
        let inside = |c: f64| !map.once || (0.0..=1.0).contains(&c);
        let raw = match map.map_type {
            MapType::Planar => (inside(p.x) && inside(p.y))
                .then(|| Vec2::new(rest(p.x * size.x, size.x), rest(p.y * size.y, size.y))),
            MapType::Spherical => {
                let d = p.length();
                (d != 0.0).then(|| Vec2::new(longitude(p), 0.5 + (p.y / d).asin() / PI) * size)
            }
            MapType::Cylindrical => {
                let on_axis = p.x == 0.0 && p.z == 0.0;
                (!on_axis && inside(p.y))
                    .then(|| Vec2::new(longitude(p) * size.x, rest(p.y * size.y, size.y)))
            }
            MapType::Torus => torus_angles(p, 1.0).map(|(theta, phi, _)| Vec2::new(theta, phi) * size),
        }?;
        let c = raw + Vec2::splat(EPS) - pixels * map.offset;
        let beside = map.once && !(c.cmpge(Vec2::ZERO).all() && c.cmplt(pixels).all());
        (!beside).then(|| Place { x: wrapped(c.x, pixels.x), y: wrapped(-c.y, pixels.y) })
    }
}
