//! All that is known of one thing.

use super::clause;
use super::entity::{Entity, text};
use super::layout::{columns, hang, paragraph};
use super::relation::{in_modes, referring, word};
use super::tree::Trees;
use super::word::numbers;
use crate::source::{Member, Table, Value};

/// A thing with what its tree says of it and who refers to it.
pub(super) fn of_entity(trees: &Trees, entity: Entity<'_>) -> String {
    let mut view = View::new(trees, &entity.title(), entity, entity.text("name"));
    view.about(entity.table);
    view.facts(entity.table, referring(entity), clause::of(entity));
    view.lists(entity.table, Some(entity));
    view.word(word(entity, None));
    view.parts.join("\n\n")
}

/// An entry of an object.
pub(super) fn of_entry(trees: &Trees, object: Entity<'_>, entry: &Member) -> String {
    let Some(table) = entry.node.table() else { return String::new() };
    let of = object.text("name").map(|name| format!(", in {name}")).unwrap_or_default();
    let name = text(table, "name").map(|name| format!("{name}{of}"));
    let subindex = numbers(&entry.key.name).map_or(0, |numbers| *numbers.start());
    let mut view = View::new(trees, &format!("entry {}:{subindex:02X}", object.key), object, name.as_deref());
    view.about(table);
    view.facts(&table.over(&shared(object.table)), Vec::new(), clause::of(object));
    view.lists(table, None);
    view.word(word(object, Some(&entry.key.name)));
    view.parts.join("\n\n")
}

/// What the entries of an object have in common, unless they say otherwise.
fn shared(object: &Table) -> Table {
    let is_shared = |member: &&Member| ["type", "access", "pdo", "category"].contains(&&*member.key.name);
    Table { at: object.at, members: object.members.iter().filter(is_shared).cloned().collect() }
}

/// Paragraphs, facts and lists, one after the other.
struct View<'t> {
    trees: &'t Trees,
    parts: Vec<String>,
}

impl<'t> View<'t> {
    fn new(trees: &'t Trees, title: &str, entity: Entity<'_>, name: Option<&str>) -> Self {
        let name = name.map(|name| format!(": {name}")).unwrap_or_default();
        Self { trees, parts: vec![format!("{title} of {}{name}", entity.tree.name)] }
    }

    fn about(&mut self, table: &Table) {
        self.parts.extend(text(table, "about").map(paragraph));
    }

    /// What is said in a line each, then who refers to it, and where a standard has it.
    fn facts(&mut self, table: &Table, referring: Vec<(&str, Vec<Entity<'_>>)>, clause: Option<&str>) {
        let own = said(table, &["name", "about"]);
        let own = own.map(|member| vec![member.key.name.to_string(), self.value(member)]);
        let others = referring.into_iter().map(|(says, others)| {
            let others: Vec<String> = others.iter().map(Entity::title).collect();
            vec![says.to_owned(), others.join(", ")]
        });
        let clause = clause.map(|clause| vec!["clause".to_owned(), clause.to_owned()]);
        let rows: Vec<Vec<String>> = own.chain(others).chain(clause).collect();
        if !rows.is_empty() {
            self.parts.push(columns(&rows).join("\n"));
        }
    }

    /// A value; a table of single values in a line.
    fn value(&self, member: &Member) -> String {
        let Some(table) = member.node.table() else { return self.trees.written(&member.node) };
        let parts = table.members.iter();
        let parts = parts.map(|part| format!("{} {}", part.key.name, self.trees.written(&part.node)));
        parts.collect::<Vec<_>>().join(", ")
    }

    /// What is said in a list. `word` is whose bits they are, if it is one.
    fn lists(&mut self, table: &Table, word: Option<Entity<'_>>) {
        for member in table.members.iter().filter(|member| is_list(member)) {
            if let Some(items) = member.node.table() {
                self.parts.push(format!("{}\n{}", member.key.name, self.items(items, word).join("\n")));
            }
        }
    }

    /// The bits of an object.
    fn word(&mut self, word: Option<Entity<'_>>) {
        if let Some(word) = word {
            self.about(word.table);
            self.lists(word.table, Some(word));
        }
    }

    fn items(&self, table: &Table, word: Option<Entity<'_>>) -> Vec<String> {
        let width = table.members.iter().map(|item| item.key.name.chars().count()).max().unwrap_or(0);
        table.members.iter().flat_map(|item| self.item(item, width, word)).collect()
    }

    /// An item with its name, and below what else is said of it.
    fn item(&self, item: &Member, width: usize, word: Option<Entity<'_>>) -> Vec<String> {
        let (head, indent) = (format!("  {:width$}  ", item.key.name), width + 4);
        let Some(table) = item.node.table() else {
            return vec![hang(&head, &self.trees.written(&item.node), indent)];
        };
        let margin = " ".repeat(indent);
        let mut below: Vec<String> = text(table, "about").map(str::to_owned).into_iter().collect();
        for key in ["rising", "falling"] {
            below.extend(text(table, key).map(|text| format!("{key}: {text}")));
        }
        below.extend(word.map(|word| in_modes(word, &item.key.name)).unwrap_or_default());
        let below = below.into_iter().map(|text| hang(&margin, &text, indent));
        let lists = table.members.iter().filter(|member| is_list(member)).filter_map(|it| it.node.table());
        let lists = lists.flat_map(|list| self.items(list, None)).map(|line| format!("{margin}{line}"));
        std::iter::once(hang(&head, &self.first_line(table), indent)).chain(below).chain(lists).collect()
    }

    /// The name, and in brackets what is said in a word.
    fn first_line(&self, table: &Table) -> String {
        let rest = said(table, &["name", "about", "rising", "falling"]);
        let rest = rest.map(|member| match &member.node.value {
            Value::Boolean(true) => member.key.name.to_string(),
            Value::String(word) => word.to_string(),
            _ => format!("{} {}", member.key.name, self.value(member)),
        });
        let rest = rest.collect::<Vec<_>>().join(", ");
        match text(table, "name") {
            Some(name) if rest.is_empty() => name.to_owned(),
            Some(name) => format!("{name} ({rest})"),
            None => rest,
        }
    }
}

/// What a table says besides lists and what is told elsewhere.
fn said<'t>(table: &'t Table, elsewhere: &'t [&str]) -> impl Iterator<Item = &'t Member> {
    table.members.iter().filter(|member| !elsewhere.contains(&&*member.key.name) && !is_list(member))
}

/// Whether a member is a table of things that have a number or more than one value.
fn is_list(member: &Member) -> bool {
    let Some(table) = member.node.table() else { return false };
    table.members.iter().any(|item| numbers(&item.key.name).is_some() || item.node.table().is_some())
}
