use crate::diagnostic::rule;

rule! {
    /// devc answers in a time that grows with the size of a description. So there are limits to what would grow faster,
    /// far above what any drive needs; the message says which. A description can have 1 000 files and 64 MiB, as written
    /// and as written out for all members and axes, and 200 000 entries of objects; a key 255 bytes, a text 65 536; an
    /// array 4 096 elements; a section of codes or indices 65 536 tables, another one 1 024; a table in a section 4 096
    /// keys; a family 256 members. Tables and arrays can lie 32 deep in one another.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// default = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[0]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// default = 0
    /// ```
    pub(crate) static EXCEEDED_LIMIT = "exceeded-limit", Format, Fatal,
        "something is larger than devc wants to work on";
}
