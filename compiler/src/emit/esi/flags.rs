//! `Flags`: who may read, write and map a value.

use super::element::Element;
use crate::model::{Access, Category, Entry, Kind, Mappable, Object, Safety, SdoAccess, WriteWindow};

/// The flags of an entry. A `SubItem` gets them all, since they hide those of its object as a whole.
pub(super) fn of_entry(entry: &Entry) -> Element {
    let special =
        Special { safety: entry.safety, sdo_access: None, backup: entry.backup, setting: entry.setting };
    flags(access(entry), entry.category, entry.pdo, special)
}

/// The flags of an object: those of its value, or for an object of several what holds for any of them.
pub(super) fn of_object(object: &Object) -> Element {
    let is_alone = object.kind == Kind::Var || object.entries.len() == 1;
    let values = || object.entries.iter().filter(|entry| is_alone || entry.address.subindex > 0);
    let readable = values().any(|entry| entry.access.readable());
    let writable = values().any(|entry| entry.access.writable());
    let first = values().next().filter(|first| values().all(|entry| access(entry) == access(first)));
    let access = first.map_or_else(|| Element::leaf("Access", word(readable, writable)), access);
    let rx = values().any(|entry| entry.pdo.rx());
    let tx = values().any(|entry| entry.pdo.tx());
    let safety = values().next().and_then(|first| first.safety);
    let special = Special {
        safety: safety.filter(|safety| values().all(|entry| entry.safety == Some(*safety))),
        sdo_access: object.sdo_access,
        backup: values().any(|entry| entry.backup),
        setting: values().any(|entry| entry.setting),
    };
    flags(access, object.category, Mappable::of(rx, tx), special)
}

/// What few values are: of weight to safety, transferred in one way only, kept by tools.
struct Special {
    safety: Option<Safety>,
    sdo_access: Option<SdoAccess>,
    backup: bool,
    setting: bool,
}

fn flags(access: Element, category: Category, pdo: Mappable, special: Special) -> Element {
    let category = match category {
        Category::Mandatory => "m",
        Category::Optional => "o",
        Category::Conditional => "c",
    };
    let mapping = match pdo {
        Mappable::None => None,
        Mappable::Rx => Some("R"),
        Mappable::Tx => Some("T"),
        Mappable::RxTx => Some("TR"),
    };
    Element::new("Flags")
        .child(access)
        .child(Element::leaf("Category", category))
        .child(mapping.map(|directions| Element::leaf("PdoMapping", directions)))
        .child(special.safety.map(|safety| Element::leaf("SafetyMapping", safety.name())))
        .child(special.sdo_access.map(|access| Element::leaf("SdoAccess", access.name())))
        .child(special.backup.then(|| Element::leaf("Backup", 1)))
        .child(special.setting.then(|| Element::leaf("Setting", 1)))
}

fn access(entry: &Entry) -> Element {
    let word = match entry.access {
        Access::Ro | Access::Const => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
    };
    Element::leaf("Access", word).with_some("WriteRestrictions", entry.written.map(WriteWindow::name))
}

fn word(readable: bool, writable: bool) -> &'static str {
    match (readable, writable) {
        (_, false) => "ro",
        (false, true) => "wo",
        (true, true) => "rw",
    }
}
