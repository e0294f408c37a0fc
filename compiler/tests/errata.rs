//! The errata of the shipped descriptions answer what rules find in the manuals: without them, each finding is
//! there again, no more and no less.

#![cfg(test)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use devc::source::Disk;

/// How often each rule is named.
type Counts = BTreeMap<String, usize>;

/// The findings in a copy of a description from which the errata were taken, and those errata.
fn without_errata(name: &str) -> (Counts, Counts) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(name);
    let copy = tempfile::tempdir().expect("a temporary folder");
    let mut errata = Counts::new();
    for entry in fs::read_dir(&folder).expect("the description is there") {
        let path = entry.expect("an entry").path();
        let text = fs::read_to_string(&path).expect("a file");
        let kept = match path.file_name() {
            Some(file) if file == "errata.toml" => {
                for line in text.lines().filter_map(|line| line.strip_prefix("rule")) {
                    let rule = line.trim_start_matches([' ', '=']).trim_matches('"');
                    *errata.entry(rule.to_owned()).or_default() += 1;
                }
                String::new()
            }
            _ => text,
        };
        fs::write(copy.path().join(path.file_name().expect("a name")), kept).expect("a file");
    }
    let compilation = devc::compile(&Disk, copy.path());
    let mut findings = Counts::new();
    for diagnostic in compilation.diagnostics.iter() {
        *findings.entry(diagnostic.rule.name.to_owned()).or_default() += 1;
    }
    (findings, errata)
}

#[test]
fn each_erratum_answers_one_finding() {
    for name in ["c887", "s700", "pmc-sc6"] {
        let (findings, errata) = without_errata(name);
        assert_eq!(findings, errata, "{name}");
        assert!(!errata.is_empty(), "{name} has errata");
    }
}

/// A device of two axes with a misprint of each kind.
const MISPRINTED: &str = r#"
[device]
name = "Example"
vendor = "Example"
profile = 402

[identity]
vendor-id = 0x76D
product-code = 3
revision = 1

[objects.0x2000]
name = "Gains"
[objects.0x2000.entries]
0 = { default = 5 }
"1..=4" = { name = "Gain {}", type = "UINT16", default = 9, max = 8 }

[objects.0x6041]
name = "Statusword"
type = "UINT16"

[words.statusword]
bits.3 = { name = "fault", reserved = true, rising = "Something went wrong." }

[states]
fault = { name = "Fault", pattern = "x0xx 1000" }

[transitions]
1 = { to = "fault", pattern = "xxxx xx0x", automatic = true }

[errors]
0x3130 = { name = "Phase lost", register = 0x81, vendor-codes = [4, 5] }
"#;

fn corrected(errata: &str) -> devc::model::Device {
    let text = format!("{MISPRINTED}\n{errata}");
    let memory = devc::source::Memory::default().with("example/device.toml", text.into_bytes());
    let mut levels = devc::lint::Levels::default();
    for group in ["dictionary", "values", "state-machine", "process-data", "facts", "output"] {
        levels.set(group, devc::diagnostic::Level::Allow, None);
    }
    let request = devc::Request { levels, ..devc::Request::default() };
    let compilation = devc::compile_with(&memory, Path::new("example"), &request, &mut |_| ());
    let messages: Vec<_> = compilation.diagnostics.iter().map(|message| &message.message).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{messages:?}"));
    family.members[0].clone()
}

