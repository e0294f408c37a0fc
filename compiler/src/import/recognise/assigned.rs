//! Start-up commands that assign and map PDOs.

use std::collections::BTreeMap;

use super::super::read::{InitCmd, PdoEntry};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::chosen::{Surroundings, lose, lose_comment};
use super::derived::{ASSIGNMENTS, word};
use super::pdos::mapped;
use super::sync_managers::{carried, carries};
use crate::model::Role;

/// `outputs`, `inputs` and `mapping`, as far as the commands write something else than what masters write by themselves, as
/// the PDOs say.
pub(super) fn process_data(
    commands: &[&InitCmd],
    surroundings: &Surroundings<'_>,
    report: &mut Report,
) -> Keys {
    let mut objects: BTreeMap<u16, Vec<&InitCmd>> = BTreeMap::new();
    for command in commands {
        objects.entry(command.index).or_default().push(command);
    }
    let (mut keys, mut mappings) = (Keys::new(), Keys::new());
    for (index, commands) in objects {
        let said = list(index, &commands).and_then(|list| choice(index, &list, surroundings, report));
        match said {
            Ok(choice) => {
                told(index, &commands, choice.is_some(), report);
                match choice {
                    Some((key, value)) if index < ASSIGNMENTS => set(&mut mappings, &key, value),
                    Some(choice) => keys.push(choice),
                    None => {}
                }
            }
            Err(why) => commands.iter().for_each(|command| lose(command, why, report)),
        }
    }
    if !mappings.is_empty() {
        set(&mut keys, "mapping", Toml::Table(mappings));
    }
    keys
}

/// Says where the commands went.
fn told(index: u16, commands: &[&InitCmd], is_chosen: bool, report: &mut Report) {
    let (what, key) =
        if index < ASSIGNMENTS { ("mapping", "`mapping`") } else { ("assignment", "`outputs` or `inputs`") };
    let why = if is_chosen {
        format!("{key} of the configuration says it; in an ESI masters write what the PDOs say")
    } else {
        "it is what the PDOs say, and masters write that by themselves".to_owned()
    };
    for command in commands {
        report.guess(command.at, format!("an InitCmd of the {what} 0x{index:04X}"), why.clone());
        if let Some(comment) = command.comment.as_ref() {
            lose_comment(command, comment, "what is written follows from the PDOs", report);
        }
    }
}

/// What an object lists when all is written.
fn list(index: u16, commands: &[&InitCmd]) -> Result<Vec<u64>, &'static str> {
    let width = if index < ASSIGNMENTS { 4 } else { 2 };
    let mut values: BTreeMap<u8, u64> = BTreeMap::new();
    for command in commands {
        if !matches!(command.transitions.as_slice(), [only] if only == "PS") {
            return Err("masters write assignments and mappings on the way to Safe-Operational");
        }
        match (command.complete_access, command.subindex, command.data.as_slice()) {
            (true, 0, [count, _, rest @ ..]) if rest.len().is_multiple_of(width) => {
                values.insert(0, (*count).into());
                values.extend((1..=u8::MAX).zip(rest.chunks(width).map(number)));
            }
            (false, 0, [count]) => _ = values.insert(0, (*count).into()),
            (false, 1.., data) if data.len() == width => _ = values.insert(command.subindex, number(data)),
            _ => return Err("its data are not as wide as the entry"),
        }
    }
    let count = values.get(&0).ok_or("nothing says how many it lists")?;
    let listed = (1..=u8::MAX).take_while(|it| u64::from(*it) <= *count);
    listed.map(|it| values.get(&it).copied().ok_or("it counts more than is written")).collect()
}

fn number(data: &[u8]) -> u64 {
    data.iter().rev().fold(0, |value, byte| value << 8 | u64::from(*byte))
}

/// The key and its value; none if it is what the PDOs say.
fn choice(
    index: u16,
    list: &[u64],
    surroundings: &Surroundings<'_>,
    report: &mut Report,
) -> Result<Option<(String, Toml)>, &'static str> {
    match index {
        ASSIGNMENTS.. => assignment(index - ASSIGNMENTS, list, surroundings),
        _ => mapping(index, list, surroundings, report),
    }
}

fn assignment(
    number: u16,
    list: &[u64],
    surroundings: &Surroundings<'_>,
) -> Result<Option<(String, Toml)>, &'static str> {
    let basis = surroundings.basis;
    let pdos = [basis.rx, basis.tx];
    let process_data = || basis.managers.iter().filter(|it| it.role.is_process_data());
    let manager = process_data().find(|it| u16::from(it.number) == number);
    let manager = manager.ok_or("there is no sync manager of process data of this number")?;
    if carried(manager, pdos).iter().map(|pdo| u64::from(pdo.index)).eq(list.iter().copied()) {
        return Ok(None);
    }
    let known = carries(manager, pdos);
    if list.iter().any(|index| !known.iter().any(|pdo| u64::from(pdo.index) == *index)) {
        return Err("it assigns a PDO that is not there");
    }
    if process_data().filter(|it| it.role == manager.role).count() > 1 {
        return Err("it chooses for one of several sync managers of a direction");
    }
    if !basis.assigns {
        return Err("the mailbox says that no master may assign PDOs");
    }
    own_axis(surroundings)?;
    let key = if manager.role == Role::Outputs { "outputs" } else { "inputs" };
    Ok(Some((key.to_owned(), Toml::texts(list.iter().map(|index| format!("0x{index:04X}"))))))
}

fn mapping(
    index: u16,
    list: &[u64],
    surroundings: &Surroundings<'_>,
    report: &mut Report,
) -> Result<Option<(String, Toml)>, &'static str> {
    let basis = surroundings.basis;
    let pdo = basis.pdo(index).ok_or("it maps a PDO that is not there")?;
    if pdo.entries.iter().map(word).eq(list.iter().copied()) {
        return Ok(None);
    }
    if pdo.fixed {
        return Err("the mapping of the PDO is fixed");
    }
    if !basis.maps {
        return Err("the mailbox says that no master may map PDOs");
    }
    own_axis(surroundings)?;
    let entry = |word: &u64| PdoEntry {
        at: pdo.at,
        index: u16::try_from(word >> 16).unwrap_or(0),
        subindex: u8::try_from(word >> 8 & 0xFF).unwrap_or(0),
        bits: u16::try_from(word & 0xFF).unwrap_or(0),
        ..PdoEntry::default()
    };
    let entries = list.iter().map(|word| mapped(&entry(word), surroundings.references, report));
    Ok(Some((format!("0x{index:04X}"), Toml::List(entries.collect()))))
}

/// Of several axes, a configuration chooses the same for all.
fn own_axis(surroundings: &Surroundings<'_>) -> Result<(), &'static str> {
    if surroundings.axes.names().is_empty() { Ok(()) } else { Err("it chooses for one of several axes") }
}
