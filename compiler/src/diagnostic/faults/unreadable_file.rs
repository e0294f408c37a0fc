use crate::diagnostic::rule;

rule! {
    /// The file is a folder, a pipe or a device, or larger than any description, or not UTF-8, or the system refuses to
    /// open it. The message says which; for a file in another encoding it says the first byte that is not UTF-8.
    ///
    /// ## Fires
    /// ```toml
    /// include = ["objects"]
    /// # file: objects/speed.toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// include = ["objects/speed.toml"]
    /// # file: objects/speed.toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static UNREADABLE_FILE = "unreadable-file", Format, Fatal,
        "a file exists but cannot be read as text";
}
