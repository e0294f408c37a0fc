use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::source::Origin;

rule! {
    /// A code selects one mode of operation, and a number one way of homing. A code that stands for two selects
    /// either, and the manual does not say which.
    ///
    /// ## Fires
    /// ```toml
    /// [homing-methods]
    /// 35 = { name = "Here" }
    /// 37 = { name = "Here, by the new number", aliases = [35] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [homing-methods]
    /// 37 = { name = "Here", aliases = [35] }
    /// ```
    pub(super) static RULE = "repeated-alias", StateMachine, Error,
        "one code selects two modes, or two ways of homing";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let modes = device.modes.iter();
    let modes = modes.map(|it| (it.code, &it.aliases[..], it.name.as_str(), &it.origin)).collect();
    judge(Section::Modes, modes, report);
    let wide = |aliases: &[i8]| aliases.iter().copied().map(i16::from).collect::<Vec<_>>();
    let aliases: Vec<_> = device.homing_methods.iter().map(|it| wide(&it.aliases)).collect();
    let methods = device.homing_methods.iter().zip(&aliases);
    let methods = methods.map(|(it, all)| (i16::from(it.number), &all[..], it.name.as_str(), &it.origin));
    judge(Section::HomingMethods, methods.collect(), report);
}

/// The code, other codes, name and place of something that a code selects.
type Selected<'d> = (i16, &'d [i16], &'d str, &'d Origin);

fn judge(section: Section, selected: Vec<Selected<'_>>, report: &mut Report) {
    let mut first: BTreeMap<i16, Selected<'_>> = selected.iter().map(|it| (it.0, *it)).collect();
    for it in &selected {
        for alias in it.1 {
            let Some(other) = first.get(alias) else {
                first.insert(*alias, *it);
                continue;
            };
            let message = format!("{alias} selects `{}` and `{}`", other.2, it.2);
            let diagnostic = Diagnostic::new(&RULE, message, it.3.value("aliases"), "again here")
                .label(other.3.header(), "first here");
            report.push(section.at(it.0), diagnostic);
        }
    }
}
