use devc_start_up::Period;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Entry, Section, Value};

rule! {
    /// 0x60C2 holds a cycle time as a count of up to 255 of a power of ten of a second (CiA 402, interpolation time period). A time
    /// that it cannot hold, or that is beyond what the description says of its entries, is not in the start-up list.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60C2]
    ///
    /// [configurations.odd]
    /// name = "Odd"
    /// cycle-time = "1234 us"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60C2]
    ///
    /// [configurations.odd]
    /// name = "Odd"
    /// cycle-time = "1200 us"
    /// ```
    pub(super) static RULE = "unrepresentable-cycle-time", ProcessData, Warning,
        "a configuration sets a cycle time that 0x60C2 cannot hold";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        let Some(time) = configuration.cycle_time else { continue };
        let fault = match time.interpolation() {
            None => "it is no count of up to 255 of a power of ten of a second".to_owned(),
            Some(Period { count, exponent }) => {
                let Some(entry) = beyond(device, [(1, count.into()), (2, exponent.into())]) else { continue };
                format!("{} does not take it: {count} of 10^{exponent} s", entry.address)
            }
        };
        let message =
            format!("`{}` sets a cycle time of {time}, which 0x60C2 cannot hold", configuration.name);
        let at = configuration.origin.value("cycle-time");
        let diagnostic = Diagnostic::new(&RULE, message, at, "cannot be written").note(fault);
        report.push(Section::Configurations.at(&configuration.id), diagnostic);
    }
}

/// The entry whose bounds a value is beyond.
fn beyond(device: &Device, values: [(u8, i64); 2]) -> Option<&Entry> {
    let objects = lookup::on_axes(device, 0x60C2).filter(|object| object.functional);
    let mut entries = objects.flat_map(|object| {
        values
            .into_iter()
            .filter_map(|(subindex, value)| Some((object.entry(subindex)?, Value::Integer(value))))
    });
    let found = entries.find(|(entry, value)| {
        lookup::beyond(value, [(entry.min.as_ref(), "min"), (entry.max.as_ref(), "max")]).is_some()
    });
    found.map(|(entry, _)| entry)
}
