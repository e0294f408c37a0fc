use crate::diagnostic::rule;

rule! {
    /// A profile brings the objects that a public standard defines, so that a description only says what is special
    /// about its drive. devc knows a fixed set of them; without the profile every object that leans on it is incomplete.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat", "cia-402"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat", "cia402"]
    /// ```
    pub(crate) static UNKNOWN_PROFILE = "unknown-profile", Format, Fatal,
        "no profile has this name";
}
