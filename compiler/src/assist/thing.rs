//! Things that can be named.

use super::Knowledge;
use crate::model::{Section, ids};
use crate::reference::relation::Names;
use crate::source::{Member, Table, Value};

/// A table of a section.
#[derive(Clone, Copy)]
pub(super) struct Thing<'k> {
    pub(super) section: Section,
    pub(super) member: &'k Member,
}

impl<'k> Thing<'k> {
    pub(super) fn key(&self) -> &'k str {
        &self.member.key.name
    }

    pub(super) fn table(&self) -> Option<&'k Table> {
        self.member.node.table().map(|table| &**table)
    }

    pub(super) fn text(&self, key: &str) -> Option<&'k str> {
        text(self.table()?, key)
    }

    /// The word that names it: of an object its id, which is made of its name unless it is given.
    pub(super) fn id(&self) -> String {
        if self.section != Section::Objects {
            return self.key().to_owned();
        }
        let made = || self.text("name").map(ids::id);
        self.text("id").map(str::to_owned).or_else(made).unwrap_or_else(|| self.key().to_owned())
    }

    /// Whether a word names it.
    pub(super) fn is(&self, word: &str) -> bool {
        let key = crate::source::CanonicalKey::of(word);
        self.member.key.canonical == key || self.section == Section::Objects && self.id() == word
    }

    /// What it is called, in a line.
    pub(super) fn title(&self) -> String {
        let name = self.text("name").or_else(|| self.text("title")).unwrap_or_default();
        let kind = ["type", "access"].iter().filter_map(|key| self.text(key));
        let parts = std::iter::once(name).chain(kind).filter(|part| !part.is_empty());
        parts.collect::<Vec<_>>().join(", ")
    }

    /// Its entries, if it is an object.
    pub(super) fn entries(&self) -> &'k [Member] {
        let entries = self.table().and_then(|table| table.get("entries")?.node.table());
        entries.map_or(&[], |entries| &entries.members)
    }
}

pub(super) fn text<'t>(table: &'t Table, key: &str) -> Option<&'t str> {
    match &table.get(key)?.node.value {
        Value::String(text) => Some(text),
        _ => None,
    }
}

/// The things of a section of a tree.
pub(super) fn of(root: &Table, section: Section) -> impl Iterator<Item = Thing<'_>> {
    let members = root.get(section.name()).and_then(|member| member.node.table());
    members.map_or(&[][..], |table| &table.members).iter().map(move |member| Thing { section, member })
}

impl Knowledge {
    /// The things of a section that the description has.
    pub(super) fn things(&self, section: Section) -> impl Iterator<Item = Thing<'_>> {
        of(&self.root, section)
    }

    /// The thing that a word names: the description's, or else one that a profile has.
    pub(super) fn find(&self, section: Section, word: &str) -> Option<Thing<'_>> {
        let of_profile = || of(&self.profile, section).find(|thing| thing.is(word));
        self.things(section).find(|thing| thing.is(word)).or_else(of_profile)
    }

    /// What a value names; for an entry, its object.
    pub(super) fn named(&self, names: Names, section: &str, word: &str) -> Option<Thing<'_>> {
        match names {
            Names::Objects => {
                let object = word.split_once(':').map_or(word, |(object, _)| object);
                self.find(Section::Objects, object.trim())
            }
            Names::Things(sections) => sections.iter().find_map(|section| self.find(*section, word)),
            Names::Siblings => self.find(Section::find(section)?, word),
            Names::Documents => {
                let known = word.split_once(": ").and_then(|(id, _)| self.find(Section::Documents, id));
                known.or_else(|| self.things(Section::Documents).next())
            }
            Names::Places => match word.split_once('.') {
                Some((section, rest)) if Section::find(section).is_some() => {
                    let section = Section::find(section)?;
                    self.find(section, rest.split('.').next().unwrap_or(rest))
                }
                _ => {
                    let index = word.split([':', '.']).next().unwrap_or(word);
                    [Section::Objects, Section::RxPdos, Section::TxPdos]
                        .into_iter()
                        .find_map(|section| self.find(section, index))
                }
            },
            Names::Rules | Names::Profiles | Names::Files | Names::Types => None,
        }
    }

    /// What the profiles have at a path.
    pub(super) fn in_profile(&self, path: &[&str]) -> Option<&Member> {
        walk(&self.profile, path)
    }

    /// What the description over its profiles has at a path.
    pub(super) fn in_description(&self, path: &[&str]) -> Option<&Member> {
        walk(&self.root, path)
    }
}

/// The member at a path of tables.
fn walk<'t>(root: &'t Table, path: &[&str]) -> Option<&'t Member> {
    let (first, rest) = path.split_first()?;
    let member = root.get(first)?;
    if rest.is_empty() { Some(member) } else { walk(member.node.table()?, rest) }
}
