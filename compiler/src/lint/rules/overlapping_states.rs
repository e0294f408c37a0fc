use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Pattern, Section, State};

rule! {
    /// A master tells the state of a drive from the bits of the statusword. If one word fits two patterns, it
    /// cannot tell which state it is; generated code takes the first that fits. A state is reported once, with the first
    /// that it overlaps.
    ///
    /// ## Fires
    /// ```toml
    /// [states.switched-on]
    /// name = "Switched on"
    /// pattern = "x01x 0x11"
    ///
    /// [states.operation-enabled]
    /// name = "Operation enabled"
    /// pattern = "x01x 0111"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [states.switched-on]
    /// name = "Switched on"
    /// pattern = "x01x 0011"
    ///
    /// [states.operation-enabled]
    /// name = "Operation enabled"
    /// pattern = "x01x 0111"
    /// ```
    pub(super) static RULE = "overlapping-states", StateMachine, Warning,
        "one statusword shows two states";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let states = || device.states.iter().filter_map(|state| Some((state, state.pattern.as_ref()?)));
    for (i, second) in states().enumerate() {
        if let Some(first) = states().take(i).find(|(_, pattern)| pattern.overlaps(second.1)) {
            report.push(Section::States.at(&second.0.id), judge(first, second));
        }
    }
}

fn judge((first, a): (&State, &Pattern), (second, b): (&State, &Pattern)) -> Diagnostic {
    let word = a.value() | b.value();
    let message = format!("statusword 0x{word:04X} shows `{}` and `{}`", first.name, second.name);
    Diagnostic::new(&RULE, message, second.origin.value("pattern"), format!("`{}`", second.name))
        .label(first.origin.value("pattern"), format!("`{}`", first.name))
        .help("tell them apart by a bit that is 0 in one and 1 in the other")
}
