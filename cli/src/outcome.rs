//! How a run can end.

use std::io;
use std::path::Path;
use std::process::ExitCode;

/// The end of a run, the worse the later.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Outcome {
    /// All is well.
    Clean,
    /// devc found something that a person has to look at.
    Findings,
    /// devc could not do its work.
    Failed,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Clean => Self::from(0),
            Outcome::Findings => Self::from(1),
            Outcome::Failed => Self::from(2),
        }
    }
}

/// Why devc could not do its work.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Failure {
    /// What went wrong, in lower case.
    pub(super) what: String,
    /// What to do about it.
    pub(super) help: Option<String>,
    /// What can be chosen from, a line each, if that is what to do.
    pub(super) choices: Vec<String>,
}

impl Failure {
    pub(super) fn new(what: impl Into<String>) -> Self {
        Self { what: what.into(), help: None, choices: Vec::new() }
    }

    /// The system refused to do something with a file or folder.
    pub(super) fn at(doing: &str, path: &Path, error: &io::Error) -> Self {
        Self::new(format!("cannot {doing} `{}`: {}", path.display(), reason(error)))
    }

    #[must_use]
    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// With what can be chosen from.
    #[must_use]
    pub(super) fn choices(self, choices: &[String]) -> Self {
        Self { choices: choices.to_vec(), ..self }
    }

    /// With help, if there is any.
    #[must_use]
    pub(super) fn maybe_help(self, help: String) -> Self {
        if help.is_empty() { self } else { self.help(help) }
    }
}

/// What the system says, as part of a sentence.
pub(super) fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or(&text);
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| first.to_lowercase().chain(characters).collect())
}
