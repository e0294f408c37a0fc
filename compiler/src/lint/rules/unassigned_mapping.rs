use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Configuration, Device, Pdo, Role, Section};

rule! {
    /// What is mapped to a PDO travels where the PDO is assigned to a sync manager. A configuration that maps one that it does not
    /// assign, nor the device by default, writes a mapping that has no effect.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects]
    /// 0x1000 = { default = 0 }
    /// 0x1018 = {}
    /// 0x2000 = { name = "Speed", type = "UINT16", pdo = "tx" }
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Values", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Further values", entries = [], fixed = false, max-entries = 1 }
    ///
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// inputs = { address = 0x1400, pdos = ["0x1A00"], slots = 2 }
    ///
    /// [mailbox]
    /// protocols = ["CoE"]
    /// pdo-assign = true
    /// pdo-config = true
    ///
    /// [configurations.further]
    /// name = "Further values"
    /// inputs = ["0x1A00"]
    /// mapping = { 0x1A01 = ["0x2000"] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects]
    /// 0x1000 = { default = 0 }
    /// 0x1018 = {}
    /// 0x2000 = { name = "Speed", type = "UINT16", pdo = "tx" }
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Values", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Further values", entries = [], fixed = false, max-entries = 1 }
    ///
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// inputs = { address = 0x1400, pdos = ["0x1A00"], slots = 2 }
    ///
    /// [mailbox]
    /// protocols = ["CoE"]
    /// pdo-assign = true
    /// pdo-config = true
    ///
    /// [configurations.further]
    /// name = "Further values"
    /// inputs = ["0x1A01"]
    /// mapping = { 0x1A01 = ["0x2000"] }
    /// ```
    pub(super) static RULE = "unassigned-mapping", ProcessData, Warning,
        "a configuration maps a PDO that nothing carries";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        let idle = configuration.mapping.iter().filter(|pdo| !is_carried(device, configuration, pdo));
        for pdo in idle {
            let message = format!("{} is mapped, but not assigned", pdo.index);
            let at = configuration.origin.value(&format!("mapping.{}", pdo.leading));
            let diagnostic = Diagnostic::new(&RULE, message, at, "has no effect");
            let key = Role::of(pdo.direction).key();
            let diagnostic = match configuration.origin.has(key) {
                true => diagnostic.label(configuration.origin.value(key), "what is assigned"),
                false => diagnostic.note("what the device assigns by default does not have it"),
            };
            let place = Section::Configurations.at(&configuration.id).at(format!("mapping.{}", pdo.index));
            report.push(place, diagnostic.help(format!("name it in `{key}`, or leave its mapping out")));
        }
    }
}

/// Whether a sync manager carries it, or nobody says what is carried.
fn is_carried(device: &Device, configuration: &Configuration, pdo: &Pdo) -> bool {
    let role = Role::of(pdo.direction);
    match configuration.assigned(pdo.direction) {
        Some(assigned) => assigned.contains(&pdo.index),
        None => {
            let mut carried = device.assigned(role).map(|pdo| pdo.index).peekable();
            carried.peek().is_none() || carried.any(|index| index == pdo.index)
        }
    }
}
