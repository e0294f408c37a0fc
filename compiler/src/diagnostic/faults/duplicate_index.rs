use crate::diagnostic::rule;

rule! {
    /// An index names one object, and a subindex one entry of it. Two of them often meet when an object is described
    /// by hand where the shift of the axes already puts one.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000.entries]
    /// "1..=2" = { name = "Gain", type = "UINT16" }
    /// 2 = { name = "Offset", type = "UINT16" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Controller"
    ///
    /// [objects.0x2000.entries]
    /// 1 = { name = "Gain", type = "UINT16" }
    /// 2 = { name = "Offset", type = "UINT16" }
    /// ```
    pub(crate) static DUPLICATE_INDEX = "duplicate-index", Format, Fatal,
        "two objects, entries or PDOs have the same index";
}
