use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Field, HomingBits, Mode, Place, Section};
use crate::source::Origin;

rule! {
    /// Each bit of a word or a register has one meaning, and in each mode of operation one. Two fields that share a
    /// bit cannot both be right, and a field beyond the last bit has no place.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Status"
    /// type = "UINT16"
    ///
    /// [words.status]
    /// object = "0x2000"
    /// bits = { 0 = "ready", "0..=1" = "state" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Status"
    /// type = "UINT16"
    ///
    /// [words.status]
    /// object = "0x2000"
    /// bits = { 0 = "ready", "1..=2" = "state" }
    /// ```
    pub(super) static RULE = "overlapping-bits", StateMachine, Error, "a bit has two meanings";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for word in &device.words {
        let at = Section::Words.at(&word.id);
        pairs(&word.fields, &word.origin, "bits", &at, report);
        beyond(&word.fields, &word.name, word.bits, &word.origin, &at, report);
    }
    for register in &device.registers {
        let at = Section::Registers.at(register.address);
        pairs(&register.fields, &register.origin, "bits", &at, report);
        let bits = u32::from(register.length) * 8;
        beyond(&register.fields, &register.name, bits, &register.origin, &at, report);
    }
    for mode in &device.modes {
        for (key, bits) in [("control-bits", &mode.control_bits), ("status-bits", &mode.status_bits)] {
            pairs(bits, &mode.origin, key, &Section::Modes.at(mode.code).at(key), report);
        }
        homing(mode, report);
    }
}

/// Reports a bit of the statusword that tells two things of a reference run.
fn homing(mode: &Mode, report: &mut Report) {
    let Some(HomingBits { start: _, reached, attained, error }) = mode.homing_bits else { return };
    for ((first, a), (second, b)) in [
        (("reached", reached), ("attained", attained)),
        (("reached", reached), ("error", error)),
        (("attained", attained), ("error", error)),
    ] {
        if a == b {
            let message = format!("bit {a} of the statusword is `{first}` and `{second}`");
            let at = |key| mode.origin.value(&format!("homing-bits.{key}"));
            let diagnostic =
                Diagnostic::new(&RULE, message, at(second), "again here").label(at(first), "first here");
            report.push(Section::Modes.at(mode.code).at("homing-bits"), diagnostic);
        }
    }
}

fn beyond(fields: &[Field], name: &str, bits: u32, origin: &Origin, at: &Place, report: &mut Report) {
    for field in fields.iter().filter(|field| u32::from(field.high) >= bits) {
        let message = format!("`{name}` has no bit {}: it has {bits} of them", field.high);
        let place = origin.value(&field.path("bits"));
        report.push(at.clone(), Diagnostic::new(&RULE, message, place, "beyond the last bit"));
    }
}

/// Reports each field that shares a bit with one before it, with the first that has the lowest of these bits.
fn pairs(fields: &[Field], origin: &Origin, bits: &str, at: &Place, report: &mut Report) {
    let mut holders: BTreeMap<u32, &Field> = BTreeMap::new();
    for second in fields {
        let own = || (0..u64::BITS).filter(|bit| second.mask() >> bit & 1 != 0);
        if let Some((bit, first)) = own().find_map(|bit| Some((bit, *holders.get(&bit)?))) {
            let message = format!("bit {bit} is `{}` and `{}`", first.name, second.name);
            let diagnostic = Diagnostic::new(&RULE, message, origin.value(&second.path(bits)), "again here")
                .label(origin.value(&first.path(bits)), "first here");
            report.push(at.clone(), diagnostic);
        }
        own().for_each(|bit| {
            holders.entry(bit).or_insert(second);
        });
    }
}
