use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::source::{Node, Value};

rule! {
    /// The numbers of transitions are those of the profile, and masters count on what they mean: where a drive comes from and
    /// where it goes. A transition of the same number between other states is another one.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states]
    /// switch-on-disabled = {}
    /// operation-enabled = {}
    /// fault = {}
    ///
    /// [transitions.15]
    /// from = ["fault", "operation-enabled"]
    /// causes = ["the fault is reset"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [states]
    /// switch-on-disabled = {}
    /// operation-enabled = {}
    /// fault = {}
    ///
    /// [transitions.15]
    /// causes = ["the fault is reset"]
    /// ```
    pub(super) static RULE = "deviating-transition", StateMachine, Warning,
        "a transition leads between other states than in the profile";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for transition in device.transitions.iter().filter(|transition| transition.supported) {
        let ends = [("from", transition.from.0.clone()), ("to", vec![transition.to.clone()])];
        for (key, mut own) in ends {
            let Some(node) = report.profile(&transition.origin, key) else { continue };
            let mut profile = words(node);
            own.sort();
            profile.sort();
            if own == profile {
                continue;
            }
            let (number, own, profile) = (transition.number, own.join(", "), profile.join(", "));
            let message = format!("transition {number} has `{key}` {own}, but {profile} in the profile");
            let diagnostic = Diagnostic::new(&RULE, message, transition.origin.value(key), "here")
                .label(node.at, "in the profile");
            report.push(Section::Transitions.at(number), diagnostic);
        }
    }
}

/// The word or the words that a profile has.
fn words(node: &Node) -> Vec<String> {
    match &node.value {
        Value::String(one) => vec![one.to_string()],
        Value::Array(several) => several.iter().flat_map(words).collect(),
        _ => Vec::new(),
    }
}
