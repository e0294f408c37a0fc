use crate::diagnostic::rule;

rule! {
    /// The value is a word that is none of those to choose from, a number outside of what its key can hold, or a
    /// text that does not have the form it needs. The message says what would do.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "read"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static INVALID_VALUE = "invalid-value", Format, Fatal,
        "a value is of the right type but means nothing";
}
