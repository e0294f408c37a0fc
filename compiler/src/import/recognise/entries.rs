//! Entries of records and arrays: what they have in common is said once, and what repeats is said as a range.

use super::super::report::Report;
use super::super::toml::{Keys, Toml, get, set};
use super::described::{Described, difference, is_usual};
use super::profile::Base;
use super::value::Said;
use super::words;
use crate::model::Entry;

/// The keys that an object can say for all its entries.
const SHARED: [&str; 11] =
    ["type", "access", "pdo", "safety", "category", "unit", "default", "min", "max", "backup", "setting"];

/// What is said once for all entries: values that most of them have, where each has some.
pub(super) fn shared(category: Option<&Toml>, members: &[&Said], base: Option<Base<'_>>) -> Keys {
    let known: Vec<Keys> =
        members.iter().map(|it| base.map(|base| base.entry(it.subindex)).unwrap_or_default()).collect();
    let mut keys = Keys::new();
    for name in SHARED {
        let values: Option<Vec<&Toml>> = members.iter().map(|member| get(&member.keys, name)).collect();
        let needed =
            members.iter().zip(&known).filter(|(member, known)| get(&member.keys, name) != get(known, name));
        let needed = needed.count();
        let own = if name == "category" { category } else { None };
        if own.is_some() && base.is_some_and(|base| get(&base.value(), name) == own) {
            continue;
        }
        let Some(most) = own.or_else(|| values.as_deref().and_then(most_frequent)) else { continue };
        let worth = needed * 2 > members.len() || own.is_some_and(|own| base.is_none() && !is_optional(own));
        let is_none = base.is_none() && name != "category" && is_usual(name, most);
        let is_usual = base.is_none() && name == "category" && is_optional(most);
        if worth && !is_none && !is_usual && (members.len() > 1 || own.is_some()) {
            set(&mut keys, name, most.clone());
        }
    }
    keys
}

fn is_optional(value: &Toml) -> bool {
    matches!(value, Toml::Text(word) if word == "optional")
}

fn most_frequent<'v>(values: &[&'v Toml]) -> Option<&'v Toml> {
    let mut counted: Vec<(&Toml, usize)> = Vec::new();
    for value in values {
        match counted.iter_mut().find(|(known, _)| known == value) {
            Some((_, count)) => *count += 1,
            None => counted.push((value, 1)),
        }
    }
    // The first of those that are as frequent.
    counted
        .iter()
        .rev()
        .max_by_key(|(_, count)| *count)
        .filter(|(_, count)| *count > 1)
        .map(|(value, _)| *value)
}

/// An entry with what is left to say of it.
struct Own {
    first: u8,
    last: u8,
    /// With a number in braces, if it repeats.
    name: Option<String>,
    keys: Keys,
    /// Whether its profile has it under its own subindex.
    fixed: bool,
}

/// The tables of the entries by subindex or range.
pub(super) fn tables(
    object: &Described,
    members: &[&Said],
    shared: &Keys,
    base: Option<Base<'_>>,
    described: &[u8],
    report: &mut Report,
) -> Keys {
    let mut runs: Vec<Own> = Vec::new();
    for member in members {
        let mut known = base.map(|base| base.entry(member.subindex)).unwrap_or_default();
        let base_name = match get(&known, "name") {
            Some(Toml::Text(name)) => Some(name.clone()),
            _ => None,
        };
        for (name, value) in shared {
            known.retain(|(known, _)| known != name);
            set(&mut known, name, value.clone());
        }
        let name =
            member.name.clone().filter(|name| words::is_other(name, base_name.as_deref(), object.at, report));
        let fixed = described.contains(&member.subindex);
        let own = Own {
            first: member.subindex,
            last: member.subindex,
            name,
            keys: difference(&member.keys, &known),
            fixed,
        };
        if !runs.last_mut().is_some_and(|run| joins(run, &own)) {
            runs.push(own);
        }
    }
    let mut tables = Keys::new();
    tables.extend(count(object, report));
    let said = runs.iter().filter(|run| !(run.fixed && run.name.is_none() && run.keys.is_empty()));
    tables.extend(said.map(table));
    tables
}

