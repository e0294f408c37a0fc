use crate::diagnostic::rule;

rule! {
    /// Some characters are not there to be read: controls, which a terminal obeys; the line breaks of Unicode; marks that
    /// turn the direction of what follows; characters that cannot be seen. Most come along when a text is copied out
    /// of a PDF. In an output they would do harm: XML cannot hold them, Rust refuses to compile them, and what a person
    /// reads is not what is there. So no key and no text can hold them, written as they are or as escapes, and nothing
    /// else in a file can, either.
    ///
    /// A text may have tabs and line feeds, and what a language needs to be written, such as the joiners U+200C and
    /// U+200D.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Spe\u0002ed"
    /// type = "UINT16"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed (θ < 90°)"
    /// type = "UINT16"
    /// ```
    pub(crate) static FORBIDDEN_CHARACTER = "forbidden-character", Format, Fatal,
        "a character is there that no text can hold";
}
