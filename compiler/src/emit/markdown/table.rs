//! Tables.

use std::fmt;

use serde::{Serialize, Serializer};

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

    fn cell(row: &[String], column: usize) -> &str {
        row.get(column).map_or("", String::as_str)
    }

    fn line<'a>(f: &mut fmt::Formatter<'_>, cells: impl Iterator<Item = &'a str>) -> fmt::Result {
        f.write_str("|")?;
        for cell in cells {
            write!(f, " {cell} |")?;
        }
        f.write_str("\n")
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return Ok(());
        }
        let used = |column: &usize| self.rows.iter().any(|row| !Self::cell(row, *column).is_empty());
        let columns: Vec<usize> = (0..self.titles.len()).filter(used).collect();
        Self::line(f, columns.iter().map(|column| Self::cell(&self.titles, *column)))?;
        Self::line(f, columns.iter().map(|_| "---"))?;
        self.rows
            .iter()
            .try_for_each(|row| Self::line(f, columns.iter().map(|column| Self::cell(row, *column))))
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
