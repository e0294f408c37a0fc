use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Drive code has the eight states of CiA 402, by the ids that the profile gives them. A state with another
    /// id is in the reference, but no drive code sees it, and the transitions that end in it are left out.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// switched-on = { name = "Switched on", pattern = "x01x 0011" }
    /// parked = { name = "Parked", pattern = "x01x 1011" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// switched-on = { name = "Switched on", pattern = "x01x 0011" }
    /// fault = { name = "Parked", pattern = "x01x 1011" }
    /// ```
    pub(crate) static RULE = "foreign-state", Output, Warning, "a state that CiA 402 does not have";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for state in device.states.iter().filter(|state| !state.is_of_profile()) {
        let message = format!("`{}` is not a state of CiA 402", state.id);
        let diagnostic = Diagnostic::new(&RULE, message, state.origin.header(), "left out of drive code")
            .help("if it is one of the profile's states under another name, use its id and write the `name`");
        report.push(Section::States.at(&state.id), diagnostic);
    }
}
