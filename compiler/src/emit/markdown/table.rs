//! Tables.

use std::collections::BTreeMap;
use std::fmt;

use super::holds::Holds;
use super::inline::small;

/// The title of the column that says where a row is from. What most rows have in it is said once, below.
const SOURCE: &str = "Source";

/// A table whose cells are Markdown already. It prints nothing while it has no rows, and leaves out columns
/// in which no row has anything.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in crate::emit) struct Table {
    titles: Vec<Title>,
    rows: Vec<Row>,
}

/// The title of a column.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in crate::emit) struct Title {
    /// The words.
    pub(in crate::emit) text: String,
    /// What the column holds for.
    pub(in crate::emit) holds: Holds,
}

/// A row.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in crate::emit) struct Row {
    /// What is in its columns.
    pub(in crate::emit) cells: Vec<String>,
    /// What it holds for.
    pub(in crate::emit) holds: Holds,
}

impl<T: Into<String>> From<T> for Title {
    fn from(text: T) -> Self {
        Self { text: text.into(), holds: Holds::default() }
    }
}

impl Table {
    /// A table with these columns.
    pub(super) fn new<T: Into<Title>>(titles: impl IntoIterator<Item = T>) -> Self {
        Self { titles: titles.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// A table with these columns, and a row for each item.
    pub(super) fn of<T, const N: usize>(
        titles: [&str; N],
        items: impl IntoIterator<Item = T>,
        row: impl Fn(T) -> [String; N],
    ) -> Self {
        let mut table = Self::new(titles);
        items.into_iter().for_each(|item| table.row(row(item)));
        table
    }

    /// Adds a row.
    pub(super) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.row_for(Holds::default(), cells);
    }

    /// Adds a row that does not hold for all, or can be chosen.
    pub(super) fn row_for(&mut self, holds: Holds, cells: impl IntoIterator<Item = String>) {
        self.rows.push(Row { cells: cells.into_iter().collect(), holds });
    }

    /// Whether it has no rows.
    pub(super) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The titles of the columns.
    pub(super) fn titles(&self) -> impl Iterator<Item = &str> {
        self.columns().iter().map(|title| title.text.as_str())
    }

    /// The columns.
    pub(in crate::emit) fn columns(&self) -> &[Title] {
        &self.titles
    }

    /// The rows.
    pub(in crate::emit) fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// All cells, to be changed.
    pub(super) fn cells_mut(&mut self) -> impl Iterator<Item = &mut String> {
        self.rows.iter_mut().flat_map(|row| &mut row.cells)
    }

    /// The table with the columns in which some row has something.
    pub(super) fn without_empty_columns(self) -> Self {
        let used = self.used();
        let rows = self.rows.into_iter();
        let rows = rows.map(|row| Row { cells: keep(row.cells, &used), holds: row.holds }).collect();
        Self { titles: keep(self.titles, &used), rows }
    }

    /// Which columns have something in some row.
    fn used(&self) -> Vec<bool> {
        (0..self.titles.len()).map(|column| self.rows.iter().any(|row| !blank(row, column))).collect()
    }

    /// Takes what most of its rows are from out of them, and says it in a line that is to follow the table.
    pub(super) fn take_source_line(&mut self) -> Option<String> {
        let source = self.take_common_source()?;
        let column = self.titles.iter().position(|title| title.text == SOURCE)?;
        let is_all = self.rows.iter().all(|row| blank(row, column));
        let otherwise = if is_all { "" } else { ", unless a row says otherwise" };
        let place = source.strip_prefix("<sub>").and_then(|place| place.strip_suffix("</sub>"));
        Some(small(&format!("Source: {}{otherwise}", place.unwrap_or(&source))))
    }

    /// Takes what at least half of the rows name as their source out of them, if every row names one.
    fn take_common_source(&mut self) -> Option<String> {
        let column = self.titles.iter().position(|title| title.text == SOURCE)?;
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for row in &self.rows {
            *counts.entry(row.cells.get(column).map_or("", String::as_str)).or_default() += 1;
        }
        let (source, count) = counts.iter().max_by_key(|(_, count)| **count)?;
        let source =
            (!counts.contains_key("") && count * 2 >= self.rows.len()).then(|| (*source).to_owned())?;
        let cells = self.rows.iter_mut().filter_map(|row| row.cells.get_mut(column));
        cells.filter(|cell| **cell == source).for_each(String::clear);
        Some(source)
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return Ok(());
        }
        let used = self.used();
        line(f, &used, self.titles())?;
        line(f, &used, used.iter().map(|_| "---"))?;
        self.rows.iter().try_for_each(|row| line(f, &used, row.cells.iter().map(String::as_str)))
    }
}

/// What is in the columns that are used.
fn keep<T>(cells: Vec<T>, used: &[bool]) -> Vec<T> {
    cells.into_iter().zip(used).filter(|(_, used)| **used).map(|(cell, _)| cell).collect()
}

fn blank(row: &Row, column: usize) -> bool {
    row.cells.get(column).is_none_or(String::is_empty)
}

fn line<'c>(f: &mut fmt::Formatter<'_>, used: &[bool], cells: impl Iterator<Item = &'c str>) -> fmt::Result {
    f.write_str("|")?;
    for (cell, _) in cells.zip(used).filter(|(_, used)| **used) {
        write!(f, " {cell} |")?;
    }
    f.write_str("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(rows: &[[&str; 3]]) -> String {
        Table::of(["Name", "Notes", "Source"], rows, |row| row.map(String::from)).to_string()
    }

    #[test]
    fn without_rows_there_is_nothing() {
        assert_eq!(table(&[]), "");
    }

    #[test]
    fn columns_without_content_are_left_out() {
        assert_eq!(
            table(&[["a", "", "p. 1"], ["b", "", "p. 2"], ["c", "", ""]]),
            "| Name | Source |\n| --- | --- |\n| a | p. 1 |\n| b | p. 2 |\n| c |  |\n"
        );
    }

    #[test]
    fn a_source_of_most_rows_is_said_once() {
        let row = |name: &str, notes: &str, place: &str| [name.into(), notes.into(), small(place)];
        let mut table = Table::new(["Name", "Notes", "Source"]);
        table.row(row("a", "x", "p. 1"));
        table.row(row("b", "", "p. 1"));
        let mut mixed = table.clone();
        assert_eq!(table.take_source_line().as_deref(), Some("<sub>Source: p. 1</sub>"));
        assert_eq!(table.to_string(), "| Name | Notes |\n| --- | --- |\n| a | x |\n| b |  |\n");

        mixed.row(row("c", "", "p. 2"));
        let line = mixed.take_source_line();
        assert_eq!(line.as_deref(), Some("<sub>Source: p. 1, unless a row says otherwise</sub>"));
        assert!(mixed.to_string().contains("| c |  | <sub>p. 2</sub> |"), "{mixed}");
    }
}
