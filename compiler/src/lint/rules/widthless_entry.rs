use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// An entry without a width carries nothing, and a mapping object that has it is refused. Padding needs its number of
    /// bits.
    ///
    /// ## Fires
    /// ```toml
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = [{ bits = 0 }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = [{ bits = 8 }]
    /// ```
    pub(super) static RULE = "widthless-entry", ProcessData, Error, "a PDO carries an entry of no bits";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device).filter(|(.., mapped)| mapped.bits == 0) {
        let message = format!("{} carries `{}` with no bits", pdo.index, mapped.name);
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), "0 bits");
        report.push(at, diagnostic.help("give it a width in `bits`, or take it out"));
    }
}
