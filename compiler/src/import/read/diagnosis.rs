//! The messages of the diagnosis history.

use super::element::Element;
use super::esi::Message;
use super::number::number;
use super::words;

/// The messages of a profile, as far as they have a text.
pub(super) fn messages(profile: &Element<'_>) -> Vec<Message> {
    let all = profile.child("DiagMessages").into_iter().flat_map(|messages| messages.all("DiagMessage"));
    all.filter_map(message).collect()
}

fn message(element: &Element<'_>) -> Option<Message> {
    let class = element.child("Flags").and_then(|flags| flags.child_as("DiagClass", class));
    let remedies: Vec<_> = element.all("CauseRemedy").collect();
    let remedy = match remedies.as_slice() {
        [only] => {
            only.attribute("Idx");
            words::name(only, "Remedy")
        }
        _ => None,
    };
    Some(Message {
        at: element.at(),
        text_id: element.child_as("TextId", number)?,
        text: words::name(element, "MessageText")?,
        texts: words::others(element, "MessageText"),
        class,
        about: words::name(element, "Description"),
        remedy,
    })
}

fn class(text: &str) -> Option<&'static str> {
    ["error", "warning", "information"].into_iter().find(|class| *class == text)
}
