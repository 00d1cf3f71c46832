//! Objects: small texts and the waist's data that they become.
mod common;

use std::sync::Arc;

use common::{debug, run};
use raggio_math::Vec3;
use raggio_scene::{
    AreaLight, Csg, Light, LightKind, Object, ObjectKind, Placed, Rgb, Scene, Shape, SplineKind, Texture,
    TextureKind,
};

#[track_caller]
fn scene(text: &str) -> Scene {
    let run = run(text);
    match run.scene {
        Some(parsed) => parsed.scene,
        None => panic!("{text}\n{:#?}", run.diagnostics),
    }
}

#[track_caller]
fn object(text: &str) -> Arc<Object> {
    scene(text).objects.last().expect("an object").clone()
}

#[track_caller]
fn shape(text: &str) -> Arc<Shape> {
    match &object(text).kind {
        ObjectKind::Shape(shape) => shape.clone(),
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn light(text: &str) -> Arc<Light> {
    match &object(text).kind {
        ObjectKind::Light(light) => light.clone(),
        other => panic!("{other:?}"),
    }
}

fn layers(texture: &Option<Placed<Texture>>) -> usize {
    match texture.as_ref().map(|t| &t.item.kind) {
        Some(TextureKind::Layers(layers)) => layers.len(),
        _ => 0,
    }
}

#[test]
fn simple_shapes_keep_their_numbers() {
    assert!(
        matches!(*shape("sphere { <1,2,3> 4 }"), Shape::Sphere { center, radius: 4.0 } if center == Vec3::new(1., 2., 3.))
    );
    assert!(matches!(*shape("box { 1, <-1,2,0> }"), Shape::Box { min, max }
        if min == Vec3::new(-1., 1., 0.) && max == Vec3::new(1., 2., 1.)));
    assert!(matches!(*shape("plane { 2*y, 3 }"), Shape::Plane { normal: Vec3::Y, distance: 3.0 }));
    assert!(matches!(*shape("cylinder { 0, y, -2 open }"), Shape::Cylinder { radius: 2.0, open: true, .. }));
    assert!(matches!(*shape("cone { 0, 1, y, 1 }"), Shape::Cylinder { .. }));
    assert!(matches!(*shape("disc { 0, 2*z, 3 }"), Shape::Disc { normal: Vec3::Z, hole: 0.0, .. }));
    assert!(matches!(*shape("ovus { 1, 3 }"), Shape::Sphere { center: Vec3::Y, radius: 3.0 }));
    assert!(matches!(*shape("object { sphere { 0, 1 } }"), Shape::Sphere { .. }));
}

#[test]
fn degenerate_shapes_are_refused_or_never_hit() {
    assert_eq!(run("cylinder { 0, 0, 1 }").error(), "degenerate-cylinder");
    assert_eq!(run("plane { 0, 1 }").error(), "degenerate-plane");
    assert!(run("sphere { 0, 1/0 }").warned("not-finite"));
    assert_eq!(run("julia_fractal { 0 quaternion sin }").error(), "bad-julia");
    assert_eq!(run("lathe { 3, <1,0>, <-1,1>, <1,2> }").error(), "bad-lathe");
    assert_eq!(run("sor { 4, <1,0>, <1,2>, <1,1>, <1,3> }").error(), "bad-sor");
    assert_eq!(run("blob { threshold 1 }").error(), "empty-blob");
    assert_eq!(run("mesh { pigment { rgb 1 } }").error(), "empty-mesh");
    assert!(run("triangle { 0, x, 2*x }").warned("degenerate-triangle"));
    let nothing = object("triangle { 0, x, 2*x }");
    assert!(matches!(&nothing.kind, ObjectKind::Csg { children, .. } if children.is_empty()));
}

#[test]
fn polynomials_name_their_terms_or_list_them() {
    let listed = shape("poly { 2, <1,2,3,4,5,6,7,8,9,10> }");
    let Shape::Poly { degree: 2, coefficients } = &*listed else { panic!("{listed:?}") };
    assert_eq!(**coefficients, [1., 2., 3., 4., 5., 6., 7., 8., 9., 10.]);
    let named =
        shape("polynomial { 2, xyz(2,0,0): 1, xyz(1,1,0): 2, xyz(0,2,0): 5, xyz(0,0,1): 9, xyz(0,0,0): 10 }");
    let Shape::Poly { coefficients, .. } = &*named else { panic!("{named:?}") };
    assert_eq!(**coefficients, [1., 2., 0., 0., 5., 0., 0., 0., 9., 10.]);
}

#[test]
fn curves_check_their_points() {
    let lathe = shape("lathe { quadratic_spline 4, <1,0>, <1,1>, <2,2>, <1,3> }");
    assert!(matches!(&*lathe, Shape::Lathe { kind: SplineKind::Quadratic, curves } if curves.len() == 2));
    assert!(run("prism { 0, 1, 3, <0,0>, <1,0>, <0,1> }").warned("open-prism"));
    let open = "prism { cubic_spline 0, 1, 6, <0,0>, <1,0>, <0,1>, <2,2>, <3,1>, <0,4> }";
    assert!(matches!(&object(open).kind, ObjectKind::Csg { children, .. } if children.is_empty()));
    let sweep = shape("sphere_sweep { linear_spline, 2, 0, 1, x, 2 tolerance 0.1 }");
    assert!(matches!(&*sweep, Shape::SphereSweep { tolerance: 0.1, spheres, .. } if spheres.len() == 2));
}

#[test]
fn meshes_share_corners_and_drop_what_has_no_area() {
    let mesh =
        shape("mesh { triangle { 0, x, y } triangle { x, y, x+y } triangle { 0, x, x } inside_vector 2*z }");
    let Shape::Mesh(mesh) = &*mesh else { panic!("{mesh:?}") };
    assert_eq!((mesh.vertices.len(), mesh.faces.len(), mesh.inside_vector), (4, 2, Some(Vec3::Z)));
    let text = "mesh2 { vertex_vectors { 4, 0, x, y, x+y } uv_vectors { 1, <0,1> } face_indices { 2, <0,1,2>, <1,2,3> } }";
    let mesh2 = shape(text);
    let Shape::Mesh(mesh2) = &*mesh2 else { panic!("{mesh2:?}") };
    assert_eq!((mesh2.faces.len(), mesh2.faces.face(1).uvs), (2, Some([0; 3])));
    assert_eq!(run(&text.replace("<1,2,3>", "<1,2,4>")).error(), "bad-index");
}

#[test]
fn height_fields_come_from_functions_too() {
    let field = shape("height_field { function 3, 2 { x*0.5 + y*0.25 } smooth water_level 0.1 }");
    let Shape::HeightField(field) = &*field else { panic!("{field:?}") };
    assert_eq!((field.width, field.depth, field.smooth, field.water_level), (3, 2, true, 0.1));
    // Row 0 of the picture, where y is 0, lies at z = 1.
    assert_eq!(field.heights, [16_383, 32_767, 49_151, 0, 16_383, 32_767]);
}

#[test]
fn textures_move_with_what_they_are_on_from_when_they_are_there() {
    let o = object("sphere { 0, 1 translate x texture { pigment { checker } } scale 2 }");
    let texture = o.texture.as_ref().expect("a texture");
    assert_eq!(texture.parent_from_item().transform_point3(Vec3::X), Vec3::X * 2.0);
    assert_eq!(o.parent_from_object.transform_point3(Vec3::ZERO), Vec3::X * 2.0);
    let o = object("sphere { 0, 1 uv_mapping pigment { checker } scale 2 }");
    assert_eq!(o.texture.as_ref().expect("a texture").parent_from_item(), raggio_math::Affine::IDENTITY);
    assert_eq!(run("sphere { 0, 1 pigment { checker } uv_mapping }").error(), "late-uv-mapping");
}

#[test]
fn textures_of_an_object_are_layers() {
    let text = "#declare S = sphere { 0, 1 texture { pigment { rgb 1 } } } object { S texture { pigment { rgbt 1 } } }";
    assert_eq!(layers(&object(text).texture), 2);
    assert_eq!(layers(&object("sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }").texture), 1);
    let two = "#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } } sphere { 0, 1 texture { T } }";
    assert_eq!(layers(&object(two).texture), 2);
    let patterned = "sphere { 0, 1 texture { checker texture {} } texture {} }";
    assert_eq!(run(patterned).error(), "layered-pattern");
}

#[test]
fn bare_objects_get_the_default_texture_when_they_are_linked() {
    let text = "#declare S = sphere { 0, 1 } #default { pigment { rgb 0.5 } } object { S }";
    let o = object(text);
    let Some(TextureKind::Layers(layers)) = o.texture.as_ref().map(|t| &t.item.kind) else { panic!("{o:?}") };
    assert!(
        matches!(layers[0].pigment.kind, raggio_scene::PigmentKind::Solid { color, .. } if color.rgb.x == 0.5)
    );
    let cut = object("difference { sphere { 0, 1 pigment { rgb 1 } } sphere { x, 1 } cutaway_textures }");
    assert!(cut.texture.is_none());
    // Where no member has a texture there is nothing to cut away to.
    let bare = object("difference { sphere { 0, 1 } sphere { x, 1 } cutaway_textures }");
    assert!(bare.texture.is_some());
    assert!(matches!(cut.kind, ObjectKind::Csg { op: Csg::Difference { cutaway_textures: true }, .. }));
}

#[test]
fn flags_are_kept_where_they_were_written() {
    let o = object(
        "union { sphere { 0, 1 } box { 0, 1 } hollow no_shadow double_illuminate inverse no_image on }",
    );
    assert_eq!(
        (o.hollow, o.no_shadow, o.double_illuminate, o.inverse, o.no_image),
        (Some(true), true, true, true, true)
    );
    let ObjectKind::Csg { children, .. } = &o.kind else { panic!("{o:?}") };
    assert!(children.iter().all(|child| child.double_illuminate && child.hollow.is_none()));
    assert_eq!(run("box { 0, 1 sturm }").error(), "wrong-flag");
    assert!(run("union { sphere { 0, 1 } }").warned("lonely-csg"));
    assert!(run("#declare S = sphere { 0, 1 } S").warned("bare-object"));
    let photons = object("sphere { 0, 1 photons { target 2 refraction on pass_through } }").photons;
    assert_eq!((photons.target, photons.refraction, photons.pass_through), (Some(2.0), Some(false), true));
}

#[test]
fn clips_take_solids_without_textures() {
    let o = object("sphere { 0, 1 clipped_by { plane { y, 0 } } bounded_by { clipped_by } translate x }");
    assert_eq!((o.clips.len(), o.bounds.len()), (1, 0));
    assert_eq!(o.clips[0].parent_from_object.translation, Vec3::X);
    assert_eq!(run("sphere { 0, 1 clipped_by { triangle { 0, x, y } } }").error(), "illegal-clip");
    assert_eq!(
        run("sphere { 0, 1 clipped_by { sphere { 0, 1 pigment { rgb 1 } } } }").error(),
        "illegal-clip"
    );
}

#[test]
fn objects_without_a_place_are_left_out() {
    for lost in [
        "sphere { 0, 0*(1/0) }",
        "sphere { 0, 1 translate x/0 }",
        "object { sphere { 0, 1 } rotate 0*(1/0) sturm }",
    ] {
        assert!(run(lost).warned("not-finite"), "{lost}");
        assert!(
            matches!(&object(lost).kind, ObjectKind::Csg { children, .. } if children.is_empty()),
            "{lost}"
        );
    }
    let rest = object("union { sphere { 0, 1 } sphere { 0*(1/0), 1 } translate x }");
    assert!(matches!(&rest.kind, ObjectKind::Csg { children, .. } if children.len() == 2));
    assert_eq!(rest.parent_from_object.translation, Vec3::X);
    assert_eq!(run("light_source { 0*(1/0), 1 }").error(), "not-finite");
    assert_eq!(run("sphere { 0, 1 pigment { rgb 1 translate x/0 } }").error(), "not-finite");
}

#[test]
fn lights_have_the_defaults_of_their_kind() {
    let spot = light("light_source { y, rgb 2 spotlight radius 10 point_at x translate z }");
    assert_eq!(spot.kind, LightKind::Spot { radius: 10.0, falloff: 45.0, tightness: 0.0 });
    assert_eq!((spot.location, spot.point_at), (Vec3::new(0., 1., 1.), Vec3::new(1., 0., 1.)));
    let cylinder = light("light_source { y, 1 cylinder }");
    assert!(cylinder.parallel);
    assert_eq!(cylinder.kind, LightKind::Cylinder { radius: 0.75, falloff: 1.0, tightness: 0.0 });
    let area =
        light("light_source { y, 1 area_light x, z, 3, 4 adaptive 1 jitter orient photons { area_light } }")
            .area;
    let expected = AreaLight {
        axis1: Vec3::X,
        axis2: Vec3::Z,
        size1: 3,
        size2: 4,
        adaptive: Some(1),
        jitter: true,
        circular: true,
        orient: true,
        area_illumination: false,
        photons_area: true,
    };
    assert_eq!(area, Some(expected));
    assert_eq!(run("light_source { y, 1 radius 3 spotlight }").error(), "misplaced-word");
    assert!(run("light_source { y translate x }").warned("missing-color"));
    assert_eq!(light("light_source { y parallel }").color, Rgb::ZERO);
    let looks = light("light_source { y, 1 looks_like { sphere { 0, 1 } } translate x }").looks_like.clone();
    let looks = looks.expect("an object");
    assert!(looks.no_shadow);
    assert_eq!(looks.parent_from_object.translation, Vec3::new(1., 1., 0.));
}

#[test]
fn functions_follow_their_own_grammar() {
    let value =
        |text: &str| debug(&format!("#declare F = function(a, b) {{ {text} }} #debug str(F(2, 5), 0, 4)"));
    assert_eq!(value("a + b * 2 - -a"), "14.0000");
    assert_eq!(value("a / b / 2"), "0.2000");
    assert_eq!(value("1 | 0 & 0"), "1.0000");
    assert_eq!(value("a < b = 1"), "1.0000");
    assert_eq!(value("sum(k, 1, 3, k*a) + prod(k, 1, 3, k)"), "18.0000");
    assert_eq!(value("max(a, b, 3) + select(-1, 10, 20) + pi*0"), "15.0000");
    assert_eq!(value("x + y + z"), "0.0000");
    let by_default =
        "#declare K = 3; #declare F = function { u + 10*v + 100*z*K } #debug str(F(1,2,3), 0, 0)";
    assert_eq!(debug(by_default), "921");
    let shadowed = "#declare R = 3; #declare F = function(R) { R*2 } #debug str(F(5), 0, 0)";
    assert_eq!(debug(shadowed), "10");
    let moved =
        "#declare F = function { transform { translate <1,2,3> } } #debug vstr(3, F(1,1,1), \",\", 0, 0)";
    assert_eq!(debug(moved), "2,3,4");
    let nested = "#declare T = function { transform { scale 2 } } #declare F = function { T(x,y,z).y + 1 } #debug str(F(1,4,1), 0, 0)";
    assert_eq!(debug(nested), "9");
    assert_eq!(debug("#declare F = function { internal(61) } #debug str(F(3,4,0,1), 0, 0)"), "4");
    assert_eq!(run("#declare F = function { x/0 }").error(), "division-by-zero");
    assert_eq!(run("#declare F = function { nothing*2 }").error(), "unknown-identifier");
}

#[test]
fn an_isosurface_is_mended_where_its_numbers_make_no_sense() {
    let iso =
        shape("isosurface { function { x } contained_by { sphere { 0, 2 } } accuracy 0 max_trace 99 open }");
    let Shape::Isosurface(iso) = &*iso else { panic!("{iso:?}") };
    assert_eq!((iso.accuracy, iso.max_trace, iso.open, iso.max_gradient), (0.001, 10, true, 1.1));
    assert!(run("isosurface { function { x } max_gradient 0 }").warned("bad-isosurface"));
}

#[test]
fn a_spline_surface_keeps_its_numbers() {
    let text = "nurbs_patch { u_degree 1 v_degree 2 v_knots { 0,0,0, 2,2,2 } points { 2, 3, 0, x, 2*x, y, x+y, 2*x+y }
        weights { 1 1 1, 1 0.5 1 } trim { points { 3, 0, u, v } } translate 5*x }";
    let shape = shape(text);
    let Shape::Nurbs(nurbs) = &*shape else { panic!("{shape:?}") };
    assert_eq!((nurbs.u.degree, &nurbs.u.knots[..]), (1, &[0., 0., 1., 1.][..]));
    assert_eq!((nurbs.v.degree, nurbs.v.domain()), (2, (0., 2.)));
    assert_eq!(nurbs.points[4], (Vec3::new(1., 1., 0.), 0.5));
    assert_eq!((nurbs.trims.len(), nurbs.trims[0].points.len(), nurbs.trims[0].knots.degree), (1, 3, 1));
    // Four by four without a word more is a bicubic patch, and its name can be declared.
    let net = "points { 4, 4, 0,x,y,z, 0,x,y,z, 0,x,y,z, 0,x,y,z }";
    object(&format!("#declare P = nurbs_patch {{ {net} }} object {{ P rotate y }}"));
    assert_eq!(
        debug("#declare nurbs_patch = 3; #declare trim = 4; #debug str(nurbs_patch + trim, 0, 0)"),
        "7"
    );
    object(&format!("#declare points = 3; nurbs_patch {{ {net} }}"));
}

#[test]
fn splines_that_do_not_fit_together_are_refused() {
    let net = "points { 2, 2, 0, x, y, z } u_degree 1 v_degree 1";
    for bad in [
        "points { 2, 2, 0, x, y, z }",
        "points { 2, 2, 0, x, y }",
        "points { 2, 2, 0, x, y, z, 0 }",
        &format!("{net} u_degree 0"),
        &format!("{net} u_degree 10"),
        &format!("{net} u_knots {{ 0, 0, 1 }}"),
        &format!("{net} u_knots {{ 0, 1, 0.5, 2 }}"),
        &format!("{net} u_knots {{ 0, 1, 1, 2 }}"),
        &format!("{net} weights {{ 1, 1, 1 }}"),
        &format!("{net} weights {{ 1, 1, 0, 1 }}"),
        &format!("{net} trim {{ degree 2 points {{ 2, 0, u }} }}"),
    ] {
        assert_eq!(run(&format!("nurbs_patch {{ {bad} }}")).error(), "bad-nurbs", "{bad}");
    }
    assert_eq!(run("nurbs_patch { u_degree 2 }").error(), "expected");
}
