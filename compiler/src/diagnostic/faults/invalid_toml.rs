use crate::diagnostic::rule;

rule! {
    /// A description is TOML, and a text that is not can mean anything. Every such place in every file is reported
    /// at once; nothing else is judged before they are gone. A key that is defined twice in a table counts too, since
    /// one of its two values would be lost.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed
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
    pub(crate) static INVALID_TOML = "invalid-toml", Format, Fatal,
        "the text is not TOML";
}
