//! Where the run of devices is told: as lines, and on a terminal with a table below them that is kept up to date.

use crate::report::Report;

/// How wide and how high a terminal is that does not say it.
const USUAL: (u16, u16) = (80, 24);

/// Lines that stay, and rows that change.
#[derive(Debug, Default)]
pub(super) struct Screen {
    /// The rows that stand below the lines.
    shown: Vec<String>,
}

impl Screen {
    /// A screen, if there is a terminal that can move its cursor, and somebody who wants to hear of it.
    pub(super) fn of(report: &Report) -> Option<Self> {
        report.is_live().then(Self::default)
    }

    /// Its width and height.
    pub(super) fn size() -> (usize, usize) {
        use terminal_size::{Height, Width};
        let told = terminal_size::terminal_size().map(|(Width(width), Height(height))| (width, height));
        let (width, height) = told.filter(|(width, height)| *width > 0 && *height > 0).unwrap_or(USUAL);
        (width.into(), height.into())
    }

    /// What to write so that further lines stand there, and these rows below them; nothing if nothing has changed.
    pub(super) fn update(&mut self, lines: &[String], rows: Vec<String>) -> String {
        if lines.is_empty() && rows == self.shown {
            return String::new();
        }
        let up = match self.shown.len() {
            0 => String::new(),
            // to the first row, and clear from there on
            count => format!("\u{1b}[{count}A\r\u{1b}[J"),
        };
        let all = lines.iter().chain(&rows).flat_map(|line| [line.as_str(), "\n"]);
        let text = std::iter::once(up.as_str()).chain(all).collect();
        self.shown = rows;
        text
    }
}

#[cfg(test)]
mod tests {
    use super::Screen;

    /// A terminal that knows what a screen asks of it.
    #[derive(Default)]
    struct Terminal {
        lines: Vec<String>,
        row: usize,
    }

    impl Terminal {
        fn write(&mut self, text: &str) {
            let mut rest = text;
            while let Some(next) = rest.chars().next() {
                if let Some(escape) = rest.strip_prefix("\u{1b}[") {
                    let end = escape.find(char::is_alphabetic).expect("it ends");
                    match &escape[end..=end] {
                        "A" => self.row -= escape[..end].parse::<usize>().expect("a number"),
                        "J" => self.lines.truncate(self.row),
                        other => panic!("{other}"),
                    }
                    rest = &escape[end + 1..];
                    continue;
                }
                match next {
                    '\n' => self.row += 1,
                    '\r' => {}
                    other => {
                        self.lines.resize(self.lines.len().max(self.row + 1), String::new());
                        self.lines[self.row].push(other);
                    }
                }
                rest = &rest[next.len_utf8()..];
            }
        }
    }

    #[test]
    fn lines_stay_and_rows_are_below_them() {
        let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        let (mut screen, mut terminal) = (Screen::default(), Terminal::default());
        terminal.write("$ devc run\n");
        terminal.write(&screen.update(&[], texts(&["head", "a 1", "b 1"])));
        terminal.write(&screen.update(&[], texts(&["head", "a 2", "b 1"])));
        terminal.write(&screen.update(&texts(&["first", "second"]), texts(&["head", "a 2", "b 2"])));
        terminal.write(&screen.update(&texts(&["third"]), texts(&["head"])));
        terminal.write(&screen.update(&[], texts(&["head", "c 1"])));
        assert_eq!(terminal.lines, ["$ devc run", "first", "second", "third", "head", "c 1"]);
        assert_eq!(screen.update(&[], texts(&["head", "c 1"])), "", "what has not changed is not written");
    }
}
