//! Names that a file gives in several languages.

use super::element::Element;

/// English.
const ENGLISH: &str = "1033";

/// The English name, else the one without a language, else the first. The others stay unread.
pub(super) fn name(parent: &Element<'_>, tag: &str) -> Option<String> {
    let named = || parent.children().iter().filter(|child| child.name() == tag && !child.is_blank());
    let english = named().find(|child| child.has("LcId", ENGLISH));
    let plain = || named().find(|child| !child.has_any("LcId"));
    let chosen = english.or_else(plain).or_else(|| named().next())?;
    chosen.attribute("LcId");
    let text = chosen.text().split_whitespace().collect::<Vec<_>>().join(" ");
    Some(text)
}
