//! A device, or a family, as one document.

use minijinja::value::Serde;
use minijinja::{Environment, Value, context};

use super::chapter::Prepared;
use super::chapters;
use super::context::Context;
use super::family;
use super::inline::text;
use super::table::sources_once;
use crate::emit::escape::comment;
use crate::emit::template::environment;
use crate::model::{Device, Family};
use crate::text::characters::line;

const ALONE: &str = include_str!("templates/document.md.j2");
const FAMILY: &str = include_str!("templates/family.md.j2");
const BODY: &str = include_str!("templates/body.md.j2");

/// The whole document: a reference, or the references of a family as one.
pub(super) fn document(family: &Family, editorial: bool) -> String {
    // Views and templates are part of devc, and each is rendered by a test: this says where one is broken.
    let reference = reference(family, editorial)
        .unwrap_or_else(|error| format!("devc could not print this: {error:#}\n"));
    let text = tidy(&format!(
        "<!-- Made by devc from the description of {}; not to be edited. -->\n{reference}",
        comment(&line(&family.id))
    ));
    sources_once(&text)
}

fn reference(family: &Family, editorial: bool) -> Result<String, minijinja::Error> {
    let environment = environment()?;
    let members: Vec<Context<'_>> =
        family.members.iter().map(|device| Context::new(device, &[], editorial)).collect();
    let bodies =
        family.members.iter().map(|device| body(&environment, &Context::new(device, &members, editorial)));
    let bodies: Vec<String> = bodies.collect::<Result<_, _>>()?;
    match family.members.as_slice() {
        [alone] => environment.render_named_str("document", ALONE, front(alone, bodies.concat())),
        _ => environment.render_named_str("family", FAMILY, family::view(family, &bodies)),
    }
}

/// The contents and the chapters of one device.
fn body(environment: &Environment<'_>, context: &Context<'_>) -> Result<String, minijinja::Error> {
    let mut chapters = Vec::new();
    for Prepared { title, anchor, sections, template, view } in chapters::chapters(context) {
        let body = environment.render_named_str(title, template, view)?;
        chapters.push(context! { title, anchor, sections => Serde(sections), body });
    }
    let main = context.device.documents.first().map_or(String::new(), |document| text(&document.title));
    Ok(tidy(&environment.render_named_str("body", BODY, context! { main, chapters })?))
}

fn front(device: &Device, body: String) -> Value {
    let title = device.title.as_deref().map_or(String::new(), text);
    context! { name => text(&device.name), title, body }
}

/// Takes out the blank lines that parts left out leave behind.
fn tidy(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut blank = true;
    for line in text.lines().map(str::trim_end) {
        if !(blank && line.is_empty()) {
            out.push_str(line);
            out.push('\n');
        }
        blank = line.is_empty();
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}
