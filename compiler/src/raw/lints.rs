//! Levels of rules: `[lints]`.

use super::compose::wrong_type;
use super::read::Sections;
use crate::diagnostic::Level;
use crate::source::{Location, Value};

/// A level set in `[lints]`.
#[derive(Debug, Clone, PartialEq)]
pub struct LintSetting {
    /// The rule or group.
    pub name: String,
    /// The level: `allow`, `warn` or `deny`.
    pub level: Level,
    /// Where the rule is named.
    pub at: Location,
}

impl Sections<'_> {
    /// The levels that the description sets.
    pub(super) fn lints(&mut self) -> Vec<LintSetting> {
        let mut settings = Vec::new();
        for member in self.members("lints") {
            let level = match &member.node.value {
                Value::String(level) => Level::parse(level),
                _ => None,
            };
            match level {
                Some(level) => {
                    let name = member.key.name.to_string();
                    settings.push(LintSetting { name, level, at: member.key.at });
                }
                None => {
                    let expected = "`\"allow\"`, `\"warn\"` or `\"deny\"`";
                    self.diagnostics.push(wrong_type(&member.node, expected));
                }
            }
        }
        settings
    }
}
