//! What an edit of a description breaks: `changes.toml` has edits with the changes that people who run masters see in
//! them, both ways.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod revisions;

use std::path::Path;

use devc::diagnostic::{Group, Level};
use devc::diff::{Gate, compare, gate};
use devc::lint::{Checked, Levels};
use devc::model::Family;
use devc::source::Memory;
use toml::{Table, Value};

/// The base without errata, which quote what the edits are of.
fn base() -> Table {
    let mut base: Table = toml::from_str(include_str!("../facts/base.toml")).expect("the base is TOML");
    base.remove("errata");
    base
}

fn family(description: &Table) -> Checked<Family> {
    compiled(toml::to_string(description).expect("a table is TOML"))
}

fn compiled(text: String) -> Checked<Family> {
    let memory = Memory::default().with("example/device.toml", text.into_bytes());
    let mut levels = Levels::default();
    Group::ALL.iter().for_each(|group| levels.set(group.name(), Level::Allow, None));
    let request = devc::Request { levels, ..devc::Request::default() };
    let compilation = devc::compile_with(&memory, Path::new("example"), &request, &mut |_| ());
    let messages: Vec<_> = compilation.diagnostics.iter().map(|one| one.message.clone()).collect();
    compilation.family.unwrap_or_else(|| panic!("{messages:#?}"))
}

/// The table that a place lies in, made where there is none, and the last key.
fn around<'t>(table: &'t mut Table, place: &[Value]) -> (&'t mut Table, String) {
    let keys: Vec<&str> = place.iter().filter_map(Value::as_str).collect();
    let (last, before) = keys.split_last().expect("a place");
    let inner = before.iter().fold(table, |table, key| {
        let inner = table.entry(*key).or_insert_with(|| Value::Table(Table::new()));
        inner.as_table_mut().expect("a table")
    });
    (inner, (*last).to_owned())
}

fn edited(edit: &Table) -> Table {
    let mut table = base();
    if let Some([Value::Array(place), value]) = edit.get("set").and_then(Value::as_array).map(Vec::as_slice) {
        let (inner, key) = around(&mut table, place);
        inner.insert(key, value.clone());
    } else {
        let place = edit["take"].as_array().expect("a place");
        let (inner, key) = around(&mut table, place);
        inner.remove(&key).expect("there is something to take");
    }
    table
}

/// The changes as `changes.toml` writes them.
fn changes(old: &Family, new: &Family) -> Vec<String> {
    let shown = |change: &devc::diff::Change| {
        format!("{} {} {}", change.kind.class.name(), change.kind.rule.name, change.at)
    };
    compare(old, new).changes.iter().map(shown).collect()
}

#[test]
fn each_edit_is_the_change_that_people_see_in_it() {
    let edits: Table = toml::from_str(include_str!("changes.toml")).expect("the edits are TOML");
    let before = family(&base());
    let mut wrong = Vec::new();
    for edit in edits["edit"].as_array().expect("a list").iter().filter_map(Value::as_table) {
        let after = family(&edited(edit));
        for (key, found) in [("gives", changes(&before, &after)), ("back", changes(&after, &before))] {
            let expected: Vec<&str> =
                edit[key].as_array().expect("a list").iter().filter_map(Value::as_str).collect();
            if found != expected {
                wrong.push(format!(
                    "{}: {key} {found:#?}, expected {expected:#?}",
                    edit.get("set").unwrap_or(&edit["gives"])
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A revision number that stays is refused with a breaking change, one that rises announces it, one that falls is always
/// refused; and another device has revisions of its own.
#[test]
fn the_gate_asks_for_a_higher_revision() {
    let with = |kind: &str, revision: i64, product: i64| {
        let mut table = base();
        table["objects"]["0x2000"].as_table_mut().expect("a table").insert("type".to_owned(), kind.into());
        let identity = table["identity"].as_table_mut().expect("a table");
        identity.insert("revision".to_owned(), revision.into());
        identity.insert("product-code".to_owned(), product.into());
        family(&table)
    };
    let old = with("UINT16", 2, 3);
    let passes = |new: &Family| gate(&compare(&old, new)) == [Gate::Passed];
    assert!(passes(&old));
    assert!(!passes(&with("UINT32", 2, 3)));
    assert!(passes(&with("UINT32", 3, 3)));
    assert!(!passes(&with("UINT16", 1, 3)));
    assert!(passes(&with("UINT32", 1, 4)));
}

/// What is not in the dictionary has its type in the PDO; another one of the same width is what nobody notices.
#[test]
fn the_type_of_what_is_only_mapped_is_compared() {
    let with = |width: &str| {
        let mut table = base();
        let entries: Value = toml::from_str::<Table>(&format!("it = [{{ entry = \"0x3F00:01\", {width} }}]"))
            .expect("TOML")["it"]
            .clone();
        let pdo = table["tx-pdos"]["0x1A00"].as_table_mut().expect("a table");
        pdo.insert("entries".to_owned(), entries);
        family(&table)
    };
    let [bits, unsigned, signed] = ["bits = 16", "type = \"UINT16\"", "type = \"INT16\""].map(with);
    assert_eq!(changes(&unsigned, &signed), ["wire-breaking changed-type 0x1A00"]);
    assert_eq!(changes(&bits, &signed), ["documentation respelt-type 0x1A00"]);
    assert_eq!(changes(&signed, &signed), Vec::<String>::new());
}

/// Where tables of one section change places, what lists them changes; the order of slots is what modules are set up by.
#[test]
fn another_order_is_told() {
    let (base, mut wrong) = (toml::to_string(&base()).expect("a table is TOML"), Vec::new());
    for (section, table, gives) in [
        ("configurations", "name = \"One\"", "documentation reordered configurations"),
        ("documents", "title = \"Another\"", "documentation reordered documents"),
        ("enumerations", "values = { 1 = { name = \"one\" } }", "documentation reordered enumerations"),
        ("parameters", "name = \"One\"", "documentation reordered parameters"),
        ("slots", "name = \"One\"\nmax = 1\nmodules = [0x100]", "configuration-breaking changed-slots slots"),
        ("states", "name = \"One\"", "documentation reordered states"),
        ("units", "quantity = \"length\"\nsymbol = \"mm\"", "documentation reordered units"),
    ] {
        let with = |ids: [&str; 2]| {
            let tables = ids.map(|id| format!("\n[{section}.{id}]\n{table}\n"));
            compiled(format!("{base}{}", tables.concat()))
        };
        let found = changes(&with(["one", "other"]), &with(["other", "one"]));
        if found != [gives] {
            wrong.push(format!("{section}: {found:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
