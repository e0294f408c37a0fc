use crate::diagnostic::rule;

rule! {
    /// Without the file a part of the description is missing, and what is left may look complete. An include is
    /// relative to the file that names it.
    ///
    /// ## Fires
    /// ```toml
    /// include = ["object.toml"]
    /// # file: objects.toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// include = ["objects.toml"]
    /// # file: objects.toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static MISSING_FILE = "missing-file", Format, Fatal,
        "a file that is named does not exist";
}
