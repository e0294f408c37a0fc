use crate::diagnostic::rule;

rule! {
    /// The value is a string where a number is needed, a number where a list is needed, and so on. devc does not
    /// guess: `"16"` may be a name.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = 2000
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "2000"
    /// type = "UINT16"
    /// access = "ro"
    /// ```
    pub(crate) static WRONG_TYPE = "wrong-type", Format, Fatal,
        "a value is of another type than its key needs";
}
