use crate::diagnostic::rule;

rule! {
    /// Each file of a description is read once, so a circle adds nothing and hides which file is the first. The note
    /// lists the files in the order in which they include one another.
    ///
    /// ## Fires
    /// ```toml
    /// include = ["objects.toml"]
    /// # file: objects.toml
    /// include = ["device.toml"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// include = ["objects.toml"]
    /// # file: objects.toml
    /// include = ["speed.toml"]
    /// # file: speed.toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static INCLUDE_CYCLE = "include-cycle", Format, Fatal,
        "files include one another in a circle";
}
