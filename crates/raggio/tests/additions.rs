//! What the language has beyond POV-Ray's, asked by a scene's own `trace` and `inside`.
use std::sync::atomic::AtomicBool;

use raggio::SceneOptions;

/// Reads a scene, which checks itself by `#error`.
#[track_caller]
fn runs(text: &str) {
    if let Err(failure) = raggio::load(&SceneOptions::text("test.pov", text)) {
        panic!("{}", failure.render());
    }
}

/// Shoots rays through a grid at two objects: hits and normals must agree.
const SAME: &str = "
    #version 3.7;
    #macro Same(A, B, Tolerance)
        #local Hits = 0;
        #for (I, -10, 10) #for (J, -10, 10)
            #local From = <I * 0.123 + 0.01, 3, J * 0.117>;
            #local To = <I * 0.05, -2, 0.3 + J * 0.07>;
            #local Na = <0, 0, 0>; #local Nb = <0, 0, 0>;
            #local Pa = trace(A, From, To - From, Na);
            #local Pb = trace(B, From, To - From, Nb);
            #if ((vlength(Na) = 0) != (vlength(Nb) = 0) | vlength(Pa - Pb) > Tolerance | vlength(Na - Nb) > 30 * Tolerance)
                #error concat(str(I, 0, 0), \" \", str(J, 0, 0))
            #end
            #if (vlength(Na) > 0) #local Hits = Hits + 1; #end
        #end #end
        #if (Hits < 40) #error \"too few rays hit\" #end
    #end
";

#[test]
fn a_surface_may_be_contained_by_any_bounded_solid() {
    let solid = "cone { -y, 0.9, 0.8*y, 0.4 rotate 20*z }";
    let function = "function { x*x + y*y*y + z*z - 0.5 } max_gradient 6 accuracy 1e-6";
    let boxed = "contained_by { box { -3, 3 } }";
    runs(&format!(
        "{SAME}
        #declare Solid = {solid}
        Same(isosurface {{ {function} contained_by {{ Solid }} }},
             intersection {{ isosurface {{ {function} {boxed} }} object {{ Solid }} }}, 1e-5)
        Same(isosurface {{ {function} contained_by {{ {solid} }} open }},
             isosurface {{ {function} {boxed} open clipped_by {{ Solid }} }}, 1e-5)"
    ));
}

#[test]
fn what_contains_a_surface_is_bounded() {
    for bad in ["plane { y, 0 }", "triangle { 0, x, y }", "cylinder { 0, y, 1 inverse }", "1"] {
        let text = format!("isosurface {{ function {{ x }} contained_by {{ {bad} }} }}");
        let Err(failure) = raggio::load(&SceneOptions::text("bad.pov", text)) else { panic!("{bad}") };
        assert!(failure.render().contains("solid"), "{bad}: {}", failure.render());
    }
}

#[test]
fn a_smooth_patch_is_the_surface_that_facets_come_close_to() {
    let points = "<-1,0,-1><-.3,1,-1><.3,-1,-1><1,0,-1> <-1,0,-.3><-.3,1,-.3><.3,-1,-.3><1,.5,-.3>
        <-1,0,.3><-.3,.7,.3><.3,-1,.3><1,0,.3> <-1,.2,1><-.3,1,1><.3,-1,1><1,0,1>";
    runs(&format!(
        "{SAME}
        Same(bicubic_patch {{ type 1 smooth flatness 0 u_steps 3 v_steps 3 {points} }},
             bicubic_patch {{ type 1 flatness 0 u_steps 7 v_steps 7 {points} }}, 1e-3)"
    ));
}

/// The middle row of a picture of a checked floor that reaches to the horizon, under light that hides nothing.
fn floor(image: &str) -> Vec<f32> {
    let text = format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 }}
        camera {{ location <0.3, 2, 0> look_at <0.3, 1, 60> right 4/3*x }}
        plane {{ y, 0
          pigment {{ image_map {{ function 64, 64 {{ mod(floor(x*63.5) + floor(y*63.5), 2) }} {image} }} rotate 90*x }}
          finish {{ ambient 1 diffuse 0 }} }}"
    );
    let loaded = raggio::load(&SceneOptions::text("floor.pov", text.as_str()))
        .unwrap_or_else(|e| panic!("{}", e.render()));
    let world = loaded.build().unwrap_or_else(|e| panic!("{}", e.render()));
    let options = raggio::RenderOptions { width: 80, height: 60, ..raggio::RenderOptions::default() };
    let film = world.render(&options, &AtomicBool::new(false), &|_, _| {});
    film.pixels[36 * 80..50 * 80].iter().map(|p| p[0]).collect()
}

#[test]
fn a_smooth_image_is_grey_where_its_squares_are_smaller_than_pixels() {
    let (plain, smooth) = (floor(""), floor("smooth"));
    assert_eq!(plain, floor("smooth off"));
    let picked = plain.iter().filter(|&&v| v == 0.0 || v == 1.0).count();
    assert!(picked > plain.len() * 9 / 10, "{picked} of {}", plain.len());
    for v in smooth {
        assert!((v - 0.5).abs() < 0.05, "{v}");
    }
}

#[test]
fn an_enlarged_smooth_image_looks_as_ever() {
    let picture = |image: &str| {
        let text = format!(
            "#version 3.7; global_settings {{ assumed_gamma 1 }}
            camera {{ orthographic location <0.5, 0.5, -1> look_at <0.5, 0.5, 0> right x up y }}
            plane {{ z, 0 pigment {{ image_map {{ function 5, 5 {{ x*y }} interpolate 2 {image} }} }}
              finish {{ ambient 1 diffuse 0 }} }}"
        );
        let loaded = raggio::load(&SceneOptions::text("near.pov", text.as_str()))
            .unwrap_or_else(|e| panic!("{}", e.render()));
        let world = loaded.build().unwrap_or_else(|e| panic!("{}", e.render()));
        let options = raggio::RenderOptions { width: 40, height: 40, ..raggio::RenderOptions::default() };
        world.render(&options, &AtomicBool::new(false), &|_, _| {}).pixels
    };
    assert_eq!(picture("smooth"), picture(""));
}
