//! Slots that modules are put into by whoever builds the machine (ETG.5001).

use super::Translations;
use super::table::{part, table};

table! {
    /// `[slots.<id>]`: places of a modular device that one of several modules can be put into. What the modules bring is
    /// described where they are: in the ESI of the modules. Slots of axes follow from `[modules]`.
    pub struct Slot by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language.
        #[serde(default)]
        pub names: Translations,
        /// How many of these places must have a module.
        #[serde(default)]
        pub min: u16,
        /// How many of them there are.
        pub max: u16,
        /// How far apart the objects of the modules are.
        #[serde(default)]
        pub index_step: u16,
        /// How far apart their PDOs are.
        #[serde(default)]
        pub pdo_step: u16,
        /// The modules that fit, by their numbers.
        #[serde(default)]
        pub modules: Vec<u32>,
        /// The module that is there if nothing is chosen.
        pub default: Option<u32>,
        /// The classes of modules that fit.
        #[serde(default)]
        pub classes: Vec<ModuleClass>,
    }
}

part! {
    /// Modules of a kind.
    #[derive(Default)]
    pub struct ModuleClass {
        /// What the modules call it.
        pub class: String,
        /// Its name, if it has one.
        pub name: Option<String>,
        /// Its name in other languages, by language.
        #[serde(default)]
        pub names: Translations,
    }
}
