//! Pigments, normals, finishes, interiors and the order of warps.
mod common;

use std::sync::Arc;

use common::run;
use raggio_math::Vec3;
use raggio_scene::{
    Color, Finish, Layer, NormalKind, NormalPattern, Object, PatternKind, Pigment, PigmentKind, Rgb,
    TextureKind, Warp, Wave,
};

#[track_caller]
fn object(text: &str) -> Arc<Object> {
    let run = run(text);
    match run.scene {
        Some(parsed) => parsed.scene.objects.last().expect("an object").clone(),
        None => panic!("{text}\n{:#?}", run.diagnostics),
    }
}

/// The only layer of the texture of a sphere with these modifiers.
#[track_caller]
fn layer(before: &str, modifiers: &str) -> Layer {
    let o = object(&format!("{before} sphere {{ 0, 1 {modifiers} }}"));
    match o.texture.as_ref().map(|t| &t.item.kind) {
        Some(TextureKind::Layers(layers)) => layers[0].clone(),
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn pigment(text: &str) -> Arc<Pigment> {
    layer("", &format!("pigment {{ {text} }}")).pigment
}

#[track_caller]
fn finish(text: &str) -> Finish {
    layer("", &format!("finish {{ {text} }}")).finish
}

#[test]
fn a_pigment_named_alone_is_the_very_one() {
    let entries = |last: &str| {
        let p = pigment(&format!(
            "pigment_pattern {{ bozo }} #local W = pigment {{ wrinkles }} pigment_map {{ [0 W] [1 {last}] }}"
        ));
        let PigmentKind::PigmentMap { map, .. } = &p.kind else { panic!("{p:?}") };
        Arc::ptr_eq(&map[0].1, &map[1].1)
    };
    assert!(entries("W"));
    assert!(!entries("W scale 2"));
    assert!(!entries("W uv_mapping"));
}

#[test]
fn the_object_of_an_object_pattern_may_be_moved() {
    let p = pigment("object { sphere { x, 1 } scale 2 translate -x rgb 0, rgb 1 }");
    let (PigmentKind::ColorMap { pattern, .. } | PigmentKind::PigmentMap { pattern, .. }) = &p.kind else {
        panic!("{p:?}")
    };
    let PatternKind::Object(object) = &pattern.kind else { panic!("{pattern:?}") };
    assert_eq!(object.parent_from_object.transform_point3(Vec3::X), Vec3::X);
    assert_eq!(object.parent_from_object.transform_point3(Vec3::ZERO), -Vec3::X);
}

#[test]
fn the_last_transform_acts_first_and_turbulence_last() {
    let p =
        pigment("bozo turbulence 0.5 scale 2 translate x warp { repeat 3*x flip y } rotate 90*y omega 0.7");
    let PigmentKind::ColorMap { pattern, .. } = &p.kind else { panic!("{p:?}") };
    let [
        Warp::Transform { forward: first, .. },
        Warp::Repeat { axis: 0, .. },
        Warp::Transform { forward, .. },
        Warp::ClassicTurbulence(t),
    ] = &pattern.warps[..]
    else {
        panic!("{:?}", pattern.warps)
    };
    assert!((first.transform_point3(Vec3::Z) - Vec3::X).length() < 1e-12);
    assert_eq!(forward.transform_point3(Vec3::ONE), Vec3::new(3.0, 2.0, 2.0));
    assert_eq!((t.amount, t.omega, t.octaves), (Vec3::splat(0.5), 0.7, 6));
}

#[test]
fn patterns_have_waves_and_frequencies_by_custom() {
    let of = |text: &str| match &pigment(text).kind {
        PigmentKind::ColorMap { pattern, .. } => pattern.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!((of("marble").wave, of("gradient x").wave), (Wave::Triangle, Wave::Ramp));
    assert_eq!((of("checker").frequency, of("granite").frequency), (0.0, 1.0));
    assert_eq!(of("granite poly_wave 2 frequency 3 phase 0.5").wave, Wave::Poly(2.0));
    assert!(matches!(of("agate agate_turb 2").kind, PatternKind::Agate { turbulence: 2.0 }));
    assert!(
        matches!(of("brick mortar 1 brick_size 2").kind, PatternKind::Brick { mortar: 1.0, size } if size == Vec3::splat(2.0))
    );
    assert_eq!(run("sphere { 0, 1 pigment { granite agate_turb 2 } }").error(), "unexpected");
    assert_eq!(run("sphere { 0, 1 pigment { pavement number_of_tiles 7 } }").error(), "bad-pavement");
}

#[test]
fn maps_fall_back_to_the_customary_colours() {
    let map = |text: &str| match &pigment(text).kind {
        PigmentKind::ColorMap { map, .. } => map.as_ref().clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(map("granite"), [(0.0, Color::BLACK), (1.0, Color::WHITE)]);
    assert_eq!(map("bozo").len(), 6);
    assert_eq!(map("spotted").len(), 2);
    let red = Color::opaque(1.0, 0.0, 0.0);
    assert_eq!(map("checker rgb x"), [(0.0, red), (1.0, Color::opaque(0.0, 1.0, 0.0))]);
    let old = map("granite color_map { [0 0.5 color red 1 color rgb 1] [0.5, 1 color rgb 1 color red 1] }");
    assert_eq!(old, [(0.0, red), (0.5, Color::WHITE), (1.0, red)]);
}

#[test]
fn identifiers_can_be_copied_and_changed() {
    let before = "#declare P = pigment { gradient y color_map { [0 rgb 0] [1 rgb 2] } scale 4 }";
    let l = layer(before, "pigment { P wood translate x }");
    let PigmentKind::ColorMap { pattern, map } = &l.pigment.kind else { panic!("{l:?}") };
    assert!(matches!(pattern.kind, PatternKind::Wood));
    assert_eq!((map[1].1.rgb, pattern.warps.len()), (Rgb::splat(2.0), 1));
    let uv = layer("#declare P = pigment { uv_mapping checker scale 2 }", "pigment { P scale 3 }").pigment;
    let PigmentKind::Uv(inner) = &uv.kind else { panic!("{uv:?}") };
    let PigmentKind::ColorMap { pattern, .. } = &inner.kind else { panic!("{inner:?}") };
    assert!(
        matches!(&pattern.warps[..], [Warp::Transform { forward, .. }] if forward.matrix3.x_axis.x == 2.0)
    );
}

#[test]
fn averages_weigh_and_maps_nest() {
    let p = pigment("average pigment_map { [2 rgb 1] [checker scale 2] }");
    let PigmentKind::PigmentMap { pattern, map } = &p.kind else { panic!("{p:?}") };
    assert!(matches!(pattern.kind, PatternKind::Average));
    assert_eq!((map[0].0, map[1].0), (2.0, 1.0));
    assert_eq!(run("sphere { 0, 1 pigment { average } }").error(), "average-without-map");
}

#[test]
fn normals_keep_their_rules_and_amounts() {
    let normal = |text: &str| layer("", &format!("normal {{ {text} }}")).normal.expect("a normal");
    let bumps = normal("bumps 0.3 scale 2");
    assert!(matches!(&bumps.kind, NormalKind::Special { pattern: NormalPattern::Bumps, .. }));
    assert_eq!((bumps.amount, bumps.accuracy), (0.3, 0.02));
    let slope = normal("gradient x, -1 slope_map { [0 <0, 1>] [1 <1, 0>] } accuracy 0.1");
    assert!(matches!(&slope.kind, NormalKind::Slope { map: Some(map), .. } if map[0] == (0.0, 0.0, 1.0)));
    assert_eq!((slope.amount, slope.accuracy), (-1.0, 0.1));
    assert_eq!(normal("bozo").amount, 0.5);
    assert!(matches!(&normal("bozo").kind, NormalKind::Slope { .. }));
    assert!(layer("", "normal { scale 2 }").normal.is_none());
}

#[test]
fn finishes_scale_by_albedo_when_the_block_ends() {
    let f = finish("specular albedo 0.5 roughness 0.1 diffuse albedo 0.6, 0.2 brilliance 3");
    let q = 10.0f32;
    assert!((f.specular - 0.5 * (q + 2.0) / (4.0 * (2.0 - (-q / 2.0).exp2()))).abs() < 1e-6);
    assert_eq!((f.diffuse, f.diffuse_back, f.diffuse_raw), (1.2, 0.4, 0.6));
    assert_eq!(finish("metallic").metallic, 1.0);
    assert_eq!(finish("emission 0.5 ambient 0").emission, Rgb::splat(0.5));
}

#[test]
fn reflections_run_from_facing_to_grazing() {
    let r = |text: &str| finish(text).reflection;
    assert_eq!((r("reflection 0.3").min, r("reflection 0.3").max), (Rgb::splat(0.3), Rgb::splat(0.3)));
    let two = r("reflection { 0.1, 0.9 falloff 2 metallic }");
    assert_eq!((two.min, two.max, two.falloff, two.metallic), (Rgb::splat(0.1), Rgb::splat(0.9), 2.0, 1.0));
    let fresnel = r("reflection { 0.5 fresnel on }");
    assert_eq!((fresnel.min, fresnel.max, fresnel.fresnel), (Rgb::ZERO, Rgb::splat(0.5), true));
}

#[test]
fn old_words_of_finishes_reach_the_interior() {
    let o = object("sphere { 0, 1 finish { ior 1.5 refraction 0.5 } }");
    let interior = &o.interior.as_ref().expect("an interior").item;
    assert_eq!((interior.ior, interior.old_refraction), (1.5, 0.5));
    assert!(run("sphere { 0, 1 phong 0.5 pigment { rgb 1 } }").warned("loose-finish"));
    let old = "#version 2.0 sphere { 0, 1 texture { pigment { color red 1 } 0.25 } }";
    assert!(run(old).warned("loose-crand"));
    assert_eq!(run(&old.replace("2.0", "3.0;")).error(), "unexpected");
}

#[test]
fn media_take_the_defaults_of_the_version() {
    let media = |head: &str| {
        let o = object(&format!(
            "{head} sphere {{ 0, 1 interior {{ media {{ scattering {{ 9, rgb 1 }} density {{ spherical }} }} }} }}"
        ));
        o.interior.as_ref().expect("an interior").item.media[0].item.clone()
    };
    let m = media("");
    assert_eq!((m.method, m.intervals, m.samples, m.densities.len()), (3, 1, (10, 10), 1));
    assert_eq!(m.scattering.map(|s| (s.kind, s.extinction)), Some((1, 1.0)));
    let old = media("#version 3.1;");
    assert_eq!((old.method, old.intervals, old.samples), (1, 10, (1, 1)));
}

#[test]
fn materials_lie_over_what_is_there() {
    let text = "#declare M = material { texture { pigment { rgbt 1 } } interior { ior 2 } }
        sphere { 0, 1 pigment { rgb 1 } interior { ior 3 } material { M } }";
    let o = object(text);
    assert_eq!(o.interior.as_ref().expect("an interior").item.ior, 2.0);
    assert!(
        matches!(&o.texture.as_ref().expect("a texture").item.kind, TextureKind::Layers(l) if l.len() == 2)
    );
}

#[test]
fn a_macro_behind_a_declared_texture_sees_it() {
    let text =
        "#macro M(A) sphere { 0, 1 texture { A } } #end #declare T = texture { pigment { rgb 1 } } M(T)";
    assert!(
        matches!(&object(text).texture.as_ref().expect("a texture").item.kind, TextureKind::Layers(l) if l.len() == 1)
    );
}

/// Filter and transmit of the layers of a sphere with these textures.
#[track_caller]
fn passes(text: &str) -> Vec<(f32, f32)> {
    let o = object(text);
    let Some(TextureKind::Layers(layers)) = o.texture.as_ref().map(|t| &t.item.kind) else { panic!("{o:?}") };
    let color = |layer: &Layer| match layer.pigment.kind {
        PigmentKind::Solid { color: c, .. } => (c.filter, c.transmit),
        ref other => panic!("{other:?}"),
    };
    layers.iter().map(color).collect()
}

#[test]
fn upper_layers_do_not_tint_up_to_version_3_1() {
    let one = "texture { pigment { rgbft <1, 0, 0, 0.5, 0.25> } }";
    let layers = |version: &str| passes(&format!("#version {version}; sphere {{ 0, 1 {one} {one} }}"));
    assert_eq!(layers("3.1"), [(0.5, 0.25), (0.0, 0.75)]);
    assert_eq!(layers("3.2"), [(0.5, 0.25), (0.5, 0.25)]);
    let used = |version: &str| {
        passes(&format!(
            "#version 3.7; #declare T = {one} {one} #version {version}; sphere {{ 0, 1 texture {{ T }} }}"
        ))
    };
    assert_eq!(used("3.1"), layers("3.1"));
    assert_eq!(used("3.7"), layers("3.7"));
}

#[test]
fn frequency_in_an_old_texture_is_that_of_the_normal() {
    let frequencies = |words: &str| {
        let layer = layer("#version 1.0;", &format!("texture {{ {words} }}"));
        let PigmentKind::ColorMap { pattern, .. } = &layer.pigment.kind else { panic!("{layer:?}") };
        let normal = layer.normal.map(|n| match &n.kind {
            NormalKind::Special { settings, .. } => settings.frequency,
            other => panic!("{other:?}"),
        });
        (pattern.frequency, normal)
    };
    assert_eq!(frequencies("wood ripples 0.7 frequency 3"), (1.0, Some(3.0)));
    assert_eq!(frequencies("frequency 3 waves 0.7 wood"), (1.0, Some(3.0)));
    assert_eq!(frequencies("wood frequency 3"), (1.0, None));
}

#[test]
fn a_light_source_takes_the_name_of_any_object() {
    let lamp = "#declare L = union { light_source { 0, rgb 1 } sphere { 0, 1 } }";
    let o = object(&format!("{lamp} light_source {{ L translate x }}"));
    assert!(matches!(o.kind, raggio_scene::ObjectKind::Csg { .. }));
    assert_eq!(o.parent_from_object.translation, Vec3::X);
    assert_eq!(run(&format!("{lamp} light_source {{ L shadowless }}")).error(), "unexpected");
}
