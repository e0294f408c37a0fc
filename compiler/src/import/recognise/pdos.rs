//! PDOs: what is in them, and what they cannot go with.

use super::super::read::{Pdo, PdoEntry};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set, set_some};
use super::draft::Block;
use super::references::References;
use super::types::{data_type, is_stand_in};
use super::words;
use crate::model::{Direction, Oversampling};

/// A direction of process data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Rx,
    Tx,
}

impl Way {
    fn section(self) -> &'static str {
        match self {
            Self::Rx => "rx-pdos",
            Self::Tx => "tx-pdos",
        }
    }

    fn direction(self) -> Direction {
        match self {
            Self::Rx => Direction::Rx,
            Self::Tx => Direction::Tx,
        }
    }

    /// The name of its elements.
    fn element(self) -> &'static str {
        match self {
            Self::Rx => "RxPdo",
            Self::Tx => "TxPdo",
        }
    }
}

/// Where mapping objects can lie.
const INDICES: std::ops::RangeInclusive<u16> = 0x1600..=0x1BFF;

/// The PDOs of a direction that a description can have: of each index the first. The indices of `others` are taken.
pub(super) fn possible<'p>(pdos: &'p [Pdo], way: Way, others: &[&Pdo], report: &mut Report) -> Vec<&'p Pdo> {
    let mut possible: Vec<&Pdo> = Vec::new();
    for pdo in pdos {
        let what = format!("{} 0x{:04X}", way.element(), pdo.index);
        if !INDICES.contains(&pdo.index) {
            report.lose(pdo.at, facts(pdo), what, "its index is none of those that mapping objects have");
        } else if possible.iter().chain(others).any(|known| known.index == pdo.index) {
            report.lose(pdo.at, facts(pdo), what, "there is one of this index already");
        } else {
            possible.push(pdo);
        }
    }
    possible
}

fn facts(pdo: &Pdo) -> usize {
    let said = [pdo.name.is_some(), pdo.fixed, pdo.mandatory, pdo.sm.is_some()];
    let own = 1 + said.into_iter().filter(|said| *said).count() + pdo.excludes.len();
    own + pdo.entries.iter().map(entry_facts).sum::<usize>()
}

fn entry_facts(entry: &PdoEntry) -> usize {
    let said = [entry.index > 0, entry.name.is_some(), entry.data_type.is_some()];
    2 + said.into_iter().filter(|said| *said).count()
}

/// What a PDO is seen with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surroundings<'s> {
    pub(super) way: Way,
    /// The PDOs of its direction.
    pub(super) pdos: &'s [&'s Pdo],
    pub(super) references: &'s References,
    /// The names of the sync units, by number.
    pub(super) units: &'s [String],
    /// How many entries its mapping object has.
    pub(super) room: usize,
}

/// The table of a PDO.
pub(super) fn block(pdo: &Pdo, surroundings: &Surroundings<'_>, report: &mut Report) -> Block {
    let Surroundings { way, references, units, room, .. } = *surroundings;
    let mut keys = Keys::new();
    let key = format!("0x{:04X}", pdo.index);
    let notes = report.notes.len();
    let name = pdo.name.clone().unwrap_or_else(|| {
        report.guess(
            pdo.at,
            format!("the name of {} {key}", way.element()),
            "it has none; its index is taken",
        );
        format!("{} {key}", way.element())
    });
    set(&mut keys, "name", Toml::text(name));
    set_some(&mut keys, "names", words::in_languages(&pdo.names));
    if !pdo.fixed {
        set(&mut keys, "fixed", Toml::Bool(false));
    }
    // A free mapping has room for all that can be mapped, if nothing is said of it.
    let is_more = !pdo.fixed && room > 0 && references.can_map(way.direction());
    if room > pdo.entries.len() || is_more {
        set(&mut keys, "max-entries", Toml::Integer(room.min(254) as i128));
    }
    if pdo.mandatory {
        set(&mut keys, "mandatory", Toml::Bool(true));
    }
    if let Some(unit) = pdo.su.and_then(|number| units.get(usize::from(number))) {
        set(&mut keys, "sync-unit", Toml::text(unit));
    }
    if pdo.r#virtual {
        set(&mut keys, "virtual", Toml::Bool(true));
    }
    set_some(&mut keys, "oversampling", pdo.oversampling.map(oversampling));
    let entries: Vec<Toml> = pdo.entries.iter().map(|entry| mapped(entry, references, report)).collect();
    if !entries.is_empty() {
        set(&mut keys, "entries", Toml::List(entries));
    }
    let excludes = excludes(pdo, surroundings, report);
    if !excludes.is_empty() {
        set(&mut keys, "excludes", Toml::texts(excludes));
    }
    Block { remarks: report.guessed_since(notes), ..Block::new(way.section(), Some(key), keys) }
}

fn oversampling(it: Oversampling) -> Toml {
    let said = [("factor", Some(it.factor)), ("min", it.min), ("max", it.max), ("step", it.step)];
    let said = said.into_iter().filter_map(|(key, value)| Some((key, value?)));
    Toml::Table(said.map(|(key, value)| (key.to_owned(), Toml::Integer(value.into()))).collect())
}

