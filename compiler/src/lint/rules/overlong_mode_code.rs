use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Modes of operation are chosen by a number in 0x6060, which is of the type INT8 (CiA 402). A number outside of
    /// -128 to 127 cannot be written to it; drive code leaves it out.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = { default = 0x80 }
    ///
    /// [modes.8]
    /// aliases = [250]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = { default = 0x80 }
    ///
    /// [modes.8]
    /// aliases = [-6]
    /// ```
    pub(crate) static RULE = "overlong-mode-code", Output, Warning, "the number of a mode does not fit 8 bits";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for mode in &device.modes {
        let aliases = mode.aliases.iter().enumerate();
        let aliases = aliases.map(|(i, alias)| (*alias, mode.origin.value(&format!("aliases.{i}"))));
        let codes = std::iter::once((mode.code, mode.origin.header())).chain(aliases);
        for (code, place) in codes.filter(|(code, _)| i8::try_from(*code).is_err()) {
            let message = format!("mode {code} does not fit the 8 bits of 0x6060");
            let mut diagnostic = Diagnostic::new(&RULE, message, place, "left out of drive code");
            if let Ok(byte) = u8::try_from(code) {
                let same = byte.cast_signed();
                diagnostic = diagnostic.help(format!("the byte 0x{byte:02X} is {same} in an INT8"));
            }
            report.push(Section::Modes.at(code), diagnostic);
        }
    }
}
