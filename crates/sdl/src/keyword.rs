//! The reserved words of the language, as one enum made from one list.

macro_rules! keywords {
    ($($name:ident)*) => {
        /// A reserved word; the variant is spelled as the word with its first letter raised.
        #[allow(non_camel_case_types, missing_docs)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u16)]
        pub enum Kw { $($name),* }

        impl Kw {
            /// All reserved words, in the order of the enum.
            pub const ALL: &[Kw] = &[$(Kw::$name),*];
            const WORDS: &[&str] = &[$({
                const WORD: [u8; stringify!($name).len()] = lowered(stringify!($name));
                match std::str::from_utf8(&WORD) {
                    Ok(word) => word,
                    Err(_) => unreachable!(),
                }
            }),*];
        }
    };
}

impl Kw {
    /// The word as it is written.
    pub fn word(self) -> &'static str {
        Self::WORDS[self as usize]
    }

    /// Does it make a directive after `#`?
    pub(crate) fn is_directive(self) -> bool {
        use Kw::*;
        matches!(
            self,
            Break
                | Case
                | Debug
                | Declare
                | Default
                | Else
                | Elseif
                | End
                | Error
                | Fclose
                | Fopen
                | For
                | If
                | Ifdef
                | Ifndef
                | Include
                | Local
                | Macro
                | Range
                | Read
                | Render
                | Statistics
                | Switch
                | Undef
                | Version
                | Warning
                | While
                | Write
        )
    }
}

const fn lowered<const N: usize>(name: &str) -> [u8; N] {
    let mut word = [0; N];
    let mut i = 0;
    while i < N {
        word[i] = name.as_bytes()[i].to_ascii_lowercase();
        i += 1;
    }
    word
}

// Reserved in 3.7.0.10, found by trying to declare each word (`halo`, `atmosphere`, `grey`, `hf`, `image_width` are not).
keywords! {
    Aa_level Aa_threshold Abs Absorption Accuracy Acos Acosh Adaptive Adc_bailout Agate Agate_turb Albedo
    All All_intersections Alpha Altitude Always_sample Ambient Ambient_light Angle Aoi Aperture Append
    Arc_angle Area_illumination Area_light Array Asc Ascii Asin Asinh Assumed_gamma Atan Atan2 Atanh
    Autostop Average B_spline Background Bezier_spline Bicubic_patch Bitwise_and Bitwise_or Bitwise_xor
    Black_hole Blob Blue Blur_samples Bmp Bokeh Bounded_by Box Boxed Bozo Break Brick Brick_size
    Brightness Brilliance Bump_map Bump_size Bumps Camera Case Caustics Ceil Cells Charset Checker Chr
    Circular Clipped_by Clock Clock_on Collect Color Color_map Colour Colour_map Component Composite
    Concat Cone Confidence Conic_sweep Conserve_energy Contained_by Control0 Control1 Coords Cos Cosh
    Count Crackle Crand Cube Cubic Cubic_spline Cubic_wave Cutaway_textures Cylinder Cylindrical Datetime
    Debug Declare Default Defined Degrees Density Density_file Density_map Dents Deprecated Df3 Difference
    Diffuse Dimension_size Dimensions Direction Disc Dispersion Dispersion_samples Dist_exp Distance Div
    Double_illuminate Eccentricity Else Elseif Emission End Error Error_bound Evaluate Exp
    Expand_thresholds Exponent Exr Exterior Extinction Face_indices Facets Fade_color Fade_colour
    Fade_distance Fade_power Falloff Falloff_angle False Fclose File_exists Filter Finish Fisheye Flatness
    Flip Floor Focal_point Fog Fog_alt Fog_offset Fog_type Fopen For Form Frequency Fresnel Function Gamma
    Gather Gif Global_lights Global_settings Gradient Granite Gray Gray_threshold Green Hdr Height_field
    Hexagon Hf_gray_16 Hierarchy Hollow Hypercomplex If Ifdef Iff Ifndef Image_map Image_pattern
    Importance Include Inside Inside_vector Int Interior Interior_texture Internal Interpolate
    Intersection Intervals Inverse Ior Irid Irid_wavelength Isosurface Jitter Jpeg Julia Julia_fractal
    Lambda Lathe Leopard Light_group Light_source Linear_spline Linear_sweep Ln Load_file Local Location
    Log Look_at Looks_like Low_error_factor Macro Magnet Major_radius Mandel Map_type Marble Material
    Material_map Matrix Max Max_extent Max_gradient Max_intersections Max_iteration Max_sample Max_trace
    Max_trace_level Maximum_reuse Media Media_attenuation Media_interaction Merge Mesh Mesh2 Mesh_camera
    Metallic Method Metric Min Min_extent Minimum_reuse Mm_per_unit Mod Mortar Natural_spline
    Nearest_count No No_bump_scale No_image No_radiosity No_reflection No_shadow Noise_generator Normal
    Normal_indices Normal_map Normal_vectors Now Number_of_sides Number_of_tiles Number_of_waves Object Octaves Off Offset Omega Omnimax
    On Once Onion Open Orient Orientation Orthographic Ovus Panoramic Parallel Parametric Pass_through
    Pattern Pavement Perspective Pgm Phase Phong Phong_size Photons Pi Pigment Pigment_map Pigment_pattern
    Planar Plane Png Point_at Poly Poly_wave Polygon Polynomial Pot Pow Ppm Precision Precompute
    Premultiplied Pretrace_end Pretrace_start Prism Prod Projected_through Pwr Quadratic_spline Quadric
    Quartic Quaternion Quick_color Quick_colour Quilted Radial Radians Radiosity Radius Rainbow Ramp_wave
    Rand Range Ratio Read Reciprocal Recursion_limit Red Reflection Reflection_exponent Refraction Render
    Repeat Rgb Rgbf Rgbft Rgbt Right Ripples Rotate Roughness Samples Save_file Scale Scallop_wave
    Scattering Seed Select Shadowless Sin Sine_wave Sinh Sint16be Sint16le Sint32be Sint32le Sint8 Size
    Sky Sky_sphere Slice Slope Slope_map Smooth Smooth_triangle Solid Sor Spacing Specular Sphere
    Sphere_sweep Spherical Spiral1 Spiral2 Spline Split_union Spotlight Spotted Sqr Sqrt Square Srgb Srgbf
    Srgbft Srgbt Statistics Str Strcmp Strength Strlen Strlwr Strupr Sturm Substr Subsurface Sum
    Superellipsoid Switch Sys T Tan Tanh Target Text Texture Texture_list Texture_map Tga Thickness
    Threshold Tiff Tightness Tile2 Tiles Tiling Tolerance Toroidal Torus Trace Transform Translate
    Translucency Transmit Triangle Triangle_wave Triangular True Ttf Turb_depth Turbulence Type U U_steps
    Uint16be Uint16le Uint8 Ultra_wide_angle Undef Union Up Use_alpha Use_color Use_colour Use_index Utf8
    Uv_indices Uv_mapping Uv_vectors V V_steps Val Variance Vaxis_rotate Vcross Vdot Version
    Vertex_vectors Vlength Vnormalize Vrotate Vstr Vturbulence Warning Warp Water_level Waves While Width
    Wood Wrinkles Write X Xyz Y Yes Z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_the_variants_in_lower_case() {
        assert_eq!(Kw::Light_source.word(), "light_source");
        assert_eq!(Kw::X.word(), "x");
        assert_eq!(Kw::ALL.len(), Kw::WORDS.len());
        assert!(Kw::ALL.iter().enumerate().all(|(i, &kw)| kw as usize == i));
    }
}
