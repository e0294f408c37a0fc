use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A device takes current from the E-bus, or gives it, at a port that is one: `K` in `physics`. Configuration tools add
    /// up the currents of the devices behind a coupler, so that one which is no part of the E-bus makes the sum wrong.
    ///
    /// ## Fires
    /// ```toml
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// physics = "YY"
    /// ebus-current = 120
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// physics = "KK"
    /// ebus-current = 120
    /// ```
    pub(super) static RULE = "portless-current", Facts, Warning,
        "a current from the E-bus without a port to it";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(current) = device.ebus_current.filter(|current| *current != 0) else { return };
    if device.physics.contains('K') {
        return;
    }
    let message = format!("{current} mA of the E-bus, and no port `K` in `physics`");
    let diagnostic = Diagnostic::new(&RULE, message, device.origin.value("ebus-current"), "from where?");
    let ports = device.origin.value("physics");
    let diagnostic = diagnostic.label(ports, format!("the ports are {:?}", device.physics));
    report.push(Section::Device.at("ebus-current"), diagnostic);
}
