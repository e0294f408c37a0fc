use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// What happens when a mode of operation changes to another is said once. If it is said twice,
    /// one of the modes is not the one that was meant.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes]
    /// 1 = {}
    /// 3 = {}
    ///
    /// [[mode-changes]]
    /// from = [1]
    /// to = [3]
    ///
    /// [[mode-changes]]
    /// from = [1]
    /// to = [3]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes]
    /// 1 = {}
    /// 3 = {}
    ///
    /// [[mode-changes]]
    /// from = [1]
    /// to = [3]
    ///
    /// [[mode-changes]]
    /// from = [3]
    /// to = [1]
    /// ```
    pub(super) static RULE = "repeated-change", StateMachine, Warning, "one change of mode is described twice";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    for (i, change) in device.mode_changes.iter().enumerate() {
        let pairs = change.from.iter().flat_map(|from| change.to.iter().map(move |to| (*from, *to)));
        let repeated = pairs.filter(|pair| *first.entry(*pair).or_insert(i) != i);
        // one message for all that two tables share
        if let Some((pair, other)) = repeated.last().and_then(|pair| Some((pair, first.get(&pair)?))) {
            let (from, to) = pair;
            let message = format!("the change from mode {from} to {to} is described twice");
            let other = device.mode_changes.get(*other).map(|other| other.origin.header());
            let diagnostic = Diagnostic::new(&RULE, message, change.origin.header(), "again here")
                .label(other.unwrap_or(change.origin.header()), "first here")
                .help("say it once, or name the modes that were meant");
            report.push(Section::ModeChanges.at(i), diagnostic);
        }
    }
}
