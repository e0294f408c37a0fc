use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A transition that happens by itself waits for no command. With a pattern of the controlword it either
    /// needs one and is not automatic, or the pattern is left over.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// switched-on = { name = "On", pattern = "1" }
    /// fault = { name = "Fault", pattern = "0" }
    ///
    /// [transitions.13]
    /// from = "switched-on"
    /// to = "fault"
    /// automatic = true
    /// pattern = "xxxx 1111"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// switched-on = { name = "On", pattern = "1" }
    /// fault = { name = "Fault", pattern = "0" }
    ///
    /// [transitions.13]
    /// from = "switched-on"
    /// to = "fault"
    /// automatic = true
    /// ```
    pub(super) static RULE = "commanded-automatic-transition", StateMachine, Warning,
        "a transition happens by itself and by a command";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for transition in device.transitions.iter().filter(|transition| transition.automatic) {
        let Some(pattern) = &transition.pattern else { continue };
        let message = format!(
            "transition {} to `{}` is automatic, but has the controlword {pattern}",
            transition.number, transition.to
        );
        let diagnostic =
            Diagnostic::new(&RULE, message, transition.origin.value("pattern"), "happens on command")
                .label(transition.origin.value("automatic"), "happens by itself")
                .help("take out what does not hold");
        report.push(Section::Transitions.at(transition.number), diagnostic);
    }
}
