//! Running text and lists that members have in versions of their own.

use super::align::{Unit, align};
use super::names::Names;
use crate::emit::markdown::page::Item;

/// A list whose items are not all the same.
pub(super) fn list(names: &Names<'_>, versions: Vec<(usize, Vec<&Item>)>) -> Vec<Item> {
    let members: Vec<usize> = versions.iter().map(|(member, _)| *member).collect();
    let same = |one: &&Item, other: &&Item| one.depth == other.depth && is_version(&one.text, &other.text);
    let items = align(versions, same, |_, _| false);
    let items = items.iter().filter_map(|unit| {
        let (_, first) = unit.items.first()?;
        let texts: Vec<(usize, &str)> =
            unit.items.iter().map(|(member, item)| (*member, &*item.text)).collect();
        let text = names.remarked(&text(names, &texts), &unit.members(), &members);
        Some(Item { depth: first.depth, text })
    });
    items.collect()
}

/// Text with each sentence once; one that not all have says who has it.
pub(super) fn text(names: &Names<'_>, versions: &[(usize, &str)]) -> String {
    let members: Vec<usize> = versions.iter().map(|(member, _)| *member).collect();
    let sentences = versions.iter().map(|(member, text)| (*member, sentences(text)));
    let sentences = align(sentences, |one: &&str, other: &&str| one == other, opens_alike);
    let sentences = sentences.iter().filter_map(|unit: &Unit<&str>| {
        let (_, sentence) = unit.items.first()?;
        Some(names.remarked(sentence, &unit.members(), &members))
    });
    sentences.collect::<Vec<_>>().join(" ")
}

/// Whether two texts are versions of one: they open with the same sentence, or with the same label.
pub(super) fn is_version(one: &str, other: &str) -> bool {
    let label = |text: &str| text.find("**: ");
    let labelled = |end: usize| label(other) == Some(end) && one.get(..end) == other.get(..end);
    one == other || opening(one) == opening(other) || label(one).is_some_and(labelled)
}

/// The first sentence, up to its full stop. What holds for some axes only stands in a span, and where it is from in small
/// print: each is in one sentence.
fn opening(text: &str) -> &str {
    const END: &str = "</span>";
    let closes = |part: &str, open, close| part.matches(open).count() == part.matches(close).count();
    let is_whole =
        |part: &&str| !part.contains('<') || (closes(part, "<span", END) && closes(part, "<sub>", "</sub>"));
    let mut parts = text.match_indices('.').filter_map(|(stop, _)| {
        let (part, rest) = text.split_at(stop + 1);
        match rest.strip_prefix(END) {
            Some(rest) if rest.starts_with(' ') => text.get(..stop + 1 + END.len()),
            _ => rest.starts_with(' ').then_some(part),
        }
    });
    parts.find(is_whole).unwrap_or(text)
}

/// Sentences by their full stops.
fn sentences(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text;
    loop {
        let sentence = opening(rest);
        found.push(sentence);
        let Some(after) = rest.get(sentence.len()..).filter(|after| !after.is_empty()) else { return found };
        rest = after.trim_start();
    }
}

/// Whether two sentences begin with the same word.
fn opens_alike(one: &&str, other: &&str) -> bool {
    one.split(' ').next() == other.split(' ').next()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::markdown::holds::Form;

    #[test]
    fn a_sentence_that_not_all_have_says_who_has_it() {
        let names = ["A".to_owned(), "B".to_owned()];
        let item = |text: &str| Item { depth: 0, text: text.to_owned() };
        let lists = [item("**x**: One. Mapped in 1. Last."), item("**x**: One. Mapped in 2. Last.")];
        let [one, other] = &lists;
        assert_eq!(
            list(&Names::new(&names, Form::Text), vec![(0, vec![one]), (1, vec![other])]),
            [item("**x**: One. Mapped in 1. *(A)* Mapped in 2. *(B)* Last.")]
        );
        let (a, b) = (item("a"), item("b"));
        assert_eq!(
            list(&Names::new(&names, Form::Text), vec![(0, vec![&a, &b]), (1, vec![&b])]),
            [item("a *(A)*"), item("b")]
        );
    }
}
