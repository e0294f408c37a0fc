//! Meanings of values that stand in a comment, as devc writes them where ETG.2000 has no enumeration for a type.

use std::rc::Rc;

use super::esi::{Choice, Object, Shape};
use super::number::number;

/// What stands before them.
const BEFORE: &str = "Values: ";

/// Takes the meanings of values out of comments, for values that have none.
pub(super) fn take_out(object: &mut Object) {
    let values = object.values.iter_mut();
    let values: Vec<_> = values.filter(|it| it.subindex > 0 || object.shape == Shape::Var).collect();
    if object.shape != Shape::Record
        && values.iter().all(|value| value.choices.is_empty())
        && let Some((comment, choices)) = object.comment.as_deref().and_then(split)
    {
        object.comment = comment;
        values.into_iter().for_each(|value| value.choices = Rc::clone(&choices));
        return;
    }
    for value in values.into_iter().filter(|value| value.choices.is_empty()) {
        if let Some((comment, choices)) = value.comment.as_deref().and_then(split) {
            (value.comment, value.choices) = (comment, choices);
        }
    }
}

/// What a comment says before the meanings, and these: `Values: 0 = off; 1 = on.` at its end.
fn split(comment: &str) -> Option<(Option<String>, Rc<[Choice]>)> {
    let (before, list) = match comment.rsplit_once(&format!(" {BEFORE}")) {
        Some((before, list)) => (Some(before.to_owned()), list),
        None => (None, comment.strip_prefix(BEFORE)?),
    };
    let mut choices: Vec<Choice> = Vec::new();
    for piece in list.strip_suffix('.')?.split("; ") {
        let meaning = piece.split_once(" = ").and_then(|(value, name)| Some((number(value)?, name)));
        match (meaning, choices.last_mut()) {
            (Some((value, name)), _) => {
                choices.push(Choice { value, name: name.to_owned(), ..Choice::default() });
            }
            // A name that has the sign between meanings in it.
            (None, Some(last)) => last.name += &format!("; {piece}"),
            (None, None) => return None,
        }
    }
    Some((before, choices.into()))
}
