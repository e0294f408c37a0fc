use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Command, Device, Pattern, Section};

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
    let asked: Vec<Asked<'_>> = device.commands.iter().filter_map(|it| Asked::new(device, it)).collect();
    for (i, second) in asked.iter().enumerate() {
        let mut earlier = asked.iter().take(i).map(|first| (first, first.hides(second)));
        let Some((first, Some(state))) = earlier.find(|(_, state)| state.is_some()) else { continue };
        let word = first.pattern.value() | second.pattern.value();
        let (first, second) = (first.command, second.command);
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

/// A command with what it leads to.
struct Asked<'d> {
    command: &'d Command,
    pattern: &'d Pattern,
    /// The states that it leads out of, each with where to; two of them tell whether another command leads elsewhere.
    ways: BTreeMap<&'d str, (&'d str, Option<&'d str>)>,
}

impl<'d> Asked<'d> {
    fn new(device: &'d Device, command: &'d Command) -> Option<Self> {
        let pattern = command.pattern.as_ref()?;
        let mut ways = BTreeMap::new();
        let numbers: BTreeSet<u8> = command.transitions.iter().copied().collect();
        for transition in device.transitions.iter().filter(|it| numbers.contains(&it.number)) {
            for from in transition.from.iter() {
                let (first, second) = ways.entry(from.as_str()).or_insert((transition.to.as_str(), None));
                if *first != transition.to {
                    second.get_or_insert(transition.to.as_str());
                }
            }
        }
        Some(Self { command, pattern, ways })
    }

    /// A state out of which another command with a word of this one leads in a different way.
    fn hides(&self, other: &Self) -> Option<&'d str> {
        let differs = |(from, way): (&&'d str, &(&str, Option<&str>))| {
            let its = other.ways.get(from)?;
            (its != way || way.1.is_some()).then_some(*from)
        };
        self.pattern.overlaps(other.pattern).then(|| self.ways.iter().find_map(differs)).flatten()
    }
}
