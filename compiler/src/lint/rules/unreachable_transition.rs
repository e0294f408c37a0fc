use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, Transition};

rule! {
    /// A transition happens by itself, by a command, or for a cause. One without any of them never happens, or
    /// the description does not say how.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready" }
    /// switched-on = { name = "On" }
    ///
    /// [transitions]
    /// 1 = { from = "ready-to-switch-on", to = "switched-on" }
    /// 2 = { from = "switched-on", to = "ready-to-switch-on" }
    ///
    /// [commands]
    /// start = { name = "Start", pattern = "xx11", transitions = [1] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready" }
    /// switched-on = { name = "On" }
    ///
    /// [transitions]
    /// 1 = { from = "ready-to-switch-on", to = "switched-on" }
    /// 2 = { from = "switched-on", to = "ready-to-switch-on", causes = ["The emergency stop is pressed."] }
    ///
    /// [commands]
    /// start = { name = "Start", pattern = "xx11", transitions = [1] }
    /// ```
    pub(super) static RULE = "unreachable-transition", StateMachine, Warning,
        "nothing sets a transition off";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.commands.is_empty() {
        return;
    }
    for transition in device.transitions.iter().filter(|transition| !explained(device, transition)) {
        let number = transition.number;
        let message = format!("nothing sets transition {number} off");
        let label = "no command, no cause, not automatic";
        let diagnostic = Diagnostic::new(&RULE, message, transition.origin.header(), label)
            .help("name it in a command, give its `causes` or `events`, or write `automatic = true` or `supported = false`");
        report.push(Section::Transitions.at(number), diagnostic);
    }
}

fn explained(device: &Device, transition: &Transition) -> bool {
    let by_event = !transition.causes.is_empty() || !transition.events.is_empty();
    let own = transition.automatic || by_event || transition.pattern.is_some();
    own || !transition.supported
        || device.commands.iter().any(|command| command.transitions.contains(&transition.number))
}
