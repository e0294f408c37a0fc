use crate::diagnostic::rule;

rule! {
    /// The files of a description are read as one text, in which each thing has one place. Of two definitions one
    /// would silently win. A section such as `[objects]` may be spread over files; one object may not.
    ///
    /// ## Fires
    /// ```toml
    /// include = ["objects.toml"]
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// # file: objects.toml
    /// [objects.0x2000]
    /// name = "Velocity"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// include = ["objects.toml"]
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// # file: objects.toml
    /// [objects.0x2001]
    /// name = "Velocity"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static DUPLICATE_DEFINITION = "duplicate-definition", Format, Fatal,
        "one thing is defined twice";
}
