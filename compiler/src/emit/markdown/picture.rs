//! Pictures that only the page has. What they show stands in a table beside them, so that a text goes without.

use crate::model::{Field, Led, Pdo, Role, SyncManager, Word};

/// A picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) enum Picture {
    /// The bits of a word, so many of them.
    Word(u32, Vec<Part>),
    /// The bytes of a PDO, by its bits.
    Bytes(u32, Vec<Part>),
    /// What the memory of the slave controller is divided into.
    Memory(Vec<Area>),
    /// Lights and how they blink.
    Lights(Vec<Light>),
}

/// Bits that belong together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Part {
    /// The first bit.
    pub(in crate::emit) first: u32,
    /// How many bits.
    pub(in crate::emit) bits: u32,
    /// Their name.
    pub(in crate::emit) name: String,
    /// Whether they have no meaning.
    pub(in crate::emit) is_reserved: bool,
}

/// The area of a sync manager.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Area {
    /// The number of the sync manager.
    pub(in crate::emit) number: u8,
    /// What it carries.
    pub(in crate::emit) carries: &'static str,
    /// The first byte.
    pub(in crate::emit) address: u16,
    /// The bytes of a buffer.
    pub(in crate::emit) size: u16,
    /// How many buffers there are, one behind the other.
    pub(in crate::emit) buffers: u16,
}

/// A light.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Light {
    /// What is printed beside it.
    pub(in crate::emit) name: String,
    /// Its colour.
    pub(in crate::emit) colour: Option<String>,
    /// What it shows, and what that means.
    pub(in crate::emit) patterns: Vec<(String, String)>,
}

/// The bits of a word.
pub(super) fn word(word: &Word) -> Picture {
    let part = |field: &Field| Part {
        first: field.low.into(),
        bits: u32::from(field.high.saturating_sub(field.low)) + 1,
        name: field.name.clone(),
        is_reserved: field.reserved,
    };
    Picture::Word(word.bits, word.fields.iter().map(part).collect())
}

/// The bytes of a PDO.
pub(super) fn bytes(pdo: &Pdo) -> Picture {
    let parts = pdo.entries.iter().map(|mapped| Part {
        first: mapped.offset,
        bits: mapped.bits,
        name: mapped.name.clone(),
        is_reserved: mapped.address.is_none(),
    });
    Picture::Bytes(pdo.bits(), parts.collect())
}

/// The areas of the sync managers. Process data has three buffers, a mailbox one (ETG.1000.4, sync manager).
pub(super) fn memory(managers: &[SyncManager]) -> Picture {
    let areas = managers.iter().filter(|manager| manager.size > 0).map(|manager| Area {
        number: manager.number,
        carries: match manager.role {
            Role::MailboxOut => "mailbox out",
            Role::MailboxIn => "mailbox in",
            Role::Outputs => "outputs",
            Role::Inputs => "inputs",
        },
        address: manager.address,
        size: manager.size,
        buffers: if manager.control & 0b11 == 0 { 3 } else { 1 },
    });
    Picture::Memory(areas.collect())
}

/// Lights and how they blink.
pub(super) fn lights(leds: &[Led]) -> Picture {
    let light = |led: &Led| Light {
        name: led.name.clone(),
        colour: led.colour.clone(),
        patterns: led.patterns.iter().map(|one| (one.shows.clone(), one.means.clone())).collect(),
    };
    Picture::Lights(leds.iter().map(light).collect())
}
