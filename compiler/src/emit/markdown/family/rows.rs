//! Tables whose rows, or columns, are not the same for all members.

use super::align::{Unit, align};
use super::names::Names;
use crate::emit::markdown::holds::Holds;
use crate::emit::markdown::table::{Table, Title};

/// The column that says which members a row holds for.
const MEMBERS: &str = "Members";

/// A cell; none if the table has no such column.
type Cell<'t> = Option<&'t str>;

/// A row, with a cell for each column of the whole.
struct Line<'t> {
    cells: Vec<Cell<'t>>,
    holds: &'t Holds,
}

/// Rows that belong together: one that names something, and those that continue it.
type Group<'t> = Vec<Line<'t>>;

/// Tables as one. A row that not all members have names them; so do the versions of a cell, and a column.
pub(super) fn merge(names: &Names<'_>, versions: &[(usize, &Table)]) -> Table {
    let members: Vec<usize> = versions.iter().map(|(member, _)| *member).collect();
    let titles = versions.iter().map(|(member, table)| (*member, table.columns().iter().collect()));
    let columns = align(titles, |one: &&Title, other: &&Title| one.text == other.text, |_, _| false);
    let titles: Vec<&Title> = columns.iter().filter_map(|unit| Some(unit.items.first()?.1)).collect();
    let groups = || versions.iter().map(|(member, table)| (*member, groups(table, &titles)));
    let units = align(groups(), is_version, is_akin);
    let differ = units.iter().any(|unit| unit.members() != members);

    let heads = columns.iter().zip(&titles).map(|(unit, title)| match unit.members() {
        own if own == members => (*title).clone(),
        own => {
            let text = format!("{} ({})", title.text, names.brief(&own));
            Title { text, holds: Holds { members: own, ..title.holds.clone() } }
        }
    });
    let mut merged = Table::new(heads.chain(differ.then(members_title)));
    for unit in &units {
        let own = unit.members();
        let label = if own == members { String::new() } else { names.brief(&own) };
        for (mut holds, row) in rows(names, unit) {
            if own != members {
                holds.members.clone_from(&own);
            }
            merged.row_for(holds, row.into_iter().chain(differ.then(|| label.clone())));
        }
    }
    merged
}

/// The title of the column that names members, which the page hides from those who look at one member.
fn members_title() -> Title {
    Title { text: MEMBERS.to_owned(), holds: Holds { kinds: ["members"].into(), ..Holds::default() } }
}

/// The rows of a table in groups, with a cell for each of `columns`.
fn groups<'t>(table: &'t Table, columns: &[&Title]) -> Vec<Group<'t>> {
    let place = |column: &&Title| table.titles().position(|title| title == column.text);
    let places: Vec<Option<usize>> = columns.iter().map(place).collect();
    let mut groups: Vec<Group<'t>> = Vec::new();
    for own in table.rows() {
        let continues = own.cells.first().is_some_and(|cell| cell.is_empty() || cell.starts_with("&emsp;"));
        let cell = |place: &Option<usize>| place.and_then(|place| own.cells.get(place)).map(String::as_str);
        let row = Line { cells: places.iter().map(cell).collect(), holds: &own.holds };
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
    one.len() == other.len()
        && one
            .iter()
            .zip(other)
            .all(|(one, other)| one.holds.axes == other.holds.axes && close(&one.cells, &other.cells))
}

/// Whether groups are about the same thing.
fn is_akin(one: &Group<'_>, other: &Group<'_>) -> bool {
    let name = |group: &Group<'_>| {
        group.first().and_then(|row| row.cells.first().copied().flatten().map(str::to_owned))
    };
    name(one) == name(other)
}

/// The rows of a group, each cell once or with its versions. What one version can be chosen by, all can.
fn rows<'u>(
    names: &'u Names<'_>,
    unit: &'u Unit<Group<'_>>,
) -> impl Iterator<Item = (Holds, Vec<String>)> + 'u {
    let shape = unit.items.first().map(|(_, group)| group);
    let shape = shape.into_iter().flatten().map(|row| row.cells.len()).enumerate();
    shape.map(move |(row, width)| {
        let lines = || unit.items.iter().filter_map(move |(member, group)| Some((*member, group.get(row)?)));
        let cells = |column: usize| {
            lines().filter_map(move |(member, line)| Some((member, line.cells.get(column).copied()??)))
        };
        let mut holds = lines().next().map_or_else(Holds::default, |(_, line)| line.holds.clone());
        lines().for_each(|(_, line)| holds.kinds.extend(&line.holds.kinds));
        (holds, (0..width).map(|column| versions(names, cells(column))).collect())
    })
}

/// A cell with its versions, each behind the other.
fn versions<'t>(names: &Names<'_>, cells: impl Iterator<Item = (usize, &'t str)>) -> String {
    let cells = cells.map(|(member, cell)| (member, vec![cell]));
    let units = align(cells, |one: &&str, other: &&str| one == other, |_, _| true);
    let told = units.iter().filter_map(|unit| Some((unit.items.first()?.1, unit.members())));
    match told.collect::<Vec<_>>().as_slice() {
        [(only, _)] => (*only).to_owned(),
        many => names.versions(many),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::markdown::holds::Form;

    fn table(titles: &[&str], rows: &[&[&str]]) -> Table {
        let mut table = Table::new(titles.iter().copied());
        rows.iter().for_each(|row| table.row(row.iter().copied().map(String::from)));
        table
    }

    fn merged(one: Table, other: Table) -> String {
        let names = ["A".to_owned(), "B".to_owned()];
        merge(&Names::new(&names, Form::Text), &[(0, &one), (1, &other)]).to_string()
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
