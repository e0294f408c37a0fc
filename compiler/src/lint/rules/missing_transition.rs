use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Command, Device, Section, Transition};
use crate::source::{Node, Value};

rule! {
    /// A command of the profile makes certain transitions. If the device's command lacks one that the device has, and no
    /// other command makes it by these bits, a master that gives the command in that state waits for what does not come.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states]
    /// ready-to-switch-on = {}
    /// switch-on-disabled = {}
    /// switched-on = {}
    ///
    /// [transitions]
    /// 7 = {}
    /// 10 = {}
    ///
    /// [commands.disable-voltage]
    /// transitions = [7, 10]
    ///
    /// [commands.quick-stop]
    /// transitions = [10]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states]
    /// ready-to-switch-on = {}
    /// switch-on-disabled = {}
    /// switched-on = {}
    ///
    /// [transitions]
    /// 7 = {}
    /// 10 = {}
    ///
    /// [commands.disable-voltage]
    /// transitions = [7, 10]
    ///
    /// [commands.quick-stop]
    /// transitions = [7, 10]
    /// ```
    pub(super) static RULE = "missing-transition", StateMachine, Warning,
        "a command lacks a transition that it makes in the profile";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for command in &device.commands {
        let Some(node) = report.profile(&command.origin, "transitions") else { continue };
        let profile = numbers(node);
        let lacks: Vec<u8> = profile.into_iter().filter(|number| lacks(device, command, *number)).collect();
        if lacks.is_empty() {
            continue;
        }
        let lacking = lookup::list(&lacks);
        let message = format!("`{}` does not make {lacking}, which it makes in the profile", command.name);
        let diagnostic = Diagnostic::new(&RULE, message, command.origin.value("transitions"), "not there")
            .label(node.at, "in the profile")
            .help("add what is missing, or write `supported = false` at a transition that the device never makes");
        report.push(Section::Commands.at(&command.id), diagnostic);
    }
}

/// Whether the device has a transition that neither the command makes, nor another one that has its bits.
fn lacks(device: &Device, command: &Command, number: u8) -> bool {
    let is_here = |transition: &Transition| transition.number == number && transition.supported;
    let makes = |other: &&Command| other.transitions.contains(&number) && share_bits(command, other);
    device.transitions.iter().any(is_here) && !device.commands.iter().any(|other| makes(&other))
}

/// Whether a word can be both commands; a command without a pattern can be any.
fn share_bits(one: &Command, other: &Command) -> bool {
    one.pattern.as_ref().zip(other.pattern.as_ref()).is_none_or(|(one, other)| one.overlaps(other))
}

fn numbers(node: &Node) -> Vec<u8> {
    let Value::Array(items) = &node.value else { return Vec::new() };
    let number = |item: &Node| match item.value {
        Value::Integer(number) => u8::try_from(number).ok(),
        _ => None,
    };
    items.iter().filter_map(number).collect()
}