#[test]
fn outputs_get_what_holds() {
    use devc::model::{Address, Index, Provenance, provenance};
    let device = corrected(
        r#"
        [[errata]]
        rule = "contradicted-count"
        at = "0x2000:00"
        says = { default = 5 }
        holds = { default = 4 }
        why = "four follow"

        [[errata]]
        rule = "unreachable-default"
        at = "0x2000:02"
        says = { default = 9 }
        holds = { default = 7 }
        why = "a slip"

        [[errata]]
        rule = "meaningful-reserved-bit"
        at = "words.statusword.3"
        says = { reserved = true }
        holds = {}
        why = "the text uses it"

        [[errata]]
        rule = "commanded-automatic-transition"
        at = "transitions.1"
        says = { pattern = "xxxx xx0x", automatic = true }
        holds = { automatic = false }
        why = "no bit sets it off"

        [[errata]]
        rule = "misclassified-error"
        at = "errors.12592"
        says = { register = 0x81, vendor-codes = [4, 5] }
        why = "nobody knows"

        [[errata]]
        rule = "placeholder-identity"
        at = "identity.revision"
        says = 1
        holds = 2
        why = "the second edition"
        "#,
    );
    let entry = |subindex| device.entry(Address { index: Index(0x2000), subindex }).expect("an entry");
    let default = |subindex| entry(subindex).default.as_ref().and_then(devc::model::Value::integer);
    assert_eq!([0, 1, 2, 3, 4].map(default), [4, 9, 7, 9, 9].map(Some));
    assert_eq!(entry(2).name, "Gain 2");
    assert_eq!(provenance(&entry(2).origin, "default"), Provenance::Corrected(1));
    assert_eq!(provenance(&entry(3).origin, "default"), Provenance::Stated);
    assert!(!device.words[0].fields[0].reserved);
    let transition = &device.transitions[0];
    assert_eq!((transition.automatic, &transition.pattern), (false, &None));
    let error = &device.errors[0];
    assert_eq!(error.register, Some(0x81), "what is contradicted stays");
    assert_eq!(provenance(&error.origin, "register"), Provenance::Contradicted(4));
    assert_eq!(provenance(&error.origin, "name"), Provenance::Stated);
    assert_eq!(device.identity.revision, 2);
    assert_eq!(provenance(&device.identity.origin, "revision"), Provenance::Corrected(5));
}

/// The rows of a list have no keys: errata count them from 0.
#[test]
fn a_row_of_a_list_has_its_erratum() {
    use devc::model::{Provenance, facts};
    let device = corrected(
        r#"
        [[master-settings]]
        name = "Watchdog"
        value = "on"

        [[master-settings]]
        name = "Cycle"
        value = "1 ms"
        per-axis = true

        [[errata]]
        rule = "placeholder-identity"
        at = "master-settings.1"
        says = { per-axis = true }
        why = "nobody knows"
        "#,
    );
    let who = |place: usize| facts(&device.master_settings[place].origin);
    assert!(who(0).iter().all(|(_, who)| *who == Provenance::Stated), "{:?}", who(0));
    assert!(who(1).contains(&("per-axis".to_owned(), Provenance::Contradicted(0))), "{:?}", who(1));
}

/// What devc says of a description with these errata, as far as it is about those.
fn answered(errata: &str) -> Vec<String> {
    let text = format!("{MISPRINTED}\n{errata}");
    let memory = devc::source::Memory::default().with("example/device.toml", text.into_bytes());
    let compilation = devc::compile(&memory, Path::new("example"));
    let messages = compilation.diagnostics.iter().map(|message| message.message.clone());
    messages.filter(|message| message.contains("two errata") || message.contains("the erratum")).collect()
}

/// A fact has one mark: that of a second erratum would hide the first.
#[test]
fn a_key_has_one_erratum() {
    let erratum = |at: &str, keys: &str| {
        format!("[[errata]]\nrule = \"placeholder-identity\"\nat = \"{at}\"\nwhy = \"a slip\"\n{keys}\n")
    };
    let pair = |at: &str, first: &str, second: &str| {
        answered(&[first, second].map(|keys| erratum(at, keys)).concat())
    };
    let repeated = |at: &str| vec![format!("two errata are about the same key at {at}")];
    for (at, first, second) in [
        ("identity.revision", "says = 1\nholds = 2", "says = 1\nholds = 3"),
        ("identity.revision", "says = 1\nholds = 2", "says = 1"),
        ("identity.revision", "says = 1", "says = 1"),
        ("errors.0x3130", "says = { register = 0x81 }\nholds = {}", "says = { register = 0x81 }"),
        ("errors.0x3130", "says = { name = \"Phase lost\", register = 0x81 }", "says = { register = 0x81 }"),
        ("errors.0x3130", "says = { }\nholds = { about = \"a\" }", "says = {}\nholds = { about = \"b\" }"),
    ] {
        assert_eq!(pair(at, first, second), repeated(at), "{first} {second}");
    }
    for (at, first, second) in [
        ("identity.revision", "says = 1\nholds = 2", "says = {}"),
        ("identity.revision", "says = {}", "says = 1\nholds = 2"),
        ("identity.revision", "says = 1\nstands = true", "says = 1\nstands = true"),
        ("errors.0x3130", "says = { name = \"Phase lost\" }", "says = { register = 0x81 }"),
    ] {
        assert!(pair(at, first, second).is_empty(), "{first} {second}: {:?}", pair(at, first, second));
    }
}
