//! What a master writes at start-up: the configuration that the device is in by default.

use super::super::read::InitCmd;
use super::super::read::Written;
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::assigned::process_data;
use super::chosen::{Chosen, Surroundings, lose};
use super::derived::is_derived;
use super::draft::Block;
use super::literal::literal;
use super::references::References;
use crate::model::DataType;
use crate::model::ids::Siblings;

/// The changes of the EtherCAT state at which there is a mailbox.
const TRANSITIONS: [&str; 6] = ["IP", "PS", "SO", "OS", "SP", "OP"];

/// Bytes of the longest value in a start-up list of a description.
const LONGEST: usize = 8;

/// `[configurations.start-up]`, if anything is written that a description can say: what a configuration has keys for by
/// these, all else as writes.
pub(super) fn configuration(
    commands: &[&InitCmd],
    surroundings: &Surroundings<'_>,
    ids: &mut Siblings,
    report: &mut Report,
) -> Option<Block> {
    let (derived, own): (Vec<&InitCmd>, Vec<&InitCmd>) =
        commands.iter().partition(|command| is_derived(command.index));
    let mut keys = process_data(&derived, surroundings, report);
    let chosen = Chosen::of(&own, surroundings);
    let mut writes = Vec::new();
    for command in own {
        match self::writes(command, surroundings.references) {
            Ok(_) if chosen.has(command) => chosen.comment(command, surroundings.references, report),
            Ok(found) => writes.extend(found),
            Err(why) => lose(command, &why, report),
        }
    }
    keys.extend(chosen.keys());
    if !writes.is_empty() {
        set(&mut keys, "writes", Toml::List(writes));
    }
    if keys.is_empty() {
        return None;
    }
    let head = [("name", Toml::text("Start-up")), ("default", Toml::Bool(true))];
    let keys = head.map(|(key, value)| (key.to_owned(), value)).into_iter().chain(keys).collect();
    Some(Block::new("configurations", Some(ids.claim("start-up")), keys))
}

/// What a command writes, once for each transition; or why a description cannot say it.
fn writes(command: &InitCmd, references: &References) -> Result<Vec<Toml>, String> {
    let target = references.get(command.index, command.subindex).ok_or("it is not in the dictionary")?;
    let data_type = target.data_type;
    let is_whole = match data_type {
        DataType::Text(_) => true,
        _ => usize::try_from(data_type.bytes()) == Ok(command.data.len()),
    };
    if command.complete_access {
        return Err("it writes an object as a whole".to_owned());
    }
    if !is_whole || command.data.len() > LONGEST {
        return Err(format!("its entry is {data_type}"));
    }
    if let Some(other) = command.transitions.iter().find(|it| !TRANSITIONS.contains(&it.as_str())) {
        return Err(format!("there is no mailbox at `{other}`"));
    }
    let value = literal(&Written::Data(command.data.clone()), data_type)?;
    let of = |transition: &String| {
        let mut keys = Keys::new();
        set(&mut keys, "entry", Toml::text(&target.text));
        set(&mut keys, "value", value.clone());
        if transition != "PS" {
            set(&mut keys, "transition", Toml::text(transition));
        }
        let why = command.comment.clone().or_else(|| target.name.clone());
        set(&mut keys, "why", Toml::text(why.unwrap_or_else(|| "the file does not say".to_owned())));
        Toml::Table(keys)
    };
    Ok(command.transitions.iter().map(of).collect())
}
