use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, Unit};

rule! {
    /// A quantity that is scaled in two ways, in the same unit and on the same path, is a trap: a value read from one
    /// object does not fit the other. If that is so, an `about` says which is for what.
    ///
    /// ## Fires
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "INT32", unit = "speed" }
    /// 0x2001 = { name = "Feed forward", type = "INT32", unit = "feed-forward" }
    ///
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 100
    ///
    /// [units.feed-forward]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 1000
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "INT32", unit = "speed" }
    /// 0x2001 = { name = "Feed forward", type = "INT32", unit = "feed-forward" }
    ///
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 100
    ///
    /// [units.feed-forward]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 1000
    /// about = "For the feed forward only; ten times as fine."
    /// ```
    pub(super) static RULE = "ambiguous-scaling", Values, Warning,
        "one quantity has two scales, and nothing says why";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (i, second) in device.units.iter().enumerate() {
        let Some(first) = device.units.iter().take(i).find(|first| clash(first, second)) else { continue };
        let message = format!("`{}` and `{}` scale a {} differently", first.id, second.id, second.quantity);
        let diagnostic =
            Diagnostic::new(&RULE, message, second.origin.value("raw-per-unit"), "another scale")
                .label(first.origin.value("raw-per-unit"), format!("that of `{}`", first.id))
                .help("add an `about` that says which is for what");
        report.push(Section::Units.at(&second.id), diagnostic);
    }
}

fn clash(first: &Unit, second: &Unit) -> bool {
    let (Some(a), Some(b)) = (first.on(None), second.on(None)) else { return false };
    let silent = first.about.is_none() && second.about.is_none();
    let same = first.quantity == second.quantity && first.path == second.path && a.symbol == b.symbol;
    silent && same && a.scale.is_some() && b.scale.is_some() && a.scale != b.scale
}
