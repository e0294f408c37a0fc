use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Command, Device, Section};

rule! {
    /// In each state one controlword has to mean one command. If it fits two that lead to different states, what
    /// the drive does depends on which it looks for first.
    ///
    /// Commands with the same pattern are fine as long as they start from different states, as Switch on and
    /// Disable operation do.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready" }
    /// switched-on = { name = "On" }
    /// switch-on-disabled = { name = "Off" }
    ///
    /// [transitions]
    /// 1 = { from = "ready-to-switch-on", to = "switched-on" }
    /// 2 = { from = "ready-to-switch-on", to = "switch-on-disabled" }
    ///
    /// [commands]
    /// start = { name = "Start", pattern = "xx11", transitions = [1] }
    /// stop = { name = "Stop", pattern = "x011", transitions = [2] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready" }
    /// switched-on = { name = "On" }
    /// switch-on-disabled = { name = "Off" }
    ///
    /// [transitions]
    /// 1 = { from = "ready-to-switch-on", to = "switched-on" }
    /// 2 = { from = "switched-on", to = "switch-on-disabled" }
    ///
    /// [commands]
    /// start = { name = "Start", pattern = "xx11", transitions = [1] }
    /// stop = { name = "Stop", pattern = "x011", transitions = [2] }
    /// ```
    pub(super) static RULE = "hidden-command", StateMachine, Warning,
        "one controlword means two commands in the same state";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (i, first) in device.commands.iter().enumerate() {
        for second in device.commands.iter().skip(i + 1) {
            let (Some(a), Some(b)) = (&first.pattern, &second.pattern) else { continue };
            let Some(state) = shared(device, first, second).filter(|_| a.overlaps(b)) else { continue };
            let word = a.value() | b.value();
            let message = format!(
                "controlword 0x{word:04X} means `{}` and `{}` in state `{state}`",
                first.name, second.name
            );
            let at = second.origin.value("pattern");
            let diagnostic = Diagnostic::new(&RULE, message, at, format!("`{}`", second.name))
                .label(first.origin.value("pattern"), format!("`{}`", first.name))
                .help("tell them apart by a bit that is 0 in one and 1 in the other");
            report.push(Section::Commands.at(&second.id), diagnostic);
        }
    }
}

/// A state that two commands lead out of in different ways.
fn shared<'d>(device: &'d Device, first: &Command, second: &Command) -> Option<&'d str> {
    let of = |command: &Command| {
        let numbers = command.transitions.clone();
        device.transitions.iter().filter(move |transition| numbers.contains(&transition.number))
    };
    of(first).find_map(|a| {
        let mut others = of(second).filter(|b| a.number != b.number && a.to != b.to);
        others.find_map(|b| a.from.iter().find(|from| b.from.contains(from)).map(String::as_str))
    })
}
