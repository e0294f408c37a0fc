//! What stops the drive, and how.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::list;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::StopOption;

/// What makes a drive stop, and how.
pub(super) fn page(context: &Context<'_>, options: &[StopOption]) -> Page {
    let titles = ["What happens", "Transitions", "Reaction", "How it slows down", "Notes", "Source"];
    let mut page = Page::default();
    page.table(Table::of(titles, options, |option| {
        [
            context.prose(&option.action),
            list(option.transitions.iter().map(u8::to_string)),
            context.prose(&option.reaction),
            context.optional(option.ramp.as_deref()),
            context.optional(option.about.as_deref()),
            context.said(option.source.as_ref(), &option.origin),
        ]
    }));
    page
}
