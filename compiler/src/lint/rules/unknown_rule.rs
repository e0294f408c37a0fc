use crate::diagnostic::{Diagnostic, Group, faults, rule};
use crate::lint::{ALL, Report};
use crate::model::Device;
use crate::source::Location;
use crate::text::near::near;

rule! {
    /// `[lints]` and errata refer to rules and groups by name. A name that no rule has is misspelled, or the
    /// rule was renamed, and what was meant does not happen.
    ///
    /// ## Fires
    /// ```toml
    /// [lints]
    /// contradicted-cuont = "allow"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [lints]
    /// contradicted-count = "allow"
    /// ```
    pub(super) static RULE = "unknown-rule", Facts, Error, "no rule has this name";
}

/// Nothing by itself: names of rules are looked at where they are used.
pub(super) fn check(_: &Device, _: &mut Report) {}

/// The message about a name that neither a rule nor a group has.
pub(in crate::lint) fn judge(name: &str, at: Location) -> Option<Diagnostic> {
    let rules = || ALL.iter().map(|lint| lint.rule.name).chain(faults::ALL.iter().map(|rule| rule.name));
    if rules().any(|rule| rule == name) || Group::parse(name).is_some() {
        return None;
    }
    let diagnostic = Diagnostic::new(&RULE, format!("there is no rule `{name}`"), at, "not a rule or group");
    Some(match near(name, rules()) {
        Some(rule) => diagnostic.fix(format!("did you mean `{rule}`?"), at, rule),
        None => diagnostic.help("`devc rules` lists all rules"),
    })
}
