//! Interned words: reserved words come first, so that a symbol below their number *is* a reserved word.
use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::keyword::Kw;

/// A word of the text; equal words have equal symbols.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Symbol(pub u32);

impl Symbol {
    /// The reserved word that this symbol is, if it is one.
    pub fn keyword(self) -> Option<Kw> {
        Kw::ALL.get(self.0 as usize).copied()
    }
}

/// All words met so far.
pub struct Symbols {
    ids: FxHashMap<Rc<str>, Symbol>,
    names: Vec<Rc<str>>,
}

impl Symbols {
    /// With the reserved words in their order.
    pub fn new() -> Self {
        let mut symbols = Symbols { ids: FxHashMap::default(), names: Vec::new() };
        for kw in Kw::ALL {
            symbols.intern(kw.word());
        }
        symbols
    }

    /// The symbol of a word.
    pub fn intern(&mut self, word: &str) -> Symbol {
        if let Some(&symbol) = self.ids.get(word) {
            return symbol;
        }
        let symbol = Symbol(self.names.len() as u32);
        let name: Rc<str> = word.into();
        self.ids.insert(name.clone(), symbol);
        self.names.push(name);
        symbol
    }

    /// The word of a symbol.
    pub fn name(&self, symbol: Symbol) -> &Rc<str> {
        &self.names[symbol.0 as usize]
    }
}
