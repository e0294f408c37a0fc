//! `Info`: how long a master waits, and how it finds the number that people set.

use super::node::{Node, optional, optional_number, optional_text, value};

/// All numbers that stand in a `Timeout` of `Info`.
pub(super) fn timeouts(node: Node<'_, '_>) -> Result<Vec<(String, u32)>, String> {
    let Some(info) = optional(node, "Info")? else { return Ok(Vec::new()) };
    let timeouts = info.descendants().filter(|it| it.has_tag_name("Timeout"));
    let times = timeouts.flat_map(|timeout| timeout.children().filter(Node::is_element));
    times.map(|time| Ok((time.tag_name().name().to_owned(), value(time)?))).collect()
}

/// Where a master finds the number that people set.
pub(super) fn set_number(node: Node<'_, '_>) -> Result<(Option<u16>, Option<String>), String> {
    let Some(info) = optional(node, "Info")? else { return Ok((None, None)) };
    Ok((optional_number(info, "IdentificationAdo")?, optional_text(info, "IdentificationReg134")?))
}
