//! What objects inherit, and which rays see them (shapes spec, section 8; light spec, sections 3.1 and 3.3).
use std::sync::Arc;

use raggio_geometry::{Geometry, Interaction, InteriorId, RayClass};
use raggio_math::transform::{rotate, scale, translate};
use raggio_math::{Ray, Vec3};
use raggio_scene::{
    Color, Csg, FaceTexture, Finish, Interior, Irid, Layer, Light, Mesh, MeshFace, Object, ObjectKind,
    Pigment, Placed, Rgb, Shape, Texture, TextureKind,
};

fn ball(x: f64) -> Object {
    let shape = Shape::Sphere { center: Vec3::new(x, 0.0, 0.0), radius: 1.0 };
    Object::new(ObjectKind::Shape(Arc::new(shape)))
}

fn group(op: Csg, children: Vec<Object>) -> Object {
    Object::new(ObjectKind::Csg { op, children: Arc::new(children.into_iter().map(Arc::new).collect()) })
}

/// A texture that is not the same everywhere, as thin films are uneven.
fn texture() -> Arc<Texture> {
    let irid = Irid { amount: 0.5, thickness: 1.0, turbulence: 1.0 };
    one_layer(Finish { irid: Some(irid), ..Finish::default() })
}

fn one_layer(finish: Finish) -> Arc<Texture> {
    let pigment = Arc::new(Pigment::solid(Color::default()));
    Arc::new(Texture { kind: TextureKind::Layers(vec![Layer { pigment, normal: None, finish }]) })
}

fn with_texture(mut object: Object, texture: &Arc<Texture>) -> Object {
    object.texture = Some(Placed::new(texture.clone()));
    object
}

fn with(mut object: Object, change: impl FnOnce(&mut Object)) -> Object {
    change(&mut object);
    object
}

fn compile(object: Object) -> Geometry {
    Geometry::of_object(&Arc::new(object)).expect("these shapes are supported")
}

fn along_z(x: f64) -> Ray {
    Ray::new(Vec3::new(x, 0.1, -5.0), Vec3::Z)
}

/// Everything on the ray, hit after hit.
fn surfaces(geometry: &Geometry, ray: &Ray) -> Vec<Interaction> {
    let mut found = Vec::new();
    let mut from = 0.0;
    while let Some(hit) = geometry.closest(ray, (from, 100.0), RayClass::Any) {
        found.push(geometry.interaction(ray, &hit));
        from = hit.t;
    }
    found
}

fn textures_at(geometry: &Geometry, x: f64) -> Vec<Vec<(usize, f32)>> {
    let id = |t: &raggio_geometry::TextureUse| {
        (Arc::as_ptr(&geometry.textures[t.texture.0 as usize].texture) as usize, t.weight)
    };
    surfaces(geometry, &along_z(x)).iter().map(|s| s.textures.as_slice().iter().map(id).collect()).collect()
}

fn sees(geometry: &Geometry, x: f64, class: RayClass) -> bool {
    geometry.closest(&along_z(x), (0.0, 100.0), class).is_some()
}

fn address(texture: &Arc<Texture>) -> usize {
    Arc::as_ptr(texture) as usize
}

#[test]
fn a_texture_goes_to_members_that_have_none() {
    let (own, parents) = (texture(), texture());
    let tree = with_texture(group(Csg::Union, vec![ball(0.0), with_texture(ball(3.0), &own)]), &parents);
    let geometry = compile(tree);
    assert_eq!(textures_at(&geometry, 0.0)[0], [(address(&parents), 1.0)]);
    assert_eq!(textures_at(&geometry, 3.0)[0], [(address(&own), 1.0)]);
}

#[test]
fn equal_textures_at_equal_places_are_one() {
    let t = texture();
    let balls = (0..5).map(|i| with_texture(ball(3.0 * f64::from(i)), &t)).collect();
    let geometry = compile(group(Csg::Union, balls));
    assert_eq!((geometry.textures.len(), geometry.materials.len()), (1, 1));
    assert!(geometry.textures[0].texture_from_world.is_none());
}

