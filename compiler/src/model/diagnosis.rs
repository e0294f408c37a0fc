//! What a device reports in its diagnosis history.

use super::Translations;
use super::table::{part, table};

table! {
    /// `[diagnosis.<text id>]`: a message of the diagnosis history, object 0x10F3.
    pub struct DiagnosisMessage by text_id: "a text id such as 0x8001" {
        /// The number by which the device names it.
        #[serde(skip_deserializing)]
        pub text_id: u16,
        /// The message; its parameters stand in it as `%d`, `%s` and the like.
        pub text: String,
        /// The message in other languages, by language.
        #[serde(default)]
        pub texts: Translations,
        /// How bad it is.
        pub class: Option<DiagnosisClass>,
        /// What it means.
        pub about: Option<String>,
        /// What to do about it.
        pub remedy: Option<String>,
    }
}

part! {
    /// How bad something is.
    #[derive(Copy, Eq)]
    pub enum DiagnosisClass {
        /// The device does no longer what it should.
        Error,
        /// It will do so if nothing is done.
        Warning,
        /// Neither.
        Information,
    }
}

impl DiagnosisClass {
    /// Its name in an ESI file and for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
            Self::Information => "information",
        }
    }
}
