use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Command, Device, Section, Transition};

rule! {
    /// A command sets a transition off in the state in which that begins. If it is ignored there, the transition never
    /// happens, although two tables say that it does.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready", pattern = "x01x 0001" }
    /// switched-on = { name = "Switched on", pattern = "x01x 0011" }
    ///
    /// [commands.switch-on]
    /// name = "Switch on"
    /// pattern = "xxxx x111"
    /// transitions = [3]
    /// ignored-in = ["ready-to-switch-on"]
    ///
    /// [transitions]
    /// 3 = { from = "ready-to-switch-on", to = "switched-on" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready", pattern = "x01x 0001" }
    /// switched-on = { name = "Switched on", pattern = "x01x 0011" }
    ///
    /// [commands.switch-on]
    /// name = "Switch on"
    /// pattern = "xxxx x111"
    /// transitions = [3]
    /// ignored-in = ["switched-on"]
    ///
    /// [transitions]
    /// 3 = { from = "ready-to-switch-on", to = "switched-on" }
    /// ```
    pub(super) static RULE = "ignored-transition", StateMachine, Warning,
        "a command is ignored where its transition begins";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for command in &device.commands {
        let made = device.transitions.iter().filter(|one| one.supported);
        for transition in made.filter(|one| command.transitions.contains(&one.number)) {
            if let Some(diagnostic) = judge(command, transition) {
                report.push(Section::Commands.at(&command.id), diagnostic);
            }
        }
    }
}

fn judge(command: &Command, transition: &Transition) -> Option<Diagnostic> {
    let (place, state) =
        command.ignored_in.iter().enumerate().find(|(_, state)| transition.from.contains(state))?;
    let message = format!(
        "`{}` sets off transition {}, but is ignored in `{state}`, where that begins",
        command.name, transition.number
    );
    let at = command.origin.value(&format!("ignored-in.{place}"));
    let diagnostic = Diagnostic::new(&RULE, message, at, "ignored here")
        .label(transition.origin.value("from"), "begins here")
        .help("take out the one that does not hold");
    Some(diagnostic)
}
