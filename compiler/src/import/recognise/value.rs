//! A value of the dictionary in the keys of a description.

use std::collections::BTreeSet;

use super::super::read::{Choice, Datum, Value};
use super::super::report::{Report, shortened};
use super::super::toml::{Keys, Toml, set, set_some};
use super::literal::{bits_of_real, literal};
use super::types::data_type;
use super::units::Units;
use super::words;
use crate::model::{Access, DataType, Mappable};

/// A value with what is to be said of it.
#[derive(Debug)]
pub(super) struct Said {
    pub(super) subindex: u8,
    pub(super) data_type: DataType,
    /// The name, if it says something.
    pub(super) name: Option<String>,
    /// Everything else, each key that an ESI file can state.
    pub(super) keys: Keys,
}

/// What a value says, be it a `single` one or one among others; none if its type is none of the language, which is
/// reported.
pub(super) fn said(
    value: &Value,
    at: &str,
    single: bool,
    units: &Units,
    report: &mut Report,
) -> Option<Said> {
    let Some((data_type, other)) = data_type(&value.type_name, value.bits) else {
        let bits = value.bits.unwrap_or(0);
        let why = format!("descriptions have no type `{}` of {bits} bits", value.type_name);
        report.lose(value.at, facts(value), format!("{at} with a type of another kind"), why);
        return None;
    };
    if other {
        let bits = value.bits.map(|bits| format!(" of {bits} bits")).unwrap_or_default();
        report.guess(
            value.at,
            format!("the type of {at}"),
            format!("`{}`{bits} is taken for {data_type}", value.type_name),
        );
    }
    let mut keys = Keys::new();
    set_some(&mut keys, "names", words::in_languages(&value.names));
    set(&mut keys, "type", Toml::text(data_type.to_string()));
    flags(value, at, &mut keys, report);
    set_some(&mut keys, "unit", units.id(value).map(Toml::text));
    for (name, datum) in [("default", &value.default), ("min", &value.min), ("max", &value.max)] {
        let literal = datum.as_ref().and_then(|datum| number(datum, name, at, data_type, report));
        if let Some(literal) = literal.filter(|literal| !is_bound(name, literal, data_type)) {
            set(&mut keys, name, literal);
        }
    }
    let meanings = meanings(value, at, data_type, report);
    if !meanings.is_empty() {
        set(&mut keys, "values", Toml::Table(meanings));
    }
    set_some(&mut keys, "about", value.comment.as_ref().map(Toml::text));
    set_some(&mut keys, "properties", words::properties(&value.properties));
    let name = value.name.clone().filter(|name| !words::says_nothing(name));
    let shown = value
        .display_name
        .as_ref()
        .filter(|shown| name.as_ref().is_none_or(|name| !words::alike(name, shown)));
    if let Some(shown) = shown.filter(|_| name.is_some() || single) {
        report.lose(
            value.at,
            1,
            "a DisplayName beside the name",
            format!("`{shown}`: an entry has one name"),
        );
    }
    let name = name.or_else(|| value.display_name.clone());
    Some(Said { subindex: value.subindex, data_type, name, keys })
}

/// Whether a limit is that of the type, which says nothing.
fn is_bound(name: &str, literal: &Toml, data_type: DataType) -> bool {
    let value = match literal {
        Toml::Integer(value) => *value,
        Toml::Hex(value, _) => i128::from(*value),
        _ => return false,
    };
    let Some((least, greatest)) = data_type.range() else { return false };
    name == "min" && value == least || name == "max" && value == greatest
}

/// How many facts a value is: those that this module reads.
fn facts(value: &Value) -> usize {
    let data = [&value.default, &value.min, &value.max].into_iter().flatten().count();
    2 + usize::from(value.name.is_some()) + data
}

