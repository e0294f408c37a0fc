//! What stands between two lines: comments and blank lines.

/// The lines before a key or a header; none is blank but where one was, and never two in a row.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Lead<'t>(Vec<&'t str>);

impl<'t> Lead<'t> {
    /// The comments and blank lines of a text that has nothing else.
    pub(super) fn of(text: &'t str) -> Self {
        let mut lines: Vec<&str> = text.split('\n').map(str::trim).collect();
        // what follows the last line break belongs to the line behind
        lines.pop();
        lines.dedup_by(|next, line| next.is_empty() && line.is_empty());
        Self(lines)
    }

    /// Whether there is no comment.
    pub(super) fn is_blank(&self) -> bool {
        self.0.iter().all(|line| line.is_empty())
    }

    /// What stands behind the last line that has a key or a header.
    pub(super) fn to_end(text: &'t str) -> Self {
        let mut lines: Vec<&str> = text.split('\n').map(str::trim).collect();
        lines.dedup_by(|next, line| next.is_empty() && line.is_empty());
        while lines.last().is_some_and(|line| line.is_empty()) {
            lines.pop();
        }
        Self(lines)
    }

    /// Whether what follows begins a new group: a blank line stands somewhere before it.
    pub(super) fn parts(&self) -> bool {
        self.0.iter().any(|line| line.is_empty())
    }

    /// Whether it has a comment that is not about what follows alone, since a blank line stands between them.
    pub(super) fn has_heading(&self) -> bool {
        let blank = self.0.iter().rposition(|line| line.is_empty());
        blank.is_some_and(|blank| self.0.iter().take(blank).any(|line| !line.is_empty()))
    }

    /// Takes off what stands before the last blank line.
    pub(super) fn behead(&mut self) -> Self {
        let blank = self.0.iter().rposition(|line| line.is_empty());
        let rest = self.0.split_off(blank.unwrap_or_default());
        Self(std::mem::replace(&mut self.0, rest)).tight()
    }

    /// Without blank lines at the beginning.
    #[must_use]
    pub(super) fn tight(&self) -> Self {
        Self(self.0.iter().copied().skip_while(|line| line.is_empty()).collect())
    }

    /// With one blank line at the beginning.
    #[must_use]
    pub(super) fn loose(&self) -> Self {
        Self([""].into_iter().chain(self.tight().0).collect())
    }

    /// With other lines behind.
    #[must_use]
    pub(super) fn joined(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }

    /// The lines, each with its end.
    pub(super) fn print(&self, out: &mut String) {
        for line in &self.0 {
            out.push_str(line);
            out.push('\n');
        }
    }
}
