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
    let all_short = blocks.len() > 2 && blocks.iter().all(is_short);
    let (short, long): (Vec<&Block>, Vec<&Block>) =
        blocks.iter().partition(|block| is_short(block) && (all_short || section_name(block) == "objects"));
    if let Some(first) = short.first() {
        text += &format!("[{}]\n", first.section);
        let keys = short.iter().map(|block| (block.key.as_deref().unwrap_or_default(), inline(block)));
        for (block, line) in short.iter().zip(lines(keys)) {
            text += &remarks(&block.remarks);
            text += &line;
        }
        text.push('\n');
    }
    for block in long {
        text += &table(block);
        text.push('\n');
    }
    text
}

/// Whether a table can be written in the one line of its key. Where order counts, all of a section have to be.
fn is_short(block: &Block) -> bool {
    let Some(name) = &block.key else { return false };
    let known = ["objects", "rx-pdos", "tx-pdos", "sync-modes", "diagnosis"].contains(&section_name(block));
    known && key(name).len() + 3 + inline(block).len() <= WIDTH
}

/// The name of the section without the member it is of.
fn section_name(block: &Block) -> &str {
    block.section.rsplit('.').next().unwrap_or_default()
}

/// Keys with their values, aligned.
fn lines<'n>(keys: impl Iterator<Item = (&'n str, String)>) -> Vec<String> {
    let keys: Vec<(String, String)> = keys.map(|(name, value)| (key(name), value)).collect();
    let widest = keys.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    keys.iter().map(|(name, value)| format!("{name:widest$} = {value}\n")).collect()
}

fn inline(block: &Block) -> String {
    Toml::Table(block.keys.clone()).inline()
}

/// Comments on what was guessed.
pub(super) fn remarks(guessed: &[String]) -> String {
    guessed.iter().map(|words| format!("# A guess: {words}.\n")).collect()
}

/// A table with a header.
fn table(block: &Block) -> String {
    let path = match &block.key {
        Some(name) => format!("{}.{}", block.section, key(name)),
        None => block.section.clone(),
    };
    remarks(&block.remarks) + &tables(&path, &block.keys)
}

/// A table, and those within it that are too long for a line.
fn tables(path: &str, keys: &Keys) -> String {
    let widest = keys.iter().map(|(name, _)| key(name).len()).max().unwrap_or(0);
    let is_inner = |name: &str, value: &Toml| {
        let is_long = widest.max(key(name).len()) + 3 + value.inline().len() > WIDTH;
        matches!(value, Toml::Table(keys) if is_long || NAMED.contains(&name) && keys.len() > 2)
    };
    let (inner, own): (Vec<_>, Vec<_>) = keys.iter().partition(|(name, value)| is_inner(name, value));
    let mut text = String::new();
    if !own.is_empty() || inner.is_empty() {
        text += &format!("[{path}]\n");
        let keys = own.iter().map(|(name, value)| (name.as_str(), laid_out(value, widest + 3)));
        text += &lines(keys).concat();
    }
    for (name, value) in inner {
        if let Toml::Table(keys) = value {
            text += &tables(&format!("{path}.{}", key(name)), keys);
        }
    }
    text
}

/// Tables of a line for each of what they name.
const NAMED: [&str; 2] = ["entries", "values"];

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