fn flags(value: &Value, at: &str, keys: &mut Keys, report: &mut Report) {
    let flags = &value.flags;
    let access = flags.access.as_deref().map(words::access_of);
    if access == Some(None) {
        let written = flags.access.as_deref().unwrap_or_default();
        report.lose(value.at, 1, format!("the access of {at}"), format!("`{written}` is not ro, wo or rw"));
    }
    set(keys, "access", Toml::text(words::access(access.flatten().unwrap_or(Access::Ro))));
    let written = flags.pdo_mapping.as_deref().unwrap_or_default();
    let mappable = words::mappable_of(written).unwrap_or_else(|| {
        report.lose(
            value.at,
            1,
            format!("the PdoMapping of {at}"),
            format!("`{written}` is not R, T or both"),
        );
        Mappable::None
    });
    set(keys, "pdo", Toml::text(words::mappable(mappable)));
    set_some(keys, "safety", flags.safety.map(|it| Toml::text(it.word())));
    if let Some(category) = flags.category.as_deref().and_then(words::category_of) {
        set(keys, "category", Toml::text(words::category(category)));
    }
    set(keys, "backup", Toml::Bool(flags.backup));
    set(keys, "setting", Toml::Bool(flags.setting));
    match flags.write_restrictions.as_deref().map(|text| (text, words::window_of(text))) {
        Some((_, Some(window))) => set(keys, "written", Toml::text(words::window(window))),
        Some((text, None)) => {
            report.lose(
                value.at,
                1,
                format!("WriteRestrictions of {at}"),
                format!("`{text}` is none that is known"),
            );
        }
        None => {}
    }
}

/// Whether the digits of a value are those of a code or of bits: of the identity and of errors, of units (0x60A8, 0x60A9),
/// and of the supported modes.
fn is_code(at: &str) -> bool {
    at.starts_with("0x10") || ["0x60A8", "0x60A9", "0x6502"].contains(&at)
}

/// A value as it is written; what identifies a device is in hexadecimal.
fn number(datum: &Datum, name: &str, at: &str, data_type: DataType, report: &mut Report) -> Option<Toml> {
    if let Some(bits) = bits_of_real(&datum.written, data_type) {
        report.guess(
            datum.at,
            format!("the {name} of {at}"),
            format!("{bits} is taken for the bits of a REAL32"),
        );
    }
    match literal(&datum.written, data_type) {
        Ok(Toml::Text(text)) if name == "default" && text.is_empty() => None,
        Ok(Toml::Integer(value)) if data_type == DataType::Uint(32) && is_code(at) => {
            Some(u64::try_from(value).map_or(Toml::Integer(value), |value| Toml::Hex(value, 8)))
        }
        Ok(literal) => Some(literal),
        Err(why) => {
            let written = shortened(&datum.written.to_string());
            let why = format!("`{written}`, as {data_type}: {why}");
            report.lose(datum.at, 1, format!("the {name} of {at}"), why);
            None
        }
    }
}

/// What values mean, each value once.
fn meanings(value: &Value, at: &str, data_type: DataType, report: &mut Report) -> Keys {
    let mut meanings: Vec<(i64, (String, Toml))> = Vec::new();
    let mut known = BTreeSet::new();
    for Choice { value: number, name, names, comment } in value.choices.iter() {
        let key = number.to_string();
        let fits = data_type.range().is_some_and(|(min, max)| (min..=max).contains(&i128::from(*number)));
        if !fits || !known.insert(*number) {
            let why = if fits { "it has another meaning already" } else { "it does not fit its type" };
            report.lose(value.at, 2, format!("the meaning of {key} of {at}"), why);
            continue;
        }
        let mut said = vec![("name".to_owned(), Toml::text(name))];
        set_some(&mut said, "names", words::in_languages(names));
        set_some(&mut said, "about", comment.as_ref().map(Toml::text));
        meanings.push((*number, (key, if said.len() > 1 { Toml::Table(said) } else { Toml::text(name) })));
    }
    // Their order says nothing.
    meanings.sort_by_key(|(number, _)| *number);
    meanings.into_iter().map(|(_, meaning)| meaning).collect()
}
