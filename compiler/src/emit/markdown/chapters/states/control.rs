//! What the drive does with what it is asked for at the wrong time.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::list;
use crate::emit::markdown::page::Page;
use crate::model::{DeviceControl, Refusal};
use crate::source::Origin;

/// What becomes of a wrong command.
pub(super) fn commands(context: &Context<'_>, control: &DeviceControl, page: &mut Page) {
    // What is left out stands beside the changes of mode.
    let DeviceControl { wrong_command, about, source, wrong_mode: _, modes_selectable_in: _, origin } =
        control;
    let refusal = match wrong_command {
        Refusal::Ignored => "A command that leads nowhere in the present state is ignored.",
        Refusal::Fault => "A command that leads nowhere in the present state is a fault: transition 13.",
    };
    page.text(said(context, origin, "wrong-command", refusal));
    page.text(context.paragraphs(about.as_deref()));
    page.text(context.said_line(source.as_ref(), origin));
}

/// When a mode can be selected, and what becomes of a wrong one.
pub(in crate::emit::markdown::chapters) fn modes(
    context: &Context<'_>,
    control: &DeviceControl,
    page: &mut Page,
) {
    // What is left out stands beside the commands.
    let DeviceControl { wrong_mode, modes_selectable_in, source, wrong_command: _, about: _, origin } =
        control;
    let states = list(modes_selectable_in.iter().map(|id| context.state(id)));
    let selectable = match modes_selectable_in.as_slice() {
        [] => String::new(),
        _ => format!("A mode can only be selected in: {states}."),
    };
    let refusal = match wrong_mode {
        Refusal::Ignored => "A change that the drive does not make is ignored.",
        Refusal::Fault => "A change that the drive does not make is a fault: transition 13.",
    };
    page.text(format!("{selectable} {}", said(context, origin, "wrong-mode", refusal)).trim());
    page.text(context.said_line(source.as_ref(), origin));
}

/// A sentence with the mark of the key that says it; none where the key is left out.
fn said(context: &Context<'_>, origin: &Origin, key: &str, sentence: &str) -> String {
    match origin.has(key) {
        true => format!("{sentence}{}", context.mark(origin, key)),
        false => String::new(),
    }
}
