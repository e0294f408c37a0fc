//! What is far beyond what a drive needs is refused, by a message that names the limit, or answered in as many messages
//! as it is worth.

use devc::diagnostic::{Diagnostics, KEPT, Level};
use devc_tests::hostile::{HEAD, Kind, all};

use crate::compile;

fn kind(name: &str) -> &'static Kind {
    all().find(|kind| kind.name == name).expect("there is such a kind")
}

/// What devc says of so much of a kind.
fn said(name: &str, count: usize) -> Diagnostics {
    compile((kind(name).files)(count)).diagnostics
}

/// The limits that so much of a kind exceeds: each message with what the label says can be.
fn refused(name: &str, count: usize) -> Vec<(String, String)> {
    let said = said(name, count);
    let of_limits = said.iter().filter(|it| it.rule.name == "exceeded-limit");
    of_limits
        .map(|it| (it.message.clone(), it.labels.first().map_or("", |label| &label.text).to_owned()))
        .collect()
}

#[test]
fn a_limit_is_named_where_it_is_exceeded() {
    for (name, count, message, limit) in [
        ("members", 400, "400 members of a family are too many", "a family can have 256"),
        ("members", 2_000, "2000 members of a family are too many", "a family can have 256"),
        (
            "bits that there are not",
            100_000,
            "100000 keys in one table are too many",
            "a table like this can have 4096",
        ),
        ("states of one pattern", 6_000, "`[states]` has 6000 tables", "it can have 1024"),
        ("elements of an array", 5_000, "5000 elements of one array are too many", "an array can have 4096"),
        ("letters of a key", 100, "a key of 2000 bytes is too long", "a key can have 255 bytes"),
        ("letters of a name", 10_000, "a text of 200000 bytes is too long", "a text can have 65536 bytes"),
        ("brackets in brackets", 100, "tables and arrays lie more than 32 deep in one another", "too deep"),
        ("dots in a header", 100, "tables and arrays lie more than 32 deep in one another", "too deep"),
    ] {
        let refused = refused(name, count);
        let found = refused.iter().any(|(said, label)| (said.as_str(), label.as_str()) == (message, limit));
        assert!(found, "{count} {name}: {refused:?}");
    }
}

#[test]
fn files_are_limited_whether_they_are_there_or_not() {
    for name in ["includes", "includes that are missing", "includes of one file"] {
        let refused = refused(name, 3_000);
        let (message, label) = refused.first().unwrap_or_else(|| panic!("3000 {name} are read"));
        assert_eq!(
            (message.as_str(), label.as_str()),
            ("the description includes too many files", "a description can have 1000")
        );
    }
}

/// What a short text asks for is counted before it is made.
#[test]
fn what_a_few_lines_ask_for_is_limited() {
    for (name, count) in [
        ("members with much in common", 15_000),
        ("objects that are like a large one", 15_000),
        ("ranges of all subindices", 5_000),
        ("letters in texts for all subindices", 50_000),
    ] {
        assert!(!refused(name, count).is_empty(), "{count} {name} are taken");
    }
}

#[test]
fn what_is_within_a_limit_is_read() {
    for (name, count) in [
        ("members", 256),
        ("states", 1_000),
        ("objects", 10_000),
        ("includes", 1_000),
        ("elements of an array", 4_096),
        ("letters of a name", 3_000),
    ] {
        assert_eq!(refused(name, count), [], "{count} {name}");
    }
}

/// However many faults there are, devc keeps so many messages of a rule, and the number of the others.
#[test]
fn messages_are_kept_up_to_a_number_and_the_others_counted() {
    for (name, count) in
        [("lines without a key", 50_000), ("the same key again", 50_000), ("words that are nothing", 50_000)]
    {
        let said = said(name, count);
        assert!(said.iter().count() <= 3 * (KEPT + 1), "{name}: {}", said.iter().count());
        assert!(said.count(Level::Error) >= count - 1, "{name}: {}", said.count(Level::Error));
        let rest = said.iter().find(|it| it.count > 1).expect("one message stands for the others");
        assert_eq!(rest.message, format!("and {} more of these", rest.count), "{name}");
    }
}

/// A state is reported once, not once for each that it overlaps.
#[test]
fn rules_that_compare_report_each_thing_once() {
    for (name, rule) in [
        ("states of one pattern", "overlapping-states"),
        ("commands of one pattern", "hidden-command"),
        ("objects of one name", "ambiguous-name"),
        ("ranges of errors across each other", "repeated-error"),
    ] {
        let said = said(name, 500);
        let count = said.iter().filter(|it| it.rule.name == rule).count();
        assert!(count < 500, "{name}: {count} messages of {rule}");
    }
}

/// The head that all kinds have is a description without a fault of its own, so that what is found is theirs.
#[test]
fn the_head_is_sound() {
    let compilation = compile(vec![("device.toml".to_owned(), HEAD.to_owned())]);
    assert_eq!(compilation.diagnostics.count(Level::Error), 0);
}
