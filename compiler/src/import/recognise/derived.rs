//! Objects that devc makes itself: mapping and assignment objects and 0x1C00. Only what it would make otherwise is said.

use std::borrow::Cow;

use super::super::read::{Object, Pdo, PdoEntry, Value, Written, number};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, get, set, set_some};
use super::draft::Block;
use super::profile::{Base, Known};
use super::sync_managers::{self, Manager};
use super::types::data_type;
use super::words;
use crate::model::{Access, Category, WriteWindow};

/// What the objects follow from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Basis<'b> {
    pub(super) rx: &'b [&'b Pdo],
    pub(super) tx: &'b [&'b Pdo],
    pub(super) managers: &'b [Manager<'b>],
    /// Whether the master may write assignments and mappings.
    pub(super) assigns: bool,
    pub(super) maps: bool,
}

impl<'b> Basis<'b> {
    /// The PDO of an index.
    pub(super) fn pdo(&self, index: u16) -> Option<&'b Pdo> {
        self.rx.iter().chain(self.tx).copied().find(|pdo| pdo.index == index)
    }
}

/// What devc makes of an object.
struct Made<'b> {
    access: Access,
    name: Cow<'b, str>,
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

/// Whether an object follows from a PDO or a sync manager of the device. If not, it is an object as any other.
pub(super) fn follows(object: &Object, basis: &Basis<'_>) -> bool {
    let is_nothing = |value: &Value| data_type(&value.type_name, value.bits).is_none();
    let mut values = object.values.iter();
    let is_empty =
        object.index >= ASSIGNMENTS && values.all(|value| value.subindex == 0 || is_nothing(value));
    is_derived(object.index) && (is_empty || made(object.index, basis).is_some())
}

/// What is to be said of a derived object, if it is not as devc makes it.
pub(super) fn block(object: &Object, basis: &Basis<'_>, known: &Known, report: &mut Report) -> Option<Block> {
    // The assignment of a sync manager without PDOs is there only if it is mentioned.
    let made = made(object.index, basis);
    let is_mentioned = made.is_none();
    let made = made.unwrap_or_else(|| Made {
        access: Access::Ro,
        name: Cow::Owned(assignment(object.index)),
        values: Vec::new(),
    });
    let mut keys = Keys::new();
    let own_name = object.name.as_ref();
    if let Some(name) = own_name.filter(|it| words::is_other(it, Some(&made.name), object.at, report)) {
        set(&mut keys, "name", Toml::text(name));
    }
    let entries: Vec<&Value> = object.values.iter().filter(|value| value.subindex > 0).collect();
    let category = category(object, &entries, report);
    contradictions(object, &made, report);
    let all = entries.first().map(|entry| entry.flags.access.as_deref().and_then(words::access_of));
    let besides = besides(object, &entries, all.flatten(), report);
    let access = access(object).unwrap_or(made.access);
    let window = window(object, report);
    let made_window =
        |access: Access| Some(WriteWindow::PreOp).filter(|_| made.access.writable() && access.writable());
    let is_said = is_mentioned
        || !keys.is_empty()
        || !besides.is_empty()
        || access != made.access
        || window.is_some() && window != made_window(made.access)
        || category.is_some_and(|category| category != Category::Mandatory);
    // What is mentioned takes what its profile says.
    let base = known.object(object.index).map(Base::value).unwrap_or_default();
    let mut say = |name: &str, own: Option<&'static str>, made: Option<&'static str>| {
        let made = get(&base, name).cloned().or_else(|| made.map(Toml::text));
        set_some(&mut keys, name, own.map(Toml::text).filter(|own| Some(own) != made.as_ref()));
    };
    say("category", category.map(words::category), Some(words::category(Category::Mandatory)));
    say("access", Some(words::access(access)), Some(words::access(made.access)));
    say("written", window.map(words::window), made_window(access).map(words::window));
    keys.extend(besides);
    is_said.then(|| Block::new("objects", Some(format!("0x{:04X}", object.index)), keys))
}

/// The object that says what each sync manager is for.
pub(super) const TYPES: u16 = 0x1C00;

/// The first assignment object, that of sync manager 0.
pub(super) const ASSIGNMENTS: u16 = 0x1C10;

/// The name of an assignment object.
fn assignment(index: u16) -> String {
    format!("Sync manager {} PDO assignment", index & 0xF)
}

fn made<'b>(index: u16, basis: &Basis<'b>) -> Option<Made<'b>> {
    let access = |free| if free { Access::Rw } else { Access::Ro };
    match index {
        TYPES => (!basis.managers.is_empty()).then(|| Made {
            access: Access::Ro,
            name: Cow::Borrowed("Sync manager communication type"),
            values: Vec::new(),
        }),
        ASSIGNMENTS.. => {
            let number = index - ASSIGNMENTS;
            let carries = |it: &&Manager<'_>| u16::from(it.number) == number && it.role.is_process_data();
            let manager = basis.managers.iter().find(carries)?;
            let carried = sync_managers::carried(manager, [basis.rx, basis.tx]);
            Some(Made {
                access: access(basis.assigns),
                name: Cow::Owned(assignment(index)),
                values: carried.iter().map(|pdo| pdo.index.into()).collect(),
            })
        }
        index => {
            let pdo = basis.pdo(index)?;
            Some(Made {
                access: access(!pdo.fixed && basis.maps),
                name: Cow::Borrowed(pdo.name.as_deref().unwrap_or_default()),
                values: pdo.entries.iter().map(word).collect(),
            })
        }
    }
}

