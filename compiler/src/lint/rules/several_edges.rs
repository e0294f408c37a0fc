use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Bit, Device, Pattern, Place, Section};
use crate::source::Origin;

rule! {
    /// A command is given by the change of one bit at most, all others by their levels. If it took two changes at
    /// once, a master could miss it; drive code waits for one of them.
    ///
    /// ## Fires
    /// ```toml
    /// [commands]
    /// start = { name = "Start", pattern = "xrxx xxxr" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [commands]
    /// start = { name = "Start", pattern = "x1xx xxxr" }
    /// ```
    pub(crate) static RULE = "several-edges", Output, Warning, "a command takes the change of several bits";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let commands = device.commands.iter().map(|it| (Section::Commands.at(&it.id), &it.pattern, &it.origin));
    let transitions = device.transitions.iter().filter(|transition| !transition.automatic);
    let transitions = transitions.map(|it| (Section::Transitions.at(it.number), &it.pattern, &it.origin));
    for (name, pattern, origin) in commands.chain(transitions) {
        if let Some(pattern) = pattern.as_ref().filter(|pattern| edges(pattern) > 1) {
            let diagnostic = judge(&name, pattern, origin);
            report.push(name, diagnostic);
        }
    }
}

fn edges(pattern: &Pattern) -> usize {
    pattern.bits.iter().filter(|bit| matches!(bit, Bit::Rising | Bit::Falling)).count()
}

fn judge(name: &Place, pattern: &Pattern, origin: &Origin) -> Diagnostic {
    let message = format!("{name} takes {} changes at once: {pattern}", edges(pattern));
    Diagnostic::new(&RULE, message, origin.value("pattern"), "more than one `r` or `f`")
        .help("write `1` or `0` for the bits that only have to be so")
}
