use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A command sends bits of the controlword, and a transition asks for bits, by level or by edge. If the command has
    /// a bit clear that the transition wants set or risen, or the other way round, it can never set it off.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready" }
    /// switched-on = { name = "On" }
    ///
    /// [transitions]
    /// 1 = { from = "ready-to-switch-on", to = "switched-on", pattern = "xxxx x11r" }
    ///
    /// [commands]
    /// start = { name = "Start", pattern = "xxxx x110", transitions = [1] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready" }
    /// switched-on = { name = "On" }
    ///
    /// [transitions]
    /// 1 = { from = "ready-to-switch-on", to = "switched-on", pattern = "xxxx x11r" }
    ///
    /// [commands]
    /// start = { name = "Start", pattern = "xxxx x111", transitions = [1] }
    /// ```
    pub(super) static RULE = "contradicted-edge", StateMachine, Warning,
        "a command does not have the bits that its transition asks for";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for command in &device.commands {
        let Some(sent) = &command.pattern else { continue };
        let own = |number: &u8| command.transitions.contains(number);
        for transition in device.transitions.iter().filter(|transition| own(&transition.number)) {
            let Some(asked) = transition.pattern.as_ref().filter(|asked| !asked.overlaps(sent)) else {
                continue;
            };
            let number = transition.number;
            let bit = (sent.mask() & asked.mask() & (sent.value() ^ asked.value())).trailing_zeros();
            let message =
                format!("`{}` cannot set off transition {number}: they differ in bit {bit}", command.id);
            let diagnostic = Diagnostic::new(
                &RULE,
                message,
                transition.origin.value("pattern"),
                format!("asks for {asked}"),
            )
            .label(command.origin.value("pattern"), format!("sends {sent}"));
            report.push(Section::Transitions.at(number), diagnostic);
        }
    }
}
