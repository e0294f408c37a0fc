use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A change of the EtherCAT state is called by the letters of the state before and the one after. If the states that it
    /// names are others, a master reads the one and a person the other.
    ///
    /// ## Fires
    /// ```toml
    /// [communication-states]
    /// init = { name = "Init", code = 1 }
    /// pre-operational = { name = "Pre-Operational", code = 2 }
    ///
    /// [communication-transitions]
    /// PS = { from = "init", to = "pre-operational" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [communication-states]
    /// init = { name = "Init", code = 1 }
    /// pre-operational = { name = "Pre-Operational", code = 2 }
    ///
    /// [communication-transitions]
    /// IP = { from = "init", to = "pre-operational" }
    /// ```
    pub(super) static RULE = "contradicted-change", StateMachine, Warning,
        "a change of the EtherCAT state is called by other states";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let letter = |id: &str| {
        let state = device.communication_states.iter().find(|state| state.id == id)?;
        Some(match state.code {
            1 => 'I',
            2 => 'P',
            3 => 'B',
            4 => 'S',
            8 => 'O',
            _ => return None,
        })
    };
    for change in &device.communication_transitions {
        let Some((from, to)) = letter(&change.from).zip(letter(&change.to)) else { continue };
        let name = format!("{from}{to}");
        if change.id != name {
            let message = format!("`{}` is said to lead from {from} to {to}", change.id);
            let diagnostic = Diagnostic::new(&RULE, message, change.origin.header(), "called so here")
                .label(change.origin.value("from"), "from here")
                .label(change.origin.value("to"), "to here")
                .help(format!("call it `{name}`, or name the states that it leads from and to"));
            report.push(Section::CommunicationTransitions.at(&change.id), diagnostic);
        }
    }
}
