use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Where the other states have a pattern of the statusword, one without cannot be recognised.
    ///
    /// ## Fires
    /// ```toml
    /// [states.switched-on]
    /// name = "Switched on"
    /// pattern = "x01x 0011"
    ///
    /// [states.operation-enabled]
    /// name = "Operation enabled"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states.switched-on]
    /// name = "Switched on"
    /// pattern = "x01x 0011"
    ///
    /// [states.operation-enabled]
    /// name = "Operation enabled"
    /// pattern = "x01x 0111"
    /// ```
    pub(super) static RULE = "patternless-state", StateMachine, Warning,
        "nothing in the statusword shows a state";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(other) = device.states.iter().find(|state| state.pattern.is_some()) else { return };
    for state in device.states.iter().filter(|state| state.pattern.is_none()) {
        let message = format!("`{}` has no pattern, so a master cannot recognise it", state.name);
        let diagnostic = Diagnostic::new(&RULE, message, state.origin.header(), "no `pattern`")
            .label(other.origin.value("pattern"), format!("`{}` has one", other.name));
        report.push(Section::States.at(&state.id), diagnostic);
    }
}
