//! The reference with a file for each chapter: the document divided, and its links led from file to file.

use super::document::{made, whole};
use super::inline::text;
use super::page::{Block, Heading, Page};
use crate::emit::Files;
use crate::model::Family;
use crate::text::characters::harmless;

/// What is to become a file.
struct Part {
    /// What the chapter is called in links; nothing is what stands before all chapters.
    chapter: Option<String>,
    text: String,
}

/// The files: `<family>.md` with what stands before the chapters, and a file for each chapter in `<family>.md.d`.
pub(super) fn files(family: &Family, editorial: bool) -> Files {
    let parts = divided(whole(family, editorial));
    let files = parts.iter().map(|part| {
        let up = part
            .chapter
            .as_ref()
            .map(|_| format!("[{}](../{}.md)\n\n", text(&family.name), in_link(&family.id)));
        let body = linked(part, &parts, &in_link(&family.id));
        let content = format!("{}\n\n{}{body}", made(family), up.unwrap_or_default());
        let name = match &part.chapter {
            Some(chapter) => format!("{}.md.d/{chapter}.md", family.id),
            None => format!("{}.md", family.id),
        };
        (name, harmless(&content).into_owned().into_bytes())
    });
    Files(files.collect())
}

/// The document, divided before each chapter.
fn divided(page: Page) -> Vec<Part> {
    let mut pages = vec![(None, Page::default())];
    for block in page.0 {
        if let Block::Heading(Heading { level: 2, anchor: Some(anchor), .. }) = &block {
            pages.push((Some(anchor.clone()), Page::default()));
        }
        pages.iter_mut().next_back().into_iter().for_each(|(_, page)| page.0.push(block.clone()));
    }
    pages.into_iter().map(|(chapter, page)| Part { chapter, text: page.to_string() }).collect()
}

/// The text of a part, whose links to places in other parts name the file.
fn linked(part: &Part, parts: &[Part], family: &str) -> String {
    let mut pieces = part.text.split("](#");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let anchor = piece.split(')').next().unwrap_or_default();
        let place = format!("<a id=\"{anchor}\">");
        let file = match parts.iter().find(|other| other.text.contains(&place)) {
            Some(other) if other.chapter != part.chapter => match (&part.chapter, &other.chapter) {
                (None, Some(chapter)) => format!("{family}.md.d/{chapter}.md"),
                (Some(_), Some(chapter)) => format!("{chapter}.md"),
                (_, None) => format!("../{family}.md"),
            },
            _ => String::new(),
        };
        out.push_str(&format!("]({file}#{piece}"));
    }
    out
}

/// A name as links have it: what they could take for their own signs is in hexadecimal.
fn in_link(name: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte);
    let byte = |byte| if is_plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    name.bytes().map(byte).collect()
}
