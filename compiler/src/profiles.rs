//! The standard profiles that devc brings along.

use crate::source::Profile;

/// What `profiles = [..]` can name.
pub(crate) const ALL: &[Profile] = &[
    Profile { name: "ethercat", text: include_str!("../profiles/ethercat.toml") },
    Profile { name: "cia402", text: include_str!("../profiles/cia402.toml") },
];
