//! The layout against `rustfmt`'s, and the tokens against those of the sources.

use std::path::Path;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::laid_out;

fn lexed(code: &str) -> TokenStream {
    code.parse().expect("the code has tokens")
}

/// Code as `rustfmt` writes it, but for lists of names, comes out as it went in.
#[test]
fn the_layout_is_that_of_rustfmt() {
    let sample = include_str!("sample.txt");
    let text = laid_out(lexed(sample));
    for (number, (ours, expected)) in (1..).zip(text.lines().zip(sample.lines())) {
        assert_eq!(ours, expected, "line {number}");
    }
    assert_eq!(text.len(), sample.len());
}

#[test]
fn laid_out_code_stays_as_it_is() {
    each_source(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src/emit")), &mut |code, path| {
        let text = laid_out(lexed(code));
        assert_eq!(laid_out(lexed(&text)), text, "{}", path.display());
    });
}

#[test]
fn the_text_has_the_tokens() {
    each_source(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src")), &mut |code, path| {
        let text = laid_out(lexed(code));
        let (mut expected, mut ours) = (Vec::new(), Vec::new());
        words(lexed(code), &mut expected);
        words(lexed(&text), &mut ours);
        for (number, (ours, expected)) in ours.iter().zip(&expected).enumerate() {
            assert_eq!(ours, expected, "word {number} of {}", path.display());
        }
        assert_eq!(ours.len(), expected.len(), "{}", path.display());
    });
}

#[test]
fn no_line_ends_with_a_space() {
    each_source(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src/model")), &mut |code, path| {
        let text = laid_out(lexed(code));
        let line = text.lines().find(|line| line.trim_end() != *line);
        assert_eq!(line, None, "{}", path.display());
    });
}

#[test]
fn what_macros_are_given_keeps_each_comma() {
    for code in [
        "a!(1, 2,);",
        "a![(1,), [2, 3,],];",
        "a! { x, y, }",
        "a! {\n    fn f(x: u8,) {}\n\n    struct B {\n        b: u8\n    }\n}",
    ] {
        let text = laid_out(lexed(code));
        assert_eq!(lexed(&text).to_string(), lexed(code).to_string());
    }
}

fn each_source(folder: &Path, check: &mut impl FnMut(&str, &Path)) {
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("the entry is there").path();
        if path.is_dir() {
            each_source(&path, check);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            check(&std::fs::read_to_string(&path).expect("the source is text"), &path);
        }
    }
}

/// The tokens but for the commas that change nothing: behind the last item, and behind the block of an arm.
fn words(stream: TokenStream, words: &mut Vec<String>) {
    let mut trees = stream.into_iter().peekable();
    let mut is_behind_block = false;
    while let Some(tree) = trees.next() {
        let is_comma = matches!(&tree, TokenTree::Punct(punct) if punct.as_char() == ',');
        let closes = |tree: &TokenTree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == '>');
        if is_comma && (is_behind_block || trees.peek().is_none_or(closes)) {
            continue;
        }
        is_behind_block = false;
        match tree {
            TokenTree::Group(group) => {
                let (opening, closing) = match group.delimiter() {
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::Parenthesis | Delimiter::None => ("(", ")"),
                };
                is_behind_block = opening == "{";
                words.push(opening.to_owned());
                self::words(group.stream(), words);
                words.push(closing.to_owned());
            }
            other => words.push(other.to_string()),
        }
    }
}
