use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Section};

rule! {
    /// An ESI with slots has what axes have in modules. An axis that no module names is missing in it, and one that two
    /// modules name is in one of them only.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names = ["A", "B"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    /// axes = ["A"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names = ["A", "B"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    /// axes = ["A", "B"]
    /// ```
    pub(crate) static RULE = "unslotted-axis", Output, Error,
        "an axis is in no module, or in several";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(first) = device.modules.first() else { return };
    for axis in &device.axes {
        let modules: Vec<_> = device.modules.iter().filter(|module| module.has(axis)).collect();
        let (message, module) = match modules.as_slice() {
            [_] => continue,
            [] => (format!("axis `{}` is in no module", axis.name), first),
            [.., last] => {
                let idents = lookup::list(modules.iter().map(|module| format!("{:#X}", module.ident)));
                (format!("axis `{}` is in the modules {}", axis.name, idents.replace("0X", "0x")), *last)
            }
        };
        let at = match module.origin.has("axes") {
            true => module.origin.value("axes"),
            false => module.origin.header(),
        };
        let diagnostic = Diagnostic::new(&RULE, message, at, "each axis is in one")
            .help("name each axis in the `axes` of one module");
        report.push(Section::Modules.at(module.ident), diagnostic);
    }
}
