//! What a reference consists of: headings, text, lists, tables.

use std::fmt;

use super::holds::Holds;
use super::machine::Machine;
use super::picture::Picture;
use super::table::Table;

/// A heading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Heading {
    /// How deep it stands: 2 for a chapter.
    pub(in crate::emit) level: usize,
    /// The place that links can lead to.
    pub(in crate::emit) anchor: Option<String>,
    /// The words.
    pub(in crate::emit) title: String,
    /// What it holds for, with all that stands under it.
    pub(in crate::emit) holds: Holds,
}

/// An item of a list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Item {
    /// How many items it is below.
    pub(super) depth: usize,
    /// What it says.
    pub(super) text: String,
}

/// What stands between two blank lines. All texts are Markdown already.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) enum Block {
    /// A heading.
    Heading(Heading),
    /// A paragraph.
    Text(String),
    /// A list without numbers.
    List(Vec<Item>),
    /// A table that has rows, and something in each column.
    Table(Table),
    /// Lines that belong together as they are: numbered steps, a warning.
    Lines(String),
    /// The picture of a state machine.
    Machine(Machine),
    /// A picture that only the page has.
    Picture(Picture),
    /// What follows, up to the end, holds for some members only.
    Open(Holds),
    /// The end of what holds for some members only.
    Close,
}

impl Block {
    /// Whether it is something to be read, and no mark or picture.
    pub(super) fn is_read(&self) -> bool {
        !matches!(self, Self::Open(_) | Self::Close | Self::Picture(_))
    }
}

/// Blocks in order, as they are put down. What is empty leaves no block.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in crate::emit) struct Page(pub(in crate::emit) Vec<Block>);

impl Page {
    /// A heading.
    pub(super) fn heading(&mut self, level: usize, title: impl Into<String>) {
        self.0.push(Block::Heading(Heading {
            level,
            anchor: None,
            title: title.into(),
            holds: Holds::default(),
        }));
    }

    /// A heading that links can lead to.
    pub(super) fn place(&mut self, level: usize, anchor: impl Into<String>, title: impl Into<String>) {
        let (anchor, title) = (Some(anchor.into()), title.into());
        self.0.push(Block::Heading(Heading { level, anchor, title, holds: Holds::default() }));
    }

    /// Paragraphs, as blank lines divide them.
    pub(super) fn text(&mut self, paragraphs: impl AsRef<str>) {
        let paragraphs = paragraphs.as_ref().split("\n\n").map(str::trim).filter(|text| !text.is_empty());
        self.0.extend(paragraphs.map(|text| Block::Text(text.to_owned())));
    }

    /// A list without numbers.
    pub(super) fn list(&mut self, items: impl IntoIterator<Item = String>) {
        self.items(items.into_iter().map(|text| Item { depth: 0, text }).collect());
    }

    /// A list of lists.
    pub(super) fn items(&mut self, items: Vec<Item>) {
        self.0.extend((!items.is_empty()).then_some(Block::List(items)));
    }

    /// Steps, numbered from 1.
    pub(super) fn steps<'s>(&mut self, steps: impl IntoIterator<Item = &'s String>) {
        let lines: Vec<String> =
            steps.into_iter().zip(1..).map(|(step, number)| format!("{number}. {step}")).collect();
        self.lines(lines.join("\n"));
    }

    /// Lines that belong together as they are.
    pub(super) fn lines(&mut self, lines: String) {
        self.0.extend((!lines.is_empty()).then_some(Block::Lines(lines)));
    }

    /// A picture that only the page has.
    pub(super) fn picture(&mut self, picture: Picture) {
        self.0.push(Block::Picture(picture));
    }

    /// The picture of a state machine.
    pub(super) fn machine(&mut self, machine: Machine) {
        self.0.push(Block::Machine(machine));
    }

    /// A table.
    pub(super) fn table(&mut self, table: Table) {
        self.0.extend((!table.is_empty()).then(|| Block::Table(table.without_empty_columns())));
    }

    /// A table under a heading.
    pub(super) fn titled(&mut self, title: &str, table: Table) {
        if !table.is_empty() {
            self.heading(3, title);
            self.table(table);
        }
    }

    /// The blocks of another page.
    pub(super) fn append(&mut self, page: Page) {
        self.0.extend(page.0);
    }

    /// Whether nothing was put down.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The parts that the contents list below a chapter: what links can lead to.
    pub(super) fn parts(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().filter_map(|block| match block {
            Block::Heading(Heading { level: 3, anchor: Some(anchor), title, .. }) => {
                Some((anchor.as_str(), title.as_str()))
            }
            _ => None,
        })
    }
}

impl fmt::Display for Heading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&"#".repeat(self.level))?;
        f.write_str(" ")?;
        if let Some(anchor) = &self.anchor {
            write!(f, "<a id=\"{anchor}\"></a>")?;
        }
        f.write_str(&self.title)
    }
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}- {}", "  ".repeat(self.depth), self.text)
    }
}

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Heading(heading) => writeln!(f, "{heading}"),
            Self::Text(text) | Self::Lines(text) => writeln!(f, "{text}"),
            Self::List(items) => items.iter().try_for_each(|item| writeln!(f, "{item}")),
            Self::Table(table) => table.fmt(f),
            Self::Machine(machine) => writeln!(f, "{machine}"),
            Self::Picture(_) | Self::Open(_) | Self::Close => Ok(()),
        }
    }
}

impl fmt::Display for Page {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, block) in self.0.iter().filter(|block| block.is_read()).enumerate() {
            if number > 0 {
                f.write_str("\n")?;
            }
            block.fmt(f)?;
        }
        Ok(())
    }
}
