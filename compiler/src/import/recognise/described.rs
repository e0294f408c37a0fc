//! An object as a description would have it, before a profile is asked.

use super::super::read::{At, Object, Shape};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, get};
use super::units::Units;
use super::value::{Said, said};
use super::words;
use crate::model::{Kind, SdoAccess};

/// An object in the words of a description.
#[derive(Debug)]
pub(super) struct Described {
    pub(super) at: At,
    pub(super) index: u16,
    pub(super) name: Option<String>,
    /// Its name in other languages.
    pub(super) names: Option<Toml>,
    pub(super) kind: Kind,
    /// What the vendor's tools are told.
    pub(super) properties: Option<Toml>,
    pub(super) about: Option<String>,
    pub(super) sdo_access: Option<SdoAccess>,
    pub(super) category: Option<Toml>,
    /// What was guessed of it.
    pub(super) remarks: Vec<String>,
    /// Its values by subindex.
    pub(super) values: Vec<Said>,
}

/// What an object says; none if nothing of it can be said, which is reported.
pub(super) fn described(object: &Object, units: &Units, report: &mut Report) -> Option<Described> {
    let kind = match object.shape {
        Shape::Var => Kind::Var,
        Shape::Array => Kind::Array,
        Shape::Record => Kind::Record,
    };
    let mut values: Vec<Said> = Vec::new();
    let notes = report.notes.len();
    for value in &object.values {
        let at = place(object.index, value.subindex, kind);
        if values.iter().any(|known| known.subindex == value.subindex) {
            report.lose(value.at, 4, format!("a second entry {at}"), "there is one of this subindex already");
            continue;
        }
        values.extend(said(value, &at, kind == Kind::Var, units, report));
    }
    values.sort_by_key(|value| value.subindex);
    // What has nothing but subindex 0 is a single value, however its type is declared.
    let is_single = kind != Kind::Var && matches!(values.as_slice(), [only] if only.subindex == 0);
    if is_single {
        let what = format!("the {} 0x{:04X}", words::kind(kind), object.index);
        report.lose(object.at, 0, what, "it has subindex 0 only, and is a single value");
    }
    let kind = if is_single { Kind::Var } else { kind };
    let nothing = values.is_empty();
    (!nothing).then(|| Described {
        at: object.at,
        index: object.index,
        name: object.name.clone(),
        names: words::in_languages(&object.names),
        kind,
        properties: words::properties(&object.properties),
        about: object.comment.clone(),
        sdo_access: object.flags.sdo_access,
        category: object
            .flags
            .category
            .as_deref()
            .and_then(words::category_of)
            .map(|it| Toml::text(words::category(it))),
        remarks: report.guessed_since(notes),
        values,
    })
}

fn place(index: u16, subindex: u8, kind: Kind) -> String {
    if kind == Kind::Var { format!("0x{index:04X}") } else { format!("0x{index:04X}:{subindex:02X}") }
}

/// The keys that say something else than what is known.
pub(super) fn difference(said: &Keys, known: &Keys) -> Keys {
    let other = |(name, value): &(String, Toml)| match (value, get(known, name)) {
        (Toml::Table(said), Some(Toml::Table(known))) if name == "values" => {
            let others: Keys = said.iter().filter(|said| !is_meant(said, known)).cloned().collect();
            (!others.is_empty()).then(|| (name.clone(), Toml::Table(others)))
        }
        (_, Some(known)) if known == value || same_text(said, known, value) => None,
        (_, None) if is_usual(name, value) => None,
        _ => Some((name.clone(), value.clone())),
    };
    said.iter().filter_map(other).collect()
}

/// Whether a value is known to mean this. What it means in full a file need not say.
fn is_meant((value, meaning): &(String, Toml), known: &Keys) -> bool {
    let Some(Toml::Table(known)) = get(known, value) else { return false };
    match meaning {
        Toml::Table(said) => said.iter().all(|(key, text)| get(known, key) == Some(text)),
        name => get(known, "name") == Some(name),
    }
}

/// The values that a profile gives a meaning and a file does not, if it says what values mean.
pub(super) fn without_meaning<'k>(said: &'k Keys, known: &'k Keys) -> impl Iterator<Item = &'k String> {
    let said = get(said, "values").zip(get(known, "values"));
    let keys = said.into_iter().filter_map(|pair| match pair {
        (Toml::Table(said), Toml::Table(known)) => Some((said, known)),
        _ => None,
    });
    keys.flat_map(|(said, known)| {
        known.iter().map(|(value, _)| value).filter(move |value| get(said, value).is_none())
    })
}

/// A text whose length follows from its default.
fn same_text(said: &Keys, known: &Toml, value: &Toml) -> bool {
    let (Toml::Text(known), Toml::Text(value), Some(Toml::Text(text))) = (known, value, get(said, "default"))
    else {
        return false;
    };
    known == "STRING" && *value == format!("STRING({})", text.len())
}

/// What a key means that is left out.
pub(super) fn is_usual(name: &str, value: &Toml) -> bool {
    matches!((name, value), ("pdo", Toml::Text(word)) if word == "none")
        || matches!((name, value), ("backup" | "setting", Toml::Bool(false)))
        || matches!((name, value), ("category", Toml::Text(word)) if word == "optional")
}
