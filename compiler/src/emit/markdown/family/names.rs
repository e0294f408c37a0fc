//! What members are called.

/// The words for the members of a family.
pub(super) struct Names<'n>(pub(super) &'n [String]);

impl Names<'_> {
    /// Members in running text: `S300 and S700`.
    pub(super) fn running(&self, members: &[usize]) -> String {
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

    /// Members as a remark behind what holds for them; nothing if that is all there are.
    pub(super) fn remark(&self, members: &[usize], all: &[usize]) -> String {
        if members == all { String::new() } else { format!(" *({})*", self.brief(members)) }
    }

    fn of(&self, members: &[usize]) -> Vec<&str> {
        members.iter().filter_map(|member| self.0.get(*member)).map(String::as_str).collect()
    }
}
