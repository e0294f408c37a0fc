//! Why a table could not be read.

use std::fmt::{self, Display};
use std::sync::Arc;

use serde::de::{self, Expected, Unexpected};

use crate::diagnostic::{Diagnostic, faults};
use crate::model::Index;
use crate::source::keys::number;
use crate::source::{FileId, Location};
use crate::text::near::{list, near};

/// The first fault of a table.
#[derive(Debug)]
pub(super) struct Error {
    fault: Box<Fault>,
    /// The innermost value or table around the fault.
    at: Option<Location>,
    /// The innermost key above the fault.
    key: Option<Arc<str>>,
    /// Whether the fault lies in a key.
    in_key: bool,
}

#[derive(Debug)]
enum Fault {
    /// A value is of another type than it needs to be.
    Type { expected: String, found: String, meant: Option<Meant> },
    /// An integer does not fit its type.
    Range { value: i128, range: String },
    /// A word is none of those to choose from.
    Word { found: String, known: &'static [&'static str] },
    /// A key is not there.
    Missing(&'static str),
    /// Anything else, in the words of the type that was read.
    Value(String),
}

/// What is meant by a value of another type, where quotes are the fault.
#[derive(Debug)]
enum Meant {
    /// The number in the quotes.
    Number(String),
    /// The index that lacks quotes.
    Index(Index),
}

impl Meant {
    fn of(found: Unexpected<'_>, expected: &str) -> Option<Self> {
        match found {
            Unexpected::Str(text) if matches!(expected, "an integer" | "a number") => {
                number(text).map(|_| Self::Number(text.to_owned()))
            }
            Unexpected::Signed(index @ 0x1000..=0xFFFF) if expected.contains("index") => {
                u16::try_from(index).ok().map(|index| Self::Index(Index(index)))
            }
            _ => None,
        }
    }

    fn suggested(self, fault: Diagnostic, at: Location) -> Diagnostic {
        match self {
            Self::Number(number) => fault.fix("a number has no quotes", at, number),
            Self::Index(index) => fault.fix("an index stands in quotes", at, format!("\"{index}\"")),
        }
    }
}

impl Error {
    /// An integer that does not fit its type.
    pub(super) fn range(value: i128, min: impl Display, max: impl Display) -> Self {
        Fault::Range { value, range: format!("{min} to {max}") }.into()
    }

    /// Sets the place, if a place further in is not known.
    pub(super) fn at(mut self, at: Location) -> Self {
        self.at.get_or_insert(at);
        self
    }

    /// Sets the key, if a key further in is not known.
    pub(super) fn under(mut self, key: &Arc<str>) -> Self {
        self.key.get_or_insert_with(|| key.clone());
        self
    }

    /// Says that the fault lies in a key, not in a value.
    pub(super) fn in_key(mut self) -> Self {
        self.in_key = true;
        self
    }

    /// Whether this is about one of these keys missing in its table.
    pub(super) fn is_missing(&self, keys: &[(Location, &str)]) -> bool {
        matches!(*self.fault, Fault::Missing(key) if keys.iter().any(|(at, name)| Some(*at) == self.at && *name == key))
    }

    pub(super) fn into_diagnostic(self) -> Diagnostic {
        let at = self.at.unwrap_or(Location { file: FileId(0), start: 0, end: 0 });
        let of = |word: &str| self.key.as_ref().map(|key| format!("{word} `{key}`")).unwrap_or_default();
        match *self.fault {
            Fault::Type { expected, found, meant } => {
                let message = format!("expected {expected}, found {found}");
                let fault = Diagnostic::new(&faults::WRONG_TYPE, message, at, of("in"));
                match meant {
                    Some(meant) => meant.suggested(fault, at),
                    None => fault,
                }
            }
            Fault::Range { value, range } => {
                let message = format!("expected a number from {range}, found {value}");
                Diagnostic::new(&faults::INVALID_VALUE, message, at, of("in"))
            }
            Fault::Word { found, known } => {
                let message = format!("`{found}` is no choice here");
                word(
                    Diagnostic::new(&faults::INVALID_VALUE, message, at, of("in")),
                    &found,
                    known,
                    !self.in_key,
                )
            }
            Fault::Missing(key) => {
                let message = format!("missing key `{key}`");
                Diagnostic::new(&faults::MISSING_KEY, message, at, format!("`{key}` has to be given here"))
            }
            Fault::Value(message) => Diagnostic::new(&faults::INVALID_VALUE, message, at, of("in")),
        }
    }
}

/// Says which words there are, or which one was meant.
fn word(diagnostic: Diagnostic, found: &str, known: &[&'static str], quoted: bool) -> Diagnostic {
    let diagnostic = diagnostic.note(format!("the values are {}", list(known)));
    match (near(found, known.iter().copied()), diagnostic.at()) {
        (Some(name), Some(at)) => {
            let text = if quoted { format!("\"{name}\"") } else { name.to_owned() };
            diagnostic.fix(format!("did you mean `{name}`?"), at, text)
        }
        _ => diagnostic,
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        Self { fault: Box::new(fault), at: None, key: None, in_key: false }
    }
}

impl de::Error for Error {
    fn custom<T: Display>(message: T) -> Self {
        Fault::Value(message.to_string()).into()
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        let expected = expectation(expected);
        let meant = Meant::of(found, &expected);
        Fault::Type { expected, found: kind(found), meant }.into()
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Fault::Value(format!("{} is not {}", value(found), expectation(expected))).into()
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        Fault::Value(format!("expected {}, found {length}", expectation(expected))).into()
    }

    fn unknown_variant(found: &str, known: &'static [&'static str]) -> Self {
        Fault::Word { found: found.to_owned(), known }.into()
    }

    fn missing_field(key: &'static str) -> Self {
        Fault::Missing(key).into()
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.fault)
    }
}

impl std::error::Error for Error {}

/// What a type expects, in the words of TOML instead of serde's.
fn expectation(expected: &dyn Expected) -> String {
    let text = expected.to_string();
    let plain = match text.as_str() {
        "u8" | "u16" | "u32" | "u64" | "u128" | "usize" => "an integer",
        "i8" | "i16" | "i32" | "i64" | "i128" | "isize" => "an integer",
        "f32" | "f64" => "a number",
        "a borrowed string" => "a string",
        "a sequence" => "an array",
        "a map" => "a table",
        _ if text.starts_with("struct ") => "a table",
        _ if text.starts_with("enum ") => "a string",
        _ => match text.strip_prefix("a tuple of size ") {
            Some(size) => return format!("an array of {size} elements"),
            None => return text,
        },
    };
    plain.to_owned()
}

/// What people call this kind of value.
fn kind(found: Unexpected<'_>) -> String {
    let kind = match found {
        Unexpected::Bool(_) => "a boolean",
        Unexpected::Unsigned(_) | Unexpected::Signed(_) => "an integer",
        Unexpected::Float(_) => "a float",
        Unexpected::Str(_) | Unexpected::Char(_) => "a string",
        Unexpected::Seq => "an array",
        Unexpected::Map => "a table",
        Unexpected::Other(text) => text,
        other => return other.to_string(),
    };
    kind.to_owned()
}

/// The value as it would be written.
fn value(found: Unexpected<'_>) -> String {
    match found {
        Unexpected::Bool(value) => value.to_string(),
        Unexpected::Unsigned(value) => value.to_string(),
        Unexpected::Signed(value) => value.to_string(),
        Unexpected::Float(value) => value.to_string(),
        Unexpected::Str(value) => format!("`{value}`"),
        other => kind(other),
    }
}
