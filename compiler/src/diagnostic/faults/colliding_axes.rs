use crate::diagnostic::rule;

rule! {
    /// Objects of an axis are repeated for the others at a fixed distance. If the distance is shorter than the
    /// range, an index means something on two axes at once; if the last axis ends beyond 0xFFFF, it does not exist.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names = ["X", "Y"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x400 }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names = ["X", "Y"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    /// ```
    pub(crate) static COLLIDING_AXES = "colliding-axes", Format, Fatal,
        "two axes share indices, or an axis lies beyond the dictionary";
}
