//! Tables with a line for each way and a column for each level of optimisation.

/// The width of a column.
pub(crate) const WIDTH: usize = 14;

/// The lines and columns.
pub(crate) struct Table<'a> {
    pub(crate) levels: &'a [String],
    pub(crate) ways: Vec<&'a str>,
}

impl Table<'_> {
    /// Prints what there is for a way and the number of a level; ways without anything are left out.
    pub(crate) fn print(&self, title: &str, cell: impl Fn(&str, usize) -> Option<String>) {
        println!("\n{title}");
        let levels = self.levels.iter().map(|level| format!("{:>WIDTH$}", format!("-O{level}")));
        println!("{:<22}{}", "", levels.collect::<String>());
        for way in &self.ways {
            let cells: Vec<_> = (0..self.levels.len()).map(|level| cell(way, level)).collect();
            if cells.iter().any(Option::is_some) {
                let cells = cells.into_iter().map(|cell| cell.unwrap_or_else(|| " ".repeat(WIDTH)));
                println!("{way:<22}{}", cells.collect::<String>());
            }
        }
    }
}
