//! Objects that devc makes itself: mapping and assignment objects and 0x1C00. Only what it would make otherwise is said.

use super::super::read::{Object, Pdo, Value, Written, number};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::draft::Block;
use super::words;
use crate::model::{Access, Category};

/// What the objects follow from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Basis<'b> {
    pub(super) rx: &'b [&'b Pdo],
    pub(super) tx: &'b [&'b Pdo],
    /// Whether the master may write assignments and mappings.
    pub(super) assigns: bool,
    pub(super) maps: bool,
    /// Which sync managers there are: for outputs, for inputs.
    pub(super) managers: [bool; 2],
}

/// What devc makes of an object.
struct Made<'b> {
    access: Access,
    name: &'b str,
    /// The values of its entries; none if the file's are not compared.
    values: Vec<u64>,
}

/// Whether devc makes an object of this index.
pub(super) fn is_derived(index: u16) -> bool {
    crate::model::Index(index).is_derived()
}

/// How many entries an object has room for, without subindex 0.
pub(super) fn room(objects: &[&Object], index: u16) -> usize {
    let object = objects.iter().find(|object| object.index == index);
    object.map_or(0, |object| object.values.iter().filter(|value| value.subindex > 0).count())
}

/// What is to be said of a derived object, if it is not as devc makes it.
pub(super) fn block(object: &Object, basis: &Basis<'_>, report: &mut Report) -> Option<Block> {
    let what = format!("0x{:04X}", object.index);
    let facts = 3 + object.values.iter().map(facts).sum::<usize>();
    let Some(made) = made(object, basis) else {
        report.lose(
            object.at,
            facts,
            format!("object {what}"),
            "it belongs to a PDO or a sync manager that is not described",
        );
        return None;
    };
    compare(object, &made, report);
    let keys = access(object, made.access, report);
    let mentioned = matches!(object.index, 0x1C10 | 0x1C11);
    let differs = !keys.is_empty() || mentioned;
    differs.then(|| Block::new("objects", Some(what), keys))
}

fn facts(value: &Value) -> usize {
    usize::from(value.default.is_some()) + usize::from(value.name.is_some())
}

fn made<'b>(object: &Object, basis: &Basis<'b>) -> Option<Made<'b>> {
    let access = |free| if free { Access::Rw } else { Access::Ro };
    let assigned =
        |pdos: &[&Pdo]| pdos.iter().filter(|pdo| pdo.sm.is_some()).map(|pdo| pdo.index.into()).collect();
    let [outputs, inputs] = basis.managers;
    match object.index {
        0x1C00 => {
            Some(Made { access: Access::Ro, name: "Sync manager communication type", values: Vec::new() })
        }
        0x1C10 => {
            Some(Made { access: Access::Ro, name: "Sync manager 0 PDO assignment", values: Vec::new() })
        }
        0x1C11 => {
            Some(Made { access: Access::Ro, name: "Sync manager 1 PDO assignment", values: Vec::new() })
        }
        0x1C12 => outputs.then(|| Made {
            access: access(basis.assigns),
            name: "Sync manager 2 PDO assignment",
            values: assigned(basis.rx),
        }),
        0x1C13 => inputs.then(|| Made {
            access: access(basis.assigns),
            name: "Sync manager 3 PDO assignment",
            values: assigned(basis.tx),
        }),
        index => {
            let pdo = basis.rx.iter().chain(basis.tx).find(|pdo| pdo.index == index)?;
            let word = |entry: &super::super::read::PdoEntry| {
                let place = u64::from(entry.index) << 16 | u64::from(entry.subindex) << 8;
                if entry.index == 0 {
                    u64::from(entry.bits & 0xFF)
                } else {
                    place | u64::from(entry.bits & 0xFF)
                }
            };
            let values = pdo.entries.iter().map(word).collect();
            Some(Made {
                access: access(!pdo.fixed && basis.maps),
                name: pdo.name.as_deref().unwrap_or_default(),
                values,
            })
        }
    }
}

