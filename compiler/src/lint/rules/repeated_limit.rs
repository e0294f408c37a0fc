use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A mode of operation has one limit of its cycle time. If two tables name the mode, be it by another of its codes, one of
    /// them was meant for another mode; a master has to keep to both.
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
    /// 8 = {}
    /// 9 = {}
    ///
    /// [cycle-times]
    /// position = { name = "Position", min = "1 ms", modes = [8] }
    /// velocity = { name = "Velocity", min = "500 us", modes = [8] }
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
    /// 8 = {}
    /// 9 = {}
    ///
    /// [cycle-times]
    /// position = { name = "Position", min = "1 ms", modes = [8] }
    /// velocity = { name = "Velocity", min = "500 us", modes = [9] }
    /// ```
    pub(super) static RULE = "repeated-limit", ProcessData, Warning, "two limits of the cycle time hold for one mode";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let main = |code: i16| {
        let mode = device.modes.iter().find(|mode| mode.aliases.contains(&code));
        mode.map_or(code, |mode| mode.code)
    };
    let mut first = BTreeMap::new();
    for limit in &device.cycle_times {
        for (i, code) in limit.modes.iter().enumerate() {
            let at = limit.origin.value(&format!("modes.{i}"));
            let (other, place) = *first.entry(main(*code)).or_insert((limit, at));
            if other.id != limit.id {
                let message = format!("`{}` and `{}` both limit mode {code}", other.name, limit.name);
                let diagnostic = Diagnostic::new(&RULE, message, at, "again here")
                    .label(place, "first here")
                    .help("name the mode that was meant, or give the limit once");
                report.push(Section::CycleTimes.at(&limit.id).at("modes"), diagnostic);
            }
        }
    }
}
