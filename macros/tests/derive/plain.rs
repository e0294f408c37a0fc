//! Messages of rustc without what changes from run to run or with the runtime: the numbers of its lines, with them the
//! width of the margin, how many types have a trait, and where the names of types are that are too long.

/// The messages without the summary behind them.
pub(crate) fn plain(messages: &str) -> String {
    let is_summary = |message: &str| {
        ["error: aborting", "Some errors have", "For more information"]
            .iter()
            .any(|start| message.starts_with(start))
    };
    let messages = messages.trim_end().split("\n\n").filter(|message| !is_summary(message));
    messages.map(plain_message).collect::<Vec<_>>().join("\n")
}

/// A message with its notes, which all have the same margin.
fn plain_message(message: &str) -> String {
    let margin = message.lines().find_map(|line| line.find("--> ")).unwrap_or(0);
    let mut lines: Vec<Line<'_>> = message.lines().map(|line| Line::of(line, margin)).collect();
    lines.retain(|line| !line.is_about_long_names());
    let mut is_runtime = false;
    for line in &mut lines {
        if let Some(place) = line.place() {
            is_runtime = place.starts_with("runtime/");
        } else if line.is_head() {
            is_runtime = false;
        }
        if is_runtime {
            line.forget_number();
        }
    }
    let width = lines.iter().filter_map(|line| line.margin).map(str::len).max().unwrap_or(0).max(1);
    lines.iter().map(|line| line.shown(width.min(margin))).collect()
}

/// A line of a message.
struct Line<'m> {
    /// The number in the margin, if there is a margin.
    margin: Option<&'m str>,
    /// What is behind it.
    text: &'m str,
}

impl<'m> Line<'m> {
    fn of(line: &'m str, margin: usize) -> Self {
        match line.split_at_checked(margin) {
            Some((number, text)) if number.chars().all(|c| c == ' ' || c.is_ascii_digit()) => {
                Self { margin: Some(number.trim_end()), text }
            }
            _ => Self { margin: None, text: line },
        }
    }

    /// The place in a file that it names.
    fn place(&self) -> Option<&'m str> {
        self.text.strip_prefix("--> ").or_else(|| self.text.strip_prefix("::: "))
    }

    /// Whether it begins the message or a note, with a snippet of its own.
    fn is_head(&self) -> bool {
        self.margin.is_none() && self.text.starts_with(char::is_alphabetic)
    }

    fn is_about_long_names(&self) -> bool {
        let starts = ["= note: the full name for the type", "= note: consider using `--verbose`"];
        starts.iter().any(|start| self.text.trim_start().starts_with(start))
    }

    fn forget_number(&mut self) {
        self.margin = self.margin.map(|_| "");
        let end = self.text.find(".rs:").filter(|_| self.place().is_some());
        self.text = end.map_or(self.text, |end| &self.text[..end + ".rs".len()]);
    }

    fn shown(&self, width: usize) -> String {
        let count = self.text.trim_start().strip_prefix("and ").and_then(|text| text.strip_suffix(" others"));
        let text = count.map_or_else(|| self.text.to_owned(), |count| self.text.replace(count, "$N"));
        match self.margin {
            Some(number) => format!("{number:<width$}{text}\n"),
            None => format!("{text}\n"),
        }
    }
}
