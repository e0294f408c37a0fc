//! Pictures, which only a page has.

use super::Context;
use crate::emit::markdown::holds::Form;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::picture::Picture;

impl Context<'_> {
    /// Puts down a picture on a page.
    pub(in crate::emit::markdown) fn picture(&self, page: &mut Page, picture: impl FnOnce() -> Picture) {
        if self.form == Form::Page {
            page.picture(picture());
        }
    }
}