/// Takes an entry into the run before it, if it says the same. Their name becomes one with a number in braces.
fn joins(run: &mut Own, next: &Own) -> bool {
    let follows = run.last.checked_add(1) == Some(next.first) && !run.fixed && !next.fixed;
    if !follows || run.keys != next.keys {
        return false;
    }
    let pattern = match (&run.name, &next.name) {
        (None, None) => {
            run.last = next.first;
            return true;
        }
        (Some(name), Some(other)) => {
            let pattern = if run.first == run.last { pattern(name, run.first) } else { Some(name.clone()) };
            pattern.filter(|pattern| filled(pattern, next.first).as_ref() == Some(other))
        }
        _ => None,
    };
    if pattern.is_none() {
        return false;
    }
    run.name = pattern;
    run.last = next.first;
    true
}

/// The name with its last number in braces, as a distance from the subindex, and with its digits if there are zeros in front.
fn pattern(name: &str, subindex: u8) -> Option<String> {
    if name.contains(['{', '}']) {
        return None;
    }
    let end = name.rfind(|char: char| char.is_ascii_digit())? + 1;
    let start = name.get(..end)?.trim_end_matches(|char: char| char.is_ascii_digit()).len();
    let digits = name.get(start..end)?;
    let number: i32 = digits.parse().ok()?;
    let distance = number - i32::from(subindex);
    let width = if digits.len() > 1 && digits.starts_with('0') { digits.len() } else { 0 };
    let braces = match (distance, width) {
        (0, 0) => "{}".to_owned(),
        (_, 0) => format!("{{{distance:+}}}"),
        (0, 1..=9) => format!("{{:0{width}}}"),
        (_, 1..=9) => format!("{{{distance:+}:0{width}}}"),
        _ => return None,
    };
    Some(format!("{}{braces}{}", name.get(..start)?, name.get(end..)?))
}

/// The name that a pattern gives a subindex.
fn filled(pattern: &str, subindex: u8) -> Option<String> {
    let (head, rest) = pattern.split_once('{')?;
    let (distance, tail) = rest.split_once('}')?;
    let (distance, width) = distance.split_once(":0").unwrap_or((distance, "0"));
    let distance: i32 = if distance.is_empty() { 0 } else { distance.parse().ok()? };
    let (number, width): (i32, usize) = (i32::from(subindex) + distance, width.parse().ok()?);
    Some(format!("{head}{number:0width$}{tail}"))
}

fn table(run: &Own) -> (String, Toml) {
    let key =
        if run.first == run.last { run.first.to_string() } else { format!("{}..={}", run.first, run.last) };
    let mut keys = Keys::new();
    if let Some(name) = &run.name {
        set(&mut keys, "name", Toml::text(name));
    }
    keys.extend(run.keys.iter().cloned());
    (key, Toml::Table(keys))
}

/// What is said of subindex 0, if it is not as devc makes it.
fn count(object: &Described, report: &mut Report) -> Option<(String, Toml)> {
    let count = object.values.iter().find(|value| value.subindex == 0)?;
    let highest = object.values.iter().map(|value| value.subindex).max().unwrap_or(0);
    let mut keys = Keys::new();
    for name in ["access", "pdo", "written", "default", "min", "max", "backup", "setting"] {
        let usual = match name {
            "access" => Some(Toml::text("ro")),
            "pdo" => Some(Toml::text("none")),
            "backup" | "setting" => Some(Toml::Bool(false)),
            "default" => Some(Toml::Integer(highest.into())),
            _ => None,
        };
        if let Some(value) = get(&count.keys, name).filter(|value| Some(*value) != usual.as_ref()) {
            set(&mut keys, name, value.clone());
        }
    }
    match count.name.as_deref().filter(|name| *name != Entry::COUNT) {
        Some(name) if words::says_count(name) => {
            let why = format!("it is a number of entries in other words; `{}` is taken", Entry::COUNT);
            report.lose(object.at, 1, "the name of subindex 0", why);
        }
        Some(name) => keys.insert(0, ("name".to_owned(), Toml::text(name))),
        None => {}
    }
    if count.data_type.bits() != 8 {
        let what = format!("the type of 0x{:04X}:00", object.index);
        report.lose(
            object.at,
            1,
            what,
            format!("{} is taken for UINT8, as ETG.1000.6 fixes it", count.data_type),
        );
        keys.retain(|(name, value)| name != "default" || matches!(value, Toml::Integer(0..=255)));
    }
    (!keys.is_empty()).then(|| ("0".to_owned(), Toml::Table(keys)))
}
