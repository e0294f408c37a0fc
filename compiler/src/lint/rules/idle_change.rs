use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::source::Origin;

rule! {
    /// A change that ends where it begins changes nothing: one of its ends was meant to be another. Programs that follow a
    /// drive by its changes never see it.
    ///
    /// ## Fires
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready to switch on", pattern = "01" }
    /// switched-on = { name = "Switched on", pattern = "11" }
    ///
    /// [transitions.3]
    /// from = "switched-on"
    /// to = "switched-on"
    /// pattern = "x111"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states]
    /// ready-to-switch-on = { name = "Ready to switch on", pattern = "01" }
    /// switched-on = { name = "Switched on", pattern = "11" }
    ///
    /// [transitions.3]
    /// from = "ready-to-switch-on"
    /// to = "switched-on"
    /// pattern = "x111"
    /// ```
    pub(super) static RULE = "idle-change", StateMachine, Warning, "a change ends where it begins";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for transition in &device.transitions {
        if transition.from.contains(&transition.to) {
            let message = format!("transition {} goes from `{}` to itself", transition.number, transition.to);
            let diagnostic = finding(message, &transition.origin);
            report.push(Section::Transitions.at(transition.number), diagnostic);
        }
    }
    for (number, change) in device.mode_changes.iter().enumerate() {
        let ([from], [to]) = (&*change.from, &*change.to) else { continue };
        if from == to {
            let message = format!("a change of mode goes from {from} to itself");
            report.push(Section::ModeChanges.at(number), finding(message, &change.origin));
        }
    }
}

fn finding(message: String, origin: &Origin) -> Diagnostic {
    Diagnostic::new(&RULE, message, origin.value("to"), "ends here")
        .label(origin.value("from"), "begins here")
}
