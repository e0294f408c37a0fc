//! Tables.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Serialize, Serializer};

use super::inline::small;

/// The title of the column that is set in small print. What most rows have in it is said once, below.
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

    /// What at least half of the rows name as their source, if every row names one.
    fn common_source(&self) -> Option<&str> {
        let column = self.titles.iter().position(|title| title == SOURCE)?;
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for row in &self.rows {
            *counts.entry(row.get(column).map_or("", String::as_str)).or_default() += 1;
        }
        let (source, count) = counts.iter().max_by_key(|(_, count)| **count)?;
        (!counts.contains_key("") && count * 2 >= self.rows.len()).then_some(source)
    }

    /// The cells as they are printed.
    fn cells(&self, common: Option<&str>) -> Vec<Vec<String>> {
        let print = |(title, cell): (&String, &String)| match title.as_str() {
            SOURCE if Some(cell.as_str()) == common => String::new(),
            SOURCE => small(cell),
            _ => cell.clone(),
        };
        self.rows.iter().map(|row| self.titles.iter().zip(row).map(print).collect()).collect()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return Ok(());
        }
        let common = self.common_source();
        let rows = self.cells(common);
        let used: Vec<bool> =
            (0..self.titles.len()).map(|column| rows.iter().any(|row| !blank(row, column))).collect();
        line(f, &used, &self.titles)?;
        line(f, &used, &vec!["---".to_owned(); used.len()])?;
        rows.iter().try_for_each(|row| line(f, &used, row))?;
        let Some(source) = common else { return Ok(()) };
        let exceptions = used.last().is_some_and(|used| *used);
        let otherwise = if exceptions { ", unless a row says otherwise" } else { "" };
        writeln!(f, "\n{}", small(&format!("Source: {source}{otherwise}")))
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
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
            "| Name | Source |\n| --- | --- |\n| a | <sub>p. 1</sub> |\n| b | <sub>p. 2</sub> |\n| c |  |\n"
        );
    }

    #[test]
    fn a_source_of_most_rows_is_said_once() {
        assert_eq!(
            table(&[["a", "x", "p. 1"], ["b", "", "p. 1"]]),
            "| Name | Notes |\n| --- | --- |\n| a | x |\n| b |  |\n\n<sub>Source: p. 1</sub>\n"
        );
        let mixed = table(&[["a", "x", "p. 1"], ["b", "", "p. 1"], ["c", "", "p. 2"]]);
        assert!(mixed.contains("| c |  | <sub>p. 2</sub> |"), "{mixed}");
        assert!(mixed.ends_with("<sub>Source: p. 1, unless a row says otherwise</sub>\n"), "{mixed}");
    }
}