/// What a mapping object holds for an entry.
pub(super) fn word(entry: &PdoEntry) -> u64 {
    let place = u64::from(entry.index) << 16 | u64::from(entry.subindex) << 8;
    u64::from(entry.bits & 0xFF) | if entry.index == 0 { 0 } else { place }
}

/// Whether a profile demands the entries, or, where there are none, the object.
fn category(object: &Object, entries: &[&Value], report: &mut Report) -> Option<Category> {
    let of = |value: &&Value| value.flags.category.as_deref().and_then(words::category_of);
    if entries.is_empty() {
        return object.flags.category.as_deref().and_then(words::category_of);
    }
    let first = entries.iter().find_map(of)?;
    for other in entries.iter().filter(|entry| of(entry).is_some_and(|category| category != first)) {
        let what = format!("the category of subindex {} of what follows from PDOs", other.subindex);
        report.lose(other.at, 1, what, "that of the first entry is taken for all");
    }
    Some(first)
}

/// Reports defaults that are not what the PDOs say, and widths that no such object has.
fn contradictions(object: &Object, made: &Made<'_>, report: &mut Report) {
    let bits = match object.index {
        TYPES => 8,
        ASSIGNMENTS.. => 16,
        _ => 32,
    };
    let entries = object.values.iter().filter(|value| value.subindex > 0);
    for entry in entries.clone().filter(|entry| entry.bits.is_some_and(|it| it != bits)) {
        let what = format!("the width of 0x{:04X}:{:02X}", object.index, entry.subindex);
        report.lose(entry.at, 1, what, format!("what lists PDOs or what is mapped has {bits} bits"));
    }
    if object.index != TYPES {
        let count = object.values.iter().filter(|value| value.subindex == 0);
        let used = u64::try_from(made.values.len()).unwrap_or(u64::MAX);
        let values = made.values.iter().copied().chain(std::iter::repeat(0));
        for (entry, value) in count.map(|count| (count, used)).chain(entries.zip(values)) {
            let stated = entry.default.as_ref().and_then(|datum| integer(&datum.written));
            if stated.is_some_and(|stated| stated != value) {
                let what = format!("a default of 0x{:04X}", object.index);
                report.lose(entry.at, 1, what, "it follows from the PDOs, which say otherwise");
            }
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

/// Who may write what it lists.
fn access(object: &Object) -> Option<Access> {
    let of = |value: &Value| value.flags.access.as_deref().and_then(words::access_of).unwrap_or(Access::Ro);
    let count = object.values.iter().find(|value| value.subindex == 0).map(of);
    object.values.iter().find(|value| value.subindex > 0).map(of).or(count)
}

/// When it can be written, if all that can be written says the same.
fn window(object: &Object, report: &mut Report) -> Option<WriteWindow> {
    let is_written = |value: &&Value| {
        value.flags.access.as_deref().and_then(words::access_of).is_some_and(Access::writable)
    };
    let window = |value: &Value| value.flags.write_restrictions.as_deref().and_then(words::window_of);
    let windows: Vec<_> = object.values.iter().filter(is_written).map(window).collect();
    let first = windows.first().copied().flatten();
    if windows.iter().any(|window| *window != first) {
        let what = format!("WriteRestrictions of 0x{:04X}", object.index);
        report.lose(object.at, 1, what, "not all entries have it");
        return None;
    }
    first
}

/// What the entries say besides, and what subindex 0 does, each where it is the same for all.
fn besides(object: &Object, entries: &[&Value], all: Option<Access>, report: &mut Report) -> Keys {
    let mut keys = Keys::new();
    if let Some(first) = entries.first().map(|entry| extras(entry)) {
        for entry in entries {
            let lost = extras(entry).iter().filter(|extra| !first.contains(extra)).count();
            if lost > 0 {
                let what = format!("limits and flags of 0x{:04X}:{:02X}", object.index, entry.subindex);
                report.lose(
                    entry.at,
                    lost,
                    what,
                    "what lists PDOs or what is mapped says them once, for all",
                );
            }
        }
        keys.extend(first);
    }
    let count = object.values.iter().find(|value| value.subindex == 0);
    let mut own = count.map(extras).unwrap_or_default();
    let access = count.and_then(|count| count.flags.access.as_deref()).and_then(words::access_of);
    if let Some(access) = access.filter(|access| all.is_some_and(|all| all != *access)) {
        own.insert(0, ("access".to_owned(), Toml::text(words::access(access))));
    }
    if !own.is_empty() {
        set(&mut keys, "entries", Toml::Table(vec![("0".to_owned(), Toml::Table(own))]));
    }
    keys
}

/// Whether a limit is that of the type, a number without a sign, which says nothing.
fn is_bound(name: &str, limit: u64, bits: Option<u32>) -> bool {
    let greatest = bits.filter(|bits| *bits < 64).map(|bits| (1_u64 << bits) - 1);
    name == "min" && limit == 0 || name == "max" && Some(limit) == greatest
}

/// The flags and limits of an entry.
fn extras(value: &Value) -> Keys {
    let mut keys = Keys::new();
    for (name, limit) in [("min", &value.min), ("max", &value.max)] {
        let limit = limit.as_ref().and_then(|datum| integer(&datum.written));
        if let Some(limit) = limit.filter(|limit| !is_bound(name, *limit, value.bits)) {
            set(&mut keys, name, Toml::Integer(limit.into()));
        }
    }
    for (name, is_so) in [("backup", value.flags.backup), ("setting", value.flags.setting)] {
        if is_so {
            set(&mut keys, name, Toml::Bool(true));
        }
    }
    keys
}
