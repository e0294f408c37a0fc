//! Who says a fact, and how sure it is.

use crate::source::{Layer, Member, Node, Origin, Value};

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
    origin.layer(path).map_or(Provenance::Derived, |layer| author(layer, path, origin.node("assumed")))
}

/// Who says the fact at `path` that is in a layer, where the table gives these reasons for what is assumed.
fn author(layer: Layer, path: &str, reasons: Option<&Node>) -> Provenance {
    match layer {
        Layer::Profile => Provenance::Profile,
        Layer::Corrected(erratum) => Provenance::Corrected(erratum),
        Layer::Contradicted(erratum) => Provenance::Contradicted(erratum),
        Layer::Description => {
            let reason = reasons.and_then(|reasons| reason(reasons, path));
            reason.map_or(Provenance::Stated, |reason| Provenance::Assumed(reason.to_owned()))
        }
    }
}

/// Why the fact at `path` is assumed, if it is: the reason for the key, for a table around it, or for all of the table.
fn reason<'o>(reasons: &'o Node, path: &str) -> Option<&'o str> {
    let text = |value: &'o Value| match value {
        Value::String(text) => Some(&**text),
        _ => None,
    };
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
        if !matches!(&*member.key.name, "source" | "assumed" | "entries" | "per-axis") {
            gather(reasons, &member.key.name, member, &mut facts);
        }
    }
    facts
}

fn gather(reasons: Option<&Node>, path: &str, member: &Member, facts: &mut Vec<(String, Provenance)>) {
    let first = facts.len();
    match &member.node.value {
        Value::Table(table) if !table.members.is_empty() => {
            for inner in &table.members {
                gather(reasons, &format!("{path}.{}", inner.key.name), inner, facts);
            }
            let inner = facts.get(first..).unwrap_or_default();
            if let Some((_, common)) = inner.first()
                && inner.iter().all(|(_, other)| other == common)
            {
                let common = common.clone();
                facts.truncate(first);
                facts.push((path.to_owned(), common));
            }
        }
        _ => facts.push((path.to_owned(), author(member.layer, path, reasons))),
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
