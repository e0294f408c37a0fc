use crate::diagnostic::rule;

rule! {
    /// Some keys have no sensible default: an erratum that does not say which rule it answers, a transition without
    /// its states. The message names the key, the label the table.
    ///
    /// ## Fires
    /// ```toml
    /// [[errata]]
    /// at = "0x2000"
    /// says = "8 bits"
    /// holds = "16 bits"
    /// why = "the values in the table need 16 bits"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static MISSING_KEY = "missing-key", Format, Fatal,
        "a table lacks a key that it cannot do without";
}
