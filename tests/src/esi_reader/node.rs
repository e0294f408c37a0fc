//! Elements by name, and what is in them.

use std::str::FromStr;

pub(super) use roxmltree::Node;

/// The children of a name.
pub(super) fn children<'a, 'd: 'a>(
    node: Node<'a, 'd>,
    name: &'a str,
) -> impl Iterator<Item = Node<'a, 'd>> + use<'a, 'd> {
    node.children().filter(move |child| child.has_tag_name(name))
}

/// The child of a name, if there is one; two are an error.
pub(super) fn optional<'a, 'd: 'a>(
    node: Node<'a, 'd>,
    name: &'a str,
) -> Result<Option<Node<'a, 'd>>, String> {
    let mut found = children(node, name);
    match (found.next(), found.next()) {
        (first, None) => Ok(first),
        (_, Some(second)) => Err(complaint(second, "is the second of its name")),
    }
}

/// The only child of a name.
pub(super) fn only<'a, 'd: 'a>(node: Node<'a, 'd>, name: &'a str) -> Result<Node<'a, 'd>, String> {
    optional(node, name)?.ok_or_else(|| complaint(node, &format!("lacks {name}")))
}

/// The text in an element.
pub(super) fn content(node: Node<'_, '_>) -> String {
    node.text().unwrap_or_default().to_owned()
}

/// The text in the only child of a name.
pub(super) fn text(node: Node<'_, '_>, name: &str) -> Result<String, String> {
    only(node, name).map(content)
}

/// The text in the child of a name, if there is one.
pub(super) fn optional_text(node: Node<'_, '_>, name: &str) -> Result<Option<String>, String> {
    Ok(optional(node, name)?.map(content))
}

/// The English text among the children of a name, or the only one.
pub(super) fn english(node: Node<'_, '_>, name: &str) -> Result<String, String> {
    optional_english(node, name)?.ok_or_else(|| complaint(node, &format!("lacks {name} in English")))
}

/// The English text among the children of a name, if there is one; two of a language are an error.
pub(super) fn optional_english(node: Node<'_, '_>, name: &str) -> Result<Option<String>, String> {
    let mut seen = Vec::new();
    for child in children(node, name) {
        let language = child.attribute("LcId").unwrap_or("1033");
        if seen.contains(&language) {
            return Err(complaint(child, "is the second of its language"));
        }
        seen.push(language);
    }
    Ok(children(node, name).find(|it| it.attribute("LcId").unwrap_or("1033") == "1033").map(content))
}

/// The number in an element.
pub(super) fn value<T: TryFrom<i64> + FromStr>(node: Node<'_, '_>) -> Result<T, String> {
    parse(&content(node))
        .ok_or_else(|| complaint(node, &format!("is no number that fits: {}", content(node))))
}

/// The number in the only child of a name.
pub(super) fn number<T: TryFrom<i64> + FromStr>(node: Node<'_, '_>, name: &str) -> Result<T, String> {
    value(only(node, name)?)
}

/// The number in the child of a name, if there is one.
pub(super) fn optional_number<T: TryFrom<i64> + FromStr>(
    node: Node<'_, '_>,
    name: &str,
) -> Result<Option<T>, String> {
    optional(node, name)?.map(value).transpose()
}

/// The number in an attribute, if there is one.
pub(super) fn attribute<T: TryFrom<i64> + FromStr>(
    node: Node<'_, '_>,
    name: &str,
) -> Result<Option<T>, String> {
    let Some(written) = node.attribute(name) else { return Ok(None) };
    parse(written)
        .map(Some)
        .ok_or_else(|| complaint(node, &format!("has no number that fits in {name}: {written}")))
}

/// Whether an attribute is there and says yes.
pub(super) fn flag(node: Node<'_, '_>, name: &str) -> bool {
    matches!(node.attribute(name), Some("1" | "true"))
}

/// The bytes in an element.
pub(super) fn bytes(node: Node<'_, '_>) -> Result<Vec<u8>, String> {
    let text = content(node);
    let digits: Option<Vec<u32>> = text.chars().map(|c| c.to_digit(16)).collect();
    let digits = digits.filter(|digits| digits.len().is_multiple_of(2));
    let digits = digits.ok_or_else(|| complaint(node, &format!("does not hold whole bytes: {text}")))?;
    let byte = |pair: &[u32]| pair.iter().fold(0, |byte, digit| byte * 16 + digit) as u8;
    Ok(digits.chunks(2).map(byte).collect())
}

/// The bytes in the child of a name, if there is one.
pub(super) fn optional_bytes(node: Node<'_, '_>, name: &str) -> Result<Option<Vec<u8>>, String> {
    optional(node, name)?.map(bytes).transpose()
}

/// A message about an element.
pub(super) fn complaint(node: Node<'_, '_>, what: &str) -> String {
    let line = node.document().text_pos_at(node.range().start).row;
    format!("line {line}: {} {what}", node.tag_name().name())
}

/// `HexDecValue`: decimal, or hexadecimal after `#x`.
fn parse<T: TryFrom<i64> + FromStr>(text: &str) -> Option<T> {
    match text.strip_prefix("#x") {
        Some(digits) => i64::from_str_radix(digits, 16).ok().and_then(|value| T::try_from(value).ok()),
        None => text.parse().ok(),
    }
}
