//! The list of rules: one line and one file each.

use super::Lint;

macro_rules! lints {
    ($($name:ident,)*) => {
        $(pub(super) mod $name;)*

        /// Every rule, by name.
        pub static ALL: &[Lint] = &[$(Lint { rule: &$name::RULE, check: $name::check }),*];
    };
}

lints! {
    contradicted_count,
    idle_erratum,
    unknown_rule,
}
