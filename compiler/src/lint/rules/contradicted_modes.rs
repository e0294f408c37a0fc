use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Entry, Mode, Object};

rule! {
    /// Object 0x6502 has a bit for each mode of operation that the drive knows. Masters read it to offer the
    /// modes there are, and refuse the others.
    ///
    /// Only the bits that the profile defines are compared, and only if the modes are described.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6060]
    /// [objects.0x6061]
    /// [objects.0x6502]
    /// default = 0
    ///
    /// [modes.6]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6060]
    /// [objects.0x6061]
    /// [objects.0x6502]
    /// default = 0x20
    ///
    /// [modes.6]
    /// ```
    pub(super) static RULE = "contradicted-modes", StateMachine, Warning,
        "the bits of 0x6502 are not the modes there are";
}

/// The bits that the profile defines; those above are the manufacturer's.
const STANDARD: i128 = 0xFFFF;

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.modes.is_empty() {
        return;
    }
    for object in lookup::on_axes(device, 0x6502) {
        if let Some(entry) = object.entry(0) {
            judge(device, object, entry, report);
        }
    }
}

fn judge(device: &Device, object: &Object, entry: &Entry, report: &mut Report) {
    let Some(says) = entry.default.as_ref().and_then(|default| default.integer()) else { return };
    let holds = bits(&device.modes) | (says & !STANDARD);
    if says == holds {
        return;
    }
    let message = format!("{} says {says:#010X}, but the modes described make {holds:#010X}", object.index);
    let message = message.replace("0X", "0x");
    let at = entry.origin.value("default");
    let mut diagnostic = Diagnostic::new(&RULE, message, at, label(says, holds));
    for (mode, bit) in device.modes.iter().filter_map(|mode| Some((mode, listed(mode)?))) {
        if says >> bit & 1 == 0 {
            diagnostic = diagnostic.label(mode.origin.header(), format!("mode {} is bit {bit}", mode.code));
        }
    }
    let value = format!("0x{holds:08X}");
    let diagnostic = diagnostic.note("the device may fill the value in when it starts");
    report.push(object.index, diagnostic.suggest("name the modes that are described", at, value));
}

fn bits(modes: &[Mode]) -> i128 {
    modes.iter().filter_map(listed).fold(0, |bits, bit| bits | 1 << bit)
}

/// The bit that announces a mode, if 0x6502 has it; another rule finds it if not.
fn listed(mode: &Mode) -> Option<u8> {
    mode.supported_bit.filter(|bit| *bit < 32)
}

fn label(says: i128, holds: i128) -> String {
    let set = |bits: i128| (0..32_u8).filter(|bit| bits >> bit & 1 == 1).collect::<Vec<_>>();
    let (missing, extra) = (set(holds & !says), set(says & !holds));
    let noun = |bits: &[u8]| if bits.len() == 1 { "bit" } else { "bits" };
    let (without, with) = (lookup::list(&missing), lookup::list(&extra));
    match (missing.is_empty(), extra.as_slice()) {
        (false, []) => format!("without {} {without}", noun(&missing)),
        (false, _) => format!("without {} {without}, but with {with}", noun(&missing)),
        (true, [_]) => format!("bit {with} stands for no mode that is described"),
        (true, _) => format!("bits {with} stand for no mode that is described"),
    }
}
