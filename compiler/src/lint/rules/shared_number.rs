use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A number in AL control and AL status is one EtherCAT state. If two have one, a master takes the one for the other.
    ///
    /// ## Fires
    /// ```toml
    /// [communication-states]
    /// init = { name = "Init", code = 1 }
    /// pre-operational = { name = "Pre-Operational", code = 1 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [communication-states]
    /// init = { name = "Init", code = 1 }
    /// pre-operational = { name = "Pre-Operational", code = 2 }
    /// ```
    pub(super) static RULE = "shared-number", StateMachine, Warning, "two EtherCAT states have one number";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    for state in &device.communication_states {
        let at = state.origin.value("code");
        let Some((other, label)) = first.get(&state.code) else {
            first.insert(state.code, (&state.name, at));
            continue;
        };
        let message = format!("`{other}` and `{}` both have the number {}", state.name, state.code);
        let diagnostic = Diagnostic::new(&RULE, message, at, "the same number")
            .label(*label, "here, too")
            .help("correct the one that is wrong");
        report.push(Section::CommunicationStates.at(&state.id), diagnostic);
    }
}
