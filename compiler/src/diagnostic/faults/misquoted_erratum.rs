use crate::diagnostic::rule;

rule! {
    /// What an erratum says is what the description has at its place, value by value, and what holds is something else.
    /// So a correction cannot outlive the misprint that it corrects, and outputs can show what holds in its place.
    ///
    /// `says` and `holds` are values of the same kind: of a key if `at` names one, else keys of the table there. A key
    /// that only `says` has is taken out. Without `holds` nobody knows what is so, and the outputs say that the fact is
    /// contradicted; `stands = true` says that the device is as printed.
    ///
    /// A fact has one mark, which leads to one erratum: that says all that there is to say of it. Another one that has to
    /// answer another rule at the same place quotes nothing, `says = {}`.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 3 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    ///
    /// [[errata]]
    /// rule = "contradicted-count"
    /// at = "0x2000:00"
    /// says = { default = 4 }
    /// holds = { default = 2 }
    /// why = "two rows follow"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 3 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    ///
    /// [[errata]]
    /// rule = "contradicted-count"
    /// at = "0x2000:00"
    /// says = { default = 3 }
    /// holds = { default = 2 }
    /// why = "two rows follow"
    /// ```
    pub(crate) static MISQUOTED_ERRATUM = "misquoted-erratum", Facts, Fatal,
        "an erratum does not quote what is written, or changes nothing";
}
