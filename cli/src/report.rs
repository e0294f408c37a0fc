//! What a run says: results on the standard output, messages on the standard error.

use std::cell::RefCell;
use std::io::{self, ErrorKind, IsTerminal, Write};

use clap::ColorChoice;
use devc::Compilation;
use devc::diagnostic::render::{Style, text};
use devc::diagnostic::{Diagnostics, Level};
use devc::source::Sources;
use devc::text::characters::line;

use super::outcome::{Failure, Outcome, reason};

/// Where results and messages go.
pub(super) struct Report {
    style: Style,
    /// Whether what went well is not said.
    quiet: bool,
    /// Why nothing more can be written to the standard output; the work goes on all the same.
    lost: RefCell<Option<io::Error>>,
}

impl Report {
    /// Colours as asked for; `auto` means on a terminal that has them and whose user does not mind
    /// (<https://no-color.org>).
    pub(super) fn new(choice: ColorChoice, quiet: bool) -> Self {
        let wanted = match choice {
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto => {
                let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
                let dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
                io::stderr().is_terminal() && !refused && !dumb
            }
        };
        let style = if wanted { Style::Colour } else { Style::Plain };
        Self { style, quiet, lost: RefCell::new(None) }
    }

    /// Prints what was done as one line, whatever is in the names that it holds.
    pub(super) fn line(&self, text: &str) {
        if !self.quiet {
            self.output(&format!("{}\n", line(text)));
        }
    }

    /// Whether the standard output is a terminal whose cursor can be moved, and what is done is said.
    pub(super) fn is_live(&self) -> bool {
        let dumb = std::env::var_os("TERM").is_none_or(|value| value.is_empty() || value == "dumb");
        !self.quiet && !dumb && io::stdout().is_terminal()
    }

    /// Whether nobody reads the standard output any more.
    pub(super) fn is_lost(&self) -> bool {
        self.lost.borrow().is_some()
    }

    /// Prints a result of lines that end themselves, and that hold nothing which a terminal would obey.
    pub(super) fn output(&self, text: &str) {
        let mut lost = self.lost.borrow_mut();
        if lost.is_none() {
            let mut out = io::stdout().lock();
            *lost = write!(out, "{text}").and_then(|()| out.flush()).err();
        }
    }

    /// The end of a run, worse if not all results could be said. A reader that has gone wanted no more of them.
    pub(super) fn end(&self, outcome: Outcome) -> Outcome {
        match &*self.lost.borrow() {
            Some(error) if error.kind() != ErrorKind::BrokenPipe => {
                let what = format!("cannot write to the standard output: {}", reason(error));
                self.failure(&Failure::new(what))
            }
            _ => outcome,
        }
    }

    /// Prints a message. If even the standard error is closed, the exit code has to do.
    pub(super) fn message(&self, text: &str) {
        let _ = writeln!(io::stderr().lock(), "{text}");
    }

    /// Prints the messages about a description.
    pub(super) fn diagnostics(&self, compilation: &Compilation) {
        self.found(&compilation.diagnostics, &compilation.sources);
    }

    /// Prints messages about texts.
    pub(super) fn found(&self, diagnostics: &Diagnostics, sources: &Sources) {
        for diagnostic in diagnostics.iter().filter(|diagnostic| diagnostic.level != Level::Allow) {
            self.message(&format!("{}\n", text(diagnostic, sources, self.style)));
        }
    }

    /// Prints an error that is about no place in a description.
    pub(super) fn error(&self, what: &str, help: Option<&str>) {
        let (red, blue, bold, reset) = match self.style {
            Style::Colour => ("\u{1b}[1m\u{1b}[91m", "\u{1b}[1m\u{1b}[94m", "\u{1b}[1m", "\u{1b}[0m"),
            Style::Plain => ("", "", "", ""),
        };
        let mut text = format!("{red}error{reset}{bold}: {}{reset}", line(what));
        if let Some(help) = help {
            text += &format!("\n  {blue}= {reset}{bold}help{reset}: {}", line(help));
        }
        self.message(&text);
    }

    /// Prints why devc could not do its work.
    pub(super) fn failure(&self, failure: &Failure) -> Outcome {
        failure.choices.iter().for_each(|choice| self.message(choice));
        self.error(&failure.what, failure.help.as_deref());
        Outcome::Failed
    }
}

/// What the messages about a description make of the run.
pub(super) fn verdict(compilation: &Compilation, deny_warnings: bool) -> Outcome {
    let diagnostics = &compilation.diagnostics;
    if compilation.files.is_empty() {
        return Outcome::Failed;
    }
    if diagnostics.has_errors() || deny_warnings && diagnostics.count(Level::Warning) > 0 {
        return Outcome::Findings;
    }
    Outcome::Clean
}

/// How many messages there are, as in `2 errors, 1 warning`; `None` if there are none.
pub(super) fn counts(diagnostics: &Diagnostics) -> Option<String> {
    let counts = [(Level::Error, "error"), (Level::Warning, "warning")].map(|(level, noun)| {
        let count = diagnostics.count(level);
        (count > 0).then(|| number(count, noun))
    });
    let counts: Vec<String> = counts.into_iter().flatten().collect();
    (!counts.is_empty()).then(|| counts.join(", "))
}

/// A number with its noun.
pub(super) fn number(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
