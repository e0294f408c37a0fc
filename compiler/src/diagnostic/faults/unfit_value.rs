use crate::diagnostic::rule;

rule! {
    /// A default or a limit that the type cannot hold would be cut off on the wire, and the drive would start with
    /// another value than the manual says.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT8"
    /// default = 300
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// default = 300
    /// ```
    pub(crate) static UNFIT_VALUE = "unfit-value", Format, Fatal,
        "a value does not fit its type";
}
