use crate::diagnostic::rule;

rule! {
    /// A word, an index or a path refers to something that the description does not have. Most often it is
    /// misspelled, or a part was renamed or left out; what leans on it would be incomplete.
    ///
    /// ## Fires
    /// ```toml
    /// without = ["objects.0x2001"]
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// without = ["objects.0x2001"]
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "INT16"
    /// access = "ro"
    /// ```
    pub(crate) static UNKNOWN_REFERENCE = "unknown-reference", Format, Fatal,
        "something that is referred to does not exist";
}
