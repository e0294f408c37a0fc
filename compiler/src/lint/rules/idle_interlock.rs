use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// An interlock keeps a command from setting a transition off. A transition that happens by itself has no command, so the
    /// interlock hinders nothing: what is meant is one of its `conditions`, or the transition is not automatic.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// not-ready-to-switch-on = { name = "Not ready to switch on", pattern = "00" }
    /// switch-on-disabled = { name = "Switch on disabled", pattern = "01" }
    ///
    /// [transitions.1]
    /// from = "not-ready-to-switch-on"
    /// to = "switch-on-disabled"
    /// automatic = true
    /// interlocks = ["locked-out"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// not-ready-to-switch-on = { name = "Not ready to switch on", pattern = "00" }
    /// switch-on-disabled = { name = "Switch on disabled", pattern = "01" }
    ///
    /// [transitions.1]
    /// from = "not-ready-to-switch-on"
    /// to = "switch-on-disabled"
    /// pattern = "xxxx x110"
    /// interlocks = ["locked-out"]
    /// ```
    pub(super) static RULE = "idle-interlock", StateMachine, Warning, "an interlock hinders no command";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for transition in device.transitions.iter().filter(|it| it.automatic && !it.interlocks.is_empty()) {
        let message = format!(
            "transition {} happens by itself, so that there is no command to hinder",
            transition.number
        );
        let at = transition.origin.value("interlocks");
        let diagnostic = Diagnostic::new(&RULE, message, at, "hinders nothing")
            .label(transition.origin.value("automatic"), "by itself")
            .help("say it in `conditions`, or take it out");
        report.push(Section::Transitions.at(transition.number), diagnostic);
    }
}
