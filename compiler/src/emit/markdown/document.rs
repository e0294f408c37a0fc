//! A device, or a family, as one document.

use super::chapters::{Chapter, chapters};
use super::context::Context;
use super::family;
use super::holds::Form;
use super::inline::text;
use super::page::{Block, Item, Page};
use crate::emit::escape::comment;
use crate::model::Family;
use crate::text::characters::line;

/// The whole document: a reference, or the references of a family as one.
pub(super) fn document(family: &Family, editorial: bool) -> String {
    let mut page = Page::default();
    page.lines(made(family));
    page.append(whole(family, editorial));
    page.to_string()
}

/// The words by which devc knows a file as its own.
pub(super) fn made(family: &Family) -> String {
    let id = comment(&line(&family.id));
    format!("<!-- Made by devc from the description of {id}; not to be edited. -->")
}

/// All that the document says.
pub(super) fn whole(family: &Family, editorial: bool) -> Page {
    let mut page = front(family);
    page.append(body(family, editorial, Form::Text));
    page
}

/// What stands before the chapters.
pub(in crate::emit) fn front(family: &Family) -> Page {
    let mut page = Page::default();
    match family.members.as_slice() {
        [alone] => {
            page.heading(1, text(&alone.name));
            alone.title.iter().for_each(|title| page.text(format!("**{}**", text(title))));
        }
        _ => family::front(family, &mut page),
    }
    page
}

/// The chapters; a text begins with a list of what is in them.
pub(in crate::emit) fn body(family: &Family, editorial: bool, form: Form) -> Page {
    let members: Vec<Context<'_>> =
        family.members.iter().map(|device| Context::new(device, editorial, form)).collect();
    let bodies: Vec<Page> = Context::among(&members).map(|member| body_of(&member)).collect();
    with_sources(match <[Page; 1]>::try_from(bodies) {
        Ok([alone]) => alone,
        Err(bodies) => family::body(family, bodies, form),
    })
}

/// The chapters of one device.
fn body_of(context: &Context<'_>) -> Page {
    let mut page = Page::default();
    if let Some(main) = context.device.documents.first().map(|document| text(&document.title)) {
        page.text(format!(
            "<sub>Small print names the place in *{main}* that a fact is from, unless it names another document.</sub>"
        ));
    }
    let chapters = chapters(context);
    if context.form == Form::Text {
        page.heading(2, "Contents");
        page.items(chapters.iter().flat_map(lines_of_contents).collect());
    }
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
