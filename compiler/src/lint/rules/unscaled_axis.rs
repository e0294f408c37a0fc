use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Section};

rule! {
    /// A unit that is scaled on some axes and not on others leaves a master with raw values there. Mostly the
    /// scale was given for the axes that differ, and forgotten for the rest.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names = ["X", "U"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    ///
    /// [objects.0x6064]
    /// name = "Position"
    /// type = "INT32"
    /// unit = "position"
    ///
    /// [units.position]
    /// quantity = "position"
    /// symbol = "mm"
    /// per-axis.U = { symbol = "deg", raw-per-unit = 1000 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names = ["X", "U"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    ///
    /// [objects.0x6064]
    /// name = "Position"
    /// type = "INT32"
    /// unit = "position"
    ///
    /// [units.position]
    /// quantity = "position"
    /// symbol = "mm"
    /// raw-per-unit = 100
    /// per-axis.U = { symbol = "deg", raw-per-unit = 1000 }
    /// ```
    pub(super) static RULE = "unscaled-axis", Values, Warning, "a unit has a scale on some axes only";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for unit in &device.units {
        let without = device.axes.iter().zip(&unit.axes).filter(|(_, unit)| unit.scale.is_none());
        let names: Vec<String> = without.map(|(axis, _)| format!("`{}`", axis.name)).collect();
        if names.is_empty() || unit.axes.iter().all(|axis| axis.scale.is_none()) {
            continue;
        }
        let message = format!("`{}` has a scale, but not on {}", unit.id, lookup::list(&names));
        let diagnostic = Diagnostic::new(&RULE, message, unit.origin.header(), "no `raw-per-unit` for all")
            .label(unit.origin.value("per-axis"), "for these axes")
            .help(format!("give `raw-per-unit` for {}, too, or for all axes", lookup::list(&names)));
        report.push(Section::Units.at(&unit.id), diagnostic);
    }
}
