//! The gate before the outputs.

use std::ops::Deref;

/// Something that all rules have seen and none has refused.
///
/// Only the stage `check` can make one, so what takes a `Checked` needs no checks of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked<T>(pub(super) T);

impl<T> Deref for Checked<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}
