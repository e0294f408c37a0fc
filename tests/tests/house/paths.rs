//! The paths in code that begin in the crate.

use crate::code::Code;

/// A path as it is written, in its parts, and where it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Written<'c> {
    pub(crate) parts: Vec<&'c str>,
    /// The name that it gives to what it leads to.
    pub(crate) name: &'c str,
    pub(crate) offset: usize,
    /// Whether it is a `pub use`, so that its name can be found here.
    pub(crate) exported: bool,
}

/// All paths that begin with `crate`, `self` or `super`, and those of each `pub use`.
pub(crate) fn written(code: &Code) -> Vec<Written<'_>> {
    let tokens = code.tokens();
    let mut found = Vec::new();
    let mut place = 0;
    while let Some((word, _)) = tokens.get(place) {
        let before = |back: usize| place.checked_sub(back).map_or("", |place| tokens[place].0);
        let exported = before(1) == "use" && is_public(&tokens[..place - 1]);
        let starts = ["crate", "self", "super"].contains(word) && !["$", "::"].contains(&before(1));
        let is_path = tokens.get(place + 1).is_some_and(|(next, _)| *next == "::");
        if exported || starts && is_path {
            place = tree(&tokens, place, &[], exported, &mut found);
        } else {
            place += 1;
        }
    }
    found
}

/// Whether what follows these words is public, be it to all or to some.
fn is_public(before: &[(&str, usize)]) -> bool {
    let words: Vec<&str> =
        before.iter().rev().take_while(|(word, _)| *word != ";").map(|(word, _)| *word).collect();
    match words.as_slice() {
        ["pub", ..] => true,
        [")", rest @ ..] => {
            let open = rest.iter().position(|word| *word == "(");
            open.and_then(|open| rest.get(open + 1)) == Some(&"pub")
        }
        _ => false,
    }
}

/// Reads a path, or those of a tree such as `a::{b, c as d}`, and tells where it ends.
fn tree<'c>(
    tokens: &[(&'c str, usize)],
    mut place: usize,
    before: &[&'c str],
    exported: bool,
    found: &mut Vec<Written<'c>>,
) -> usize {
    let mut parts = before.to_vec();
    let offset = tokens.get(place).map_or(0, |(_, offset)| *offset);
    let word = |place: usize| tokens.get(place).map_or("", |(word, _)| *word);
    loop {
        if word(place) == "{" {
            place += 1;
            while !["}", ""].contains(&word(place)) {
                place = tree(tokens, place, &parts, exported, found);
                place += usize::from(word(place) == ",");
            }
            return place + 1;
        }
        parts.push(word(place));
        place += 1;
        let goes_on = word(place) == "::" && (word(place + 1) == "{" || is_name(word(place + 1)));
        if !goes_on {
            break;
        }
        place += 1;
    }
    let alias = (word(place) == "as").then(|| word(place + 1));
    place += if alias.is_some() { 2 } else { 0 };
    if parts.len() > 1 && parts.last() == Some(&"self") {
        parts.pop();
    }
    let name = alias.or(parts.last().copied()).unwrap_or_default();
    found.push(Written { parts, name, offset, exported });
    place
}

fn is_name(word: &str) -> bool {
    word == "*" || word.starts_with(|char: char| char.is_alphabetic() || char == '_')
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn paths(text: &str) -> Vec<String> {
        let code = Code::new(Path::new("a.rs"), text);
        written(&code).iter().map(|path| format!("{} {}", path.parts.join("::"), path.name)).collect()
    }

    #[test]
    fn trees_are_many_paths() {
        let text = "use crate::a::{self, b::C, d::{E as F}};\nuse std::fmt;";
        assert_eq!(paths(text), ["crate::a a", "crate::a::b::C C", "crate::a::d::E F"]);
    }

    #[test]
    fn paths_in_code_count() {
        assert_eq!(
            paths("fn a(b: super::C) -> D { crate::e::f::<G>(self.h) }"),
            ["super::C C", "crate::e::f f"]
        );
        assert_eq!(paths("$crate::a::b"), [""; 0]);
    }

    #[test]
    fn what_is_exported_can_begin_anywhere() {
        assert_eq!(
            paths("pub use a::B; pub(in crate::x) use c::d; use e::f;"),
            ["a::B B", "crate::x x", "c::d d"]
        );
    }
}
