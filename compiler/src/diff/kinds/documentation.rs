//! Changes that only people and generated names notice.

use super::kinds;

kinds! { Documentation:
    /// Something has another name. On the wire nothing changes; but engineering tools refer to variables by their names, and
    /// generated code takes its identifiers from them: links are lost, and programs have to be adapted when they are built
    /// anew.
    RENAMED = "renamed", "something has another name";

    /// A type is spelt otherwise: the same bytes with the same meaning.
    RESPELT_TYPE = "respelt-type", "a type is spelt otherwise";

    /// A unit is spelt otherwise: the same number means the same.
    RESPELT_UNIT = "respelt-unit", "a unit is spelt otherwise";

    /// A default is stated that was not, or is no longer. For all one knows the device has not changed.
    STATED_DEFAULT = "stated-default", "a default is newly stated, or no longer";

    /// What the device says of itself in 0x1008 to 0x100A, or its serial number, is something else.
    CHANGED_LABEL = "changed-label", "the device's own name or version is another one";

    /// The same things are described in another order. Lists in references and generated code follow it; no number, name or
    /// byte does.
    REORDERED = "reordered", "the same is described in another order";

    /// A text, a figure for people, or where a fact is from.
    CHANGED_TEXT = "changed-text", "a description, a note or a source is another one";
}
