//! The words that descriptions and ESI files have for the same.

use super::super::read::{At, Property, Texts};
use super::super::report::Report;
use super::super::toml::{Toml, set_some};
use crate::model::{Access, Category, Kind, Mappable, WriteWindow};

pub(super) fn access(access: Access) -> &'static str {
    match access {
        Access::Ro => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
        Access::Const => "const",
    }
}

pub(super) fn mappable(mappable: Mappable) -> &'static str {
    match mappable {
        Mappable::None => "none",
        Mappable::Rx => "rx",
        Mappable::Tx => "tx",
        Mappable::RxTx => "rx-tx",
    }
}

pub(super) fn category(category: Category) -> &'static str {
    match category {
        Category::Mandatory => "mandatory",
        Category::Optional => "optional",
        Category::Conditional => "conditional",
    }
}

pub(super) fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Var => "var",
        Kind::Array => "array",
        Kind::Record => "record",
    }
}

pub(super) fn window(window: WriteWindow) -> &'static str {
    match window {
        WriteWindow::PreOp => "pre-op",
        WriteWindow::PreOpSafeOp => "pre-op-safe-op",
        WriteWindow::PreOpOp => "pre-op-op",
        WriteWindow::SafeOp => "safe-op",
        WriteWindow::SafeOpOp => "safe-op-op",
        WriteWindow::Op => "op",
    }
}

const WINDOWS: [WriteWindow; 6] = [
    WriteWindow::PreOp,
    WriteWindow::PreOpSafeOp,
    WriteWindow::PreOpOp,
    WriteWindow::SafeOp,
    WriteWindow::SafeOpOp,
    WriteWindow::Op,
];

/// What a file calls a restriction of writing, in any case of letters.
pub(super) fn window_of(text: &str) -> Option<WriteWindow> {
    WINDOWS.into_iter().find(|window| window.name().eq_ignore_ascii_case(text.trim()))
}

/// `ro`, `wo`, `rw`, `const`, in any case of letters.
pub(super) fn access_of(text: &str) -> Option<Access> {
    match text.trim().to_ascii_lowercase().as_str() {
        "ro" => Some(Access::Ro),
        "wo" => Some(Access::Wo),
        "rw" => Some(Access::Rw),
        "const" => Some(Access::Const),
        _ => None,
    }
}

/// `R`, `T` or both, in any case of letters, and as `Rx` and `Tx`; nothing if it says nothing.
pub(super) fn mappable_of(text: &str) -> Option<Mappable> {
    let has = |letter| text.chars().any(|char| char.eq_ignore_ascii_case(&letter));
    let is_known = text.chars().all(|char| "rtx ,".contains(char.to_ascii_lowercase()));
    is_known.then(|| Mappable::of(has('r'), has('t')))
}

/// `m`, `o`, `c`, in any case of letters.
pub(super) fn category_of(text: &str) -> Option<Category> {
    match text.trim().to_ascii_lowercase().as_str() {
        "m" => Some(Category::Mandatory),
        "o" => Some(Category::Optional),
        "c" => Some(Category::Conditional),
        _ => None,
    }
}

/// Texts in other languages by the codes of these; none if there are none.
pub(super) fn in_languages(texts: &Texts) -> Option<Toml> {
    let texts: Vec<_> =
        texts.iter().map(|(language, text)| (language.code().to_owned(), Toml::text(text))).collect();
    (!texts.is_empty()).then_some(Toml::Table(texts))
}

/// What the vendor's tools are told; none if that is nothing.
pub(super) fn properties(properties: &[Property]) -> Option<Toml> {
    let table = |property: &Property| {
        let mut keys = vec![("name".to_owned(), Toml::text(&property.name))];
        set_some(&mut keys, "value", property.value.as_ref().map(Toml::text));
        set_some(&mut keys, "about", property.about.as_ref().map(Toml::text));
        Toml::Table(keys)
    };
    let tables: Vec<Toml> = properties.iter().map(table).collect();
    (!tables.is_empty()).then_some(Toml::List(tables))
}

/// Whether two names are the same but for case, blanks and signs.
pub(super) fn alike(one: &str, other: &str) -> bool {
    let letters = |text: &str| -> String {
        text.chars().filter(|char| char.is_alphanumeric()).flat_map(char::to_lowercase).collect()
    };
    letters(one) == letters(other)
}

/// Whether a name is another than the one `known`, which is taken where only the spelling differs.
pub(super) fn is_other(name: &str, known: Option<&str>, at: At, report: &mut Report) -> bool {
    let Some(known) = known.filter(|known| alike(known, name)) else { return true };
    if known != name {
        let why = "letters and signs differ from those of its profile or its object, which are taken";
        report.lose(at, 0, "the spelling of a name", why);
    }
    false
}

/// Whether a name says no more than the subindex, as `SubIndex 001` or `Elements`.
pub(super) fn says_nothing(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    let rest = lower.strip_prefix("subindex").or_else(|| lower.strip_prefix("sub-index"));
    lower.is_empty()
        || lower == "elements"
        || rest.is_some_and(|rest| rest.trim().bytes().all(|byte| byte.is_ascii_digit()))
}

/// Whether a name says that it is the number of the others, as that of subindex 0 does: `Number of entries`.
pub(super) fn says_count(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    let counts = ["number", "no of", "no. of", "num", "max", "highest", "largest", "last", "count"];
    let counted = ["sub", "entr", "element", "object", "pdo", "item", "error"];
    let has = |words: &[&str]| words.iter().any(|word| lower.contains(word));
    lower == "entries" || has(&counts) && has(&counted)
}