/// The PDOs that it cannot be assigned together with.
fn excludes(pdo: &Pdo, surroundings: &Surroundings<'_>, report: &mut Report) -> Vec<String> {
    let mut excludes: Vec<String> = Vec::new();
    for (index, at) in &pdo.excludes {
        let text = format!("0x{index:04X}");
        if *index == pdo.index || !surroundings.pdos.iter().any(|other| other.index == *index) {
            let what = format!("Exclude {text} of {} 0x{:04X}", surroundings.way.element(), pdo.index);
            report.lose(*at, 1, what, "it names no other PDO of the direction");
        } else if !excludes.contains(&text) {
            excludes.push(text);
        }
    }
    // Their order says nothing.
    excludes.sort();
    excludes
}

/// An entry of a PDO: a word, or a table where the word is not all.
pub(super) fn mapped(entry: &PdoEntry, references: &References, report: &mut Report) -> Toml {
    let bits = || ("bits".to_owned(), Toml::Integer(entry.bits.into()));
    let named = |name: &String| ("name".to_owned(), Toml::text(name));
    let names = words::in_languages(&entry.names).map(|it| ("names".to_owned(), it));
    let about = entry.comment.as_ref().map(|it| ("about".to_owned(), Toml::text(it)));
    if entry.index == 0 {
        let said = usize::from(entry.subindex > 0) + usize::from(entry.data_type.is_some());
        if said > 0 {
            report.lose(entry.at, said, "the subindex and type of padding", "what is left free has none");
        }
        let name = entry.name.iter().filter(|name| !is_padding(name)).map(named);
        return Toml::Table(std::iter::once(bits()).chain(name).chain(names).chain(about).collect());
    }
    let address = format!("0x{:04X}:{:02X}", entry.index, entry.subindex);
    let target = references.get(entry.index, entry.subindex);
    let Some(target) = target.filter(|target| !target.is_repeated) else {
        let known = target.map(|target| target.data_type).filter(|it| it.bits() == u32::from(entry.bits));
        let own_type = known.map(|it| it.to_string()).or_else(|| own_type(entry, report));
        let width = own_type.map_or_else(bits, |it| ("type".to_owned(), Toml::text(it)));
        let keys = [("entry".to_owned(), Toml::text(address.as_str())), width];
        // What has no name is called by its address.
        let own = entry.name.as_ref().filter(|name| **name != address);
        let name = own.or(target.and_then(|target| target.name.as_ref())).map(named);
        return Toml::Table(keys.into_iter().chain(name).chain(names).chain(about).collect());
    };
    let told = entry.data_type.as_deref().map(|name| data_type(name, Some(entry.bits.into())));
    let told = told.map(|told| told.map(|(found, _)| found));
    let own_type = told.flatten().filter(|told| *told != target.data_type);
    let own_type = own_type.filter(|own| own.bits() == target.data_type.bits() && own.bits() > 0);
    if own_type.is_none() && told.is_some_and(|told| told != Some(target.data_type)) {
        let written = entry.data_type.as_deref().unwrap_or_default();
        let why = format!("its object is {}, the PDO says {written}", target.data_type);
        report.lose(entry.at, 1, format!("the data type of {address} in a PDO"), why);
    }
    let mut keys = vec![("entry".to_owned(), Toml::text(&target.text))];
    if u32::from(entry.bits) != target.data_type.bits() {
        keys.push(bits());
    }
    keys.extend(own_type.map(|own| ("type".to_owned(), Toml::text(own.to_string()))));
    let own = entry.name.as_ref();
    keys.extend(
        own.filter(|name| words::is_other(name, target.name.as_deref(), entry.at, report)).map(named),
    );
    let is_other =
        keys.iter().any(|(key, _)| key == "name") || words::in_languages(&entry.names) != target.names;
    keys.extend(names.filter(|_| is_other));
    keys.extend(about);
    if keys.len() > 1 { Toml::Table(keys) } else { Toml::text(&target.text) }
}

/// The type of what is not in the dictionary, if the language has it.
fn own_type(entry: &PdoEntry, report: &mut Report) -> Option<String> {
    let written = entry.data_type.as_deref()?;
    match data_type(written, Some(entry.bits.into())) {
        Some((found, false)) => Some(found.to_string()),
        Some((found, true)) if is_stand_in(written) && found.bits() == u32::from(entry.bits) => {
            report.guess(
                entry.at,
                "the data type of a mapped entry",
                format!("`{written}` is taken for {found}"),
            );
            Some(found.to_string())
        }
        _ => {
            let why = format!("descriptions have no `{written}` of {} bits", entry.bits);
            report.lose(entry.at, 1, "the data type of a mapped entry", why);
            None
        }
    }
}

/// Whether the name of a padding says no more than that.
fn is_padding(name: &str) -> bool {
    ["padding", "reserved", "alignment", "---", ""].iter().any(|word| name.trim().eq_ignore_ascii_case(word))
}
