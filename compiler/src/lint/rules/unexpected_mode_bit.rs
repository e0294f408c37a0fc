use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Field, Index, Mode, Section, Word};

rule! {
    /// A word marks the bits whose meaning a mode of operation gives. A mode that uses another bit takes it from
    /// the state machine, or the word does not say that it is the mode's.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6040 = {}
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [words.controlword]
    ///
    /// [modes.6]
    /// control-bits.3 = "start"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6040 = {}
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [words.controlword]
    ///
    /// [modes.6]
    /// control-bits.5 = "start"
    /// ```
    pub(super) static RULE = "unexpected-mode-bit", StateMachine, Warning,
        "a mode uses a bit that its word does not leave to modes";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for mode in &device.modes {
        let words =
            [(0x6040, "control-bits", &mode.control_bits), (0x6041, "status-bits", &mode.status_bits)];
        for (index, key, fields) in words {
            let word = device.words.iter().find(|word| word.address.index == Index(index));
            if let Some(word) = word {
                judge(word, mode, (key, fields), report);
            }
        }
    }
}

fn judge(word: &Word, mode: &Mode, (key, fields): (&str, &[Field]), report: &mut Report) {
    for field in fields.iter().filter(|field| !field.reserved) {
        let shared = |other: &&Field| other.mask() & field.mask() != 0 && !other.per_mode;
        let Some(other) = word.fields.iter().find(shared) else { continue };
        let message = format!(
            "mode {} uses bit {} of {} for `{}`, but it is `{}`",
            mode.code, field.low, word.name, field.name, other.name
        );
        let diagnostic = Diagnostic::new(&RULE, message, mode.origin.value(&field.path(key)), "used here")
            .label(word.origin.value(&other.path("bits")), "not left to modes")
            .help("write `per-mode = true` at the bit of the word if modes may use it");
        report.push(Section::Modes.at(mode.code), diagnostic);
    }
}
