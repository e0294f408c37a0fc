use crate::diagnostic::rule;

rule! {
    /// Without its type nobody knows how many bytes a value has. Objects of a standard profile bring their type along;
    /// all others have to state it.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
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
    pub(crate) static UNTYPED_ENTRY = "untyped-entry", Format, Fatal,
        "a value has no type";
}
