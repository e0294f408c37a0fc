//! How bad each rule is held to be.

use super::rules::unknown_rule;
use crate::diagnostic::{Diagnostic, Group, Level, Rule};
use crate::raw::LintSetting;
use crate::source::Location;

/// Levels that someone set, later ones over earlier ones.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Levels {
    settings: Vec<Setting>,
}

#[derive(Debug, Clone, PartialEq)]
struct Setting {
    /// A rule or a group of rules.
    name: String,
    level: Level,
    /// Where it was set in a description; none for the command line.
    at: Option<Location>,
}

impl Levels {
    /// The levels that a description sets.
    pub(crate) fn described(settings: &[LintSetting]) -> Self {
        let mut levels = Self::default();
        for setting in settings {
            levels.set(&setting.name, setting.level, Some(setting.at));
        }
        levels
    }

    /// Lets other levels hold over these.
    pub fn extend(&mut self, over: &Self) {
        self.settings.extend(over.settings.iter().cloned());
    }

    /// Sets the level of a rule or group.
    pub fn set(&mut self, name: &str, level: Level, at: Option<Location>) {
        self.settings.push(Setting { name: name.to_owned(), level, at });
    }

    /// The message at the level that holds for its rule, with a note if someone set it; none if it is
    /// allowed.
    pub(super) fn judge(&self, mut diagnostic: Diagnostic) -> Option<Diagnostic> {
        let rule = diagnostic.rule;
        let setting = self.settings.iter().rev().find(|setting| setting.names(rule));
        if let Some(setting) = setting.filter(|_| !rule.fixed) {
            diagnostic.level = setting.level;
            let place = if setting.at.is_some() { "in `[lints]`" } else { "on the command line" };
            diagnostic =
                diagnostic.note(format!("`{}` is set to \"{}\" {place}", setting.name, setting.level.name()));
        }
        (diagnostic.level != Level::Allow).then_some(diagnostic)
    }

    /// A message for each name that neither a rule nor a group has.
    pub(super) fn unknown(&self) -> impl Iterator<Item = Diagnostic> {
        self.settings.iter().filter_map(|setting| unknown_rule::judge(&setting.name, setting.at?))
    }
}

impl Setting {
    fn names(&self, rule: &Rule) -> bool {
        self.name == rule.name || Group::parse(&self.name) == Some(rule.group)
    }
}
