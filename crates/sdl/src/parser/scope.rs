//! Names and what they stand for (language spec, section 1.3).
//!
//! A stack of tables: the global one, then one for each open include file and each active macro call. Each symbol
//! keeps a chain of its bindings, newest first, so that looking one up is one index.
use std::rc::Rc;

use smallvec::SmallVec;

use super::macros::Macro;
use super::symbol::Symbol;
use crate::value::Value;

/// Index of a binding; stays valid until the binding's table is closed.
pub type Slot = u32;
const NONE: u32 = u32::MAX;

/// What a name stands for.
#[derive(Debug)]
pub enum Entry {
    /// Nothing yet, or no longer.
    Undeclared,
    /// A value.
    Value(Value),
    /// A macro.
    Macro(Rc<Macro>),
    /// A macro parameter given by reference.
    Ref(Place),
}

/// Where a value lives: a binding, then an item index for each array on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The binding.
    pub slot: Slot,
    /// Flat indices into arrays in arrays.
    pub path: SmallVec<[u32; 2]>,
}

impl Place {
    /// A whole variable.
    pub fn variable(slot: Slot) -> Self {
        Place { slot, path: SmallVec::new() }
    }
}

/// What `#declare deprecated` says about a name.
#[derive(Debug)]
pub struct Deprecation {
    /// Say it once only?
    pub once: bool,
    /// The scene's own words.
    pub message: Option<String>,
}

#[derive(Debug)]
struct Binding {
    entry: Entry,
    symbol: Symbol,
    table: u32,
    below: u32,
    deprecation: Option<Box<Deprecation>>,
}

/// All names.
#[derive(Debug)]
pub struct Scopes {
    newest: Vec<u32>,
    bindings: Vec<Binding>,
    free: Vec<u32>,
    tables: Vec<Vec<u32>>,
}

impl Scopes {
    /// With the global table.
    pub fn new() -> Self {
        Scopes { newest: Vec::new(), bindings: Vec::new(), free: Vec::new(), tables: vec![Vec::new()] }
    }

    /// The newest binding of a symbol.
    #[inline]
    pub fn lookup(&self, symbol: Symbol) -> Option<Slot> {
        self.newest.get(symbol.0 as usize).copied().filter(|&slot| slot != NONE)
    }

    /// What a slot holds.
    #[inline]
    pub fn entry(&self, slot: Slot) -> &Entry {
        &self.bindings[slot as usize].entry
    }

    /// What a slot holds, to be changed.
    pub fn entry_mut(&mut self, slot: Slot) -> &mut Entry {
        &mut self.bindings[slot as usize].entry
    }

    /// The index of the newest table.
    pub fn depth(&self) -> u32 {
        self.tables.len() as u32 - 1
    }

    /// Is the slot's table still open?
    pub fn is_alive(&self, slot: Slot) -> bool {
        self.bindings[slot as usize].table <= self.depth()
    }

    /// Opens a table.
    pub fn open(&mut self) {
        self.tables.push(Vec::new());
    }

    /// Closes the newest table; its names are forgotten.
    pub fn close(&mut self) {
        for slot in self.tables.pop().unwrap_or_default().into_iter().rev() {
            self.unlink(slot);
            let binding = &mut self.bindings[slot as usize];
            binding.entry = Entry::Undeclared;
            binding.deprecation = None;
            self.free.push(slot);
        }
    }

    /// Takes a binding out of its symbol's chain, if it is in it.
    fn unlink(&mut self, slot: Slot) {
        let Binding { symbol, below, .. } = self.bindings[slot as usize];
        let mut link = self.newest[symbol.0 as usize];
        if link == slot {
            self.newest[symbol.0 as usize] = below;
            return;
        }
        while link != NONE {
            let next = self.bindings[link as usize].below;
            if next == slot {
                self.bindings[link as usize].below = below;
                return;
            }
            link = next;
        }
    }

    /// The binding of a symbol in one table, made if need be.
    pub fn bind(&mut self, symbol: Symbol, table: u32) -> Slot {
        let index = symbol.0 as usize;
        if self.newest.len() <= index {
            self.newest.resize(index + 1, NONE);
        }
        let (mut above, mut at) = (NONE, self.newest[index]);
        while at != NONE && self.bindings[at as usize].table > table {
            (above, at) = (at, self.bindings[at as usize].below);
        }
        if at != NONE && self.bindings[at as usize].table == table {
            return at;
        }
        let binding = Binding { entry: Entry::Undeclared, symbol, table, below: at, deprecation: None };
        let slot = self.insert(binding);
        match above {
            NONE => self.newest[index] = slot,
            above => self.bindings[above as usize].below = slot,
        }
        self.tables[table as usize].push(slot);
        slot
    }

    fn insert(&mut self, binding: Binding) -> Slot {
        if let Some(slot) = self.free.pop() {
            self.bindings[slot as usize] = binding;
            return slot;
        }
        self.bindings.push(binding);
        self.bindings.len() as u32 - 1
    }

    /// Forgets the innermost visible binding. The slot stays reserved, as parameters may still point at it.
    pub fn undefine(&mut self, slot: Slot) {
        self.unlink(slot);
        self.bindings[slot as usize].entry = Entry::Undeclared;
    }

    /// Marks a name as deprecated.
    pub fn deprecate(&mut self, slot: Slot, deprecation: Deprecation) {
        self.bindings[slot as usize].deprecation = Some(Box::new(deprecation));
    }

    /// Is there something to say about the use of this name?
    #[inline]
    pub fn is_deprecated(&self, slot: Slot) -> bool {
        self.bindings[slot as usize].deprecation.is_some()
    }

    /// What to say about the use of a deprecated name.
    #[inline]
    pub fn deprecation(&mut self, slot: Slot) -> Option<Option<String>> {
        let deprecation = self.bindings[slot as usize].deprecation.as_deref()?;
        let message = deprecation.message.clone();
        if deprecation.once {
            self.bindings[slot as usize].deprecation = None;
        }
        Some(message)
    }

    /// Every symbol that stands for something now.
    pub fn visible(&self) -> impl Iterator<Item = Symbol> + '_ {
        let bound = |&slot: &u32| slot != NONE && !matches!(self.entry(slot), Entry::Undeclared);
        (0..).zip(&self.newest).filter(move |(_, slot)| bound(slot)).map(|(i, _)| Symbol(i))
    }
}
