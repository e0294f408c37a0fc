//! Pins of HAL.

use serde::Serialize;

use crate::emit::identifier::Claimed;
use crate::emit::program::{Assigned, Entry, Kind, Step};
use crate::lint::rules::overlong_pin;
use crate::model::Dimension;

/// What an entry is in HAL.
#[derive(Debug, Default, Serialize)]
pub(super) struct Pin {
    /// None where no type of HAL holds the value: it is mapped, and out of reach.
    name: Option<String>,
    hal_type: &'static str,
    /// Units for one raw step.
    scale: Option<f64>,
}

/// A sync manager with pins.
#[derive(Debug, Serialize)]
pub(super) struct Pinned<'m> {
    number: u8,
    is_output: bool,
    pdos: Vec<PinnedPdo<'m>>,
}

/// A PDO with pins.
#[derive(Debug, Serialize)]
struct PinnedPdo<'m> {
    index: u16,
    title: &'m str,
    entries: Vec<PinnedEntry<'m>>,
}

/// What is mapped, with its pin.
#[derive(Debug, Serialize)]
struct PinnedEntry<'m> {
    #[serde(flatten)]
    entry: &'m Entry,
    pin: Pin,
}

/// The sync managers of process data; all pins of a slave have names of their own.
pub(super) fn pinned(managers: &[Assigned]) -> Vec<Pinned<'_>> {
    let mut names = Claimed::default();
    let managers = managers.iter().filter(|manager| manager.is_process_data && !manager.pdos.is_empty());
    let pinned = managers.map(|manager| {
        let pdos = manager.pdos.iter().map(|pdo| {
            let entries = pdo.entries.iter().map(|entry| PinnedEntry { entry, pin: pin(entry, &mut names) });
            PinnedPdo { index: pdo.index, title: &pdo.title, entries: entries.collect() }
        });
        Pinned { number: manager.number, is_output: manager.is_output, pdos: pdos.collect() }
    });
    pinned.collect()
}

fn pin(entry: &Entry, names: &mut Claimed) -> Pin {
    let Some(value) = &entry.value else { return Pin::default() };
    let scale = value.step.and_then(scale);
    let hal_type = match (value.kind, entry.bits) {
        (Kind::Bool, 1) => "bit",
        (Kind::Int, ..=32) if scale.is_some() => "float",
        (Kind::Int, ..=32) => "s32",
        (Kind::Uint, ..=32) if scale.is_some() => "float-unsigned",
        (Kind::Bool | Kind::Uint, ..=32) => "u32",
        (Kind::Real, 32) => "float-ieee",
        (Kind::Real, 64) => "float-double-ieee",
        _ => return Pin::default(),
    };
    let name = value.name.replace('_', "-");
    let cut = |room: usize| name.get(..room).unwrap_or(&name).trim_end_matches('-').to_owned();
    let room = overlong_pin::LONGEST;
    let name = names.claim(cut(room), |number| format!("{}-{number}", cut(room.saturating_sub(4))));
    Pin { name: Some(name), hal_type, scale: scale.filter(|_| hal_type.starts_with("float")) }
}

/// The units of LinuxCNC for one raw step: millimetres, degrees, and these in a second.
fn scale(step: Step) -> Option<f64> {
    let smallest = match step.dimension {
        Dimension::Length | Dimension::Velocity => 1e6,
        Dimension::Angle | Dimension::AngularVelocity => 1e9,
        _ => return None,
    };
    let (units, raw) = step.smallest;
    Some(units / (raw * smallest))
}
