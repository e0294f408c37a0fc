//! A device, or a family, as one document.

use super::chapters::{Chapter, chapters};
use super::context::Context;
use super::family;
use super::inline::text;
use super::page::{Block, Item, Page};
use crate::emit::escape::comment;
use crate::model::{Device, Family};
use crate::text::characters::line;

/// The whole document: a reference, or the references of a family as one.
pub(super) fn document(family: &Family, editorial: bool) -> String {
    let members: Vec<Context<'_>> =
        family.members.iter().map(|device| Context::new(device, &[], editorial)).collect();
    let bodies = family.members.iter().map(|device| body(&Context::new(device, &members, editorial)));
    let bodies: Vec<Page> = bodies.collect();
    let mut page = Page::default();
    let id = comment(&line(&family.id));
    page.lines(format!("<!-- Made by devc from the description of {id}; not to be edited. -->"));
    match family.members.as_slice() {
        [alone] => {
            front(alone, &mut page);
            bodies.into_iter().for_each(|body| page.append(body));
            with_sources(page).to_string()
        }
        _ => {
            family::front(family, &mut page);
            page.append(family::body(family, bodies));
            family::first_anchors(&with_sources(page).to_string())
        }
    }
}

fn front(device: &Device, page: &mut Page) {
    page.heading(1, text(&device.name));
    device.title.iter().for_each(|title| page.text(format!("**{}**", text(title))));
}

/// The contents and the chapters of one device.
fn body(context: &Context<'_>) -> Page {
    let mut page = Page::default();
    if let Some(main) = context.device.documents.first().map(|document| text(&document.title)) {
        page.text(format!(
            "<sub>Small print names the place in *{main}* that a fact is from, unless it names another document.</sub>"
        ));
    }
    let chapters = chapters(context);
    page.heading(2, "Contents");
    page.items(chapters.iter().flat_map(lines_of_contents).collect());
    for chapter in chapters {
        page.place(2, chapter.anchor, chapter.title);
        page.append(chapter.page);
    }
    page
}

fn lines_of_contents(chapter: &Chapter) -> impl Iterator<Item = Item> {
    let line = |depth, (anchor, title): (&str, &str)| Item { depth, text: format!("[{title}](#{anchor})") };
    let parts = chapter.page.parts().map(move |part| line(1, part));
    [line(0, (chapter.anchor, chapter.title))].into_iter().chain(parts)
}

/// Says below each table what most of its rows are from, instead of in each row.
fn with_sources(page: Page) -> Page {
    let mut out = Page::default();
    for block in page.0 {
        match block {
            Block::Table(mut table) => {
                let source = table.take_source_line();
                out.table(table);
                source.iter().for_each(|source| out.text(source));
            }
            other => out.0.push(other),
        }
    }
    out
}
