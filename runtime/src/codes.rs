//! Numbers of which standards name some.

/// Names codes of a type that is a number: a constant for each, and what it means.
macro_rules! codes {
    ($codes:ident: $($name:ident = $code:literal, $meaning:literal;)+) => {
        impl $codes {
            $(
                #[doc = concat!($meaning, ".")]
                pub const $name: Self = Self($code);
            )+

            /// Every code that a standard names, ascending.
            pub const NAMED: &'static [Self] = &[$(Self::$name),+];

            /// What the code means, if a standard says so.
            pub const fn meaning(self) -> Option<&'static str> {
                match self {
                    $(Self::$name => Some($meaning),)+
                    _ => None,
                }
            }
        }
    };
}
pub(crate) use codes;
