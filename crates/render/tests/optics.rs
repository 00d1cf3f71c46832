//! Thin films and dispersion against the physics they stand for.
mod stage;

use raggio_image::Rgb;
use raggio_math::Vec3;
use raggio_scene::*;
use stage::*;

/// The light that a matt wall under a film sends back, seen and lit from one far point at an angle to it.
fn film(amount: f32, thickness: f32, angle: f64) -> Rgb {
    let irid = (amount != 0.0).then_some(Irid { amount, thickness, turbulence: 0.0 });
    let finish = Finish { diffuse: 1.0, diffuse_raw: 1.0, irid, ..glowing(0.0) };
    let (sin, cos) = angle.to_radians().sin_cos();
    let wall = plane(v(sin, 0.0, -cos), 0.0, texture(Color::WHITE, finish));
    let light = shine(Light::new(v(0.0, 0.0, -1e7), Rgb::ONE));
    let camera = view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 1e-3, 1e-3);
    pixel(&render(&scene(camera, vec![light, wall]), &options(1, 1)), 0, 0)
}

/// The wavelengths that the three channels stand for by default.
const WAVELENGTHS: [f64; 3] = [0.70, 0.52, 0.48];

#[test]
fn films_brighten_where_paths_differ_by_whole_wavelengths() {
    let bare = film(0.0, 0.0, 0.0);
    for (channel, wavelength) in WAVELENGTHS.into_iter().enumerate() {
        for order in 1..4 {
            // Down and up again at right angles: twice the thickness.
            let whole = film(0.4, (f64::from(order) * wavelength / 2.0) as f32, 0.0) / bare;
            let half = film(0.4, ((f64::from(order) + 0.5) * wavelength / 2.0) as f32, 0.0) / bare;
            assert!((whole[channel] - 1.4).abs() < 1e-4, "{wavelength} order {order}: {whole}");
            assert!((half[channel] - 0.6).abs() < 1e-4, "{wavelength} order {order}: {half}");
        }
    }
}

#[test]
fn films_only_move_light_from_thickness_to_thickness() {
    let bare = film(0.0, 0.0, 0.0);
    // Sixty to ninety wavelengths of each channel, evenly.
    let count = 240;
    let sum: Rgb = (0..count).map(|i| film(0.7, 22.0 * i as f32 / 240.0, 0.0)).sum();
    assert!((sum / count as f32 / bare - Rgb::ONE).abs().max_element() < 0.02, "{sum}");
}

#[test]
fn slanting_films_look_thinner() {
    for angle in [20.0, 45.0, 70.0_f64] {
        let cos = angle.to_radians().cos();
        for thickness in [0.3, 0.8, 2.1] {
            let slanting = film(0.5, thickness, angle) / film(0.0, 0.0, angle);
            let straight = film(0.5, (f64::from(thickness) * cos) as f32, 0.0) / film(0.0, 0.0, 0.0);
            assert!(
                (slanting - straight).abs().max_element() < 1e-3,
                "{angle} {thickness}: {slanting} {straight}"
            );
        }
    }
}

const IOR: f64 = 1.5;
const DISPERSION: f64 = 1.3;
const SAMPLES: u32 = 7;
const TILT: f64 = 50.0;
/// How deep in the glass the wall stands.
const DEPTH: f64 = 10.0;

/// Wavelengths in nanometres in the middle of equal parts of the spectrum from 380 to 730.
fn wavelength(i: u32) -> f64 {
    380.0 + 350.0 * (f64::from(i) + 0.5) / f64::from(SAMPLES)
}

/// Where a ray along z meets the wall behind a slanting face of glass, by Snell's law. The index at the blue end of the
/// spectrum is DISPERSION times that at the red end, and what the scene says in between, at 555 nm.
fn place(wavelength: f64) -> f64 {
    let index = IOR * DISPERSION.powf((555.0 - wavelength) / 350.0);
    let entered = TILT.to_radians();
    let refracted = (entered.sin() / index).asin();
    DEPTH * (refracted - entered).tan()
}

/// Half a space of glass behind a slanting face, with shining things in it, seen by one ray along z.
fn through_glass(things: Vec<Object>) -> Rgb {
    let (sin, cos) = TILT.to_radians().sin_cos();
    let clear = texture(rgbft([1.0, 1.0, 1.0, 0.0, 1.0]), glowing(0.0));
    let interior = Interior {
        ior: IOR as f32,
        dispersion: DISPERSION as f32,
        dispersion_samples: SAMPLES,
        ..Interior::default()
    };
    let mut objects = vec![inside(plane(v(sin, 0.0, -cos), 0.0, clear), interior)];
    objects.extend(things);
    let camera = view(CameraKind::Orthographic, v(0.0, 0.0, -5.0), 1e-6, 1e-6);
    pixel(&render(&scene(camera, objects), &options(1, 1)), 0, 0)
}

fn strip(x: f64, half_width: f64) -> Object {
    let middle = Vec3::new(x, 0.0, DEPTH);
    let half = Vec3::new(half_width, 5.0, 0.0);
    block(middle - half, middle + half + 1e-3 * Vec3::Z, texture(Color::WHITE, glowing(1.0)))
}

#[test]
fn each_wavelength_goes_where_snells_law_sends_it() {
    let places: Vec<f64> = (0..SAMPLES).map(|i| place(wavelength(i))).collect();
    let mut sum = Rgb::ZERO;
    for (i, &x) in places.iter().enumerate() {
        let hue = through_glass(vec![strip(x, 0.004)]);
        assert!(hue.max_element() > 0.1, "no light of {} nm at {x}", wavelength(i as u32));
        sum += hue;
        // Between two of them there is nothing.
        if let Some(next) = places.get(i + 1) {
            assert_eq!(through_glass(vec![strip((x + next) / 2.0, 0.004)]), Rgb::ZERO, "beside {x}");
        }
    }
    let all = through_glass(vec![strip(0.0, 50.0)]);
    assert!((sum - all).abs().max_element() < 1e-5, "{sum} in parts, {all} in all");
    assert!((all - Rgb::ONE).abs().max_element() < 0.02, "{all} is not white");
}

#[test]
fn blue_bends_most_and_the_hues_are_those_of_the_spectrum() {
    let hue = |i: u32| through_glass(vec![strip(place(wavelength(i)), 0.004)]);
    let (blue, green, red) = (hue(1), hue(3), hue(5));
    // The face leans to the right, so that light bends to the left: what bends more lies further out.
    assert!(place(wavelength(1)).abs() > place(wavelength(3)).abs());
    assert!(place(wavelength(3)).abs() > place(wavelength(5)).abs());
    assert!(blue.z > blue.x && blue.z > blue.y, "{blue}");
    assert!(green.y > green.x && green.y > green.z, "{green}");
    assert!(red.x > red.y && red.x > red.z, "{red}");
}
