//! Texts in several languages, and the messages of the diagnosis history.

use super::node::{Node, children, content, english, number, optional, optional_english, text};

/// A message of the diagnosis history: its text id, its text in English, how bad it is, what it means, and what to do.
pub type Message = (u16, String, Option<String>, Option<String>, Option<String>);

pub(super) fn translations(node: Node<'_, '_>) -> Vec<(String, u16, String)> {
    let spoken = node.descendants().filter_map(|it| Some((it, it.attribute("LcId")?.parse().ok()?)));
    let others = spoken.filter(|(_, language)| *language != 1033);
    others.map(|(it, language)| (it.tag_name().name().to_owned(), language, content(it))).collect()
}

pub(super) fn messages(profile: Node<'_, '_>) -> Result<Vec<Message>, String> {
    let list = optional(profile, "DiagMessages")?;
    list.into_iter().flat_map(|list| children(list, "DiagMessage")).map(message).collect()
}

fn message(node: Node<'_, '_>) -> Result<Message, String> {
    let class = optional(node, "Flags")?.map(|flags| text(flags, "DiagClass")).transpose()?;
    let remedy = optional(node, "CauseRemedy")?.map(|it| english(it, "Remedy")).transpose()?;
    let about = optional_english(node, "Description")?;
    Ok((number(node, "TextId")?, english(node, "MessageText")?, class, about, remedy))
}
