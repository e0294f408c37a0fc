//! What a program in any language needs of a device: numbers, and names that it can use.
//!
//! Outputs that are programs are templates over this. A name is unique among its siblings, for languages with enumerations
//! and classes; a `global` name is unique in the whole program, for those that have one namespace for all.

mod codes;
mod dictionary;
mod names;
mod pieces;
mod process_data;
#[cfg(any(feature = "icube", feature = "igh", feature = "lcec"))]
mod setup;
mod start_up;
mod transport;
mod value;

use serde::Serialize;

#[cfg(feature = "wireshark")]
pub(super) use self::codes::Bits;
pub(super) use self::codes::Word;
use self::codes::{Error, Mode, Named, State};
pub(super) use self::dictionary::Object;
use self::names::Names;
use self::start_up::StartUp;
use self::transport::{Clock, Identity, Manager};

pub(super) use self::pieces::{Piece, pieces};
pub(super) use self::process_data::{Field, Image, Part, Pdo, Selection};
#[cfg(feature = "igh")]
pub(super) use self::setup::setups;
#[cfg(any(feature = "icube", feature = "lcec"))]
pub(super) use self::setup::{Assigned, Entry, Head, Setup, Step, each_way};
pub(super) use self::value::Kind;
#[cfg(feature = "wireshark")]
pub(super) use self::value::of_type;

use super::escape::prose;
use super::identifier::snake;
use crate::model::Device;

/// Words of a language that no name may be.
pub(super) type Keywords = &'static [&'static str];

/// A device.
#[derive(Debug, Serialize)]
pub(super) struct Program {
    /// The description it is from.
    pub(super) family: String,
    /// The first part of all names.
    pub(super) prefix: String,
    pub(super) name: String,
    pub(super) title: Option<String>,
    pub(super) identity: Identity,
    pub(super) managers: Vec<Manager>,
    pub(super) clocks: Vec<Clock>,
    pub(super) objects: Vec<Object>,
    pub(super) modes: Vec<Mode>,
    pub(super) words: Vec<Word>,
    pub(super) states: Vec<State>,
    pub(super) errors: Vec<Error>,
    pub(super) al_codes: Vec<Named>,
    /// What there is by default, then what configurations choose otherwise.
    pub(super) selections: Vec<Selection>,
    pub(super) start_ups: Vec<StartUp>,
}

impl Program {
    /// What a program in a language with these keywords needs of a device.
    pub(super) fn of(device: &Device, family: &str, keywords: Keywords) -> Self {
        let prefix = prefix(family, &device.id);
        let mut names = Names::new(keywords, &prefix);
        // what has further names made of its own comes first, so that these are free
        let selections = process_data::selections(device, &mut names);
        let states = codes::states(device, &mut names);
        Self {
            prefix,
            family: prose(family),
            name: prose(&device.name),
            title: device.title.as_deref().map(prose),
            identity: transport::identity(device),
            managers: transport::managers(device),
            clocks: transport::clocks(device, &mut names),
            selections,
            start_ups: start_up::start_ups(device, &mut names),
            modes: codes::modes(device, &mut names),
            words: codes::words(device, &mut names),
            states,
            errors: codes::errors(device, &mut names),
            al_codes: codes::al_codes(device),
            objects: dictionary::objects(device, &mut names),
        }
    }
}

/// The first part of all names: the family and the member, as modules are named elsewhere.
fn prefix(family: &str, member: &str) -> String {
    let id = if family == member { member.to_owned() } else { format!("{family}-{member}") };
    match snake(&id) {
        name if name.is_empty() => "device".to_owned(),
        name if name.starts_with(|c: char| c.is_ascii_digit()) => format!("n{name}"),
        name => name,
    }
}
