//! Sync managers and PDOs.

use super::element::Element;
use super::esi::{Fmmu, Pdo, PdoEntry, Sm};
use super::number::{number, truth};
use super::words;
use crate::model::Oversampling;

/// A mapping unit.
pub(super) fn fmmu(element: &Element<'_>) -> Fmmu {
    element.says_usual("OpOnly");
    Fmmu {
        at: element.at(),
        name: element.text().to_owned(),
        sm: element.attribute_as("Sm", number),
        su: element.attribute_as("Su", number),
    }
}

pub(super) fn sm(element: &Element<'_>) -> Sm {
    element.says_usual("Watchdog");
    Sm {
        at: element.at(),
        name: element.text().to_owned(),
        address: element.attribute_as("StartAddress", number),
        default_size: element.attribute_as("DefaultSize", number),
        min_size: element.attribute_as("MinSize", number),
        max_size: element.attribute_as("MaxSize", number),
        control: element.attribute_as("ControlByte", number),
        enable: element
            .attribute_as("Enable", |text| truth(text).or(number::<u8>(text).map(|it| it & 1 == 1))),
        op_only: element.attribute_as("OpOnly", truth).unwrap_or(false),
        r#virtual: element.attribute_as("Virtual", truth).unwrap_or(false),
    }
}

pub(super) fn pdo(element: &Element<'_>) -> Option<Pdo> {
    element.says_usual("OverwrittenByModule");
    let fixed = element.attribute_as("Fixed", truth).unwrap_or(false);
    // What is in a fixed PDO is fixed.
    element
        .all("Entry")
        .for_each(|entry| _ = entry.attribute_as("Fixed", |text| truth(text).filter(|it| *it == fixed)));
    Some(Pdo {
        at: element.at(),
        index: index(element)?,
        name: words::name(element, "Name"),
        names: words::others(element, "Name"),
        fixed,
        mandatory: element.attribute_as("Mandatory", truth).unwrap_or(false),
        sm: element.attribute_as("Sm", number),
        su: element.attribute_as("Su", number),
        r#virtual: element.attribute_as("Virtual", truth).unwrap_or(false),
        oversampling: oversampling(element),
        excludes: element.all("Exclude").filter_map(|it| Some((number(it.text())?, it.at()))).collect(),
        entries: element.all("Entry").filter_map(entry).collect(),
    })
}

/// Whether it depends on a slot says something in modules only, which ask for it themselves.
fn index(element: &Element<'_>) -> Option<u16> {
    let index = element.child_as("Index", number)?;
    element.child("Index")?.attribute("DependOnSlot");
    Some(index)
}

/// How often its values can be there; not without how often they are.
fn oversampling(element: &Element<'_>) -> Option<Oversampling> {
    let factor = element.attribute_as("OSFac", number)?;
    let of = |name| element.attribute_as(name, number);
    Some(Oversampling { factor, min: of("OSMin"), max: of("OSMax"), step: of("OSIndexInc") })
}

fn entry(element: &Element<'_>) -> Option<PdoEntry> {
    Some(PdoEntry {
        at: element.at(),
        index: index(element).unwrap_or(0),
        subindex: element.child_as("SubIndex", number).unwrap_or(0),
        bits: element.child_as("BitLen", number)?,
        name: words::name(element, "Name"),
        names: words::others(element, "Name"),
        comment: words::name(element, "Comment"),
        data_type: element.child("DataType").map(|it| it.text().to_owned()).filter(|it| !it.is_empty()),
    })
}
