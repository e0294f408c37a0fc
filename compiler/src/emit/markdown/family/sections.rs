//! The blocks of a reference, by the headings under which they stand.

use super::sentences;
use crate::emit::markdown::page::{Block, Heading, Page};

/// A heading with what stands under it, up to the next heading of any level.
pub(super) struct Section {
    /// The heading; none for what stands before the first.
    pub(super) heading: Option<Heading>,
    /// The blocks.
    pub(super) blocks: Vec<Led>,
}

/// A block with what leads up to it.
pub(super) struct Led {
    pub(super) block: Block,
    /// The paragraph before it, if that ends in a colon.
    pub(super) caption: Option<String>,
}

impl Section {
    /// The sections of a page.
    pub(super) fn split(page: Page) -> Vec<Self> {
        let mut sections = vec![Self { heading: None, blocks: Vec::new() }];
        let mut caption = None;
        for block in page.0 {
            let next = leads_up(&block).map(str::to_owned);
            match (block, sections.last_mut()) {
                (Block::Heading(heading), _) => {
                    sections.push(Self { heading: Some(heading), blocks: Vec::new() });
                }
                (block, Some(section)) => section.blocks.push(Led { block, caption }),
                (_, None) => {}
            }
            caption = next;
        }
        sections
    }

    /// How deep its heading stands.
    pub(super) fn level(&self) -> usize {
        self.heading.as_ref().map_or(0, |heading| heading.level)
    }

    /// Where links to it lead.
    pub(super) fn anchor(&self) -> Option<&str> {
        self.heading.as_ref()?.anchor.as_deref()
    }
}

/// The paragraph, if it is one that leads up to what follows.
pub(super) fn leads_up(block: &Block) -> Option<&str> {
    match block {
        Block::Text(text) if text.ends_with(':') => Some(text),
        _ => None,
    }
}

impl Led {
    /// Whether two blocks are versions of one: the same, or tables, lists or paragraphs that can become one.
    pub(super) fn is_version(&self, other: &Self) -> bool {
        let alike = match (&self.block, &other.block) {
            (Block::Table(one), Block::Table(other)) => one.titles().next() == other.titles().next(),
            (Block::List(_), Block::List(_)) => true,
            (Block::Text(one), Block::Text(other)) => {
                self.caption.is_none() && sentences::is_version(one, other)
            }
            _ => false,
        };
        self.block == other.block || alike && self.caption == other.caption
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_begin_with_their_headings() {
        let mut page = Page::default();
        page.text("before");
        page.place(2, "a", "A");
        page.text("One:");
        page.list(["two".to_owned()]);
        page.text("three");
        let sections = Section::split(page);
        assert_eq!(sections.iter().map(Section::level).collect::<Vec<_>>(), [0, 2]);
        assert_eq!(sections[1].anchor(), Some("a"));
        let captions: Vec<_> = sections[1].blocks.iter().map(|led| led.caption.as_deref()).collect();
        assert_eq!(captions, [None, Some("One:"), None]);
    }
}
