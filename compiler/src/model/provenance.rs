//! Who says a fact, and how sure it is.

use crate::source::{Layer, Member, Members, Node, Origin, Value};

/// Who says a fact.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
pub enum Provenance {
    /// The source that its table names.
    Stated,
    /// A standard profile; the description says nothing of it.
    Profile,
    /// Nobody; the description takes it to be so for this reason.
    Assumed(String),
    /// An erratum, by its number in the list of errata: the source says something else.
    Corrected(u16),
    /// The source, against an erratum that does not know what holds, by its number in the list of errata.
    Contradicted(u16),
    /// Nobody: it follows from other facts, or from what the format says of a key that is left out.
    Derived,
}

/// Who says the fact at `path` in a table.
pub fn provenance(origin: &Origin, path: &str) -> Provenance {
    match origin.layer(path) {
        Some(layer) => author(layer, path, origin.node("assumed")),
        // what a table is called by, such as the index of a PDO, is no key in it
        None => {
            let named = named_reasons(origin).find(|(key, _)| *key == path);
            named.map_or(Provenance::Derived, |(_, reason)| Provenance::Assumed(reason.to_owned()))
        }
    }
}

/// Why the fact at `path` is assumed, if it is, whatever an erratum says of it.
pub fn assumption<'o>(origin: &'o Origin, path: &str) -> Option<&'o str> {
    reason(origin.node("assumed")?, path)
}

/// Who says the fact at `path` that is in a layer, where the table gives these reasons for what is assumed. That what the
/// profile says holds for the device can be assumed, too.
fn author(layer: Layer, path: &str, reasons: Option<&Node>) -> Provenance {
    let reason = || reasons.and_then(|reasons| reason(reasons, path));
    match layer {
        Layer::Corrected(erratum) => Provenance::Corrected(erratum),
        Layer::Contradicted(erratum) => Provenance::Contradicted(erratum),
        Layer::Profile | Layer::Description => match reason() {
            Some(reason) => Provenance::Assumed(reason.to_owned()),
            None if layer == Layer::Profile => Provenance::Profile,
            None => Provenance::Stated,
        },
    }
}

/// The keys for which a table has reasons of their own.
fn named_reasons(origin: &Origin) -> impl Iterator<Item = (&str, &str)> {
    let reasons = origin.node("assumed").and_then(Node::table);
    let keys = reasons.into_iter().flat_map(|reasons| &*reasons.members);
    keys.filter_map(|member| Some((&*member.key.name, text(&member.node.value)?)))
}

fn text(value: &Value) -> Option<&str> {
    match value {
        Value::String(text) => Some(text),
        _ => None,
    }
}

/// Why the fact at `path` is assumed, if it is: the reason for the key, for a table around it, or for all of the table.
fn reason<'o>(reasons: &'o Node, path: &str) -> Option<&'o str> {
    match &reasons.value {
        Value::Table(reasons) => {
            let covers = |member: &&Member| {
                let rest = path.strip_prefix(&*member.key.name);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            };
            reasons.members.iter().find(covers).and_then(|member| text(&member.node.value))
        }
        all => text(all),
    }
}

/// The facts of a table by their paths, each with who says it. Facts of one table inside it that all have the same
/// author are one.
pub fn facts(origin: &Origin) -> Vec<(String, Provenance)> {
    let (mut facts, reasons) = (Vec::new(), origin.node("assumed"));
    for member in &origin.table().members {
        match (&*member.key.name, &member.node.value) {
            // these have facts of their own
            ("source" | "assumed", _) | ("entries", Value::Table(_)) => {}
            (path, _) => gather(reasons, path, member, &mut facts),
        }
    }
    facts.extend(gone("", &origin.table().members));
    for (key, reason) in named_reasons(origin) {
        let is_told =
            |path: &str| path.strip_prefix(key).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
        if !facts.iter().any(|(path, _)| is_told(path)) {
            facts.push((key.to_owned(), Provenance::Assumed(reason.to_owned())));
        }
    }
    facts
}

/// The facts of a table that belong to the type that stands for it in programs. Members of a family share that of a PDO
/// though what it carries is assumed for some of them only.
pub fn facts_of_type(origin: &Origin) -> Vec<(String, Provenance)> {
    let is_list = matches!(origin.node("entries").map(|entries| &entries.value), Some(Value::Array(_)));
    facts(origin).into_iter().filter(|(path, _)| !(is_list && path == "entries")).collect()
}

/// What errata have taken out of a table: it is not so, and nothing else is.
fn gone(prefix: &str, members: &Members) -> impl Iterator<Item = (String, Provenance)> {
    let gone = members.gone().iter();
    gone.map(move |(key, layer)| (format!("{prefix}{key}"), author(*layer, key, None)))
}

fn gather(reasons: Option<&Node>, path: &str, member: &Member, facts: &mut Vec<(String, Provenance)>) {
    let first = facts.len();
    match &member.node.value {
        Value::Table(table) if !table.members.is_empty() => {
            for inner in &table.members {
                gather(reasons, &format!("{path}.{}", inner.key.name), inner, facts);
            }
            facts.extend(gone(&format!("{path}."), &table.members));
            let inner = facts.get(first..).unwrap_or_default();
            if let Some((_, common)) = inner.first()
                && inner.iter().all(|(_, other)| other == common)
            {
                let common = common.clone();
                facts.truncate(first);
                facts.push((path.to_owned(), common));
            }
        }
        value => {
            facts.push((path.to_owned(), author(member.layer, path, reasons)));
            items(path, value, facts);
        }
    }
}

/// What errata say of the tables in a list, by their places in it.
fn items(path: &str, list: &Value, facts: &mut Vec<(String, Provenance)>) {
    let Value::Array(items) = list else { return };
    for (table, place) in items.iter().zip(0..).filter_map(|(item, place)| Some((item.table()?, place))) {
        let answered = table.members.iter().filter(|member| Layer::Description < member.layer);
        let who = |member: &Member| author(member.layer, "", None);
        facts.extend(answered.map(|member| (format!("{path}.{place}.{}", member.key.name), who(member))));
        facts.extend(gone(&format!("{path}.{place}."), &table.members));
    }
}

/// As who says each fact of the table.
#[cfg(feature = "json")]
impl serde::Serialize for Origin {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(facts(self).into_iter().map(|(path, who)| (path.replace('-', "_"), who)))
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Origin {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Provenances".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let who = generator.subschema_for::<Provenance>();
        schemars::json_schema!({
            "description": "Who says each fact, by the key under which a description has it.",
            "type": "object",
            "additionalProperties": who,
        })
    }
}
