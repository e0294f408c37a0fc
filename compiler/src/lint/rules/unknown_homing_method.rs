use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A drive that is told to home as delivered uses the default of 0x6098. If it is none of the methods there
    /// are, homing ends in an error, or a method is missing from the list.
    ///
    /// 0 is fine: it stands for no method.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6098]
    /// default = 35
    ///
    /// [homing-methods.37]
    /// name = "Here"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6098]
    /// default = 37
    ///
    /// [homing-methods.37]
    /// name = "Here"
    /// ```
    pub(super) static RULE = "unknown-homing-method", StateMachine, Warning,
        "the default homing method is none of those there are";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.homing_methods.is_empty() {
        return;
    }
    let known = |number: i128| {
        let mut numbers = device
            .homing_methods
            .iter()
            .flat_map(|method| [method.number].into_iter().chain(method.aliases.clone()));
        numbers.any(|other| i128::from(other) == number)
    };
    for object in lookup::on_axes(device, 0x6098) {
        let Some(entry) = object.entry(0) else { continue };
        let number =
            entry.default.as_ref().and_then(|default| default.integer()).filter(|number| *number != 0);
        let Some(number) = number.filter(|number| !known(*number)) else { continue };
        let message = format!("{} is {number} by default, which is no homing method", object.index);
        let methods = lookup::all("method", device.homing_methods.iter().map(|method| method.number));
        let diagnostic =
            Diagnostic::new(&RULE, message, entry.origin.value("default"), "no such method").note(methods);
        report.push(object.index, diagnostic);
    }
}
