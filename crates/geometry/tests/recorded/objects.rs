//! The objects behind the recorded answers.
use std::sync::Arc;

use raggio_math::transform::{rotate, scale, translate};
use raggio_math::{Affine, Vec3};
use raggio_scene::{Csg, FaceTexture, Mesh, MeshFace, Object, Shape};

use super::{csg, solid};

fn v(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

fn sphere(center: Vec3, radius: f64) -> Object {
    solid(Shape::Sphere { center, radius })
}

fn cuboid(a: Vec3, b: Vec3) -> Object {
    solid(Shape::Box { min: a.min(b), max: a.max(b) })
}

fn plane(normal: Vec3, distance: f64) -> Object {
    solid(Shape::Plane { normal: normal.normalize(), distance })
}

fn cylinder(base: Vec3, cap: Vec3, radius: f64, open: bool) -> Object {
    solid(Shape::Cylinder { base, cap, radius, open })
}

fn cone(base: Vec3, base_radius: f64, cap: Vec3, cap_radius: f64, open: bool) -> Object {
    solid(Shape::Cone { base, base_radius, cap, cap_radius, open })
}

fn disc(center: Vec3, normal: Vec3, radius: f64, hole: f64) -> Object {
    solid(Shape::Disc { center, normal: normal.normalize(), radius, hole })
}

fn moved(mut object: Object, steps: &[Affine]) -> Object {
    steps.iter().for_each(|t| object.transform(t));
    object
}

fn inverted(mut object: Object) -> Object {
    object.inverse = true;
    object
}

fn clipped(mut object: Object, clip: Object) -> Object {
    object.clips.push(Arc::new(clip));
    object
}

fn difference(children: impl IntoIterator<Item = Object>) -> Object {
    csg(Csg::Difference { cutaway_textures: false }, children)
}

fn two() -> [Object; 2] {
    [sphere(v(-0.4, 0., 0.), 0.7), cuboid(v(0., -0.5, -0.5), v(1., 0.5, 0.5))]
}

fn polygon() -> Object {
    let square = |r: f64| [(-r, -r), (r, -r), (r, r), (-r, r), (-r, -r)].map(|(x, y)| v(x, y, 0.)).to_vec();
    moved(solid(Shape::Polygon { loops: vec![square(1.0), square(0.5)] }), &[rotate(v(25., 30., 0.))])
}

/// A mesh of single triangles, smooth where normals are given.
fn triangles(corners: &[[Vec3; 3]], normals: &[[Vec3; 3]], inside_vector: Option<Vec3>) -> Object {
    let single = |v: &Vec3| v.as_vec3().to_array();
    let face = |i: usize| {
        let at = 3 * i as u32;
        MeshFace {
            vertices: [at, at + 1, at + 2],
            normals: (!normals.is_empty()).then_some([at, at + 1, at + 2]),
            uvs: None,
            texture: FaceTexture::Object,
        }
    };
    solid(Shape::Mesh(Arc::new(Mesh {
        vertices: corners.iter().flatten().map(single).collect(),
        normals: normals.iter().flatten().map(|n| single(&n.normalize())).collect(),
        faces: (0..corners.len()).map(face).collect(),
        inside_vector: inside_vector.map(Vec3::normalize),
        ..Mesh::default()
    })))
}

fn tetrahedron() -> Object {
    let (a, b, c, d) = (v(-1., -1., -1.), v(1., -1., 1.), v(1., 1., -1.), v(-1., 1., 1.));
    triangles(&[[a, b, c], [a, c, d], [a, d, b], [c, b, d]], &[], Some(v(0.3, 1., 0.2)))
}

fn smooth_mesh() -> Object {
    let corners = [
        [v(-1., -1., 0.), v(1., -1., 0.2), v(1., 1., 0.)],
        [v(-1., -1., 0.), v(1., 1., 0.), v(-1., 1., -0.3)],
    ];
    let normals = [
        [v(-0.3, -0.3, -1.), v(0.4, -0.3, -1.), v(0.3, 0.5, -1.)],
        [v(-0.3, -0.3, -1.), v(0.3, 0.5, -1.), v(-0.5, 0.4, -1.)],
    ];
    moved(triangles(&corners, &normals, None), &[scale(v(1., 1.3, 0.8)), rotate(v(10., 30., 5.))])
}

fn octahedron() -> Object {
    let axes = [[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]];
    let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    solid(Shape::Mesh(Arc::new(Mesh {
        vertices: axes.to_vec(),
        normals: axes.to_vec(),
        uvs: vec![[0., 0.], [1., 0.], [0., 1.], [1., 1.], [0.5, 0.25], [0.25, 0.75]],
        faces: faces
            .iter()
            .map(|&f| MeshFace { vertices: f, normals: Some(f), uvs: Some(f), texture: FaceTexture::Object })
            .collect(),
        inside_vector: Some(v(0.1, 0.2, 1.).normalize()),
        textures: Vec::new(),
    })))
}

/// The object of a name.
pub fn object(name: &str) -> Object {
    let corners = [v(-1., -0.5, 0.), v(1., -0.75, 0.5), v(0.25, 1.25, -0.25)];
    match name {
        "sphere" => sphere(v(0.25, -0.5, 0.75), 1.25),
        "sphere_inv" => inverted(sphere(Vec3::ZERO, 1.0)),
        "ellipsoid" => moved(
            sphere(v(0.5, 0., 0.), 1.0),
            &[scale(v(1.5, 0.75, 1.)), rotate(v(20., 35., -15.)), translate(v(0.1, 0.2, 0.3))],
        ),
        "box" => cuboid(v(1., 2., -0.5), v(-1., -0.75, 0.5)),
        "box_rot" => moved(
            cuboid(v(-1., -0.5, -0.75), v(1., 0.5, 0.75)),
            &[rotate(v(25., 40., 10.)), translate(v(0.2, 0., -0.1))],
        ),
        "plane" => plane(v(1., 2., -0.5), 0.75),
        "plane_scaled" => {
            moved(plane(v(1., 2., -0.5), 0.75), &[scale(v(1., 2., 3.)), rotate(v(10., 20., 30.))])
        }
        "cylinder" => cylinder(v(-0.5, -1., 0.25), v(0.75, 1., 0.5), 0.6, false),
        "cylinder_open" => cylinder(v(0., -1., 0.), v(0., 1., 0.), 0.7, true),
        "cone" => cone(v(0.2, 1., 0.), 0.3, v(-0.3, -1., 0.4), 0.9, false),
        "cone_point" => cone(v(0., 1.2, 0.), 0.0, v(0., -1., 0.), 1.0, false),
        "cone_open" => cone(v(0., 1., 0.), 0.2, v(0., -1., 0.), 1.0, true),
        "disc" => disc(v(0.1, 0.2, 0.), v(1., 2., -0.5), 1.2, 0.0),
        "disc_hole" => moved(disc(Vec3::ZERO, v(0., 0., -3.), 1.2, 0.5), &[rotate(v(30., 20., 0.))]),
        "triangle" => solid(Shape::Triangle { points: corners }),
        "smooth_triangle" => solid(Shape::SmoothTriangle {
            points: corners,
            normals: Box::new([v(-0.5, 0., -1.), v(0.5, -0.2, -1.), v(0., 0.5, -1.)].map(Vec3::normalize)),
        }),
        "polygon" => polygon(),
        "mesh" => tetrahedron(),
        "mesh_smooth" => smooth_mesh(),
        "mesh2" => octahedron(),
        "quadric" => solid(Shape::Quadric([1., -1., 1., 0.2, 0.3, -0.1, 0.1, 0., -0.2, -0.3])),
        "quadric_clip" => clipped(
            solid(Shape::Quadric([1., 0., 1., 0., 0., 0., 0., -1., 0., 0.])),
            cuboid(v(-1., -0.1, -1.), v(1., 0.9, 1.)),
        ),
        "union" => csg(Csg::Union, two()),
        "merge" => csg(Csg::Merge, two()),
        "intersection" => csg(
            Csg::Intersection,
            [
                sphere(Vec3::ZERO, 1.0),
                cuboid(v(-0.8, -0.7, -0.9), v(0.7, 0.9, 0.8)),
                plane(v(1., 1., -1.), 0.6),
            ],
        ),
        "difference" => difference([
            cuboid(Vec3::splat(-0.9), Vec3::splat(0.9)),
            sphere(v(0.4, 0.5, -0.6), 0.8),
            cylinder(v(-2., -0.4, 0.), v(2., -0.4, 0.), 0.3, false),
        ]),
        "diff_union" => {
            let cutter = csg(
                Csg::Union,
                [
                    cuboid(v(0., 0., -2.), v(2., 2., 2.)),
                    cylinder(v(-0.5, -2., -0.2), v(-0.5, 2., -0.2), 0.3, false),
                ],
            );
            moved(difference([sphere(Vec3::ZERO, 1.0), cutter]), &[rotate(v(0., 30., 10.))])
        }
        "clipped" => clipped(sphere(Vec3::ZERO, 1.0), plane(v(1., 1., 0.), 0.3)),
        "clip_inv" => clipped(
            cylinder(v(0., -1., 0.), v(0., 1., 0.), 0.7, false),
            inverted(sphere(v(0.6, 0., -0.4), 0.6)),
        ),
        "bounded" => {
            let mut ball = sphere(Vec3::ZERO, 1.0);
            ball.bounds.push(Arc::new(cuboid(v(-0.5, -0.5, -2.), v(0.5, 2., 2.))));
            ball
        }
        _ => panic!("no such object: {name}"),
    }
}
