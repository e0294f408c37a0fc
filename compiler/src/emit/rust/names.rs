//! From ids to identifiers.

use proc_macro2::{Ident, Span};

use crate::emit::identifier::{self, Claimed};

/// Words that Rust keeps for itself but allows behind `r#`.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait",
    "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Words that Rust does not allow at all.
const PATHS: &[&str] = &["crate", "self", "super", "Self", "_"];

/// The id in `snake_case`.
pub fn snake(id: &str) -> Ident {
    ident(&identifier::snake(id))
}

/// The id in `UpperCamelCase`.
pub fn camel(id: &str) -> Ident {
    ident(&identifier::camel(id))
}

/// The id in `SHOUTING_CASE`.
pub(super) fn shout(id: &str) -> Ident {
    ident(&identifier::shout(id))
}

/// Identifiers of one namespace, each only once.
#[derive(Debug, Default)]
pub(super) struct Names(Claimed);

impl Names {
    /// A namespace in which these are taken.
    pub(super) fn with(taken: &[&str]) -> Self {
        Self(Claimed::with(taken))
    }

    /// The identifier, or if it is taken, the identifier with the first free number.
    pub(super) fn claim(&mut self, wanted: &Ident) -> Ident {
        let wanted = wanted.to_string();
        let plain = wanted.trim_start_matches("r#").to_owned();
        let name = self.0.claim(wanted, |number| format!("{plain}_{number}"));
        ident(name.trim_start_matches("r#"))
    }

    /// Whether the identifier is taken.
    pub(super) fn has(&self, name: &Ident) -> bool {
        self.0.has(&name.to_string())
    }
}

/// An identifier whatever the text is.
fn ident(text: &str) -> Ident {
    let span = Span::call_site();
    match text {
        "" => Ident::new("unnamed", span),
        _ if KEYWORDS.contains(&text) => Ident::new_raw(text, span),
        _ if PATHS.contains(&text) => Ident::new(&format!("{text}_"), span),
        _ if text.starts_with(|c: char| c.is_ascii_digit()) => Ident::new(&format!("_{text}"), span),
        _ => Ident::new(text, span),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_become_identifiers() {
        assert_eq!(snake("target-position").to_string(), "target_position");
        assert_eq!(camel("target-position").to_string(), "TargetPosition");
        assert_eq!(shout("target-position").to_string(), "TARGET_POSITION");
        assert_eq!(camel("C-887.53x").to_string(), "C887_53x");
        assert_eq!(camel("limit-2-3").to_string(), "Limit2_3");
    }

    #[test]
    fn what_rust_does_not_allow_is_escaped() {
        let escaped = ["type", "self", "2nd", "", "θ"].map(|id| snake(id).to_string());
        assert_eq!(escaped, ["r#type", "self_", "_2nd", "unnamed", "unnamed"]);
        assert_eq!(camel("self").to_string(), "Self_");
    }

    #[test]
    fn no_name_is_given_twice() {
        let mut names = Names::with(&["axis"]);
        let claimed = ["axis", "type", "type", "axis"].map(|id| names.claim(&snake(id)).to_string());
        assert_eq!(claimed, ["axis_2", "r#type", "type_2", "axis_3"]);
    }
}
