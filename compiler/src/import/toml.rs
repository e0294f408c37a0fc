//! Values and tables of TOML as a person would write them.

use crate::text::characters::harmless;

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Toml {
    Bool(bool),
    Integer(i128),
    /// A number in hexadecimal with so many digits.
    Hex(u64, usize),
    Real(f64),
    Text(String),
    List(Vec<Toml>),
    Table(Keys),
}

/// The keys of a table in order.
pub(super) type Keys = Vec<(String, Toml)>;

impl Toml {
    pub(super) fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    pub(super) fn texts<T: Into<String>>(texts: impl IntoIterator<Item = T>) -> Self {
        Self::List(texts.into_iter().map(Self::text).collect())
    }

    /// In one line.
    pub(super) fn inline(&self) -> String {
        match self {
            Self::Bool(value) => value.to_string(),
            Self::Integer(value) => value.to_string(),
            Self::Hex(value, digits) => format!("0x{value:0digits$X}"),
            Self::Real(value) => real(*value),
            Self::Text(text) => quoted(text),
            Self::List(items) => {
                format!("[{}]", items.iter().map(Self::inline).collect::<Vec<_>>().join(", "))
            }
            Self::Table(keys) if keys.is_empty() => "{}".to_owned(),
            Self::Table(keys) => {
                let keys = keys.iter().map(|(name, value)| format!("{} = {}", key(name), value.inline()));
                format!("{{ {} }}", keys.collect::<Vec<_>>().join(", "))
            }
        }
    }
}

/// A number that is never taken for a whole one.
fn real(value: f64) -> String {
    match value.abs() {
        0.0..1e15 if value.fract() == 0.0 => format!("{value:.1}"),
        1e-6..1e15 => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// A key, in quotes if it needs them.
pub(super) fn key(name: &str) -> String {
    let bare = |char: char| char.is_ascii_alphanumeric() || char == '-' || char == '_';
    if !name.is_empty() && name.chars().all(bare) { name.to_owned() } else { quoted(name) }
}

fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for char in harmless(text).chars() {
        match char {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            char => out.push(char),
        }
    }
    out.push('"');
    out
}

/// Sets a key at its place behind those that are there.
pub(super) fn set(keys: &mut Keys, name: &str, value: Toml) {
    keys.push((name.to_owned(), value));
}

/// Sets a key if it has a value.
pub(super) fn set_some(keys: &mut Keys, name: &str, value: Option<Toml>) {
    if let Some(value) = value {
        set(keys, name, value);
    }
}

/// The value of a key.
pub(super) fn get<'k>(keys: &'k Keys, name: &str) -> Option<&'k Toml> {
    keys.iter().find(|(key, _)| key == name).map(|(_, value)| value)
}
