//! A walk through the model that shows what its parts have in common, whatever they are.

use super::difference::FieldPath;
use crate::source::Origin;

/// Who is shown the texts and the lists of values.
pub trait Walker {
    /// A part begins that knows where it was written.
    fn enter(&mut self, path: &FieldPath, origin: &Origin);

    /// The part ends.
    fn leave(&mut self);

    /// A text.
    fn text(&mut self, path: &FieldPath, text: &str);

    /// A list of values, each for people.
    fn list(&mut self, path: &FieldPath, items: &mut dyn Iterator<Item = String>);
}
