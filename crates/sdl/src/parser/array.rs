//! Arrays (language spec, section 1.4).
use raggio_diag::Span;
use smallvec::SmallVec;

use super::{Parser, Result, Tok};
use crate::value::{Kind, Value};

/// An array: every item of one kind unless it is mixed, some perhaps not given yet.
#[derive(Clone, Debug)]
pub struct Array {
    /// Items a dimension, 1 to 5 of them.
    pub dims: SmallVec<[u32; 2]>,
    /// Kind of the items, and how many components vectors have, once there is an item.
    pub kind: Option<(Kind, u8)>,
    /// `array mixed` (version 3.8): items of any kinds.
    pub mixed: bool,
    /// The items, last dimension fastest.
    pub items: Vec<Option<Value>>,
}

/// Most items that an array may have.
const MAX_ITEMS: u64 = 1 << 24;
/// Most dimensions.
const MAX_DIMENSIONS: usize = 5;

impl Array {
    /// May `value` be an item?
    pub fn takes(&self, value: &Value) -> bool {
        self.mixed || self.kind.is_none_or(|kind| kind == item_kind(value))
    }

    /// Gives an item; the first one settles the kind of all.
    pub fn set(&mut self, index: u32, value: Value) {
        self.kind.get_or_insert(item_kind(&value));
        self.items[index as usize] = Some(value);
    }
}

fn item_kind(value: &Value) -> (Kind, u8) {
    let len = if let Value::Vector { len, .. } = value { *len } else { 0 };
    (value.kind(), len)
}

impl Parser<'_> {
    /// `array [mixed] [n]... [{ ... }]`, the word already read.
    pub(super) fn array(&mut self) -> Result<Array> {
        let start = self.here();
        let mixed = self.peek()? == Tok::Unknown && self.text() == "mixed";
        if mixed {
            self.next()?;
        }
        let mut dims = SmallVec::new();
        while dims.len() < MAX_DIMENSIONS && self.accept_punct('[')? {
            dims.push(self.dimension()?);
        }
        if dims.is_empty() {
            return self.expected("`[` and the size of the array");
        }
        let count = dims.iter().map(|&d| u64::from(d)).product::<u64>();
        if count > MAX_ITEMS {
            return self.error("array-too-large", format!("an array of {count} items is too large"), start);
        }
        let mut array = Array { dims, kind: None, mixed, items: vec![None; count as usize] };
        if self.accept_punct('{')? {
            let mut next = 0;
            self.initializer(&mut array, 0, &mut next)?;
        }
        Ok(array)
    }

    fn dimension(&mut self) -> Result<u32> {
        let (size, span) = self.nested(|p| Ok((p.float()?, p.here())))?;
        self.expect(']')?;
        let size = (size + raggio_math::EPS).trunc();
        if size < 1.0 {
            return self.error("array-size", "an array needs at least one item in each dimension", span);
        }
        Ok(size.min(f64::from(u32::MAX)) as u32)
    }

    /// The items of one dimension, after `{`.
    fn initializer(&mut self, array: &mut Array, dim: usize, next: &mut u32) -> Result<()> {
        let size = array.dims[dim];
        for item in 0..size {
            if self.accept_punct('}')? {
                let message = format!("this array wants {size} items here, but only {item} are given");
                return self.error("array-items", message, self.here());
            }
            if dim + 1 < array.dims.len() {
                self.expect('{')?;
                self.nested(|p| p.initializer(array, dim + 1, next))?;
            } else {
                let value = self.nested(Self::value)?;
                self.check_item(array, &value)?;
                array.set(*next, value);
                *next += 1;
            }
            self.comma()?;
        }
        if !self.accept_punct('}')? {
            let span = self.span();
            return self.error("array-items", format!("this array wants only {size} items here"), span);
        }
        Ok(())
    }

    /// Refuses values of another kind than the array's.
    pub(super) fn check_item(&self, array: &Array, value: &Value) -> Result<()> {
        if array.takes(value) {
            return Ok(());
        }
        let kind = array.kind.map_or("", |(kind, _)| kind.name());
        let message = format!("this array holds items of kind {kind}, not {}", value.kind().name());
        self.error("array-type", message, self.here())
    }

    /// Reads `[i][j]...` for an array of these dimensions; the flat index.
    pub(super) fn subscripts(&mut self, dims: &[u32]) -> Result<u32> {
        let mut index = 0;
        for &dim in dims {
            self.expect('[')?;
            let (i, span) = self.nested(|p| Ok((p.float()?, p.here())))?;
            self.expect(']')?;
            index = index * dim + self.subscript(i, dim, span)?;
        }
        Ok(index)
    }

    fn subscript(&self, value: f64, dim: u32, span: Span) -> Result<u32> {
        let i = value + raggio_math::EPS;
        if i >= 0.0 && i.trunc() < f64::from(dim) {
            return Ok(i as u32);
        }
        let message = format!("subscript {value} is out of range: the items are numbered 0 to {}", dim - 1);
        self.error("array-subscript", message, span)
    }
}