#[test]
fn textures_move_with_their_objects() {
    let mut tree = group(
        Csg::Union,
        vec![with(with_texture(ball(0.0), &texture()), |o| {
            o.transform(&scale(Vec3::splat(2.0)));
        })],
    );
    tree.transform(&translate(Vec3::X));
    let geometry = compile(tree);
    let back = geometry.textures[0].texture_from_world.as_deref().expect("it was moved");
    assert_eq!(back.transform_point3(Vec3::new(5.0, 2.0, 0.0)), Vec3::new(2.0, 1.0, 0.0));
}

#[test]
fn copies_of_one_colour_share_their_texture() {
    let plain = one_layer(Finish::default());
    let moved = |i: i32| {
        with(with_texture(ball(0.0), &plain), |o| o.transform(&translate(Vec3::X * f64::from(3 * i))))
    };
    let geometry = compile(group(Csg::Union, (0..5).map(moved).collect()));
    assert_eq!((geometry.textures.len(), geometry.materials.len()), (1, 1));
}

#[test]
fn textures_with_uv_mapping_stay() {
    let mut tree =
        group(Csg::Union, vec![with(with_texture(ball(0.0), &texture()), |o| o.uv_mapping = true)]);
    tree.transform(&translate(Vec3::X));
    let geometry = compile(tree);
    assert!(geometry.textures[0].texture_from_world.is_none());
    assert!(geometry.materials[0].uv_mapping);
}

#[test]
fn interior_textures_show_from_inside() {
    let (outer, inner) = (texture(), texture());
    let object =
        with(with_texture(ball(0.0), &outer), |o| o.interior_texture = Some(Placed::new(inner.clone())));
    let geometry = compile(object);
    let seen = textures_at(&geometry, 0.0);
    assert_eq!(seen, [[(address(&outer), 1.0)], [(address(&inner), 1.0)]]);
}

#[test]
fn parts_of_a_top_level_object_share_its_interior() {
    let glass = Placed::new(Arc::new(Interior { ior: 1.5, ..Interior::default() }));
    let own = with(ball(6.0), |o| o.interior = Some(glass.clone()));
    for interior in [None, Some(glass)] {
        let tree = group(Csg::Union, vec![ball(0.0), group(Csg::Merge, vec![ball(3.0)]), own.clone()]);
        let geometry = compile(with(tree, |o| o.interior = interior));
        let id = |x: f64| {
            let found = surfaces(&geometry, &along_z(x));
            geometry.materials[found[0].material.0 as usize].interior
        };
        assert_eq!(id(0.0), id(3.0));
        assert_ne!(id(0.0), id(6.0));
        assert_eq!(geometry.interiors_at(Vec3::ZERO).as_slice(), [id(0.0)]);
        assert_eq!(geometry.interiors_at(Vec3::X * 6.0).as_slice(), [id(6.0)]);
        assert!(geometry.interiors_at(Vec3::X * 20.0).is_empty());
    }
}

#[test]
fn what_cuts_does_not_lend_its_interior() {
    let tree = group(
        Csg::Difference { cutaway_textures: false },
        vec![ball(0.0), with(ball(1.0), |o| o.interior = Some(Placed::new(Arc::default())))],
    );
    let geometry = compile(tree);
    let first: InteriorId = geometry.materials[0].interior;
    assert_eq!(geometry.interiors_at(Vec3::X * -0.5).as_slice(), [first]);
    assert!(geometry.interiors_at(Vec3::X * 1.5).is_empty());
}

#[test]
fn the_last_member_decides_whether_a_shared_interior_is_hollow() {
    let hollow = |first: Option<bool>, last: Option<bool>, all: Option<bool>| {
        let members = vec![with(ball(0.0), |o| o.hollow = first), with(ball(3.0), |o| o.hollow = last)];
        let geometry = compile(with(group(Csg::Union, members), |o| o.hollow = all));
        geometry.interiors[0].hollow
    };
    assert!(hollow(None, None, Some(true)));
    assert!(hollow(Some(false), None, Some(true)));
    assert!(!hollow(None, Some(false), Some(true)));
    assert!(!hollow(Some(true), None, None));
}

