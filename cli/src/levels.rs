//! Levels of rules as arguments.

use clap::Args;
use devc::diagnostic::{Group, Level};
use devc::lint::Levels;
use devc::rules;

use super::outcome::Failure;

/// What every subcommand that checks descriptions can be told about the rules.
#[derive(Debug, Args)]
pub(super) struct LevelArguments {
    /// Do not report a rule, or a group of rules; may be given several times.
    #[arg(long, short = 'A', value_name = "RULE")]
    allow: Vec<String>,

    /// Report a rule or group as a warning; holds over `--allow`.
    #[arg(long, short = 'W', value_name = "RULE")]
    warn: Vec<String>,

    /// Report a rule or group as an error; holds over `--warn` and `--allow`.
    #[arg(long, short = 'D', value_name = "RULE")]
    deny: Vec<String>,

    /// Count warnings as findings.
    #[arg(long)]
    pub(super) deny_warnings: bool,
}

impl LevelArguments {
    /// The levels, groups before single rules, so that what names a rule holds over what names its group.
    pub(super) fn levels(&self) -> Result<Levels, Failure> {
        let given = [(&self.allow, Level::Allow), (&self.warn, Level::Warning), (&self.deny, Level::Error)];
        let given = || given.iter().flat_map(|(names, level)| names.iter().map(|name| (name, *level)));
        let mut levels = Levels::default();
        for (name, level) in given().filter(|(name, _)| Group::parse(name).is_some()) {
            levels.set(name, level, None);
        }
        for (name, level) in given().filter(|(name, _)| Group::parse(name).is_none()) {
            let rule = rules::find(name).map_err(|near| unknown(name, near))?;
            if rule.fixed {
                let what = format!("the level of `{name}` cannot be changed");
                return Err(Failure::new(what).help("what it reports leaves nothing to go on with"));
            }
            levels.set(name, level, None);
        }
        Ok(levels)
    }
}

fn unknown(name: &str, near: Option<&str>) -> Failure {
    Failure::new(format!("there is no rule or group `{name}`")).help(match near {
        Some(near) => format!("did you mean `{near}`?"),
        None => "`devc rules` lists all rules".to_owned(),
    })
}
