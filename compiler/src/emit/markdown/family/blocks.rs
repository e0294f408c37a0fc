//! Markdown taken apart: sections under headings, and blocks between blank lines.

use super::sentences::is_version;

/// A heading with what stands under it, up to the next heading of any level.
pub(super) struct Section<'t> {
    /// The line of the heading; empty for what stands before the first.
    pub(super) heading: &'t str,
    /// The first anchor in the heading.
    pub(super) anchor: Option<&'t str>,
    /// The blocks.
    pub(super) blocks: Vec<Block<'t>>,
}

/// What stands between two blank lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Block<'t> {
    /// Its lines.
    pub(super) text: &'t str,
    /// The block before it, if that leads up to it.
    pub(super) caption: &'t str,
}

impl<'t> Section<'t> {
    /// The sections of a text.
    pub(super) fn split(text: &'t str) -> Vec<Self> {
        let mut sections = vec![Self::under("")];
        let mut caption = "";
        for text in blocks(text) {
            match sections.last_mut() {
                Some(section) if !text.starts_with('#') => section.blocks.push(Block { text, caption }),
                _ => sections.push(Self::under(text)),
            }
            caption = if text.ends_with(':') { text } else { "" };
        }
        sections
    }

    /// A section with nothing in it yet.
    fn under(heading: &'t str) -> Self {
        let anchor = heading.split_once("<a id=\"").and_then(|(_, id)| id.split('"').next());
        Self { heading, anchor, blocks: Vec::new() }
    }

    /// How deep its heading stands: 2 for a chapter.
    pub(super) fn level(&self) -> usize {
        self.heading.bytes().take_while(|byte| *byte == b'#').count()
    }
}

/// The text between blank lines, code with blank lines in it whole.
fn blocks(text: &str) -> Vec<&str> {
    let mut blocks = Vec::new();
    let mut rest = text.trim_matches('\n');
    while !rest.is_empty() {
        let fence = rest.starts_with("```");
        let end = match fence {
            true => rest.find("\n```").map(|at| at + 4),
            false => rest.find("\n\n"),
        };
        let (block, after) = rest.split_at(end.unwrap_or(rest.len()));
        blocks.push(block);
        rest = after.trim_start_matches('\n');
    }
    blocks
}

impl<'t> Block<'t> {
    /// Whether it is a table.
    pub(super) fn is_table(&self) -> bool {
        self.text.starts_with('|')
    }

    /// Whether it is a list without numbers.
    pub(super) fn is_list(&self) -> bool {
        self.text.lines().all(|line| line.trim_start().starts_with("- "))
    }

    /// Whether it is text in sentences.
    fn is_text(&self) -> bool {
        !self.is_table() && !self.is_list() && !self.text.contains('\n') && self.caption.is_empty()
    }

    /// Whether two blocks are versions of one: the same words, or tables, lists or sentences that can become one.
    pub(super) fn is_version(&self, other: &Self) -> bool {
        let tables = self.is_table() && other.is_table() && self.first_cell() == other.first_cell();
        let lists = self.is_list() && other.is_list();
        let texts = self.is_text() && other.is_text() && is_version(self.text, other.text);
        self.text == other.text || (self.caption == other.caption && (tables || lists)) || texts
    }

    /// The title of a table's first column.
    fn first_cell(&self) -> Option<&'t str> {
        self.text.split(" | ").next()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_begin_with_their_headings() {
        let sections = Section::split("before\n\n## A\n\n```\n\n# no\n```\n\nOne:\n\n- two\n");
        let headings: Vec<&str> = sections.iter().map(|section| section.heading).collect();
        assert_eq!(headings, ["", "## A"]);
        let blocks = &sections[1].blocks;
        assert_eq!(blocks.len(), 3);
        assert_eq!(blocks[2], Block { text: "- two", caption: "One:" });
    }
}
