//! The messages of the diagnosis history.

use std::collections::BTreeSet;

use super::super::read::Message;
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set, set_some};
use super::draft::Block;
use super::words::in_languages;

/// `[diagnosis]`, each text id once.
pub(super) fn blocks(messages: &[Message], report: &mut Report) -> Vec<Block> {
    let mut known = BTreeSet::new();
    let mut blocks = Vec::new();
    for message in messages {
        let text_id = u16::try_from(message.text_id).ok();
        match text_id.filter(|text_id| known.insert(*text_id)) {
            Some(text_id) => blocks.push(block(message, text_id)),
            None => {
                let what = format!("DiagMessage 0x{:04X}", message.text_id);
                let why = match text_id {
                    Some(_) => "there is one of this text id already",
                    None => "a text id has 16 bits",
                };
                report.lose(message.at, 2 + 2 * message.texts.len(), what, why);
            }
        }
    }
    blocks.sort_by(|one, other| one.key.cmp(&other.key));
    blocks
}

fn block(message: &Message, text_id: u16) -> Block {
    let mut keys = Keys::new();
    set(&mut keys, "text", Toml::text(&message.text));
    set_some(&mut keys, "texts", in_languages(&message.texts));
    set_some(&mut keys, "class", message.class.map(Toml::text));
    set_some(&mut keys, "about", message.about.as_ref().map(Toml::text));
    set_some(&mut keys, "remedy", message.remedy.as_ref().map(Toml::text));
    Block::new("diagnosis", Some(format!("0x{text_id:04X}")), keys)
}
