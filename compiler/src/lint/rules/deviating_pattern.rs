use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Pattern, Place, Section};
use crate::source::{Origin, Value};

rule! {
    /// Masters decode the statusword and make the controlword by the patterns of the profile. If no word fits both
    /// those and the device's, a master misreads the state, or its command does something else.
    ///
    /// Patterns that are only looser than the profile's are no fault; stricter ones are for `overstrict-pattern`.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states.quick-stop-active]
    /// pattern = "x00x 0011"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states.quick-stop-active]
    /// pattern = "xx0x 0111"
    /// ```
    pub(super) static RULE = "deviating-pattern", StateMachine, Warning,
        "a pattern of bits contradicts the profile";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for state in &device.states {
        judge(&Section::States.at(&state.id), &state.name, state.pattern.as_ref(), &state.origin, report);
    }
    for command in &device.commands {
        let at = Section::Commands.at(&command.id);
        judge(&at, &command.name, command.pattern.as_ref(), &command.origin, report);
    }
}

fn judge(at: &Place, name: &str, pattern: Option<&Pattern>, origin: &Origin, report: &mut Report) {
    let Some((pattern, node)) = pattern.zip(report.profile(origin, "pattern")) else { return };
    let Value::String(text) = &node.value else { return };
    let Some(profile) = Pattern::parse(text).filter(|profile| !profile.overlaps(pattern)) else { return };
    let message = format!("`{name}` is {pattern}, but {profile} in the profile; no word is both");
    let bits = pattern.mask() & profile.mask() & (pattern.value() ^ profile.value());
    let diagnostic = Diagnostic::new(&RULE, message, origin.value("pattern"), "here")
        .label(node.at, "the profile's pattern")
        .note(format!("they differ in bit {}", bits.trailing_zeros()));
    report.push(at.clone(), diagnostic);
}
