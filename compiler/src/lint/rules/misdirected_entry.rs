use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Direction, Entry, Mappable, Safety};
use crate::source::Layer;

rule! {
    /// What a master sends has to be writable and mappable as an output; what a device sends has to be readable
    /// and mappable as an input. Against its direction a value never arrives. So it is with safe
    /// inputs and outputs, which are named from the side of the master. What can be mapped so by the dictionary, though nothing
    /// maps it, is offered by configuration tools.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "rw"
    /// pdo = "rx-tx"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(super) static RULE = "misdirected-entry", ProcessData, Warning,
        "a PDO maps an object against its direction";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut carried = BTreeSet::new();
    for (pdo, at, mapped) in lookup::mapped(device) {
        let Some((object, entry)) = lookup::target(device, mapped) else { continue };
        carried.insert((pdo.direction == Direction::Rx, entry.address));
        let Some((key, why)) = fault(pdo.direction, entry) else { continue };
        let name = lookup::name(object, entry);
        let who = match pdo.direction {
            Direction::Rx => "the master sends",
            Direction::Tx => "the device sends",
        };
        let message = format!("{} maps {name}, which is {why}", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), format!("{who} it here"))
            .label(entry.origin.value(key), why);
        report.push(at, diagnostic);
    }
    // against a profile that says how it is mapped, the access deviates, which is another fault
    let is_own = |entry: &Entry| entry.origin.layer("pdo").is_some_and(|layer| layer != Layer::Profile);
    for (object, entry) in lookup::entries(device).filter(|(_, entry)| is_own(entry)) {
        for (direction, can, way) in
            [(Direction::Rx, entry.pdo.rx(), "an output"), (Direction::Tx, entry.pdo.tx(), "an input")]
        {
            let is_carried = carried.contains(&(direction == Direction::Rx, entry.address));
            let Some((key, why)) = fault(direction, entry).filter(|_| can && !is_carried) else { continue };
            let name = lookup::name(object, entry);
            let message = format!("{name} can be mapped as {way}, but is {why}");
            let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value("pdo"), way)
                .label(entry.origin.value(key), why);
            report.push(name, diagnostic);
        }
    }
}

/// What forbids a direction, and the key that says so; what is not mappable at all is another fault.
fn fault(direction: Direction, entry: &Entry) -> Option<(&'static str, &'static str)> {
    match direction {
        _ if entry.pdo == Mappable::None => None,
        Direction::Rx if !entry.pdo.rx() => Some(("pdo", "for inputs only")),
        Direction::Tx if !entry.pdo.tx() => Some(("pdo", "for outputs only")),
        Direction::Rx if entry.safety == Some(Safety::Inputs) && !entry.pdo.tx() => {
            Some(("safety", "a safe input"))
        }
        Direction::Tx if entry.safety == Some(Safety::Outputs) && !entry.pdo.rx() => {
            Some(("safety", "a safe output"))
        }
        Direction::Rx if !entry.access.writable() => Some(("access", "not writable")),
        Direction::Tx if !entry.access.readable() => Some(("access", "not readable")),
        _ => None,
    }
}
