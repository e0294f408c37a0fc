//! What an editor asks while somebody writes: texts that are half there, and places anywhere in them.

use std::ops::Range;

use bolero::TypeGenerator;
use devc::assist::{Definition, Renaming};
use devc::assist::{Knowledge, Symbol, complete, define, hover, name_at, rename, symbols};

use crate::edits::{Edit, edited, few};
use crate::run::holds;
use crate::subjects::{Files, compile, small};

/// A description that somebody edits, and where the cursor is.
#[derive(Debug, TypeGenerator)]
struct Input {
    subject: u16,
    #[generator(few())]
    before: Vec<Edit>,
    /// What came since it was compiled last.
    #[generator(few())]
    since: Vec<Edit>,
    file: u8,
    at: u16,
    choice: u8,
}

#[test]
fn questions() {
    holds("questions", 150, |input: &Input| {
        let files = edited(small(input.subject), &input.before);
        let knowledge = Knowledge::of(&compile(&files));
        let files = edited(&files, &input.since);
        let text = files.values().nth(usize::from(input.file) % files.len()).expect("a file");
        // often in a text, now and then behind its end or within a character
        let at = usize::from(input.at) % (text.len() + 4);
        let is_in = |range: &Range<usize>| text.get(range.clone()).is_some();
        let knowledge = knowledge.as_ref();
        let completions = complete(text, at, knowledge);
        for completion in &completions {
            assert!(is_in(&completion.replaces) && !completion.label.is_empty(), "{completion:?} at {at}");
        }
        if let Some(hover) = hover(text, at, knowledge) {
            assert!(is_in(&hover.at) && !hover.text.is_empty(), "{hover:?} at {at}");
        }
        if let (Some(Definition::At(place)), Some(knowledge)) = (define(text, at, knowledge), knowledge) {
            assert!(knowledge.sources().slice(place).is_some(), "{place:?}");
        }
        are_nested(text, &symbols(text), 0..text.len());
        is_renamed(&files, text, at, knowledge);
        // what is chosen is there, and is no reason to fall over
        if let Some(chosen) = completions.get(usize::from(input.choice)) {
            let mut text = text.clone();
            text.replace_range(chosen.replaces.clone(), &chosen.text);
            complete(&text, chosen.replaces.start + chosen.text.len(), knowledge);
            hover(&text, chosen.replaces.start, knowledge);
        }
    });
}

/// Symbols lie in the text, and what is inside of one lies in it.
fn are_nested(text: &str, all: &[Symbol], within: Range<usize>) {
    for symbol in all {
        assert!(
            text.get(symbol.at.clone()).is_some() && text.get(symbol.name_at.clone()).is_some(),
            "{symbol:?}"
        );
        assert!(within.start <= symbol.at.start && symbol.at.end <= within.end, "{symbol:?} in {within:?}");
        are_nested(text, &symbol.inside, symbol.at.clone());
    }
}

/// What has another name and then its own again is what it was.
fn is_renamed(files: &Files, text: &str, at: usize, knowledge: Option<&Knowledge>) {
    const OTHER: &str = "quite-another-name";
    let Ok(Some((range, word))) = name_at(text, at, knowledge) else { return };
    assert_eq!(text.get(range.clone()), Some(word.as_str()));
    let texts: Vec<&str> = files.values().map(String::as_str).collect();
    let Ok(renamings) = rename(text, at, OTHER, &texts, knowledge) else { return };
    let new: Files =
        files.iter().zip(&renamings).map(|((name, text), edits)| (name.clone(), with(text, edits))).collect();
    let place = texts.iter().position(|one| *one == text).expect("it is one of them");
    let before = renamings[place].iter().filter(|(at, _)| at.end <= range.start);
    let moved = before.map(|(at, text)| text.len() as isize - at.len() as isize).sum::<isize>();
    let at = range.start.checked_add_signed(moved).expect("it is in the text");
    let renamed = new.values().nth(place).expect("a file");
    let knowledge = Knowledge::of(&compile(&new));
    let texts: Vec<&str> = new.values().map(String::as_str).collect();
    if let Ok(back) = rename(renamed, at, &word, &texts, knowledge.as_ref()) {
        for ((old, new), edits) in files.values().zip(new.values()).zip(&back) {
            assert_eq!(*old, with(new, edits), "`{word}` at {at}");
        }
    }
}

fn with(text: &str, edits: &Renaming) -> String {
    let mut edits = edits.clone();
    edits.sort_by_key(|(at, _)| at.start);
    let mut text = text.to_owned();
    for (at, new) in edits.into_iter().rev() {
        text.replace_range(at, &new);
    }
    text
}
