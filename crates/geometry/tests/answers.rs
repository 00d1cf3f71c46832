//! The simple shapes and CSG against POV-Ray's recorded answers.
mod recorded;

use recorded::{check_hits, check_inside, check_uv};

/// Every object with recorded answers, and how well known its points are.
const OBJECTS: [(&str, f64); 30] = [
    ("sphere", 1e-9),
    ("sphere_inv", 1e-9),
    ("ellipsoid", 1e-9),
    ("box", 1e-9),
    ("box_rot", 1e-9),
    ("plane", 1e-9),
    ("plane_scaled", 1e-9),
    ("cylinder", 1e-9),
    ("cylinder_open", 1e-9),
    ("cone", 1e-9),
    ("cone_point", 1e-9),
    ("cone_open", 1e-9),
    ("disc", 1e-9),
    ("disc_hole", 1e-9),
    ("triangle", 1e-9),
    ("smooth_triangle", 1e-9),
    ("polygon", 1e-9),
    // Meshes keep their corners in single precision.
    ("mesh", 1e-6),
    ("mesh_smooth", 1e-6),
    ("mesh2", 1e-6),
    ("quadric", 1e-9),
    ("quadric_clip", 1e-9),
    ("union", 1e-9),
    ("merge", 1e-9),
    ("intersection", 1e-9),
    ("difference", 1e-9),
    ("diff_union", 1e-9),
    ("clipped", 1e-9),
    ("clip_inv", 1e-9),
    ("bounded", 1e-9),
];

/// Those for which `inside` is an error in the language, or was not asked.
const WITHOUT_INSIDE: [&str; 4] = ["triangle", "smooth_triangle", "mesh_smooth", "polygon"];

#[test]
fn rays_hit_as_recorded() {
    OBJECTS.iter().for_each(|(name, tolerance)| check_hits(name, *tolerance));
}

#[test]
fn insides_are_as_recorded() {
    OBJECTS.iter().map(|o| o.0).filter(|name| !WITHOUT_INSIDE.contains(name)).for_each(check_inside);
}

#[test]
fn texture_coordinates_are_as_recorded() {
    let names = [
        "sphere",
        "ellipsoid",
        "box",
        "box_rot",
        "plane",
        "cylinder",
        "cone",
        "disc",
        "polygon",
        "mesh_smooth",
        "mesh2",
        "quadric",
        "union",
        "difference",
    ];
    names.into_iter().for_each(check_uv);
}
