use crate::diagnostic::rule;

rule! {
    /// A description is a folder that can be copied, reviewed and versioned as a whole. A file elsewhere would break
    /// that, and a path out of the folder is also a way to read what is nobody's business. Links are followed before
    /// the folders are compared.
    ///
    /// ## Fires
    /// ```toml
    /// include = ["../objects.toml"]
    /// # file: ../objects.toml
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
    pub(crate) static OUTSIDE_INCLUDE = "outside-include", Format, Fatal,
        "an include leaves the folder of the description";
}
