//! The grammar: one file a block of the language.
