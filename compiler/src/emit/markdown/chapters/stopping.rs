//! What stops the drive, and how.

use serde::Serialize;

use crate::emit::markdown::chapter::Chapter;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::list;
use crate::emit::markdown::table::Table;
use crate::model::StopOption;

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    options: Table,
}

impl Chapter for View {
    type Parts<'d> = &'d [StopOption];

    const ID: &'static str = "stopping";
    const TITLE: &'static str = "Stopping";
    const TEMPLATE: &'static str = include_str!("../templates/stopping.md.j2");

    fn view(context: &Context<'_>, options: Self::Parts<'_>) -> Option<Self> {
        let titles = ["What happens", "Transitions", "Reaction", "How it slows down", "Notes", "Source"];
        let options = Table::of(titles, options, |option| {
            [
                context.prose(&option.action),
                list(option.transitions.iter().map(u8::to_string)),
                context.prose(&option.reaction),
                context.optional(option.ramp.as_deref()),
                context.optional(option.about.as_deref()),
                context.said(option.source.as_ref(), &option.origin),
            ]
        });
        (!options.is_empty()).then_some(Self { options })
    }
}
