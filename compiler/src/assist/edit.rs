//! What renaming comes to: edits, or why there are none.

use std::ops::Range;

use super::spot::Spot;

/// The edits of one file: what to replace, in bytes, with what.
pub type Renaming = Vec<(Range<usize>, String)>;

/// Why something cannot have another name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal(pub String);

/// Where in a spot the word stands, without quotes and what is around it.
pub(super) fn inner(spot: &Spot, text: &str, word: &str) -> Option<Range<usize>> {
    let written = text.get(spot.at.clone())?;
    let places = written.match_indices(word).map(|(place, _)| place);
    let is_whole = |place: &usize| {
        let is_part = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
        let before = written.get(..*place).and_then(|before| before.chars().next_back());
        let behind = written.get(place + word.len()..).and_then(|behind| behind.chars().next());
        !before.is_some_and(is_part) && !behind.is_some_and(is_part)
    };
    let place = places.into_iter().find(is_whole)?;
    let start = spot.at.start + place;
    Some(start..start + word.len())
}
