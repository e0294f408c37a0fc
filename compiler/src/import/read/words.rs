//! Names that a file gives in several languages.

use super::element::Element;
use super::esi::Texts;
use super::number::number;
use crate::model::Language;

/// English.
const ENGLISH: &str = "1033";

/// The English name, else the one without a language, else the first.
pub(super) fn name(parent: &Element<'_>, tag: &str) -> Option<String> {
    let chosen = chosen(parent, tag)?;
    // One in another language is taken for English, and that it is not stays unread.
    chosen.attribute_as("LcId", |lcid| number::<u32>(lcid).is_none_or(|it| !is_other(it)).then_some(()));
    Some(one_line(chosen.text()))
}

/// The names in other languages than the one that is taken for English. What says the same in another language says
/// nothing; languages that descriptions do not have stay unread.
pub(super) fn others(parent: &Element<'_>, tag: &str) -> Texts {
    let Some(chosen) = chosen(parent, tag) else { return Texts::default() };
    let english = name(parent, tag);
    let mut texts = Texts::default();
    for other in named(parent, tag).filter(|other| !std::ptr::eq(*other, chosen)) {
        let language = other.attribute_as("LcId", language);
        let Some(language) = language.filter(|language| texts.iter().all(|(known, _)| known != language))
        else {
            continue;
        };
        let text = one_line(other.text());
        if Some(&text) != english.as_ref() {
            texts.push((language, text));
        }
    }
    texts
}

/// Whether a number is that of another language than English: the low ten bits say which, in any country. 0 and 1 are none.
fn is_other(lcid: u32) -> bool {
    lcid > 1 && lcid & 0x3FF != 9
}

fn language(lcid: &str) -> Option<Language> {
    number(lcid).and_then(Language::of_lcid)
}

/// A text in several lines as one line.
pub(in super::super) fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn named<'e, 't>(
    parent: &'e Element<'t>,
    tag: &'e str,
) -> impl Iterator<Item = &'e Element<'t>> + use<'e, 't> {
    parent.children().iter().filter(move |child| child.name() == tag && !child.is_blank())
}

fn chosen<'e, 't>(parent: &'e Element<'t>, tag: &'e str) -> Option<&'e Element<'t>> {
    let english = named(parent, tag).find(|child| child.has("LcId", ENGLISH));
    let plain = || named(parent, tag).find(|child| !child.has_any("LcId"));
    english.or_else(plain).or_else(|| named(parent, tag).next())
}
