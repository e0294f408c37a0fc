//! What a master writes at start-up: the configuration that the device is in by default.

use super::super::read::InitCmd;
use super::super::read::Written;
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::derived::is_derived;
use super::draft::Block;
use super::literal::literal;
use super::references::References;
use crate::model::DataType;

/// The changes of the EtherCAT state at which there is a mailbox.
const TRANSITIONS: [&str; 6] = ["IP", "PS", "SO", "OS", "SP", "OP"];

/// Bytes of the longest value in a start-up list of a description.
const LONGEST: usize = 8;

/// `[configurations.start-up]`, if anything is written that a description can say.
pub(super) fn configuration<'c>(
    commands: impl IntoIterator<Item = &'c InitCmd>,
    references: &References,
    report: &mut Report,
) -> Option<Block> {
    let mut writes = Vec::new();
    for command in commands {
        match self::writes(command, references) {
            Ok(found) => writes.extend(found),
            Err(why) => {
                let place = format!("0x{:04X}:{:02X}", command.index, command.subindex);
                let data: String = command.data.iter().map(|byte| format!("{byte:02X}")).collect();
                let what = format!("InitCmd {place} in {}", command.transitions.join(", "));
                report.lose(command.at, command.facts, what, format!("{why}; it writes {data}"));
            }
        }
    }
    if writes.is_empty() {
        return None;
    }
    let mut keys = Keys::new();
    set(&mut keys, "name", Toml::text("Start-up"));
    set(&mut keys, "default", Toml::Bool(true));
    set(&mut keys, "writes", Toml::List(writes));
    Some(Block::new("configurations", Some("start-up".to_owned()), keys))
}

/// What a command writes, once for each transition; or why a description cannot say it.
fn writes(command: &InitCmd, references: &References) -> Result<Vec<Toml>, String> {
    if is_derived(command.index) {
        return Err("masters write assignments and mappings by themselves, as the PDOs say".to_owned());
    }
    let target = references.get(command.index, command.subindex).ok_or("it is not in the dictionary")?;
    let data_type = target.data_type;
    let is_whole = match data_type {
        DataType::Text(_) => true,
        _ => usize::try_from(data_type.bytes()) == Ok(command.data.len()),
    };
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
