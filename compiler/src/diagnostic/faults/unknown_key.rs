use crate::diagnostic::rule;

rule! {
    /// Most often the key is misspelled, and what it says would be lost without a word. If a known key looks like it,
    /// the message says which; otherwise it lists those that the table may have.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// nmae = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static UNKNOWN_KEY = "unknown-key", Format, Fatal,
        "a table has a key that means nothing there";
}
