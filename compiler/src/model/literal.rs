//! Single values that TOML has no type of its own for.

use devc_start_up::Period;
use serde::Deserialize;
use serde::de::{self, Deserializer, IntoDeserializer, SeqAccess, Visitor};

use super::compare::value;
use super::{Compare, FieldPath, Walker};

/// A value of an object, in the type that TOML gave it.
#[derive(Debug, Clone, PartialEq)]
pub enum Literal {
    /// `true` or `false`.
    Boolean(bool),
    /// A whole number.
    Integer(i128),
    /// A number with a fraction.
    Float(f64),
    /// Text.
    Text(String),
}

impl Literal {
    /// A number that a text holds twice, once in hexadecimal and once in decimal: `"0x14 (20)"`, `"20 (0x14)"`.
    pub(crate) fn twice(text: &str) -> Option<(i128, i128)> {
        let (first, second) = text.strip_suffix(')')?.split_once('(')?;
        let (first, second) = (first.trim(), second.trim());
        (first.starts_with("0x") != second.starts_with("0x")).then_some(())?;
        let number = |text: &str| match text.strip_prefix("0x") {
            Some(digits) => u64::from_str_radix(digits, 16).ok().map(i128::from),
            None => text.parse::<i64>().ok().map(i128::from),
        };
        number(first).zip(number(second))
    }
}

impl Default for Literal {
    fn default() -> Self {
        Self::Integer(0)
    }
}

impl<'de> Deserialize<'de> for Literal {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;
        impl Visitor<'_> for Any {
            type Value = Literal;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number, a string or a boolean")
            }

            fn visit_bool<E: de::Error>(self, value: bool) -> Result<Literal, E> {
                Ok(Literal::Boolean(value))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Literal, E> {
                Ok(Literal::Integer(value.into()))
            }

            fn visit_i128<E: de::Error>(self, value: i128) -> Result<Literal, E> {
                Ok(Literal::Integer(value))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Literal, E> {
                Ok(Literal::Integer(value.into()))
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Literal, E> {
                Ok(Literal::Float(value))
            }

            fn visit_str<E: de::Error>(self, value: &str) -> Result<Literal, E> {
                Ok(Literal::Text(value.to_owned()))
            }
        }
        deserializer.deserialize_any(Any)
    }
}

/// A number as a fraction of whole numbers: `100000`, or `"4294967296/30720000"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    /// Above the line.
    pub numerator: u64,
    /// Below the line; never 0.
    pub denominator: u64,
}

impl<'de> Deserialize<'de> for Fraction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let fraction = match Literal::deserialize(deserializer)? {
            Literal::Integer(whole) => u64::try_from(whole).ok().map(|numerator| (numerator, 1)),
            Literal::Text(text) => text
                .split_once('/')
                .and_then(|(above, below)| Some((above.trim().parse().ok()?, below.trim().parse().ok()?))),
            Literal::Boolean(_) | Literal::Float(_) => None,
        };
        match fraction {
            Some((numerator, denominator)) if numerator > 0 && denominator > 0 => {
                Ok(Self { numerator, denominator })
            }
            _ => {
                Err(de::Error::custom("expected a positive whole number or a fraction such as \"1/100000\""))
            }
        }
    }
}

/// A time in nanoseconds, written with its unit: `"250 us"`, `"1 ms"`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct Duration(pub u64);

impl Duration {
    /// The time as 0x60C2 holds it, if it can.
    pub fn interpolation(self) -> Option<Period> {
        Period::of_ns(self.0)
    }
}

impl<'de> Deserialize<'de> for Duration {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let digits = text.trim_end_matches(|c: char| !c.is_ascii_digit());
        let factor = match text.get(digits.len()..).map(str::trim) {
            Some("ns") => Some(1),
            Some("us" | "µs") => Some(1_000),
            Some("ms") => Some(1_000_000),
            Some("s") => Some(1_000_000_000),
            _ => None,
        };
        let count = digits.parse::<u64>().ok();
        factor
            .zip(count)
            .and_then(|(factor, count)| count.checked_mul(factor))
            .map(Self)
            .ok_or_else(|| de::Error::custom("expected a time with its unit, such as \"250 us\" or \"1 ms\""))
    }
}

/// A time in nanoseconds that may lie before what it is counted from: `"-20 us"`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct Delay(pub i64);

impl<'de> Deserialize<'de> for Delay {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let (sign, digits) = text.strip_prefix('-').map_or((1, text.as_str()), |digits| (-1, digits));
        let time: Duration = Duration::deserialize(digits.into_deserializer())?;
        i64::try_from(time.0).map(|time| Self(sign * time)).map_err(|_| de::Error::custom("too long"))
    }
}

/// Bytes in hexadecimal: `"050E 03EE"`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct Hex(pub Vec<u8>);

impl Hex {
    /// Pairs of hexadecimal digits, with or without blanks.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let digits: Vec<char> = text.chars().filter(|c| !c.is_whitespace()).collect();
        let is_digit = |digit: &char| digit.is_ascii_hexdigit();
        let is_whole = digits.len().is_multiple_of(2) && digits.iter().all(is_digit);
        let byte = |pair: &[char]| u8::from_str_radix(&pair.iter().collect::<String>(), 16).ok();
        is_whole.then(|| digits.chunks(2).map(byte).collect::<Option<Vec<u8>>>())?.map(Self)
    }
}

impl<'de> Deserialize<'de> for Hex {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expected = "expected pairs of hexadecimal digits, such as \"050E03EE\"";
        Self::parse(&String::deserialize(deserializer)?).ok_or_else(|| de::Error::custom(expected))
    }
}

/// One text, or a list of texts: `"fault"`, `["fault", "switched-on"]`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct OneOrMore(pub Vec<String>);

value! { Delay Duration Hex }

impl Compare for OneOrMore {
    const IS_VALUE: bool = true;

    fn shown(&self) -> String {
        self.to_string()
    }

    fn walk(&self, path: &mut FieldPath, walker: &mut dyn Walker) {
        self.0.walk(path, walker);
    }
}

impl std::ops::Deref for OneOrMore {
    type Target = [String];

    fn deref(&self) -> &[String] {
        &self.0
    }
}

impl<'de> Deserialize<'de> for OneOrMore {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Texts;
        impl<'de> Visitor<'de> for Texts {
            type Value = OneOrMore;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a string or a list of strings")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<OneOrMore, E> {
                Ok(OneOrMore(vec![text.to_owned()]))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<OneOrMore, A::Error> {
                Vec::deserialize(de::value::SeqAccessDeserializer::new(list)).map(OneOrMore)
            }
        }
        deserializer.deserialize_any(Texts)
    }
}

impl std::fmt::Display for OneOrMore {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0.join(", "))
    }
}

impl std::fmt::Display for Duration {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let units = [(1_000_000_000, "s"), (1_000_000, "ms"), (1_000, "us")];
        let whole = units.into_iter().find(|(factor, _)| self.0 != 0 && self.0.is_multiple_of(*factor));
        let (factor, unit) = whole.unwrap_or((1, "ns"));
        write!(f, "{} {unit}", self.0 / factor)
    }
}

impl std::fmt::Display for Delay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ns", self.0)
    }
}

impl std::fmt::Display for Hex {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02X}"))
    }
}
