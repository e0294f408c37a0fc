//! The comment at the head of the file: where it is from, and what in it no source states.
//!
//! It stands outside of every element because some readers take no comments within them.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::literal::prose;
use super::unit;
use crate::model::{Assumption, Device, Family, Place, Section};
use crate::source::parts;

/// What of a PDO is in the file.
const OF_PDO: &[&str] =
    &["name", "names", "entries", "fixed", "mandatory", "excludes", "sync-unit", "virtual", "oversampling"];

/// What of a description is in the file: sections, and the keys of them if not all are. Objects and PDOs are there whole,
/// but for what only a reference says.
const IN_FILE: &[(Section, &[&str])] = &[
    (
        Section::Device,
        &[
            "name",
            "vendor",
            "group",
            "type-name",
            "profile",
            "physics",
            "title",
            "names",
            "url",
            "urls",
            "ebus-current",
            "no-lrw",
            "image",
        ],
    ),
    (
        Section::Identity,
        &[
            "vendor-id",
            "product-code",
            "revision",
            "serial",
            "replaces",
            "check-product-code",
            "check-revision",
            "requested-id",
            "id-address",
        ],
    ),
    (Section::Eeprom, &["size", "config-data", "bootstrap"]),
    (Section::Axes, &["names", "add-info"]),
    (Section::Modules, &["name", "axes"]),
    (Section::Enumerations, &["values"]),
    (Section::Units, &["symbol", "raw-per-unit"]),
    (
        Section::Slots,
        &["name", "names", "min", "max", "index-step", "pdo-step", "modules", "default", "classes"],
    ),
    (
        Section::Mailbox,
        &[
            "protocols",
            "sdo-info",
            "pdo-assign",
            "pdo-config",
            "complete-access",
            "segmented",
            "pdo-upload",
            "aoe-router",
            "aoe-generates-net-id",
            "aoe-initialize-net-id",
            "eoe-ip",
            "eoe-mac",
        ],
    ),
    (Section::Timeouts, &["pre-op", "safe-op-op", "back-to-init", "back-to-safe-op", "request", "response"]),
    (
        Section::SyncManagers,
        &[
            "role", "number", "address", "min-size", "size", "max-size", "control", "enable", "op-only",
            "virtual", "pdos",
        ],
    ),
    (Section::SyncModes, &["name", "assign-activate", "sync0", "sync1", "managers", "default"]),
    (Section::Diagnosis, &["text", "texts", "class", "about", "remedy"]),
    (Section::RxPdos, OF_PDO),
    (Section::TxPdos, OF_PDO),
    (
        Section::Objects,
        &[
            "name",
            "names",
            "kind",
            "type",
            "access",
            "pdo",
            "safety",
            "category",
            "unit",
            "default",
            "min",
            "max",
            "values",
            "written",
            "entries",
            "about",
            "note",
            "functional",
            "backup",
            "setting",
            "sdo-access",
            "properties",
        ],
    ),
];

/// Whether the file says what is assumed.
fn is_in_file(assumption: &Assumption, device: &Device) -> bool {
    if assumption.at.section == Section::Configurations {
        let default = device.configurations.iter().find(|configuration| configuration.default);
        return default
            .is_some_and(|default| assumption.at.key == Section::Configurations.at(&default.id).key);
    }
    let keys = IN_FILE.iter().find(|(section, _)| *section == assumption.at.section).map(|(_, keys)| keys);
    let mut path = assumption.at.path.iter().flat_map(|path| parts(path));
    // behind `per-axis` the axis comes, and then the key
    let first = path.next().and_then(|first| if first == "per-axis" { path.nth(1) } else { Some(first) });
    let is_unit = assumption.at.section == Section::Units || first == Some("unit");
    keys.is_some_and(|keys| first.is_none_or(|first| keys.contains(&first)))
        && (!is_unit || has_unit(&assumption.at, device))
}

/// Whether values at a place, or in a unit, have a unit in the file: not each has a code.
fn has_unit(place: &Place, device: &Device) -> bool {
    let entries =
        device.objects.iter().flat_map(|object| object.entries.iter().map(move |entry| (object, entry)));
    let mut meant = entries.filter(|(object, entry)| match place.section {
        Section::Units => entry.unit.iter().any(|unit| Section::Units.at(unit).key == place.key),
        _ => Place::from(object.index).key == place.key,
    });
    meant.any(|(object, entry)| unit::of(device, entry, object.axis).is_some())
}

