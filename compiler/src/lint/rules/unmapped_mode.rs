use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::images::{self, Image};
use crate::model::{Address, Device, Direction, Index, Mode, Pdo, Role, Section};

rule! {
    /// In a cyclic mode the master sends a set value in every cycle. If no PDO carries it and none can be
    /// changed to do so, the mode cannot be used.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6040]
    /// [objects.0x6060]
    /// [objects.0x6061]
    /// [objects.0x607A]
    /// [objects.0x6502]
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["controlword"]
    ///
    /// [modes.8]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6040]
    /// [objects.0x6060]
    /// [objects.0x6061]
    /// [objects.0x607A]
    /// [objects.0x6502]
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["controlword", "target-position"]
    ///
    /// [modes.8]
    /// ```
    pub(super) static RULE = "unmapped-mode", ProcessData, Warning,
        "no PDO carries the set value of a cyclic mode";
}

/// The set value of each cyclic mode of CiA 402.
const SET_VALUES: [(i16, Index, &str); 3] = [
    (8, Index(0x607A), "target position"),
    (9, Index(0x60FF), "target velocity"),
    (10, Index(0x6071), "target torque"),
];

pub(super) fn check(device: &Device, report: &mut Report) {
    modes(device, report);
    for image in images::images(device).filter(|image| image.role == Role::Outputs) {
        chosen(device, &image, report);
    }
}

fn modes(device: &Device, report: &mut Report) {
    let mut outputs = device.pdos_of(Direction::Rx).peekable();
    if outputs.peek().is_none() || outputs.any(|pdo| !pdo.fixed) {
        return;
    }
    for mode in device.modes.iter().filter(|mode| mode.cyclic) {
        let Some((code, index, name)) = set_value(mode.code) else { continue };
        if device.pdos_of(Direction::Rx).any(|pdo| carries(pdo, mode, index)) {
            continue;
        }
        let message =
            format!("no receive PDO carries {index}, the {name} that mode {code} needs in each cycle");
        let diagnostic = Diagnostic::new(&RULE, message, mode.origin.header(), "cannot be used without it");
        report.push(Section::Modes.at(code), diagnostic.help("map it, or leave the mode out"));
    }
}

/// A configuration that sets a cyclic mode has to carry its set value.
fn chosen(device: &Device, image: &Image<'_>, report: &mut Report) {
    let Some(configuration) = image.configuration else { return };
    let (Some(code), Some(assigned)) = (configuration.mode, image.assigned()) else { return };
    let mode = device.modes.iter().find(|mode| mode.code == code && mode.cyclic);
    let Some((mode, (_, index, name))) = mode.zip(set_value(code)) else { return };
    if image.pdos.iter().any(|pdo| carries(pdo, mode, index)) {
        return;
    }
    let message = format!("`{}` carries no {index}, the {name} that mode {code} needs", configuration.name);
    let diagnostic = Diagnostic::new(&RULE, message, assigned, "not among these");
    report.push(image.place(), diagnostic.label(configuration.origin.value("mode"), "sets the mode"));
}

fn set_value(code: i16) -> Option<(i16, Index, &'static str)> {
    SET_VALUES.iter().find(|(mode, ..)| *mode == code).copied()
}

/// Whether a PDO is for a mode: because it says so, or because it carries the set value or another object that
/// the mode uses besides controlword and mode.
fn carries(pdo: &Pdo, mode: &Mode, set_value: Index) -> bool {
    let uses = |address: &Address| {
        let common = matches!(address.index.0, 0x6040 | 0x6060);
        address.index == set_value || (mode.objects.contains(address) && !common)
    };
    pdo.mode == Some(mode.code) || pdo.entries.iter().filter_map(|mapped| mapped.address).any(|it| uses(&it))
}
