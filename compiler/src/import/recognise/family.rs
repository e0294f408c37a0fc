//! Devices of one file that are members of a family: what they share is said once.

use std::collections::BTreeMap;

use super::super::toml::{Keys, Toml, get, set};
use super::draft::{Block, Draft};
use crate::model::ids::Siblings;

/// What of a description has to be shared for a family, of a hundred tables.
const SHARED: usize = 50;

/// The description of all devices together; none if they share too little. Each has the word for it and its name.
pub(in super::super) fn family(members: Vec<(String, String, Draft)>) -> Option<Draft> {
    let mut drafts = members.iter().map(|(_, _, draft)| draft);
    let first = drafts.next()?;
    let mut shared = Draft { profiles: first.profiles.clone(), ..Draft::default() };
    if drafts.any(|draft| draft.profiles != first.profiles) {
        return None;
    }
    let others: Vec<&Draft> = members.iter().skip(1).map(|(_, _, draft)| draft).collect();
    shared.device = common(&first.device, &others.iter().map(|it| it.device.as_slice()).collect::<Vec<_>>());
    shared.pdos = common(&first.pdos, &others.iter().map(|it| it.pdos.as_slice()).collect::<Vec<_>>());
    shared.objects =
        common(&first.objects, &others.iter().map(|it| it.objects.as_slice()).collect::<Vec<_>>());
    shared.diagnosis =
        common(&first.diagnosis, &others.iter().map(|it| it.diagnosis.as_slice()).collect::<Vec<_>>());
    let everywhere = |path: &&String| others.iter().all(|other| other.without.contains(path));
    shared.without = first.without.iter().filter(everywhere).cloned().collect();
    let keyed = |draft: &Draft| blocks(draft).filter(|block| block.key.is_some()).count();
    let all: usize = members.iter().map(|(_, _, draft)| keyed(draft)).sum();
    if keyed(&shared) * members.len() * 100 < all * SHARED || keyed(&shared) < 3 {
        return None;
    }
    let names: Vec<&str> = members.iter().map(|(_, name, _)| name.as_str()).collect();
    shared
        .device
        .insert(0, Block::new("family", None, vec![("name".to_owned(), Toml::text(common_name(&names)))]));
    let mut ids = Siblings::default();
    let known = index(blocks(&shared));
    let own: Vec<Block> = members
        .iter()
        .flat_map(|(word, _, draft)| member(&ids.claim(word), draft, &shared.without, &known))
        .collect();
    shared.members = own;
    Some(shared)
}

fn blocks(draft: &Draft) -> impl Iterator<Item = &Block> {
    draft.device.iter().chain(&draft.pdos).chain(&draft.objects).chain(&draft.diagnosis)
}

/// The tables that all have; of those that are alone in their section, the keys.
fn common(first: &[Block], others: &[&[Block]]) -> Vec<Block> {
    let others: Vec<Index<'_>> = others.iter().map(|other| index(*other)).collect();
    let shared = first.iter().filter_map(|block| {
        let same: Vec<&Block> = others.iter().filter_map(|other| twin(block, other)).collect();
        let keys = match block.key {
            _ if same.len() < others.len() => return None,
            Some(_) => same.iter().all(|other| other.keys == block.keys).then(|| block.keys.clone())?,
            None => {
                let is_shared = |(name, value): &&(String, Toml)| {
                    same.iter().all(|other| get(&other.keys, name) == Some(value))
                };
                block.keys.iter().filter(is_shared).cloned().collect::<Keys>()
            }
        };
        (!keys.is_empty() || block.key.is_some()).then(|| Block { keys, ..block.clone() })
    });
    shared.collect()
}

/// Tables by section and key.
type Index<'b> = BTreeMap<(&'b str, Option<&'b str>), &'b Block>;

fn index<'b>(blocks: impl IntoIterator<Item = &'b Block>) -> Index<'b> {
    blocks.into_iter().map(|block| ((block.section.as_str(), block.key.as_deref()), block)).collect()
}

fn twin<'b>(block: &Block, others: &Index<'b>) -> Option<&'b Block> {
    others.get(&(block.section.as_str(), block.key.as_deref())).copied()
}

/// What a member has of its own.
fn member(id: &str, draft: &Draft, everywhere: &[String], shared: &Index<'_>) -> Vec<Block> {
    let mut own = Vec::new();
    let without: Vec<&String> = draft.without.iter().filter(|path| !everywhere.contains(path)).collect();
    if !without.is_empty() {
        let keys = vec![("without".to_owned(), Toml::texts(without))];
        own.push(Block::new("members", Some(id.to_owned()), keys));
    }
    for block in blocks(draft) {
        let known = twin(block, shared);
        let mut keys = Keys::new();
        for (name, value) in &block.keys {
            if known.is_none_or(|known| get(&known.keys, name) != Some(value)) {
                set(&mut keys, name, value.clone());
            }
        }
        if known.is_none() || !keys.is_empty() {
            own.push(Block { section: format!("members.{id}.{}", block.section), keys, ..block.clone() });
        }
    }
    own
}

/// How the names of all begin, or the first of them.
fn common_name(names: &[&str]) -> String {
    let first = names.first().copied().unwrap_or_default();
    let same = |length: usize| names.iter().all(|name| name.get(..length) == first.get(..length));
    let ends = first.char_indices().map(|(place, char)| place + char.len_utf8());
    let common =
        ends.take_while(|end| same(*end)).last().and_then(|end| first.get(..end)).unwrap_or_default();
    let common = common.trim_end_matches(|char: char| !char.is_alphanumeric());
    if common.chars().count() < 2 { names.join(", ") } else { common.to_owned() }
}
