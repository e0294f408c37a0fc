//! What members are called.

use crate::emit::markdown::holds::{Form, Holds};

/// The words for the members of a family.
pub(super) struct Names<'n> {
    names: &'n [String],
    form: Form,
}

impl<'n> Names<'n> {
    /// The words, in what is made with them.
    pub(super) fn new(names: &'n [String], form: Form) -> Self {
        Self { names, form }
    }

    /// Members in running text: `S300 and S700`.
    fn running(&self, members: &[usize]) -> String {
        match self.of(members).as_slice() {
            [first @ .., one, other] => {
                first.iter().map(|name| format!("{name}, ")).collect::<String>() + one + " and " + other
            }
            names => names.concat(),
        }
    }

    /// Members in a cell: `S300, S700`.
    pub(super) fn brief(&self, members: &[usize]) -> String {
        self.of(members).join(", ")
    }

    /// A line that says for which members what follows holds.
    pub(super) fn line(&self, before: &str, members: &[usize], after: &str) -> String {
        let words = format!("{before}{}{after}", self.running(members));
        match self.form {
            Form::Text => format!("*{words}*"),
            Form::Page => format!("<i class=\"of\">{words}</i>"),
        }
    }

    /// What holds for some members, with these as a remark behind it unless they are all.
    pub(super) fn remarked(&self, what: &str, members: &[usize], all: &[usize]) -> String {
        match self.form {
            _ if members == all => what.to_owned(),
            Form::Text => format!("{what} *({})*", self.brief(members)),
            Form::Page => Holds::for_members(members).around("", &self.with_names(what, members)),
        }
    }

    /// The versions of what is in a cell, a line each, with the members that have it.
    pub(super) fn versions(&self, versions: &[(&str, Vec<usize>)]) -> String {
        let shown = |what: &str| if what.is_empty() { "–".to_owned() } else { what.to_owned() };
        let version = |(what, members): &(&str, Vec<usize>)| match self.form {
            Form::Text => format!("{} *({})*", shown(what), self.brief(members)),
            Form::Page => {
                Holds::for_members(members).around("version", &self.with_names(&shown(what), members))
            }
        };
        let versions = versions.iter().map(version).collect::<Vec<_>>();
        versions.join(if self.form == Form::Text { "<br>" } else { "" })
    }

    /// Something with the names of members behind it, which the page hides from those who look at one member.
    fn with_names(&self, what: &str, members: &[usize]) -> String {
        format!("{what} <i class=\"of\">({})</i>", self.brief(members))
    }

    fn of(&self, members: &[usize]) -> Vec<&str> {
        members.iter().filter_map(|member| self.names.get(*member)).map(String::as_str).collect()
    }
}
