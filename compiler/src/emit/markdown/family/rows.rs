//! Tables whose rows, or columns, are not the same for all members.

use super::align::{Unit, align};
use super::names::Names;
use crate::emit::markdown::table::Table;

/// The column that says which members a row holds for.
const MEMBERS: &str = "Members";

/// A cell; none if the table has no such column.
type Cell<'t> = Option<&'t str>;

/// Rows that belong together: one that names something, and those that continue it.
type Group<'t> = Vec<Vec<Cell<'t>>>;

/// Tables as one. A row that not all members have names them; so do the versions of a cell, and a column.
pub(super) fn merge(names: &Names<'_>, versions: &[(usize, &Table)]) -> Table {
    let members: Vec<usize> = versions.iter().map(|(member, _)| *member).collect();
    let titles = versions.iter().map(|(member, table)| (*member, table.titles().collect()));
    let columns = align(titles, |one: &&str, other: &&str| one == other, |_, _| false);
    let titles: Vec<&str> = columns.iter().filter_map(|unit| Some(unit.items.first()?.1)).collect();
    let groups = || versions.iter().map(|(member, table)| (*member, groups(table, &titles)));
    let units = align(groups(), is_version, is_akin);
    let differ = units.iter().any(|unit| unit.members() != members);

    let heads = columns.iter().zip(&titles).map(|(unit, title)| match unit.members() {
        own if own == members => (*title).to_owned(),
        own => format!("{title} ({})", names.brief(&own)),
    });
    let mut merged = Table::new(heads.chain(differ.then(|| MEMBERS.to_owned())));
    for unit in &units {
        let own = unit.members();
        let label = if own == members { String::new() } else { names.brief(&own) };
        for row in rows(names, unit) {
            merged.row(row.into_iter().chain(differ.then(|| label.clone())));
        }
    }
    merged
}

/// The rows of a table in groups, with a cell for each of `columns`.
fn groups<'t>(table: &'t Table, columns: &[&str]) -> Vec<Group<'t>> {
    let places: Vec<Option<usize>> =
        columns.iter().map(|column| table.titles().position(|title| title == *column)).collect();
    let mut groups: Vec<Group<'t>> = Vec::new();
    for own in table.rows() {
        let continues = own.first().is_some_and(|cell| cell.is_empty() || cell.starts_with("&emsp;"));
        let cell = |place: &Option<usize>| place.and_then(|place| own.get(place)).map(String::as_str);
        let row = places.iter().map(cell).collect();
        match groups.last_mut().filter(|_| continues) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    groups
}

/// Whether groups are versions of one: in each row, at most one cell that both have is not the same.
fn is_version(one: &Group<'_>, other: &Group<'_>) -> bool {
    let differs = |(one, other): &(&Cell<'_>, &Cell<'_>)| one.is_some() && other.is_some() && one != other;
    let close = |one: &[Cell<'_>], other: &[Cell<'_>]| {
        one.first() == other.first() && one.iter().zip(other).filter(differs).count() <= 1
    };
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| close(one, other))
}

/// Whether groups are about the same thing.
fn is_akin(one: &Group<'_>, other: &Group<'_>) -> bool {
    let name =
        |group: &Group<'_>| group.first().and_then(|row| row.first().copied().flatten().map(str::to_owned));
    name(one) == name(other)
}

/// The rows of a group, each cell once or with its versions.
fn rows<'u>(names: &'u Names<'_>, unit: &'u Unit<Group<'_>>) -> impl Iterator<Item = Vec<String>> + 'u {
    let shape = unit.items.first().map(|(_, group)| group);
    let shape = shape.into_iter().flatten().map(|row| row.len()).enumerate();
    shape.map(move |(row, width)| {
        let cells = |column: usize| {
            let cell = move |group: &Group<'u>| group.get(row)?.get(column).copied().flatten();
            unit.items.iter().filter_map(move |(member, group)| Some((*member, cell(group)?)))
        };
        (0..width).map(|column| versions(names, cells(column))).collect()
    })
}

/// A cell with its versions, each behind the other.
fn versions<'t>(names: &Names<'_>, cells: impl Iterator<Item = (usize, &'t str)>) -> String {
    let cells = cells.map(|(member, cell)| (member, vec![cell]));
    let units = align(cells, |one: &&str, other: &&str| one == other, |_, _| true);
    let told = units.iter().filter_map(|unit| Some((unit.items.first()?.1, unit.members())));
    match told.collect::<Vec<_>>().as_slice() {
        [(only, _)] => (*only).to_owned(),
        many => {
            let lines = many.iter().map(|(cell, members)| {
                let cell = if cell.is_empty() { "–" } else { cell };
                format!("{cell} *({})*", names.brief(members))
            });
            lines.collect::<Vec<_>>().join("<br>")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(titles: &[&str], rows: &[&[&str]]) -> Table {
        let mut table = Table::new(titles.iter().copied());
        rows.iter().for_each(|row| table.row(row.iter().copied().map(String::from)));
        table
    }

    fn merged(one: Table, other: Table) -> String {
        let names = ["A".to_owned(), "B".to_owned()];
        merge(&Names(&names), &[(0, &one), (1, &other)]).to_string()
    }

    #[test]
    fn a_row_that_one_member_has_names_it() {
        assert_eq!(
            merged(table(&["X", "Y"], &[&["a", "b"], &["c", "d"]]), table(&["X", "Y"], &[&["a", "b"]])),
            "| X | Y | Members |\n| --- | --- | --- |\n| a | b |  |\n| c | d | A |\n"
        );
    }

    #[test]
    fn a_cell_has_versions_and_a_column_has_members() {
        assert_eq!(
            merged(table(&["X", "Y"], &[&["a", "b"]]), table(&["X", "Y", "Z"], &[&["a", "c", "d"]])),
            "| X | Y | Z (B) |\n| --- | --- | --- |\n| a | b *(A)*<br>c *(B)* | d |\n"
        );
    }
}
