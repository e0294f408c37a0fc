//! Patterns of bits.

use std::fmt;

use super::compare::value;
use super::plain;

plain! {
    /// What the bits of a word must be, lowest first; bits beyond are either.
    #[derive(Eq)]
    #[cfg_attr(feature = "json", serde(into = "String"))]
    #[cfg_attr(feature = "schema", schemars(with = "String", inline))]
    pub struct Pattern {
        /// The bits, bit 0 first.
        pub bits: Vec<Bit>,
    }

    /// What a bit must be.
    #[derive(Copy, Eq)]
    pub enum Bit {
        /// Clear.
        Zero,
        /// Set.
        One,
        /// Clear or set.
        Either,
        /// Clear before and set now.
        Rising,
        /// Set before and clear now.
        Falling,
    }
}

value! { Pattern }

impl Pattern {
    /// Reads a pattern as descriptions write it: `"x01x 0001"`, highest bit first.
    pub fn parse(text: &str) -> Option<Self> {
        let bits: Option<Vec<Bit>> = text.chars().rev().filter(|c| *c != ' ').map(Bit::parse).collect();
        bits.filter(|bits| (1..=16).contains(&bits.len())).map(|bits| Self { bits })
    }

    /// The bits that matter by their level; an edge counts with the level it ends on.
    pub fn mask(&self) -> u16 {
        self.select(|bit| bit != Bit::Either)
    }

    /// The levels of the bits that matter.
    pub fn value(&self) -> u16 {
        self.select(|bit| matches!(bit, Bit::One | Bit::Rising))
    }

    /// The bits that must have risen.
    pub fn rising(&self) -> u16 {
        self.select(|bit| bit == Bit::Rising)
    }

    /// The bits that must have fallen.
    pub fn falling(&self) -> u16 {
        self.select(|bit| bit == Bit::Falling)
    }

    /// Whether there is a word that fits both.
    pub fn overlaps(&self, other: &Self) -> bool {
        let both = self.mask() & other.mask();
        self.value() & both == other.value() & both
    }

    fn select(&self, wanted: impl Fn(Bit) -> bool) -> u16 {
        let bits = self.bits.iter().zip(0_u16..16).filter(|(bit, _)| wanted(**bit));
        bits.map(|(_, place)| 1_u16 << place).sum()
    }
}

impl<'de> serde::Deserialize<'de> for Pattern {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let expected = "expected a pattern of up to 16 bits, each 0, 1, x, r or f, such as \"x01x 0001\"";
        Self::parse(&text).ok_or_else(|| serde::de::Error::custom(expected))
    }
}

impl Bit {
    fn parse(c: char) -> Option<Self> {
        match c {
            '0' => Some(Self::Zero),
            '1' => Some(Self::One),
            'x' => Some(Self::Either),
            'r' => Some(Self::Rising),
            'f' => Some(Self::Falling),
            _ => None,
        }
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, bit) in self.bits.iter().enumerate().rev() {
            let c = match bit {
                Bit::Zero => '0',
                Bit::One => '1',
                Bit::Either => 'x',
                Bit::Rising => 'r',
                Bit::Falling => 'f',
            };
            write!(f, "{c}")?;
            if place % 4 == 0 && place > 0 {
                f.write_str(" ")?;
            }
        }
        Ok(())
    }
}

impl From<Pattern> for String {
    fn from(pattern: Pattern) -> Self {
        pattern.to_string()
    }
}
