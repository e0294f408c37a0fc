use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, texts};
use crate::model::Device;

rule! {
    /// XML has no way to hold control characters, so an ESI file shows � in their place. They mostly come from a
    /// text that was copied out of a PDF.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Spe\u0002ed"
    /// type = "UINT16"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed (θ < 90°)"
    /// type = "UINT16"
    /// ```
    pub(super) static RULE = "unprintable-character", Output, Warning, "a name has a character that XML cannot hold";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for text in texts::names(device).chain(texts::dictionary(device)) {
        let Some(odd) = text.text.chars().find(|c| banned(*c)) else { continue };
        let message = format!("{} has the character U+{:04X} in it", text.at, u32::from(odd));
        report.push(text.at, Diagnostic::new(&RULE, message, text.place, "XML cannot hold it"));
    }
}

fn banned(c: char) -> bool {
    (c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{80}'..)) || matches!(c, '\u{FFFE}' | '\u{FFFF}')
}
