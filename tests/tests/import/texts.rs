//! Texts in other languages, and the messages of the diagnosis history.

use super::facts::{Collector, Node, all, content, find, lines, name, number, text_in};

/// The texts of a diagnosis history by text id.
pub(crate) fn messages(device: Node<'_, '_>, facts: &mut Collector) {
    let list = find(device, "Profile").and_then(|profile| find(profile, "DiagMessages"));
    for node in list.into_iter().flat_map(|list| all(list, "DiagMessage")) {
        let text_id = text_in(node, "TextId").and_then(|it| number(&it)).unwrap_or(0);
        let key = format!("message/{text_id:04X}");
        let at = vec![lines(node)];
        facts.text(&key, name(node, "MessageText"), &at);
        in_languages(node, "MessageText", &key, facts);
        facts.text(&format!("{key}/about"), name(node, "Description"), &at);
        let class = find(node, "Flags").and_then(|flags| text_in(flags, "DiagClass"));
        facts.text(&format!("{key}/class"), class, &at);
        for remedy in all(node, "CauseRemedy") {
            facts.text(&format!("{key}/remedy"), name(remedy, "Remedy"), &at);
        }
    }
}

/// What the same is called in other languages, where it is called otherwise.
pub(crate) fn in_languages(node: Node<'_, '_>, tag: &str, key: &str, facts: &mut Collector) {
    let english = name(node, tag);
    let spoken =
        |it: &Node<'_, '_>| !matches!(it.attribute("LcId").map(str::trim), None | Some("0" | "1033"));
    for other in all(node, tag).filter(|it| spoken(it) && Some(content(*it)) != english) {
        let language = other.attribute("LcId").unwrap_or_default().trim();
        let text = Some(content(other)).filter(|text| !text.is_empty());
        facts.text(&format!("{key} in {language}"), text, &[lines(other)]);
    }
}
