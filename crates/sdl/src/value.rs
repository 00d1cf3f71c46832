//! The values that identifiers can have.
use std::sync::Arc;

use raggio_function::Function;
use raggio_math::Affine;
use raggio_scene as scene;

/// A value of the language. Cloning is cheap: everything large is shared, and changed only through `Arc::make_mut`.
#[derive(Clone, Debug)]
pub enum Value {
    Float(f64),
    /// 2 to 5 components in `len`.
    Vector {
        v: [f64; 5],
        len: u8,
    },
    /// Five components, already rounded to single precision.
    Color([f64; 5]),
    String(Arc<str>),
    /// Items are changed in place by `Arc::make_mut`.
    Array(Arc<crate::parser::Array>),
    Function(Arc<Function>),
    Spline(Arc<crate::parser::Spline>),
    Object(Arc<scene::Object>),
    /// All layers of a texture.
    Texture(Arc<scene::Texture>),
    Pigment(Arc<scene::Pigment>),
    Normal(Arc<scene::Normal>),
    Finish(Arc<scene::Finish>),
    Material(Arc<Material>),
    Interior(Arc<scene::Interior>),
    Media(Arc<scene::Media>),
    Density(Arc<scene::Density>),
    ColorMap(Arc<scene::ColorMap>),
    PigmentMap(Arc<scene::Map<scene::Pigment>>),
    NormalMap(Arc<scene::Map<scene::Normal>>),
    TextureMap(Arc<scene::Map<scene::Texture>>),
    DensityMap(Arc<scene::Map<scene::Density>>),
    SlopeMap(Arc<Vec<(f32, f32, f32)>>),
    Transform(Box<Affine>),
    Camera(Arc<scene::Camera>),
    Fog(Arc<scene::Fog>),
    Rainbow(Arc<scene::Rainbow>),
    SkySphere(Arc<scene::SkySphere>),
    /// An open `#fopen` handle.
    File(crate::parser::FileHandle),
}

/// `material { texture interior_texture interior }`
#[derive(Clone, Debug, Default)]
pub struct Material {
    pub texture: Option<scene::Placed<scene::Texture>>,
    pub interior_texture: Option<scene::Placed<scene::Texture>>,
    pub interior: Option<scene::Placed<scene::Interior>>,
}

macro_rules! kinds {
    ($($kind:ident $name:literal),*) => {
        /// The kind of a [`Value`], for the grammar to branch on.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Kind { $($kind),* }

        impl Kind {
            /// What to call it in messages.
            pub fn name(self) -> &'static str {
                match self { $(Kind::$kind => $name),* }
            }
        }

        impl Value {
            /// The kind of this value.
            pub fn kind(&self) -> Kind {
                match self { $(Value::$kind { .. } => Kind::$kind),* }
            }
        }
    };
}

kinds! {
    Float "number", Vector "vector", Color "colour", String "string", Array "array", Function "function",
    Spline "spline", Object "object", Texture "texture", Pigment "pigment", Normal "normal", Finish
    "finish", Material "material", Interior "interior", Media "media", Density "density", ColorMap
    "color_map", PigmentMap "pigment_map", NormalMap "normal_map", TextureMap "texture_map", DensityMap
    "density_map", SlopeMap "slope_map", Transform "transform", Camera "camera", Fog "fog", Rainbow
    "rainbow", SkySphere "sky_sphere", File "file"
}
