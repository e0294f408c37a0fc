//! What the examples of rules leave open: other faults that a rule finds, and what is close to one but none.
//!
//! In the files of `more/`, a line `#! rule` begins a description, and a line `#= text` says what a message about it
//! contains, a line a message, to which lines `#& text` add, and `#~ text` what it does not contain; without one, nothing may
//! be said.

use std::fs;
use std::path::Path;

use crate::example::{compiled, messages};
use crate::rules;

struct Case<'t> {
    rule: &'t str,
    description: &'t str,
    said: Vec<Said<'t>>,
}

/// What a message contains, and what it does not.
struct Said<'t> {
    with: Vec<&'t str>,
    without: Vec<&'t str>,
}

impl Said<'_> {
    fn is_in(&self, message: &str) -> bool {
        self.with.iter().all(|text| message.contains(text))
            && !self.without.iter().any(|text| message.contains(text))
    }
}

fn cases(text: &str) -> impl Iterator<Item = Case<'_>> {
    text.split("#! ").skip(1).map(|case| {
        let (rule, description) = case.split_once('\n').expect("a description");
        let mut said: Vec<Said<'_>> = Vec::new();
        for (mark, text) in description.lines().filter_map(|line| line.split_once(' ')) {
            match (mark, said.last_mut()) {
                ("#=", _) => said.push(Said { with: vec![text], without: Vec::new() }),
                ("#&", Some(last)) => last.with.push(text),
                ("#~", Some(last)) => last.without.push(text),
                _ => {}
            }
        }
        Case { rule, description, said }
    })
}

/// Why a case does not hold, if it does not.
fn fault(Case { rule, description, said }: &Case<'_>) -> Option<String> {
    let found: Vec<&str> = compiled(rule, description).diagnostics.iter().map(|it| it.rule.name).collect();
    let messages = messages(rule, description);
    let holds = found.len() == said.len()
        && found.iter().all(|name| name == rule)
        && messages.iter().zip(said).all(|(message, said)| said.is_in(message));
    (!holds).then(|| format!("#! {rule}\n{description}\nfound:\n\n{}", messages.join("\n\n")))
}

#[test]
fn rules_find_this_and_no_more() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/rules/more");
    let mut wrong = Vec::new();
    for file in fs::read_dir(folder).expect("the folder") {
        let text = fs::read_to_string(file.expect("a file").path()).expect("text");
        for case in cases(&text) {
            assert!(rules().any(|rule| rule.name == case.rule), "there is no rule {}", case.rule);
            wrong.extend(fault(&case));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
