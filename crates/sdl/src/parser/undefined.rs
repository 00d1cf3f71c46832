//! Numbers that are none, such as zero times infinity. An object that has one in its shape or place is never hit, so it
//! is left out with a warning; elsewhere they are refused.
use super::{Parser, Result};

/// What to do about undefined numbers, and whether one was met.
#[derive(Default)]
pub struct Undefined {
    allowed: bool,
    met: bool,
}

impl Parser<'_> {
    /// Reads an object. The second value says that one of its numbers was undefined where that is allowed.
    pub fn noting_undefined<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<(T, bool)> {
        let outer = std::mem::take(&mut self.undefined);
        let object = read(self);
        let noted = std::mem::replace(&mut self.undefined, outer);
        Ok((object?, noted.met))
    }

    /// Reads what decides shape or place of the object that `noting_undefined` reads.
    pub fn allowing_undefined<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let outer = std::mem::replace(&mut self.undefined.allowed, true);
        let value = read(self);
        self.undefined.allowed = outer;
        value
    }

    /// Notes that the number just read is `what`, or fails where that is not allowed.
    pub fn met_undefined(&mut self, what: &str) -> Result<()> {
        let span = self.span();
        if !self.undefined.allowed {
            return self.error("not-finite", format!("what stands before here is {what}"), span);
        }
        if !self.undefined.met {
            let message = format!("what stands before here is {what}; the object is left out");
            self.warn("not-finite", message, span);
        }
        self.undefined.met = true;
        Ok(())
    }
}