/// Reports what of the file is not as it follows from its PDOs.
fn compare(object: &Object, made: &Made<'_>, report: &mut Report) {
    if object.name.as_ref().is_some_and(|name| !words::alike(name, made.name)) {
        report.lose(
            object.at,
            1,
            "the name of an object that follows from others",
            "it has one that follows",
        );
    }
    let category = |value: &Value| value.flags.category.as_deref().and_then(words::category_of);
    let entries: Vec<&Value> = object.values.iter().filter(|value| value.subindex > 0).collect();
    if entries.iter().filter_map(|entry| category(entry)).any(|category| category != Category::Mandatory) {
        let why = "what follows from others is mandatory";
        report.lose(object.at, 1, "the category of an object that follows from others", why);
    }
    if !matches!(object.index, 0x1C00 | 0x1C10 | 0x1C11) {
        beyond(object, made, &entries, report);
        defaults(made, &entries, report);
    }
}

/// Reports entries that a PDO does not fill.
fn beyond(object: &Object, made: &Made<'_>, entries: &[&Value], report: &mut Report) {
    let beyond = entries.get(made.values.len()..).unwrap_or_default();
    if !beyond.is_empty() && !matches!(object.index, 0x1C12 | 0x1C13) {
        let facts = beyond.iter().map(|entry| facts(entry)).sum();
        report.lose(
            object.at,
            facts,
            "entries of a mapping object beyond those of its PDO",
            "they follow from the PDO",
        );
    }
}

/// Reports defaults that are not what the PDOs say.
fn defaults(made: &Made<'_>, entries: &[&Value], report: &mut Report) {
    for (entry, value) in entries.iter().zip(&made.values) {
        let stated = entry.default.as_ref().and_then(|datum| integer(&datum.written));
        if stated.is_some_and(|stated| stated != *value) {
            let why = "it follows from the PDOs, which say otherwise";
            report.lose(entry.at, 1, "the default of a mapping or assignment object", why);
        }
    }
}

fn integer(written: &Written) -> Option<u64> {
    match written {
        Written::Data(bytes) if bytes.len() <= 8 => {
            Some(bytes.iter().rev().fold(0, |value, byte| value << 8 | u64::from(*byte)))
        }
        Written::Number(text) => number(text),
        _ => None,
    }
}

/// Who may write it, where that is not what devc would make of it.
fn access(object: &Object, made: Access, report: &mut Report) -> Keys {
    let of = |value: &Value| value.flags.access.as_deref().and_then(words::access_of).unwrap_or(Access::Ro);
    let count = object.values.iter().find(|value| value.subindex == 0).map(of);
    let entries = object.values.iter().find(|value| value.subindex > 0).map(of);
    let all = entries.or(count).unwrap_or(made);
    let mut keys = Keys::new();
    let is_profile = object.index >= 0x1C00;
    let own = count.filter(|count| *count != all);
    if all != made || is_profile && own.is_some() {
        set(&mut keys, "access", Toml::text(words::access(all)));
    }
    let window = |value: &Value| value.flags.write_restrictions.as_deref().and_then(words::window_of);
    let windows: Vec<_> = object.values.iter().filter(|value| of(value) != Access::Ro).map(window).collect();
    if let Some(Some(window)) = windows.first().filter(|first| windows.iter().all(|it| it == *first)) {
        if is_profile && keys.is_empty() {
            set(&mut keys, "access", Toml::text(words::access(all)));
        }
        set(&mut keys, "written", Toml::text(words::window(*window)));
    } else if windows.iter().any(Option::is_some) {
        report.lose(
            object.at,
            1,
            "WriteRestrictions of an object that follows from others",
            "not all entries have it",
        );
    }
    if let Some(count) = own {
        let table = vec![("access".to_owned(), Toml::text(words::access(count)))];
        set(&mut keys, "entries", Toml::Table(vec![("0".to_owned(), Toml::Table(table))]));
    }
    keys
}
