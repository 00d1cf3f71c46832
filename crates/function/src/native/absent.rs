//! Where there is no native code: another processor, or a build without it.
use crate::program::Program;

/// Nothing.
#[derive(Debug, Default)]
pub(crate) struct Native(());

impl Native {
    #[inline(always)]
    pub(crate) fn value(&self, _program: &Program, _args: &[f64]) -> Option<f64> {
        None
    }

    pub(crate) fn prepare(&self, _program: &Program) -> bool {
        false
    }
}
