use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A message of the diagnosis history comes with parameters, which a master puts where the text has placeholders as `%d`, in
    /// their order. A translation with others shows the wrong parameters, or none.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x10F3]
    /// name = "Diagnosis history"
    /// type = "UINT8"
    ///
    /// [diagnosis.0x8001]
    /// text = "Axis %d is too fast: %d rpm"
    /// texts = { de = "Achse zu schnell: %d rpm" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x10F3]
    /// name = "Diagnosis history"
    /// type = "UINT8"
    ///
    /// [diagnosis.0x8001]
    /// text = "Axis %d is too fast: %d rpm"
    /// texts = { de = "Achse %d zu schnell: %d rpm" }
    /// ```
    pub(super) static RULE = "contradicted-placeholder", Facts, Warning,
        "a translation of a message has other placeholders";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for message in &device.diagnosis {
        let own = placeholders(&message.text);
        for translation in message.texts.iter().filter(|it| placeholders(&it.text) != own) {
            let path = format!("texts.{}", translation.language);
            let place = Section::Diagnosis.at(message.text_id);
            let text = format!("{place} has other placeholders in `{}`", translation.language);
            let theirs = placeholders(&translation.text);
            let diagnostic = Diagnostic::new(&RULE, text, message.origin.value(&path), shown(&theirs))
                .label(message.origin.value("text"), shown(&own))
                .help("a master fills them in this order: write the same ones");
            report.push(place, diagnostic);
        }
    }
}

fn shown(placeholders: &[&str]) -> String {
    if placeholders.is_empty() { "no placeholders".to_owned() } else { placeholders.join(", ") }
}

/// The placeholders of a text in their order; `%%` is none.
fn placeholders(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find('%') {
        let from = rest.get(start..).unwrap_or_default();
        let end = from.char_indices().skip(1).find(|(_, c)| c.is_ascii_alphabetic() || *c == '%');
        // what has neither is a sign like any other
        let Some((end, last)) = end else { break };
        if last != '%' {
            found.extend(from.get(..=end).filter(|it| !it.contains(char::is_whitespace)));
        }
        rest = from.get(end + 1..).unwrap_or_default();
    }
    found
}