#[test]
fn flags_hide_objects_from_their_rays() {
    let geometry = compile(group(
        Csg::Union,
        vec![
            with(ball(0.0), |o| o.no_shadow = true),
            with(ball(3.0), |o| o.no_image = true),
            with(ball(6.0), |o| o.no_reflection = true),
            with(ball(9.0), |o| o.no_radiosity = true),
        ],
    ));
    let classes =
        [RayClass::Shadow, RayClass::Camera, RayClass::Reflected, RayClass::Radiosity, RayClass::Any];
    for (i, x) in [0.0, 3.0, 6.0, 9.0].into_iter().enumerate() {
        for (j, class) in classes.into_iter().enumerate() {
            assert_eq!(sees(&geometry, x, class), i != j, "{x} {class:?}");
        }
    }
}

#[test]
fn flags_on_members_of_merges_and_intersections() {
    let hidden = |x: f64| {
        with(ball(x), |o| {
            o.no_shadow = true;
            o.no_image = true;
        })
    };
    let merge = compile(group(Csg::Merge, vec![hidden(0.0), ball(3.0)]));
    assert!(!sees(&merge, 0.0, RayClass::Camera) && sees(&merge, 0.0, RayClass::Shadow));
    let both = compile(group(Csg::Intersection, vec![hidden(0.0), hidden(0.5)]));
    assert!(sees(&both, 0.2, RayClass::Camera) && sees(&both, 0.2, RayClass::Shadow));
    let whole = with(group(Csg::Intersection, vec![ball(0.0), ball(0.5)]), |o| {
        o.no_shadow = true;
        o.no_image = true;
    });
    let whole = compile(group(Csg::Union, vec![whole]));
    assert!(!sees(&whole, 0.2, RayClass::Camera) && !sees(&whole, 0.2, RayClass::Shadow));
}

#[test]
fn a_clipped_union_casts_no_shadow_only_if_no_member_does() {
    let everything = || Arc::new(with(ball(0.0), |o| o.transform(&scale(Vec3::splat(100.0)))));
    let shadowless = |x: f64| with(ball(x), |o| o.no_shadow = true);
    let all = group(Csg::Union, vec![shadowless(0.0), shadowless(3.0)]);
    let all = compile(with(all, |o| o.clips.push(everything())));
    assert!(!sees(&all, 0.0, RayClass::Shadow) && sees(&all, 0.0, RayClass::Camera));
    let some = group(Csg::Union, vec![shadowless(0.0), ball(3.0)]);
    let some = compile(with(some, |o| o.clips.push(everything())));
    assert!(sees(&some, 0.0, RayClass::Shadow));
}

#[test]
fn cut_surfaces_show_what_they_cut() {
    let (first, second, third) = (texture(), texture(), texture());
    let nearer = || with(ball(0.0), |o| o.transform(&translate(-Vec3::Z)));
    let difference = |solid: Object| group(Csg::Difference { cutaway_textures: true }, vec![solid, nearer()]);
    let cut = compile(difference(with_texture(ball(0.0), &first)));
    assert_eq!(textures_at(&cut, 0.0), [[(address(&first), 1.0)], [(address(&first), 1.0)]]);
    // Where the cut solid has no texture there is none; where the whole has one it counts.
    assert!(textures_at(&compile(difference(ball(0.0))), 0.0)[0].is_empty());
    let textured = compile(with_texture(difference(with_texture(ball(0.0), &first)), &second));
    assert_eq!(textures_at(&textured, 0.0), [[(address(&second), 1.0)], [(address(&first), 1.0)]]);
    // The far side of the nearer ball lies in both others: their average, the bare one left out.
    let members = vec![with_texture(ball(0.0), &first), nearer(), ball(0.1), with_texture(ball(0.3), &third)];
    let seen = textures_at(&compile(group(Csg::CutawayIntersection, members)), 0.2);
    assert_eq!(seen.last().unwrap().as_slice(), [(address(&first), 0.5), (address(&third), 0.5)]);
}

