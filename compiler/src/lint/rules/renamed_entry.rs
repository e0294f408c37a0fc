use crate::diagnostic::{Diagnostic, rule};
use crate::lint::words::words;
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A value that a PDO calls otherwise than the dictionary does looks like two values to the one who links it. Either
    /// the PDO maps another object than it says, or one of the names is to go.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = [{ entry = "0x2000", name = "Torque" }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = [{ entry = "0x2000", name = "Speed (actual)" }]
    /// ```
    pub(super) static RULE = "renamed-entry", ProcessData, Warning,
        "a PDO and the dictionary call a value differently";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device) {
        let Some((object, entry)) = lookup::target(device, mapped) else { continue };
        if akin(&mapped.name, &object.name) || akin(&mapped.name, &entry.name) {
            continue;
        }
        let name = lookup::name(object, entry);
        let message =
            format!("{} calls {name} `{}`, the dictionary `{}`", pdo.index, mapped.name, entry.name);
        let label = "the name in the dictionary";
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), "another name")
            .label(entry.origin.value("name"), label);
        report.push(at, diagnostic);
    }
}

/// Whether one name is the other, however it is spaced, or its words are among those of the other.
fn akin(one: &str, other: &str) -> bool {
    let (one, other) = (words(one), words(other));
    let (few, many) = if one.len() <= other.len() { (&one, &other) } else { (&other, &one) };
    one.concat() == other.concat() || many.windows(few.len().max(1)).any(|part| part == few.as_slice())
}

#[cfg(test)]
mod tests {
    use super::akin;

    #[test]
    fn names_are_compared_by_words() {
        assert!(akin("Target position", "target-position"));
        assert!(akin("TargetPosition", "Target position"));
        assert!(akin("Speed (actual)", "Speed"));
        assert!(!akin("Input", "Inputs of the drive"), "a part of a word is another word");
        assert!(!akin("Actual torque value", "Actual value"), "what stands between matters");
        assert!(!akin("Torque", "Speed"));
    }
}
