//! A stage for small scenes: objects, lights and textures by short names, and pictures of them.
#![allow(dead_code)]
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio_image::{Color, Curve, Rgb};
use raggio_math::Vec3;
use raggio_render::{Film, Options, World};
use raggio_scene::*;

pub fn v(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

pub fn rgb(r: f32, g: f32, b: f32) -> Rgb {
    Rgb::new(r, g, b)
}

pub fn rgbft(c: [f64; 5]) -> Color {
    Color::from_array(c)
}

/// A texture of one layer.
pub fn texture(color: Color, finish: Finish) -> Texture {
    layers(vec![(color, finish)])
}

pub fn layers(list: Vec<(Color, Finish)>) -> Texture {
    let layer = |(color, finish)| Layer { pigment: Arc::new(Pigment::solid(color)), normal: None, finish };
    Texture { kind: TextureKind::Layers(list.into_iter().map(layer).collect()) }
}

/// A finish that only shines by itself.
pub fn glowing(ambient: f32) -> Finish {
    Finish { ambient: Rgb::splat(ambient), diffuse: 0.0, diffuse_raw: 0.0, ..Finish::default() }
}

pub fn object(shape: Shape, texture: Texture) -> Object {
    Object {
        texture: Some(Placed::new(Arc::new(texture))),
        ..Object::new(ObjectKind::Shape(Arc::new(shape)))
    }
}

pub fn sphere(center: Vec3, radius: f64, texture: Texture) -> Object {
    object(Shape::Sphere { center, radius }, texture)
}

pub fn plane(normal: Vec3, distance: f64, texture: Texture) -> Object {
    object(Shape::Plane { normal, distance }, texture)
}

pub fn block(min: Vec3, max: Vec3, texture: Texture) -> Object {
    object(Shape::Box { min, max }, texture)
}

pub fn inside(mut object: Object, interior: Interior) -> Object {
    object.interior = Some(Placed::new(Arc::new(interior)));
    object
}

pub fn shine(light: Light) -> Object {
    Object::new(ObjectKind::Light(Arc::new(light)))
}

/// A camera along z from a place, as wide and high as given.
pub fn view(kind: CameraKind, location: Vec3, width: f64, height: f64) -> Camera {
    Camera {
        kind,
        location,
        direction: Vec3::Z,
        up: Vec3::Y * height,
        right: Vec3::X * width,
        angle: 90.0,
        focal_blur: None,
        normal: None,
    }
}

pub fn scene(camera: Camera, objects: Vec<Object>) -> Scene {
    Scene {
        settings: Settings {
            version: Version { language: 370, effective: 370 },
            gamma: GammaMode::Working(Curve::Linear),
            adc_bailout: 1.0 / 255.0,
            ambient_light: Rgb::ONE,
            irid_wavelength: rgb(0.70, 0.52, 0.48),
            max_trace_level: 5,
            noise_generator: 2,
            number_of_waves: 10,
            mm_per_unit: 10.0,
            subsurface: None,
            radiosity: None,
            photons: None,
            default_radiosity_importance: 1.0,
        },
        camera,
        atmosphere: Atmosphere::default(),
        objects: objects.into_iter().map(Arc::new).collect(),
    }
}

pub fn options(width: usize, height: usize) -> Options {
    Options {
        width,
        height,
        region: None,
        quality: 9,
        antialias: None,
        threads: 1,
        seed: 0,
        max_trace_level: None,
        alpha: false,
    }
}

pub fn render(scene: &Scene, options: &Options) -> Film {
    let world = World::build(scene).expect("the scene can be built");
    world.render(options, &AtomicBool::new(false), &|_, _| {})
}

/// The colour of one pixel.
pub fn pixel(film: &Film, x: usize, y: usize) -> Rgb {
    let [r, g, b, _] = film.pixels[y * film.width + x];
    rgb(r, g, b)
}

/// Fails unless a pixel has that colour.
pub fn expect(film: &Film, x: usize, y: usize, expected: [f32; 3], tolerance: f32) {
    let got = pixel(film, x, y);
    let apart = (got - Rgb::from_array(expected)).abs().max_element();
    assert!(apart <= tolerance, "pixel ({x}, {y}) is {got} and should be {expected:?}");
}
