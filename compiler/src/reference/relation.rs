//! Which keys name things, and of what kind.

use crate::model::Section;

/// What a value names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Names {
    /// An object, or an entry of one.
    Objects,
    /// A thing of one of these sections, by its key.
    Things(&'static [Section]),
    /// The same section's.
    Siblings,
    /// A document, before a colon.
    Documents,
    /// A rule of devc.
    Rules,
    /// A profile that devc brings along.
    Profiles,
    /// A file.
    Files,
    /// Any thing of the description: `states.fault`.
    Places,
    /// A data type.
    Types,
}

const PDOS: Names = Names::Things(&[Section::RxPdos, Section::TxPdos]);
const STATES: Names = Names::Things(&[Section::States]);
const MODES: Names = Names::Things(&[Section::Modes]);
const TRANSITIONS: Names = Names::Things(&[Section::Transitions]);

/// The section, the key whose value it is, and what it names. `*` is any key.
const RELATIONS: &[(&str, &str, Names)] = &[
    ("", "include", Names::Files),
    ("", "profiles", Names::Profiles),
    ("*", "like", Names::Siblings),
    ("*", "source", Names::Documents),
    ("device", "image", Names::Files),
    ("objects", "type", Names::Types),
    ("objects", "unit", Names::Things(&[Section::Units])),
    ("objects", "values", Names::Things(&[Section::Enumerations])),
    ("objects", "parameter", Names::Things(&[Section::Parameters])),
    ("objects", "mode", MODES),
    ("objects", "uses", Names::Objects),
    ("objects", "updates", Names::Objects),
    ("units", "factor", Names::Objects),
    ("rx-pdos", "entries", Names::Objects),
    ("rx-pdos", "entry", Names::Objects),
    ("rx-pdos", "excludes", PDOS),
    ("rx-pdos", "mode", MODES),
    ("tx-pdos", "entries", Names::Objects),
    ("tx-pdos", "entry", Names::Objects),
    ("tx-pdos", "excludes", PDOS),
    ("tx-pdos", "mode", MODES),
    ("sync-managers", "pdos", PDOS),
    ("configurations", "outputs", Names::Things(&[Section::RxPdos])),
    ("configurations", "inputs", Names::Things(&[Section::TxPdos])),
    ("configurations", "mapping", Names::Objects),
    ("configurations", "entry", Names::Objects),
    ("configurations", "mode", MODES),
    ("words", "object", Names::Objects),
    ("commands", "transitions", TRANSITIONS),
    ("commands", "ignored-in", STATES),
    ("transitions", "from", STATES),
    ("transitions", "to", STATES),
    ("device-control", "modes-selectable-in", STATES),
    ("communication-transitions", "from", Names::Things(&[Section::CommunicationStates])),
    ("communication-transitions", "to", Names::Things(&[Section::CommunicationStates])),
    ("modes", "objects", Names::Objects),
    ("mode-changes", "from", MODES),
    ("mode-changes", "to", MODES),
    ("stop-options", "transitions", TRANSITIONS),
    ("homing-methods", "parameters", Names::Things(&[Section::Parameters])),
    ("procedures", "object", Names::Objects),
    ("errata", "rule", Names::Rules),
    ("errata", "at", Names::Places),
    ("remarks", "at", Names::Places),
];

/// What the value at a path within a device names.
pub(crate) fn names(path: &[&str]) -> Option<Names> {
    let (key, around) = path.split_last()?;
    let section = around.first().copied().unwrap_or_default();
    // what is mapped stands under the index of its PDO
    let key = if around.last() == Some(&"mapping") { "mapping" } else { key };
    let fits = |(of, name, _): &&(&str, &str, Names)| {
        *name == key && (*of == section || *of == "*" && !section.is_empty() || key == "source")
    };
    RELATIONS.iter().find(fits).map(|(_, _, names)| *names)
}

/// A path within a device, without the member of a family in front.
pub(crate) fn within_device<'p, 'k>(path: &'p [&'k str]) -> &'p [&'k str] {
    match path {
        ["members", _, rest @ ..] => rest,
        all => all,
    }
}
