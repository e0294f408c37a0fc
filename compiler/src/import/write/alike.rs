//! Objects that are like another one say only what differs.

use std::collections::BTreeMap;

use super::super::toml::{Keys, Toml, get, set};
use super::Block;
use super::layout::Section;

/// Objects of one shape, of which those behind the first are written by what differs from it, if that is much less.
/// Objects of `profiles` have that to differ from, and stay as they are.
pub(super) fn alike(objects: &[Block], profiles: &[&str]) -> Vec<Block> {
    let mut first: BTreeMap<String, &Block> = BTreeMap::new();
    let mut written = Vec::new();
    for block in objects {
        let is_own = block.key.as_deref().is_some_and(|key| is_own(key, profiles.contains(&"cia402")));
        let shape = is_own.then(|| shape(&block.keys));
        let short = shape.and_then(|shape| match first.get(&shape) {
            Some(base) => shorter(block, base),
            None => {
                first.insert(shape, block);
                None
            }
        });
        written.push(short.unwrap_or_else(|| block.clone()));
    }
    written
}

/// Whether no profile has an object of this index: mapping objects and what a manufacturer or a device profile adds.
fn is_own(key: &str, is_drive: bool) -> bool {
    let index = key.strip_prefix("0x").and_then(|digits| u16::from_str_radix(digits, 16).ok());
    index.is_some_and(|index| match index {
        0x1600..=0x1BFF | 0x2000..=0x5FFF | 0x6800..=0xEFFF => true,
        0x6000..=0x67FF => !is_drive,
        _ => false,
    })
}

/// The keys of a table and of those in it.
fn shape(keys: &Keys) -> String {
    let inner = |value: &Toml| match value {
        Toml::Table(keys) => format!("{{{}}}", shape(keys)),
        _ => String::new(),
    };
    keys.iter().map(|(name, value)| format!("{name:?}{},", inner(value))).collect()
}

/// An object by what differs from another of its shape, if that takes half the lines at most.
fn shorter(block: &Block, base: &Block) -> Option<Block> {
    let mut keys = vec![("like".to_owned(), Toml::text(base.key.clone()?))];
    keys.extend(difference(&block.keys, &base.keys));
    let short = Block { keys, ..block.clone() };
    let lines = |block: &Block| Section::of(std::slice::from_ref(block)).text().lines().count();
    (lines(&short) * 2 <= lines(block)).then_some(short)
}

fn difference(own: &Keys, base: &Keys) -> Keys {
    let mut keys = Keys::new();
    for (name, value) in own {
        match (value, get(base, name)) {
            (value, Some(known)) if value == known => {}
            (Toml::Table(own), Some(Toml::Table(base))) => {
                set(&mut keys, name, Toml::Table(difference(own, base)));
            }
            _ => set(&mut keys, name, value.clone()),
        }
    }
    keys
}

#[cfg(test)]
mod tests {
    use super::*;

    fn object(key: &str, name: &str, second: i128) -> Block {
        let value = |number: i128| Toml::Table(vec![("default".to_owned(), Toml::Integer(number))]);
        let entries = (1..=6).map(|it| (it.to_string(), value(if it == 2 { second } else { it })));
        let keys = vec![
            ("name".to_owned(), Toml::text(name)),
            ("type".to_owned(), Toml::text("UINT8")),
            ("entries".to_owned(), Toml::Table(entries.collect())),
        ];
        Block::new("objects", Some(key.to_owned()), keys)
    }

    #[test]
    fn what_differs_is_left() {
        let blocks = [object("0x2000", "A", 2), object("0x2010", "B", 2), object("0x2020", "C", 9)];
        let written = alike(&blocks, &[]);
        let like = |name: &str| {
            vec![("like".to_owned(), Toml::text("0x2000")), ("name".to_owned(), Toml::text(name))]
        };
        assert_eq!(written[0].keys, blocks[0].keys);
        assert_eq!(written[1].keys, like("B"));
        let second = vec![("default".to_owned(), Toml::Integer(9))];
        let entries = ("entries".to_owned(), Toml::Table(vec![("2".to_owned(), Toml::Table(second))]));
        assert_eq!(written[2].keys, [like("C"), vec![entries]].concat());
    }

    #[test]
    fn objects_of_profiles_and_short_ones_stay() {
        let profile = [object("0x6098", "A", 2), object("0x6099", "B", 2)];
        assert_eq!(alike(&profile, &["cia402"])[1].keys, profile[1].keys);
        let one = |key: &str| {
            Block::new("objects", Some(key.to_owned()), vec![("type".to_owned(), Toml::text("UINT8"))])
        };
        assert_eq!(alike(&[one("0x2000"), one("0x2001")], &[])[1].keys, one("0x2001").keys);
    }
}
