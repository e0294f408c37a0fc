//! Tables.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Serialize, Serializer};

use super::inline::small;

/// The title of the column that says where a row is from. What most rows have in it is said once, below.
const SOURCE: &str = "Source";

/// A table whose cells are Markdown already. It prints nothing while it has no rows, and leaves out columns
/// in which no row has anything.
#[derive(Debug, Clone, Default)]
pub(super) struct Table {
    titles: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these columns.
    pub(super) fn new<T: Into<String>>(titles: impl IntoIterator<Item = T>) -> Self {
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
        self.rows.push(cells.into_iter().collect());
    }

    /// Whether it has no rows.
    pub(super) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The titles of the columns.
    pub(super) fn titles(&self) -> impl Iterator<Item = &str> {
        self.titles.iter().map(String::as_str)
    }

    /// The rows, each with its cells.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[String]> {
        self.rows.iter().map(Vec::as_slice)
    }

    /// Reads a table as it is printed.
    pub(super) fn parse(text: &str) -> Self {
        let mut lines = text.lines().map(cells);
        let mut table = Self { titles: lines.next().unwrap_or_default(), rows: Vec::new() };
        table.rows.extend(lines.skip(1));
        table
    }

    /// Takes what at least half of the rows name as their source out of them, if every row names one.
    fn take_common_source(&mut self) -> Option<String> {
        let column = self.titles.iter().position(|title| title == SOURCE)?;
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for row in &self.rows {
            *counts.entry(row.get(column).map_or("", String::as_str)).or_default() += 1;
        }
        let (source, count) = counts.iter().max_by_key(|(_, count)| **count)?;
        let source =
            (!counts.contains_key("") && count * 2 >= self.rows.len()).then(|| (*source).to_owned())?;
        let cells = self.rows.iter_mut().filter_map(|row| row.get_mut(column));
        cells.filter(|cell| **cell == source).for_each(String::clear);
        Some(source)
    }
}

/// Says below each table of a document what most of its rows are from.
pub(super) fn sources_once(text: &str) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let blocks = lines.chunk_by(|one, next| one.starts_with('|') == next.starts_with('|'));
    blocks.map(<[&str]>::concat).map(source_once).collect()
}

/// Says below a block, if it is a table, what most of its rows are from.
fn source_once(block: String) -> String {
    if !block.starts_with('|') {
        return block;
    }
    let mut table = Table::parse(&block);
    let Some(source) = table.take_common_source() else { return block };
    let exceptions = table.titles.iter().position(|title| title == SOURCE);
    let exceptions = exceptions.is_some_and(|column| table.rows.iter().any(|row| !blank(row, column)));
    let otherwise = if exceptions { ", unless a row says otherwise" } else { "" };
    let place = source.strip_prefix("<sub>").and_then(|place| place.strip_suffix("</sub>"));
    let place = place.unwrap_or(&source);
    format!("{table}\n{}\n", small(&format!("Source: {place}{otherwise}")))
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return Ok(());
        }
        let used: Vec<bool> =
            (0..self.titles.len()).map(|column| self.rows.iter().any(|row| !blank(row, column))).collect();
        line(f, &used, &self.titles)?;
        line(f, &used, &vec!["---".to_owned(); used.len()])?;
        self.rows.iter().try_for_each(|row| line(f, &used, row))
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The cells of a line. What stands in them has no bare bars.
fn cells(line: &str) -> Vec<String> {
    let inner = line.strip_prefix("| ").unwrap_or(line);
    inner.strip_suffix(" |").unwrap_or(inner).split(" | ").map(String::from).collect()
}

fn blank(row: &[String], column: usize) -> bool {
    row.get(column).is_none_or(String::is_empty)
}

fn line(f: &mut fmt::Formatter<'_>, used: &[bool], cells: &[String]) -> fmt::Result {
    f.write_str("|")?;
    for (cell, _) in cells.iter().zip(used).filter(|(_, used)| **used) {
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
    fn what_is_printed_can_be_read() {
        let printed = "| X |  | Y |\n| --- | --- | --- |\n| a \\| b |  | c |\n|  | d |  |\n";
        let table = Table::parse(printed);
        assert_eq!(table.rows().collect::<Vec<_>>(), [["a \\| b", "", "c"], ["", "d", ""]]);
        assert_eq!(table.to_string(), printed);
    }

    #[test]
    fn a_source_of_most_rows_is_said_once() {
        let small = |place: &str| small(place);
        let two = table(&[["a", "x", &small("p. 1")], ["b", "", &small("p. 1")]]);
        assert_eq!(
            sources_once(&format!("text\n\n{two}\nmore\n")),
            "text\n\n| Name | Notes |\n| --- | --- |\n| a | x |\n| b |  |\n\n<sub>Source: p. 1</sub>\n\nmore\n"
        );
        let mixed = sources_once(&(two + &format!("| c |  | {} |\n", small("p. 2"))));
        assert!(mixed.contains("| c |  | <sub>p. 2</sub> |"), "{mixed}");
        assert!(mixed.ends_with("<sub>Source: p. 1, unless a row says otherwise</sub>\n"), "{mixed}");
    }
}