/// What the file says although the description does not.
fn unsaid(device: &Device) -> impl Iterator<Item = String> + use<> {
    let head = [("physics", &device.physics), ("group", &device.group), ("type-name", &device.type_name)];
    let head = head.into_iter().filter(|(key, _)| !device.origin.has(key));
    let head: Vec<_> =
        head.map(|(key, value)| format!("device.{key} = {value}: the description does not say it")).collect();
    let size = (device.eeprom.is_described() && !device.eeprom.origin.has("size"))
        .then(|| format!("eeprom.size = {}: usual", device.eeprom.size));
    let control = device.sync_managers.iter().filter(|manager| !manager.origin.has("control"));
    let control = control.map(|manager| {
        let (id, control) = (&manager.id, manager.control);
        format!("sync-managers.{id}.control = 0x{control:02X}: usual for what it carries")
    });
    let control: Vec<_> = control.collect();
    let free = device.mailbox.as_ref().is_some_and(|mailbox| mailbox.pdo_config);
    let fixed = device.pdos.iter().any(|pdo| pdo.fixed && free && !pdo.origin.has("fixed"));
    let fixed =
        fixed.then(|| "Fixed = 1: where the description does not say that a mapping is free".to_owned());
    let layer =
        device.mailbox.as_ref().map(|_| "DataLinkLayer = 1: mail is acknowledged, as is usual".to_owned());
    let keys = ["sdo-info", "pdo-assign", "pdo-config", "complete-access", "segmented"];
    let said = |key: &&str| device.mailbox.as_ref().is_none_or(|mailbox| mailbox.origin.has(key));
    let keys: Vec<&str> = keys.into_iter().filter(|key| !said(key)).collect();
    let lines = keys.into_iter().map(|key| format!("mailbox.{key} = false: the description does not say it"));
    let fmmus = (!device.sync_managers.is_empty()).then(|| {
        "Fmmu: one for each sync manager of process data and one for the state of the mailbox, as is usual".to_owned()
    });
    let silent = device.sync_managers.iter().any(|manager| manager.enable && !manager.origin.has("enable"));
    let enable =
        silent.then(|| "Sm Enable = 1: each sync manager that carries something is in use".to_owned());
    head.into_iter()
        .chain(size)
        .chain(lines)
        .chain(layer)
        .chain(control)
        .chain(fmmus)
        .chain(enable)
        .chain(fixed)
}

/// The text of the comment.
pub(super) fn heading(family: &Family) -> String {
    let mut text = format!(
        "\n  Generated by devc from the description \"{}\". Edit the description, not this file.\n",
        family.id
    );
    let assumptions = assumptions(family);
    if !assumptions.is_empty() {
        text.push_str("\n  No source states what follows; it is assumed:\n");
    }
    for assumption in assumptions {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  - {assumption}");
    }
    text
}

/// What is assumed, each line once, with the device in front where it does not hold for all.
fn assumptions(family: &Family) -> Vec<String> {
    let own = |device: &Device| device.assumptions.iter().map(line).collect::<BTreeSet<_>>();
    let mut members = family.members.iter().map(own);
    let first = members.next().unwrap_or_default();
    let everywhere = members.fold(first, |all, own| all.intersection(&own).cloned().collect());
    let (mut seen, mut lines) = (BTreeSet::new(), Vec::new());
    for device in &family.members {
        for assumption in device.assumptions.iter().filter(|assumption| is_in_file(assumption, device)) {
            let text = line(assumption);
            let text = if everywhere.contains(&text) { text } else { format!("{}: {text}", device.name) };
            if seen.insert(text.clone()) {
                lines.push(text);
            }
        }
        for line in unsaid(device) {
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
    }
    lines
}

fn line(assumption: &Assumption) -> String {
    let value = assumption.value.iter().map(|value| format!(" = {value}"));
    prose(&format!("{}{}: {}", assumption.at, value.collect::<String>(), assumption.reason))
}
