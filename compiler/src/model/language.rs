//! Texts in other languages than English, in which descriptions are written.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error};

use super::compare::value;
use super::keyed::{keyed, list};
use super::model;

/// A language that ESI files have texts in, other than English.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Language {
    /// Its code of ISO 639-1, with a country where that makes a difference.
    code: &'static str,
    /// Its number in ESI files, which is that of Windows.
    lcid: u16,
}

value! { Language }

/// The languages; of two with one code the first is meant.
const LANGUAGES: [(&str, u16); 35] = [
    ("ar", 1025),
    ("bg", 1026),
    ("cs", 1029),
    ("da", 1030),
    ("de", 1031),
    ("el", 1032),
    ("es", 3082),
    ("es", 1034),
    ("et", 1061),
    ("fi", 1035),
    ("fr", 1036),
    ("he", 1037),
    ("hi", 1081),
    ("hr", 1050),
    ("hu", 1038),
    ("id", 1057),
    ("it", 1040),
    ("ja", 1041),
    ("ko", 1042),
    ("lt", 1063),
    ("lv", 1062),
    ("nb", 1044),
    ("nl", 1043),
    ("pl", 1045),
    ("pt", 2070),
    ("pt-BR", 1046),
    ("ro", 1048),
    ("ru", 1049),
    ("sk", 1051),
    ("sl", 1060),
    ("sv", 1053),
    ("th", 1054),
    ("tr", 1055),
    ("zh", 2052),
    ("zh-TW", 1028),
];

impl Language {
    /// The language of a code, in any case of letters.
    pub fn of_code(code: &str) -> Option<Self> {
        let (code, lcid) = LANGUAGES.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(code))?;
        Some(Self { code, lcid })
    }

    /// The language of a number in an ESI file.
    pub fn of_lcid(lcid: u16) -> Option<Self> {
        let (code, _) = LANGUAGES.into_iter().find(|(_, known)| *known == lcid)?;
        Self::of_code(code)
    }

    /// Its code of ISO 639-1.
    pub fn code(self) -> &'static str {
        self.code
    }

    /// Its number in ESI files.
    pub fn lcid(self) -> u16 {
        self.lcid
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code)
    }
}

impl<'de> Deserialize<'de> for Language {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let expected = "expected the code of a language other than English, such as `de`, `fr` or `zh`";
        Self::of_code(&text).ok_or_else(|| Error::custom(format!("`{text}` means nothing here, {expected}")))
    }
}

#[cfg(feature = "json")]
impl serde::Serialize for Language {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.code)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Language {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "language".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "string", "pattern": "^[a-z]{2}(-[A-Z]{2})?$" })
    }
}

model! {
    /// A text in another language than English.
    pub struct Translation by language {
        /// The language, by its code of ISO 639-1.
        pub language: Language,
        /// The text.
        pub text: String,
    }
}

list! {
    /// A text in other languages than English, by language.
    Translations of Translation as String;
}

impl<'de> Deserialize<'de> for Translations {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut texts: Vec<(Language, String)> = keyed(deserializer)?;
        texts.sort_by_key(|(language, _)| *language);
        texts.dedup_by_key(|(language, _)| *language);
        Ok(Self(texts.into_iter().map(|(language, text)| Translation { language, text }).collect()))
    }
}
