use crate::diagnostic::{Diagnostic, rule};
use crate::lint::refusal::refusal;
use crate::lint::{Report, lookup};
use crate::model::{ChosenWrite, Configuration, Device, Direction, Entry, Index, Role, Section};
use crate::source::Location;

rule! {
    /// A configuration is brought about by writes through the mailbox. What the device does not let a master write is not in
    /// the start-up list: a PDO would be assigned with its old content, or a mode would stay as it was.
    ///
    /// If something else sets it, as the tool of the vendor, an erratum says so with `stands`.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects]
    /// 0x1000 = { default = 0 }
    /// 0x1018 = {}
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// fixed = false
    ///
    /// [sync-managers.mailbox-out]
    /// address = 0x1000
    /// size = 128
    ///
    /// [sync-managers.mailbox-in]
    /// address = 0x1080
    /// size = 128
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    ///
    /// [mailbox]
    /// protocols = ["CoE"]
    /// pdo-assign = true
    /// pdo-config = false
    ///
    /// [configurations.torque]
    /// name = "Torque"
    /// inputs = ["0x1A00"]
    /// mapping = { 0x1A00 = ["0x2001"] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects]
    /// 0x1000 = { default = 0 }
    /// 0x1018 = {}
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// fixed = false
    ///
    /// [sync-managers.mailbox-out]
    /// address = 0x1000
    /// size = 128
    ///
    /// [sync-managers.mailbox-in]
    /// address = 0x1080
    /// size = 128
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    ///
    /// [mailbox]
    /// protocols = ["CoE"]
    /// pdo-assign = true
    /// pdo-config = true
    ///
    /// [configurations.torque]
    /// name = "Torque"
    /// inputs = ["0x1A00"]
    /// mapping = { 0x1A00 = ["0x2001"] }
    /// ```
    pub(super) static RULE = "refused-choice", ProcessData, Warning,
        "a configuration chooses what a master cannot write";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        let place = || Section::Configurations.at(&configuration.id);
        for (pdo, diagnostic) in fixed(configuration) {
            report.push(place().at(format!("mapping.{pdo}")), diagnostic);
        }
        let refused = mapping(device, configuration).into_iter().chain(assignments(device, configuration));
        refused.chain(values(device, configuration)).for_each(|diagnostic| report.push(place(), diagnostic));
        for (i, diagnostic) in writes(device, configuration) {
            report.push(place().at(format!("writes.{i}")), diagnostic);
        }
    }
}

/// Mappings of PDOs that are fixed.
fn fixed(configuration: &Configuration) -> impl Iterator<Item = (Index, Diagnostic)> {
    configuration.mapping.iter().filter(|pdo| pdo.fixed).map(|pdo| {
        let at = configuration.origin.value(&format!("mapping.{}", pdo.leading));
        let message = format!("{} is mapped, but its mapping is fixed", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, at, "would not be written");
        (pdo.index, diagnostic.label(pdo.origin.header(), "fixed unless it says `fixed = false`"))
    })
}

/// The mapping, if the device lets no master map.
fn mapping(device: &Device, configuration: &Configuration) -> Option<Diagnostic> {
    let mailbox = device.mailbox.as_ref().filter(|mailbox| !mailbox.pdo_config)?;
    let is_mapped = configuration.mapping.iter().any(|pdo| !pdo.fixed);
    is_mapped.then(|| {
        let message = format!("`{}` maps PDOs, but no master may map them", configuration.name);
        because(message, configuration.origin.value("mapping"), mailbox.origin.value("pdo-config"))
    })
}

/// Assignments other than the default of a device that lets no master assign.
fn assignments<'d>(device: &'d Device, configuration: &'d Configuration) -> impl Iterator<Item = Diagnostic> {
    let mailbox = device.mailbox.as_ref().filter(|mailbox| !mailbox.pdo_assign);
    [(Direction::Rx, "outputs"), (Direction::Tx, "inputs")].into_iter().filter_map(move |(way, key)| {
        let (mailbox, assigned) = (mailbox?, configuration.assigned(way)?);
        let manager = device.sync_manager(Role::of(way));
        let is_default = manager.is_some_and(|manager| manager.pdos == assigned);
        let message = "PDOs are assigned, but no master may assign them".to_owned();
        let diagnostic =
            because(message, configuration.origin.value(key), mailbox.origin.value("pdo-assign"));
        (!is_default).then_some(diagnostic)
    })
}

fn because(message: String, at: Location, why: Location) -> Diagnostic {
    Diagnostic::new(&RULE, message, at, "would not be written").label(why, "says that it cannot be")
}

/// A mode and a cycle time without an object to write them to.
fn values<'d>(device: &'d Device, configuration: &'d Configuration) -> impl Iterator<Item = Diagnostic> {
    let chosen = [
        ("mode", configuration.mode.is_some(), 0x6060, 0),
        ("cycle-time", configuration.cycle_time.is_some(), 0x60C2, 1),
    ];
    chosen.into_iter().filter(|(_, is_chosen, ..)| *is_chosen).filter_map(move |(key, _, index, subindex)| {
        let mut objects = lookup::on_axes(device, index).filter(|object| object.functional);
        if objects.any(|object| object.entry(subindex).is_some_and(is_written_early)) {
            return None;
        }
        let message =
            format!("a {} is chosen, but there is no 0x{index:04X} to write it to", key.replace('-', " "));
        let diagnostic =
            Diagnostic::new(&RULE, message, configuration.origin.value(key), "would not be written");
        Some(diagnostic.help("describe the object, or leave this out"))
    })
}

/// Whether a master can write it before Safe-Operational.
fn is_written_early(entry: &Entry) -> bool {
    entry.access.writable() && entry.written.is_none_or(|window| window.states()[0])
}

/// Writes to what cannot be written, at the change of the EtherCAT state that they name, or not with this value.
fn writes<'d>(
    device: &'d Device,
    configuration: &'d Configuration,
) -> impl Iterator<Item = (usize, Diagnostic)> {
    configuration.writes.iter().enumerate().filter_map(|(i, chosen)| {
        let ChosenWrite { value, write, at } = chosen;
        let entry = device.entry(write.address)?;
        let refusal = refusal(entry, value, Some(&write.transition))?;
        let (address, transition) = (write.address, &write.transition);
        let message = format!("{value} is written to {address} at {transition}, which {}", refusal.comes);
        let diagnostic = Diagnostic::new(&RULE, message, *at, "written here");
        Some((i, diagnostic.label(entry.origin.value(refusal.key), refusal.why)))
    })
}
