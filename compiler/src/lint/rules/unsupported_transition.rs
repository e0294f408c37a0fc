use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Command, Device, Section, Transition};
use crate::source::Value;

rule! {
    /// A command lists the transitions that it sets off. One that the device does not make leaves a master
    /// waiting for a state that never comes.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6040]
    ///
    /// [states.switched-on]
    /// [states.operation-enabled]
    /// [states.quick-stop-active]
    ///
    /// [commands.enable-operation]
    /// transitions = [4, 16]
    ///
    /// [transitions]
    /// 4 = {}
    /// 16 = { supported = false }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6040]
    ///
    /// [states.switched-on]
    /// [states.operation-enabled]
    /// [states.quick-stop-active]
    ///
    /// [commands.enable-operation]
    /// transitions = [4]
    ///
    /// [transitions]
    /// 4 = {}
    /// 16 = { supported = false }
    /// ```
    pub(super) static RULE = "unsupported-transition", StateMachine, Warning,
        "a command sets off a transition that the device does not make";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for command in &device.commands {
        let unsupported = |number: &&u8| transition(device, **number).is_some_and(|found| !found.supported);
        let lost: Vec<u8> = command.transitions.iter().filter(unsupported).copied().collect();
        if !lost.is_empty() {
            report.push(Section::Commands.at(&command.id), judge(device, command, &lost));
        }
    }
}

fn transition(device: &Device, number: u8) -> Option<&Transition> {
    device.transitions.iter().find(|transition| transition.number == number)
}

fn judge(device: &Device, command: &Command, lost: &[u8]) -> Diagnostic {
    let list = |numbers: &[u8]| numbers.iter().map(u8::to_string).collect::<Vec<_>>().join(", ");
    let names = list(lost);
    let message = match lost {
        [_] => format!("`{}` sets off transition {names}, which is not supported", command.name),
        _ => format!("`{}` sets off transitions {names}, which are not supported", command.name),
    };
    let at = first(command, lost);
    let mut diagnostic = Diagnostic::new(&RULE, message, at, "sets it off");
    for transition in lost.iter().filter_map(|number| transition(device, *number)) {
        diagnostic = diagnostic.label(transition.origin.value("supported"), "the device does not make it");
    }
    let kept: Vec<u8> = command.transitions.iter().filter(|number| !lost.contains(number)).copied().collect();
    diagnostic.help(format!("write `transitions = [{}]`", list(&kept)))
}

/// Where the first of some transitions stands in a command's list.
fn first(command: &Command, lost: &[u8]) -> crate::source::Location {
    let is_lost =
        |value: &Value| matches!(value, Value::Integer(n) if lost.iter().any(|l| i128::from(*l) == *n));
    let items = match command.origin.node("transitions").map(|node| &node.value) {
        Some(Value::Array(items)) => &items[..],
        _ => &[],
    };
    items.iter().find(|item| is_lost(&item.value)).map_or(command.origin.header(), |item| item.at)
}
