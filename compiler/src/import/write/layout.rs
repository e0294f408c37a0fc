//! Tables in lines: what is short stands in one line, keys of a table are aligned.

use super::super::toml::{Keys, Toml, key};
use super::Block;

/// The longest line that is written if there is a choice.
const WIDTH: usize = 120;

/// Tables of sections in order.
pub(super) struct Section<'b>(&'b [Block]);

impl<'b> Section<'b> {
    pub(super) fn of(blocks: &'b [Block]) -> Self {
        Self(blocks)
    }

    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        let mut rest = self.0;
        while let Some(first) = rest.first() {
            let same = rest.iter().take_while(|block| block.section == first.section).count();
            let (section, others) = rest.split_at(same);
            text += &self::section(section);
            rest = others;
        }
        text
    }
}

/// The tables of one section: first those of a line each, then the others.
fn section(blocks: &[Block]) -> String {
    let mut text = String::new();
    let (short, long): (Vec<&Block>, Vec<&Block>) =
        blocks.iter().partition(|block| is_short(block, blocks.len()));
    if let Some(first) = short.first() {
        text += &format!("[{}]\n", first.section);
        let widest = short
            .iter()
            .filter_map(|block| block.key.as_deref())
            .map(|name| key(name).len())
            .max()
            .unwrap_or(0);
        for block in &short {
            text +=
                &format!("{:widest$} = {}\n", key(block.key.as_deref().unwrap_or_default()), inline(block));
        }
        text.push('\n');
    }
    for block in long {
        text += &table(block);
        text.push('\n');
    }
    text
}

/// Whether a table is written in the one line of its key.
fn is_short(block: &Block, siblings: usize) -> bool {
    let Some(name) = &block.key else { return false };
    let is_object = block.section == "objects" || block.section == "sync-modes" && siblings > 2;
    is_object && block.remarks.is_empty() && key(name).len() + 3 + inline(block).len() <= WIDTH
}

fn inline(block: &Block) -> String {
    Toml::Table(block.keys.clone()).inline()
}

/// A table with a header.
fn table(block: &Block) -> String {
    let mut text = String::new();
    for remark in &block.remarks {
        text += &format!("# A guess: {remark}.\n");
    }
    let path = match &block.key {
        Some(name) => format!("{}.{}", block.section, key(name)),
        None => block.section.to_owned(),
    };
    text += &format!("[{path}]\n");
    let (inner, own): (Keys, Keys) = block.keys.iter().cloned().partition(|(_, value)| is_inner(value));
    let widest = own.iter().map(|(name, _)| key(name).len()).max().unwrap_or(0);
    for (name, value) in &own {
        text += &format!("{:widest$} = {}\n", key(name), laid_out(value, widest + 3));
    }
    for (name, value) in &inner {
        let Toml::Table(keys) = value else { continue };
        text += &format!("[{path}.{}]\n", key(name));
        let widest = keys.iter().map(|(name, _)| key(name).len()).max().unwrap_or(0);
        for (name, value) in keys {
            text += &format!("{:widest$} = {}\n", key(name), value.inline());
        }
    }
    text
}

/// Whether a value is written as a table of its own.
fn is_inner(value: &Toml) -> bool {
    matches!(value, Toml::Table(keys) if keys.len() > 2 || value.inline().len() > WIDTH - 20)
}

/// A list that is too long for a line has a line an item.
fn laid_out(value: &Toml, before: usize) -> String {
    let line = value.inline();
    match value {
        Toml::List(items) if before + line.len() > WIDTH => {
            let items = items.iter().map(|item| format!("    {},\n", item.inline()));
            format!("[\n{}]", items.collect::<String>())
        }
        _ => line,
    }
}
