//! `devc fmt` changes how a description is written, never what it says.

use std::path::Path;

use bolero::TypeGenerator;
use devc::emit::{self, Options};
use devc::format::format;

use crate::edits::{Edit, Layout, edited, few, laid};
use crate::run::holds;
use crate::subjects::{ALL, Files, SHIPPED, compile, small, subject};

/// A description that somebody edited, and laid out otherwise.
#[derive(Debug, TypeGenerator)]
struct Input {
    subject: u16,
    #[generator(few())]
    edits: Vec<Edit>,
    layout: Vec<(u8, u16, Layout)>,
}

/// Each file is TOML and laid out in one step, or it is refused; and it means what it meant.
#[test]
fn layouts() {
    holds("layouts", 60, |input: &Input| {
        means_the_same(&laid(&edited(small(input.subject), &input.edits), &input.layout));
    });
}

/// As they are: each third, as it takes long.
#[test]
fn subjects_mean_the_same() {
    assert!(ALL.len() > 100, "{}", ALL.len());
    ALL.iter().skip(SHIPPED).step_by(3).for_each(means_the_same);
}

/// Layout alone, of what is shipped as well.
#[test]
fn large_layouts() {
    holds("large_layouts", 100, |input: &Input| {
        laid_out(&laid(&edited(subject(input.subject), &input.edits), &input.layout));
    });
}

fn means_the_same(files: &Files) {
    let new = laid_out(files);
    if *files != new {
        let (before, after) = (meaning(files), meaning(&new));
        assert_eq!(before.0, after.0, "{new:#?}");
        assert!(before.1 == after.1, "the outputs differ of {new:#?}");
    }
}

/// Lays out all files that are TOML, and asserts that doing it again changes nothing. A picture is none, whatever is in it.
fn laid_out(files: &Files) -> Files {
    let lay_out = |(name, text): (&String, &String)| {
        let new = match format(name, text) {
            Ok(_) if !name.ends_with(".toml") => text.clone(),
            Ok(once) => {
                let twice = format(name, &once).map_err(|_| "what was laid out is TOML");
                assert_eq!(twice.as_ref(), Ok(&once), "{name} laid out twice, from\n{text}");
                once
            }
            Err((diagnostics, sources)) => {
                assert!(diagnostics.has_errors());
                assert!(diagnostics.iter().all(|it| it.at().is_none_or(|at| sources.slice(at).is_some())));
                text.clone()
            }
        };
        (name.clone(), new)
    };
    files.iter().map(lay_out).collect()
}

/// Everything that devc says of a description and makes of it, without the places in the text; in capitals, since
/// messages quote numbers as they are written. Marks of provenance are listed as the keys are written, so of outputs
/// for people it is all words, and of the ESI each byte.
fn meaning(files: &Files) -> (Vec<String>, Vec<String>) {
    let compilation = compile(files);
    let said = compilation.diagnostics.iter().map(|it| {
        let mut labels: Vec<&str> = it.labels.iter().map(|label| label.text.as_str()).collect();
        labels.sort_unstable();
        let helps: Vec<&str> = it.helps.iter().map(|help| help.text.as_str()).collect();
        let said =
            format!("{:?} {} {} {labels:?} {:?} {helps:?}", it.level, it.rule.name, it.message, it.notes);
        said.to_uppercase()
    });
    let mut said: Vec<String> = said.collect();
    said.sort();
    let made = compilation.family.as_ref().map(|family| emit::emit(family, emit::ALL, &Options::default()));
    let mut made: Vec<String> = made.into_iter().flat_map(|files| files.0).flat_map(words).collect();
    made.sort();
    (said, made)
}

fn words((name, content): (String, Vec<u8>)) -> Vec<String> {
    let text = String::from_utf8_lossy(&content).into_owned();
    if Path::new(&name).extension().is_some_and(|extension| extension == "xml") {
        return vec![text];
    }
    let words = text.split(|c: char| !c.is_alphanumeric()).map(str::to_uppercase);
    words.filter(|word| !word.is_empty()).collect()
}
