use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, HomingMethod, Parameter, Section};

rule! {
    /// A homing method that looks for the positive limit switch needs the parameter of that switch. If it names that of the
    /// negative one instead, and not its own, one of the two is a slip: a reference run that looks at the wrong switch runs
    /// into the end stop.
    ///
    /// ## Fires
    /// ```toml
    /// [parameters]
    /// I101 = { name = "Source of the positive limit switch" }
    /// I102 = { name = "Source of the negative limit switch" }
    ///
    /// [homing-methods.18]
    /// name = "Positive limit switch"
    /// target = "the positive limit switch"
    /// parameters = ["I102"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [parameters]
    /// I101 = { name = "Source of the positive limit switch" }
    /// I102 = { name = "Source of the negative limit switch" }
    ///
    /// [homing-methods.18]
    /// name = "Positive limit switch"
    /// target = "the positive limit switch"
    /// parameters = ["I101"]
    /// ```
    pub(super) static RULE = "opposed-switch", StateMachine, Warning,
        "a homing method needs the parameter of the other switch";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for method in &device.homing_methods {
        if let Some(parameter) = method.target.as_deref().and_then(|target| opposed(device, method, target)) {
            let message = format!(
                "homing method {} looks for {}, but needs {}, {}",
                method.number,
                method.target.as_deref().unwrap_or_default(),
                parameter.id,
                parameter.name
            );
            let diagnostic =
                Diagnostic::new(&RULE, message, method.origin.value("parameters"), "the other switch")
                    .label(method.origin.value("target"), "what it looks for");
            report.push(Section::HomingMethods.at(method.number), diagnostic);
        }
    }
}

/// The parameter of the switch at the other end, if the method names that and not the one of its own end.
fn opposed<'d>(device: &'d Device, method: &HomingMethod, target: &str) -> Option<&'d Parameter> {
    let own = end(target)?;
    let named = || device.parameters.iter().filter(|it| method.parameters.contains(&it.id));
    let switches = || named().filter(|it| it.name.contains("switch"));
    let is_named = switches().any(|it| end(&it.name) == Some(own));
    switches().find(|it| end(&it.name).is_some_and(|end| end != own)).filter(|_| !is_named)
}

/// The end that a text is about, if it is about one; true for the positive one.
fn end(text: &str) -> Option<bool> {
    match (text.contains("positive"), text.contains("negative")) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}
