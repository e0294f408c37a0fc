use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Protocol, Section};

rule! {
    /// SOES speaks CoE, EoE and FoE. A firmware that is built on it and is to speak another protocol needs code of its own for
    /// it, which the options of the stack cannot ask for.
    ///
    /// ## Fires
    /// ```toml
    /// [mailbox]
    /// protocols = ["FoE", "SoE"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [mailbox]
    /// protocols = ["FoE"]
    /// ```
    pub(crate) static RULE = "foreign-protocol", Output, Warning, "SOES does not speak a protocol of the mailbox";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(mailbox) = &device.mailbox else { return };
    for protocol in &mailbox.protocols {
        if matches!(protocol, Protocol::Coe | Protocol::Eoe | Protocol::Foe) {
            continue;
        }
        let message = format!("SOES does not speak {}", protocol.name());
        let place = mailbox.origin.value("protocols");
        report.push(
            Section::Mailbox.at("protocols"),
            Diagnostic::new(&RULE, message, place, "is not in the stack"),
        );
    }
}
