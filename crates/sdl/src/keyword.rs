//! The reserved words of the language, as one enum made from one list.

macro_rules! keywords {
    ($($name:ident)*) => {
        /// A reserved word; the variant is spelled as the word with its first letter raised.
        #[allow(non_camel_case_types)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Kw { $($name),* }
    };
}

keywords! {
    Sphere Box Camera Texture Pigment
}
