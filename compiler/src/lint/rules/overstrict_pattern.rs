use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Pattern, Section, State};
use crate::source::Value;

rule! {
    /// A pattern with a bit that the profile leaves open is not fitted by every word of the state: where the bit has
    /// the other value after all, as a fault that comes before a bit is shown, a master finds no state and does not
    /// know what to do, not even that it should reset the fault. Manuals print what they saw, and the text on the bit
    /// often says when it has which value.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states.fault]
    /// pattern = "x01x 1000"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states.fault]
    /// pattern = "x0xx 1000"
    /// ```
    pub(super) static RULE = "overstrict-pattern", StateMachine, Warning,
        "the pattern of a state fixes a bit that the profile leaves open";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    device.states.iter().for_each(|state| judge(state, report));
}

fn judge(state: &State, report: &mut Report) {
    let written = state.pattern.as_ref().zip(report.profile(&state.origin, "pattern"));
    let Some((pattern, node)) = written else { return };
    let Value::String(text) = &node.value else { return };
    let Some(profile) = Pattern::parse(text) else { return };
    let fixed = pattern.mask() & !profile.mask();
    if fixed == 0 {
        return;
    }
    let bits: Vec<String> =
        (0..16_u32).filter(|bit| (fixed >> bit) & 1 == 1).map(|bit| bit.to_string()).collect();
    let noun = if bits.len() == 1 { "bit" } else { "bits" };
    let message =
        format!("`{}` fixes {noun} {}, which the profile leaves open", state.name, bits.join(" and "));
    let diagnostic = Diagnostic::new(&RULE, message, state.origin.value("pattern"), "here")
        .label(node.at, "the profile's pattern")
        .note(format!("a word with another value there, as {profile} allows it, is not this state"));
    report.push(Section::States.at(&state.id), diagnostic);
}