#[test]
fn faces_of_meshes_bring_their_textures() {
    let (own, a, b, c) = (texture(), texture(), texture(), texture());
    let face = |vertices, texture| MeshFace { vertices, normals: None, uvs: None, texture };
    let mesh = Mesh {
        vertices: vec![[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [4., 4., 0.]],
        textures: vec![a.clone(), b.clone(), c.clone()],
        faces: [face([0, 1, 2], FaceTexture::Three([0, 1, 2])), face([1, 3, 2], FaceTexture::Object)]
            .into_iter()
            .collect(),
        ..Mesh::default()
    };
    let object = Object::new(ObjectKind::Shape(Arc::new(Shape::Mesh(Arc::new(mesh)))));
    let geometry = compile(with_texture(object, &own));
    let at = |x: f64, y: f64| {
        let ray = Ray::new(Vec3::new(x, y, -1.0), Vec3::Z);
        let hit = geometry.closest(&ray, (0.0, 10.0), RayClass::Any).unwrap();
        let uses = geometry.interaction(&ray, &hit).textures;
        let id = |t: &raggio_geometry::TextureUse| {
            (address(&geometry.textures[t.texture.0 as usize].texture), t.weight)
        };
        uses.as_slice().iter().map(id).collect::<Vec<_>>()
    };
    assert_eq!(at(1.0, 2.0), [(address(&a), 0.25), (address(&b), 0.25), (address(&c), 0.5)]);
    assert_eq!(at(3.0, 3.0), [(address(&own), 1.0)]);
}

fn light(location: Vec3, looks_like: Option<Object>) -> Object {
    let looks_like = looks_like.map(Arc::new);
    Object::new(ObjectKind::Light(Arc::new(Light { looks_like, ..Light::new(location, Rgb::ONE) })))
}

#[test]
fn lights_are_found_moved_and_grouped() {
    let grouped = Object::new(ObjectKind::LightGroup {
        children: Arc::new(vec![Arc::new(ball(0.0)), Arc::new(light(Vec3::X, None))]),
        global_lights: false,
    });
    let mut tree = group(Csg::Union, vec![light(Vec3::Y, Some(ball(3.0))), grouped, ball(6.0)]);
    tree.transform(&rotate(Vec3::Z * 90.0));
    tree.transform(&rotate(Vec3::Z * -90.0));
    tree.transform(&translate(Vec3::Z));
    let geometry = compile(tree);
    let [global, own] = geometry.lights.as_slice() else { panic!("two lights") };
    assert!((global.light.location - Vec3::new(0.0, 1.0, 1.0)).length() < 1e-12);
    assert!(global.group.is_none() && own.group.is_some());
    let material = |x: f64| {
        let found = surfaces(&geometry, &along_z(x));
        geometry.materials[found[0].material.0 as usize].clone()
    };
    assert_eq!((material(0.0).light_group, material(0.0).global_lights), (own.group, false));
    assert_eq!((material(6.0).light_group, material(6.0).global_lights), (None, true));
    // What shows a light casts no shadow.
    assert!(sees(&geometry, 3.0, RayClass::Camera) && !sees(&geometry, 3.0, RayClass::Shadow));
}

#[test]
fn an_inverted_quadric_turns_its_inside_but_not_its_normal() {
    let coefficients = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
    let quadric = Object::new(ObjectKind::Shape(Arc::new(Shape::Quadric(coefficients))));
    let geometry = compile(with(quadric, |o| o.inverse = true));
    let seen = surfaces(&geometry, &Ray::new(Vec3::new(0.0, 0.0, -3.0), Vec3::Z));
    assert_eq!((seen.len(), seen[0].n), (2, Vec3::NEG_Z));
    assert!(!geometry.inside(Vec3::ZERO) && geometry.inside(Vec3::X * 2.0));
}

#[test]
fn moved_triangles_have_a_normal_that_does_not_depend_on_their_order() {
    let normal = |points: [Vec3; 3], by: f64| {
        let middle = (points[0] + points[1] + points[2]) / 3.0;
        let object = Object::new(ObjectKind::Shape(Arc::new(Shape::Triangle { points })));
        let geometry = compile(with(object, |o| o.transform(&translate(Vec3::splat(by)))));
        let dir = (points[1] - points[0]).cross(points[2] - points[0]).normalize();
        surfaces(&geometry, &Ray::new(middle - dir * 3.0, dir))[0].n
    };
    let (o, x, y, z) = (Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z);
    assert_eq!((normal([o, x, y], 0.0), normal([o, y, x], 0.0)), (-z, z));
    assert_eq!((normal([o, x, y], 1e-12), normal([o, y, x], 1e-12)), (-z, -z));
    assert_eq!((normal([o, y, z], 1e-12), normal([o, z, y], 1e-12)), (-x, -x));
    assert_eq!((normal([o, x, z], 1e-12), normal([o, z, x], 1e-12)), (y, y));
}
